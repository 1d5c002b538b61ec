// SPDX-License-Identifier: BSD-3-Clause
// The elastic forces of all membranes: Skalak in the plane, Helfrich out of it.
#include "membrane/membrane_forces.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "membrane/bending.hpp"
#include "membrane/ordered_sum.hpp"
#include "membrane/skalak.hpp"
#include "membrane/v3.hpp"

/// Before a loop over triangles: its iterations are independent. Not `omp simd`, which makes g++ 12 keep the laws'
/// structs as arrays over the lanes, and then not vectorise.
#define TRIANGLE_LOOP _Pragma("GCC ivdep")

namespace rouleau {
namespace {

constexpr std::int32_t padded(std::int32_t n) {
  return (n + VertexGather::width - 1) / VertexGather::width * VertexGather::width;
}

/// The triangles as plain pointers, and their edges u = b - a, v = c - a.
struct TriangleEdges {
  const std::int32_t *a, *b, *c;
  ConstV3s X;
  TriangleEdges(const Triangles& triangles, const VectorArray& positions)
      : a(triangles.a.data()), b(triangles.b.data()), c(triangles.c.data()), X(positions) {}
  [[nodiscard]] V3 u(std::ptrdiff_t t) const { return X[b[t]] - X[a[t]]; }
  [[nodiscard]] V3 v(std::ptrdiff_t t) const { return X[c[t]] - X[a[t]]; }
};

/// One corner's part of three corner arrays.
struct CornerV3s {
  double *x, *y, *z;
  CornerV3s(std::array<Array<double>, 3>& arrays, std::ptrdiff_t offset)
      : x(arrays[0].data() + offset), y(arrays[1].data() + offset), z(arrays[2].data() + offset) {}
  void set(std::ptrdiff_t t, V3 value) const {
    x[t] = value.x;
    y[t] = value.y;
    z[t] = value.z;
  }
  void add(std::ptrdiff_t t, V3 value) const {
    x[t] += value.x;
    y[t] += value.y;
    z[t] += value.z;
  }
};

}  // namespace

MembraneForces::MembraneForces(const Cells& cells)
    : triangles_(static_cast<std::int32_t>(cells.triangles.size())),
      corner_stride_(padded(triangles_)),
      gather_(cells.around, corner_stride_, 3 * corner_stride_),
      work_(cells) {
  const auto triangles = static_cast<std::size_t>(triangles_);
  for (auto* array : {&reference_.G11, &reference_.G12, &reference_.G22, &reference_.inverse_det, &reference_.area}) {
    array->resize(triangles);
  }
  const TriangleEdges edges(cells.triangles, cells.X_reference);
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto index = static_cast<std::ptrdiff_t>(t);
    const ReferenceMetric G = reference_metric(edges.u(index), edges.v(index));
    if (!(G.area > 0) || !std::isfinite(G.inverse_det)) {
      fail(Exit::bad_input, "membrane: triangle {} of the reference shape has the area {}; mend the mesh.", t, G.area);
    }
    reference_.G11[t] = G.G11;
    reference_.G12[t] = G.G12;
    reference_.G22[t] = G.G22;
    reference_.inverse_det[t] = G.inverse_det;
    reference_.area[t] = G.area;
  }
  const auto corner_values = static_cast<std::size_t>(3 * corner_stride_ + 1);
  for (CornerArray& array : force_) array.assign(corner_values, 0.0);
  for (CornerArray& array : laplacian_) array.assign(corner_values, 0.0);
  area_.assign(corner_values, 0.0);
  p_.resize(static_cast<std::size_t>(gather_.blocks()) * VertexGather::width);
  s_.resize(p_.size());
}

std::int32_t MembraneForces::block_end(std::int32_t triangle_block) const {
  return std::min((triangle_block + 1) * WorkBlocks::triangles_per_block, triangles_);
}

void MembraneForces::compute(Cells& cells, const Moduli& moduli, std::span<const std::uint8_t> needed) {
  constexpr std::int32_t block_size = WorkBlocks::triangles_per_block;
  work_.select(needed);
  for (const std::int32_t block : work_.force_triangles()) stretch(cells, moduli, block * block_size, block_end(block));
  if (moduli.kappa_B != 0) {
    for (const std::int32_t block : work_.curvature_triangles()) {
      weigh_corners(cells, block * block_size, block_end(block));
    }
    for (const std::int32_t block : work_.curvature_vertices()) sum_curvature(block);
    for (const std::int32_t block : work_.force_triangles()) {
      add_bending(cells, moduli.kappa_B, block * block_size, block_end(block));
    }
  }
  for (const std::int32_t block : work_.force_vertices()) sum_forces(cells, block);
}

/// Sets the corners' forces to those of the Skalak law.
void MembraneForces::stretch(const Cells& cells, const Moduli& moduli, std::int32_t begin, std::int32_t end) {
  const TriangleEdges edges(cells.triangles, cells.X);
  const double *G11 = reference_.G11.data(), *G12 = reference_.G12.data(), *G22 = reference_.G22.data();
  const double *inverse_det = reference_.inverse_det.data(), *reference_area = reference_.area.data();
  const double kappa_S = moduli.kappa_S, kappa_A = moduli.kappa_A;
  const CornerV3s F_a(force_, 0), F_b(force_, corner_stride_), F_c(force_, 2 * corner_stride_);
  TRIANGLE_LOOP
  for (std::int32_t t = begin; t < end; ++t) {
    const ReferenceMetric G{G11[t], G12[t], G22[t], inverse_det[t], reference_area[t]};
    const CornerForces F = skalak_forces(edges.u(t), edges.v(t), G, kappa_S, kappa_A);
    F_a.set(t, -(F.b + F.c));
    F_b.set(t, F.b);
    F_c.set(t, F.c);
  }
}

