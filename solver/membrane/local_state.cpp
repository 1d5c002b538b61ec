// SPDX-License-Identifier: BSD-3-Clause
// Sums over the triangles around each vertex.
#include "membrane/local_state.hpp"

#include <array>
#include <cmath>

#include "membrane/bending.hpp"
#include "membrane/neo_hookean.hpp"
#include "membrane/skalak.hpp"

namespace rouleau {
namespace {

/// What is summed over the triangles around a vertex.
struct Sums {
  double area = 0, area_at_rest = 0, tension_times_area = 0;
  V3 normal, L;  ///< twice the area vector; L and A of bending.hpp
  double A = 0;
};

/// (T1 + T2) / 2 of a triangle times its area. Where g grows by the factor 1 + s, the energy grows by s E : g and the
/// area by s times itself.
double tension_times_area(const Metric& g, const ReferenceMetric& reference, const Moduli& moduli) {
  const MetricGradient E = moduli.law == InPlaneLaw::neo_hookean
                               ? neo_hookean_gradient(g, reference, moduli.kappa_S)
                               : skalak_gradient(g, reference, moduli.kappa_S, moduli.kappa_A);
  return E.E11 * g.g11 + E.E12 * g.g12 + E.E22 * g.g22;
}

std::vector<Sums> sums_around_vertices(const Cells& cells, const Moduli& moduli) {
  const ConstV3s X(cells.X), X_reference(cells.X_reference);
  std::vector<Sums> sums(cells.vertices());
  for (std::size_t t = 0; t < cells.triangles.size(); ++t) {
    const std::array<std::int32_t, 3> corner{cells.triangles.a[t], cells.triangles.b[t], cells.triangles.c[t]};
    const V3 u = X[corner[1]] - X[corner[0]], v = X[corner[2]] - X[corner[0]];
    const ReferenceMetric reference = reference_metric(
        metric(X_reference[corner[1]] - X_reference[corner[0]], X_reference[corner[2]] - X_reference[corner[0]]));
    const Metric g = metric(u, v);
    const CornerCurvatures curvature = corner_curvatures(u, v);
    const std::array<V3, 3> L{curvature.L_a, curvature.L_b, curvature.L_c};
    const std::array<double, 3> A{curvature.A_a, curvature.A_b, curvature.A_c};
    for (std::size_t c = 0; c < 3; ++c) {
      Sums& at = sums[static_cast<std::size_t>(corner[c])];
      at.area += 0.5 * std::sqrt(determinant(g));
      at.area_at_rest += reference.area;
      at.tension_times_area += tension_times_area(g, reference, moduli);
      at.normal = at.normal + cross(u, v);
      at.L = at.L + L[c];
      at.A += A[c];
    }
  }
  return sums;
}

}  // namespace

LocalState local_state(const Cells& cells, const Moduli& moduli) {
  LocalState state;
  for (const Sums& sum : sums_around_vertices(cells, moduli)) {
    state.area_strain.push_back(sum.area / sum.area_at_rest - 1);
    state.tension.push_back(sum.tension_times_area / sum.area);
    // |L| = 2 A 2 |H|; L points outwards where the surface is convex
    state.mean_curvature.push_back(std::copysign(std::sqrt(dot(sum.L, sum.L)) / (4 * sum.A), dot(sum.L, sum.normal)));
  }
  return state;
}

}  // namespace rouleau
