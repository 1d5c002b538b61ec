// SPDX-License-Identifier: BSD-3-Clause
// Walks the rows of a block and hands each to the row loop in the variant it needs.
#include "fluid/collide.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "fluid/row.hpp"

namespace rouleau {

namespace {

template <class Real>
TwoFluids<TrtFactors<Real>> in_precision(const TwoFluids<TrtRates<>>& r) {
  return {factors_of<Real>(r.outside), factors_of<Real>(r.inside)};
}

template <class Real>
TwoFluids<MrtRates<Real>> in_precision(const TwoFluids<MrtRates<>>& r) {
  const auto cast = [](const MrtRates<>& s) {
    return MrtRates<Real>{Real(s.e), Real(s.eps), Real(s.q), Real(s.nu), Real(s.pi), Real(s.m)};
  };
  return {cast(r.outside), cast(r.inside)};
}

/// The rows of all directions, found for one (j, k) at a time: 19 searches side by side in vector registers.
template <class Real>
class RowsOfDirections {
 public:
  explicit RowsOfDirections(Populations<Real>& f) : all_(f.rows(0)) {
    for (int q = 0; q < Q; ++q) {
      first_[q] = f.rows(q).first;
      turn_[q] = f.rows(q).turn;
    }
  }
  [[nodiscard]] std::array<Real*, Q> at(int j, int k) const {
    const std::ptrdiff_t row = (j + all_.halo) + std::ptrdiff_t{k + all_.halo} * all_.size_y;
    std::array<Real*, Q> f;
    ROW_LOOP
    for (std::size_t q = 0; q < Q; ++q) {
      const std::ptrdiff_t turned = row + turn_[q];
      f[q] = first_[q] + (turned >= all_.count ? turned - all_.count : turned) * all_.stride;
    }
    return f;
  }

 private:
  Rows<Real> all_;  ///< what they have in common
  std::array<Real*, Q> first_;
  std::array<std::ptrdiff_t, Q> turn_;
};

/// What streams into both ends of a row, from the halo, or from the other end if the row closes in itself: sets the
/// node beyond the east end, returns what comes from the west.
template <class Real>
WestPacks<Real> stream_in(const Row<Real>& row, int size, bool closes) {
  WestPacks<Real> west;
  for (std::size_t e = 0; e < eastward.size(); ++e)
    west[e] = broadcast<Pack<Real>>(row.f[eastward[e]][closes ? size - 1 : -1]);
  if (closes)
    for (const int q : westward) row.f[q][size] = row.f[q][0];
  return west;
}

/// Whether some of the nodes are inside a cell; if so, sets their flags in the type of the populations.
template <class Real>
bool load_flags(const std::uint8_t* flags, Run run, Real* inside) {
  const auto* const begin = flags + run.begin;
  if (std::memchr(begin, 1, static_cast<std::size_t>(run.end - run.begin)) == nullptr) return false;
  std::transform(begin, flags + run.end, inside + run.begin, [](std::uint8_t flag) { return Real(flag); });
  return true;
}

/// The runs of a row before, within and behind the segments that membranes touch.
std::array<Run, 3> runs_of(unsigned segments, int shift, int size) {
  if (segments == 0) return {{{0, size}, {size, size}, {size, size}}};
  const int begin = std::min(size, std::countr_zero(segments) << shift);
  const int end = std::min(size, (8 - std::countl_zero(static_cast<std::uint8_t>(segments))) << shift);
  return {{{0, begin}, {begin, end}, {end, size}}};
}

}  // namespace

template <class Real>
void collide_and_stream(Fluid<Real>& fluid, const Collision& collision, const Field<std::uint8_t>& inside,
                        const Vec3& body_force, const MembraneRows& membranes) {
  const Int3 size = fluid.block.size;
  fluid.f.advance();  // now f_q of the row (j, k) is what streams there, before the collision and after it
  const RowsOfDirections<Real> rows(fluid.f);
  Row<Real> row;
  row.body_force = {Real(body_force[0]), Real(body_force[1]), Real(body_force[2])};
  row.inside = fluid.inside_row.data();
  const auto step_rows = [&](const auto& rates) {
    std::size_t r = 0;
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j, ++r) {
        row.f = rows.at(j, k);
        for (int a = 0; a < 3; ++a) {
          row.g[a] = &fluid.g[a](0, j, k);
          row.u[a] = &fluid.u[a](0, j, k);
        }
        WestPacks<Real> west = stream_in(row, size[0], fluid.closes_x());
        const std::uint8_t* const flags = &inside(0, j, k);
        const unsigned segments = membranes.segments.empty() ? 0xff : membranes.segments[r];
        const std::array<Run, 3> runs = runs_of(segments, membranes.segment_shift, size[0]);
        for (std::size_t p = 0; p < runs.size(); ++p) {
          if (runs[p].begin == runs[p].end) continue;
          const bool has_inside = load_flags(flags, runs[p], fluid.inside_row.data());
          step_row(row, runs[p], {p == 1, has_inside}, rates, west);
        }
      }
  };
  std::visit([&](const auto& law) { step_rows(in_precision<Real>(law)); }, collision);
}

template void collide_and_stream(Fluid<float>&, const Collision&, const Field<std::uint8_t>&, const Vec3&,
                                 const MembraneRows&);
template void collide_and_stream(Fluid<double>&, const Collision&, const Field<std::uint8_t>&, const Vec3&,
                                 const MembraneRows&);

}  // namespace rouleau