/// Sets what each triangle adds to L and A of its corners.
void MembraneForces::weigh_corners(const Cells& cells, std::int32_t begin, std::int32_t end) {
  const TriangleEdges edges(cells.triangles, cells.X);
  const CornerV3s L_a(laplacian_, 0), L_b(laplacian_, corner_stride_), L_c(laplacian_, 2 * corner_stride_);
  double *A_a = area_.data(), *A_b = A_a + corner_stride_, *A_c = A_b + corner_stride_;
  TRIANGLE_LOOP
  for (std::int32_t t = begin; t < end; ++t) {
    const CornerCurvatures c = corner_curvatures(edges.u(t), edges.v(t));
    L_a.set(t, c.L_a);
    L_b.set(t, c.L_b);
    L_c.set(t, c.L_c);
    A_a[t] = c.A_a;
    A_b[t] = c.A_b;
    A_c[t] = c.A_c;
  }
}

/// Sets p and s of a block of vertices.
void MembraneForces::sum_curvature(std::int32_t vertex_block) {
  const auto sums =
      gather_.sum<4>(vertex_block, {laplacian_[0].data(), laplacian_[1].data(), laplacian_[2].data(), area_.data()});
  const std::ptrdiff_t first = std::ptrdiff_t{vertex_block} * VertexGather::width;
  double *x = p_.x.data() + first, *y = p_.y.data() + first, *z = p_.z.data() + first, *s = s_.data() + first;
  TRIANGLE_LOOP
  for (int l = 0; l < VertexGather::width; ++l) {
    const VertexCurvature vertex = vertex_curvature({sums[0][l], sums[1][l], sums[2][l]}, sums[3][l]);
    x[l] = vertex.p.x;
    y[l] = vertex.p.y;
    z[l] = vertex.p.z;
    s[l] = vertex.s;
  }
}

/// Adds the bending forces to those of the corners.
void MembraneForces::add_bending(const Cells& cells, double kappa_B, std::int32_t begin, std::int32_t end) {
  const TriangleEdges edges(cells.triangles, cells.X);
  const CornerV3s F_a(force_, 0), F_b(force_, corner_stride_), F_c(force_, 2 * corner_stride_);
  const ConstV3s p(p_);
  const double* s = s_.data();
  TRIANGLE_LOOP
  for (std::int32_t t = begin; t < end; ++t) {
    const std::int32_t a = edges.a[t], b = edges.b[t], c = edges.c[t];
    const CornerForces F = bending_forces(edges.u(t), edges.v(t), {p[a], s[a]}, {p[b], s[b]}, {p[c], s[c]}, kappa_B);
    F_a.add(t, -(F.b + F.c));
    F_b.add(t, F.b);
    F_c.add(t, F.c);
  }
}

/// Sets cells.F of a block of vertices.
void MembraneForces::sum_forces(Cells& cells, std::int32_t vertex_block) const {
  const auto sums = gather_.sum<3>(vertex_block, {force_[0].data(), force_[1].data(), force_[2].data()});
  const std::size_t first = static_cast<std::size_t>(vertex_block) * VertexGather::width;
  const std::size_t lanes = std::min<std::size_t>(VertexGather::width, cells.vertices() - first);
  std::copy_n(sums[0].begin(), lanes, cells.F.x.begin() + static_cast<std::ptrdiff_t>(first));
  std::copy_n(sums[1].begin(), lanes, cells.F.y.begin() + static_cast<std::ptrdiff_t>(first));
  std::copy_n(sums[2].begin(), lanes, cells.F.z.begin() + static_cast<std::ptrdiff_t>(first));
}

MembraneEnergy MembraneForces::energy(const Cells& cells, const Moduli& moduli) {
  const TriangleEdges edges(cells.triangles, cells.X);
  MembraneEnergy energy;
  energy.skalak = ordered_sum(0, triangles_, [&](std::ptrdiff_t t) {
    const ReferenceMetric G{reference_.G11[t], reference_.G12[t], reference_.G22[t], reference_.inverse_det[t],
                            reference_.area[t]};
    return skalak_energy(edges.u(t), edges.v(t), G, moduli.kappa_S, moduli.kappa_A);
  });
  weigh_corners(cells, 0, triangles_);
  for (std::int32_t block = 0; block < gather_.blocks(); ++block) {
    const auto sums =
        gather_.sum<4>(block, {laplacian_[0].data(), laplacian_[1].data(), laplacian_[2].data(), area_.data()});
    const std::size_t first = static_cast<std::size_t>(block) * VertexGather::width;
    for (std::size_t l = 0; l < VertexGather::width && first + l < cells.vertices(); ++l) {
      s_[first + l] = bending_energy({sums[0][l], sums[1][l], sums[2][l]}, sums[3][l], moduli.kappa_B);
    }
  }
  energy.bending =
      ordered_sum(0, static_cast<std::ptrdiff_t>(cells.vertices()), [&](std::ptrdiff_t v) { return s_[v]; });
  return energy;
}

}  // namespace rouleau
