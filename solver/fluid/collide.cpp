// SPDX-License-Identifier: BSD-3-Clause
// Walks the rows of a block and hands each to the row loop in the variant it needs.
#include "fluid/collide.hpp"

#include <algorithm>
#include <cstring>

#include "fluid/row.hpp"

namespace rouleau {

namespace {

template <class Real>
TwoFluids<TrtRates<Real>> in_precision(const TwoFluids<TrtRates<>>& r) {
  const auto cast = [](const TrtRates<>& s) { return TrtRates<Real>{Real(s.even), Real(s.odd)}; };
  return {cast(r.outside), cast(r.inside)};
}

template <class Real>
TwoFluids<MrtRates<Real>> in_precision(const TwoFluids<MrtRates<>>& r) {
  const auto cast = [](const MrtRates<>& s) {
    return MrtRates<Real>{Real(s.e), Real(s.eps), Real(s.q), Real(s.nu), Real(s.pi), Real(s.m)};
  };
  return {cast(r.outside), cast(r.inside)};
}

bool asked(std::span<const std::uint8_t> mask, std::size_t row) { return mask.empty() || mask[row] != 0; }

/// Points `row` at the nodes (., j, k).
template <class Real>
void place_row(Row<Real>& row, Fluid<Real>& fluid, int j, int k) {
  const std::ptrdiff_t node = fluid.f.layout.index(0, j, k);
  for (int q = 0; q < Q; ++q) {
    row.from[q] = fluid.f.direction(q) + node - fluid.f.offset(q);
    row.to[q] = fluid.f_next.direction(q) + node;
  }
  for (int a = 0; a < 3; ++a) {
    row.g[a] = &fluid.g[a](0, j, k);
    row.u[a] = &fluid.u[a](0, j, k);
  }
}

/// Whether the row has a node inside a cell; if so, sets the flags in the type of the populations: mixed with bytes,
/// the loop would be vectorised over 64 nodes at a time and run out of registers.
template <class Real>
bool load_flags(const std::uint8_t* flags, int size, Real* inside) {
  if (std::memchr(flags, 1, static_cast<std::size_t>(size)) == nullptr) return false;
  std::transform(flags, flags + size, inside, [](std::uint8_t flag) { return Real(flag); });
  return true;
}

}  // namespace

template <class Real>
void collide_and_stream(Fluid<Real>& fluid, const Collision& collision, const Field<std::uint8_t>& inside,
                        const Vec3& body_force, const RowMasks& masks) {
  const Int3 size = fluid.block.size;
  Row<Real> row;
  row.size = size[0];
  row.body_force = {Real(body_force[0]), Real(body_force[1]), Real(body_force[2])};
  row.inside = fluid.inside_row.data();
  std::visit(
      [&](const auto& law) {
        const auto rates = in_precision<Real>(law);
        std::size_t r = 0;
        for (int k = 0; k < size[2]; ++k)
          for (int j = 0; j < size[1]; ++j, ++r) {
            place_row(row, fluid, j, k);
            const bool has_inside = load_flags(&inside(0, j, k), size[0], fluid.inside_row.data());
            step_row(row, {asked(masks.has_force, r), asked(masks.wants_velocity, r), has_inside}, rates);
          }
      },
      collision);
  std::swap(fluid.f, fluid.f_next);
}

template void collide_and_stream(Fluid<float>&, const Collision&, const Field<std::uint8_t>&, const Vec3&,
                                 const RowMasks&);
template void collide_and_stream(Fluid<double>&, const Collision&, const Field<std::uint8_t>&, const Vec3&,
                                 const RowMasks&);

}  // namespace rouleau
