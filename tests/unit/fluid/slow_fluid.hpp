// SPDX-License-Identifier: BSD-3-Clause
// The same method written a second time, plainly: full populations, one node and one link at a time, dense matrices.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "base/grid.hpp"
#include "fluid/lattice.hpp"
#include "fluid/moment_basis.hpp"
#include "fluid/rates.hpp"

namespace rouleau::testing {

using Column = Eigen::Matrix<double, Q, 1>;
using Square = Eigen::Matrix<double, Q, Q>;

inline Vec3 velocity_of(int q) { return Vec3(c_q[q][0], c_q[q][1], c_q[q][2]); }

inline Square basis_matrix() {
  Square M;
  for (int k = 0; k < Q; ++k)
    for (int q = 0; q < Q; ++q) M(k, q) = moment_basis[k].value[q];
  return M;
}

/// Relaxation operator on populations.
inline Square relaxation(const MrtRates<>& s) {
  Column rate;
  for (int k = 0; k < Q; ++k) switch (moment_basis[k].kind) {
      case MomentKind::conserved:
        rate[k] = 0.77;
        break;  // whatever: conserved moments do not relax
      case MomentKind::e:
        rate[k] = s.e;
        break;
      case MomentKind::eps:
        rate[k] = s.eps;
        break;
      case MomentKind::q:
        rate[k] = s.q;
        break;
      case MomentKind::nu:
        rate[k] = s.nu;
        break;
      case MomentKind::pi:
        rate[k] = s.pi;
        break;
      case MomentKind::m:
        rate[k] = s.m;
        break;
    }
  const Square M = basis_matrix();
  return M.inverse() * rate.asDiagonal() * M;
}

inline Square relaxation(const TrtRates<>& omega) {
  Square R = Square::Zero();
  for (int q = 0; q < Q; ++q) {
    R(q, q) += 0.5 * (omega.even + omega.odd);
    R(q, opposite(q)) += 0.5 * (omega.even - omega.odd);
  }
  return R;
}

/// Eq. 3 of the paper with the density in front of all terms.
inline Column equilibrium_column(double rho, const Vec3& u) {
  Column f;
  for (int q = 0; q < Q; ++q) {
    const double cu = velocity_of(q).dot(u);
    f[q] = w_q(q) * rho * (1 + 3 * cu + 4.5 * cu * cu - 1.5 * u.squaredNorm());
  }
  return f;
}

/// [Guo2002] eq. 20 without 1 - omega/2.
inline Column source_column(const Vec3& u, const Vec3& F) {
  Column S;
  for (int q = 0; q < Q; ++q) {
    const Vec3 c = velocity_of(q);
    S[q] = w_q(q) * (3 * (c - u) + 9 * c.dot(u) * c).dot(F);
  }
  return S;
}

/// f - R (f - f_eq) + (1 - R/2) S, u = (sum c f + F/2) / rho.
inline Column collide_slowly(const Column& f, const Vec3& F, const Square& R, Vec3* velocity = nullptr) {
  Vec3 j = 0.5 * F;
  for (int q = 0; q < Q; ++q) j += f[q] * velocity_of(q);
  const double rho = f.sum();
  const Vec3 u = j / rho;
  if (velocity != nullptr) *velocity = u;
  const Column S = source_column(u, F);
  return f - R * (f - equilibrium_column(rho, u)) + S - 0.5 * (R * S);
}

/// A whole lattice. Walls: a link that would leave through one comes back reversed.
struct SlowFluid {
  Lattice lattice;
  std::array<std::array<Vec3, 2>, 3> wall_velocity;
  std::vector<Column> f;  ///< after collision

  [[nodiscard]] std::size_t index(const Int3& n) const {
    return static_cast<std::size_t>(n[0] + lattice.size[0] * (n[1] + lattice.size[1] * n[2]));
  }

  /// What direction q brings to `node`.
  [[nodiscard]] double arriving(const Int3& node, int q) const {
    Int3 from{};
    int wall_axis = -1, wall_side = 0;
    for (int a = 0; a < 3; ++a) {
      from[a] = lattice.wrap(a, node[a] - c_q[q][a]);
      if (!lattice.contains(a, from[a])) {
        wall_axis = a;  // the later axis wins
        wall_side = from[a] < 0 ? 0 : 1;
      }
    }
    if (wall_axis < 0) return f[index(from)][q];
    return f[index(node)][opposite(q)] + 6 * w_q(q) * velocity_of(q).dot(wall_velocity[wall_axis][wall_side]);
  }

  template <class ForceOf, class OperatorOf>
  void step(ForceOf force_of, OperatorOf operator_of) {
    std::vector<Column> next(f.size());
    for (int k = 0; k < lattice.size[2]; ++k)
      for (int j = 0; j < lattice.size[1]; ++j)
        for (int i = 0; i < lattice.size[0]; ++i) {
          const Int3 n{i, j, k};
          Column pulled;
          for (int q = 0; q < Q; ++q) pulled[q] = arriving(n, q);
          next[index(n)] = collide_slowly(pulled, force_of(n), operator_of(n));
        }
    f = next;
  }
};

}  // namespace rouleau::testing
