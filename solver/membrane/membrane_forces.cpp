// SPDX-License-Identifier: BSD-3-Clause
// The elastic forces of all membranes: Skalak or neo-Hookean in the plane, Helfrich out of it.
#include "membrane/membrane_forces.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "membrane/bending.hpp"
#include "membrane/neo_hookean.hpp"
#include "membrane/ordered_sum.hpp"
#include "membrane/skalak.hpp"
#include "membrane/v3.hpp"

/// Before a loop over the triangles or vertices of a block: its iterations are independent. Not `omp simd`, which makes
/// g++ 12 keep the laws' structs as arrays over the lanes, and then not vectorise.
#define BLOCK_LOOP _Pragma("GCC ivdep")

namespace rouleau {
namespace {

constexpr int block_size = PackedRows::size;
static_assert(block_size == WorkBlocks::size);

constexpr std::size_t padded(std::size_t n) { return (n + block_size - 1) / block_size * block_size; }

/// The laws in the plane, each with its moduli.
struct Skalak {
  double kappa_S, kappa_A;
  [[nodiscard]] double energy(const Metric& g, const ReferenceMetric& G) const {
    return skalak_energy(g, G, kappa_S, kappa_A);
  }
  [[nodiscard]] MetricGradient gradient(const Metric& g, const ReferenceMetric& G) const {
    return skalak_gradient(g, G, kappa_S, kappa_A);
  }
};
struct NeoHookean {
  double kappa_S;
  [[nodiscard]] double energy(const Metric& g, const ReferenceMetric& G) const {
    return neo_hookean_energy(g, G, kappa_S);
  }
  [[nodiscard]] MetricGradient gradient(const Metric& g, const ReferenceMetric& G) const {
    return neo_hookean_gradient(g, G, kappa_S);
  }
};

/// Calls `use` with the law of these moduli: once for a whole membrane, never for a triangle.
template <class Use>
auto with_law(const Moduli& moduli, Use&& use) {
  if (moduli.law == InPlaneLaw::neo_hookean) return use(NeoHookean{moduli.kappa_S});
  return use(Skalak{moduli.kappa_S, moduli.kappa_A});
}

/// The corners of a block of triangles.
struct BlockCorners {
  const std::int32_t *a, *b, *c;
  BlockCorners(const std::array<Array<std::int32_t>, 3>& corner, std::int32_t block)
      : a(corner[0].data() + block * block_size),
        b(corner[1].data() + block * block_size),
        c(corner[2].data() + block * block_size) {}
};

V3 vector(const PackedRows& rows, int i) { return {rows.x[i], rows.y[i], rows.z[i]}; }

void set(PackedRows& rows, int i, V3 vector, double scalar) {
  rows.x[i] = vector.x;
  rows.y[i] = vector.y;
  rows.z[i] = vector.z;
  rows.w[i] = scalar;
}

/// Sets the edges u = b - a and v = c - a of a block of triangles.
void gather_edges(const Packed* X, const BlockCorners& corners, PackedRows& u, PackedRows& v) {
  const auto [a, b, c] = corners;
  for (int t = 0; t < block_size; t += 4) {
    const Packed X_0 = X[a[t]], X_1 = X[a[t + 1]], X_2 = X[a[t + 2]], X_3 = X[a[t + 3]];
    set_rows(u, t, X[b[t]] - X_0, X[b[t + 1]] - X_1, X[b[t + 2]] - X_2, X[b[t + 3]] - X_3);
    set_rows(v, t, X[c[t]] - X_0, X[c[t + 1]] - X_1, X[c[t + 2]] - X_2, X[c[t + 3]] - X_3);
  }
}

void gather(const Packed* values, const std::int32_t* vertex, PackedRows& rows) {
  for (int t = 0; t < block_size; t += 4) {
    set_rows(rows, t, values[vertex[t]], values[vertex[t + 1]], values[vertex[t + 2]], values[vertex[t + 3]]);
  }
}

/// Adds the corners' values to those of their vertices, triangle after triangle: blocks in ascending order give each
/// vertex the same order of additions, whichever blocks are left out for other vertices.
void scatter(const PackedRows& at_a, const PackedRows& at_b, const PackedRows& at_c, const BlockCorners& corners,
             Packed* sums) {
  for (int t = 0; t < block_size; t += 4) {
    Packed a[4], b[4], c[4];
    get_rows(at_a, t, a[0], a[1], a[2], a[3]);
    get_rows(at_b, t, b[0], b[1], b[2], b[3]);
    get_rows(at_c, t, c[0], c[1], c[2], c[3]);
    for (int k = 0; k < 4; ++k) {
      sums[corners.a[t + k]] += a[k];
      sums[corners.b[t + k]] += b[k];
      sums[corners.c[t + k]] += c[k];
    }
  }
}

}  // namespace

MembraneForces::MembraneForces(const Cells& cells)
    : work_(cells), triangles_(static_cast<std::int32_t>(cells.triangles.size())) {
  const auto vertices = static_cast<std::int32_t>(cells.vertices());
  corner_ = {cells.triangles.a, cells.triangles.b, cells.triangles.c};
  for (std::int32_t k = 0; k < 3; ++k) corner_[k].resize(padded(cells.triangles.size()), vertices + k);
  for (Array<Packed>* array : {&X_, &curvature_, &F_}) array->assign(padded(cells.vertices() + 3), Packed{});
  X_[vertices + 1] = Packed{1, 0, 0, 0};  // the triangles that fill the last block have an area
  X_[vertices + 2] = Packed{0, 1, 0, 0};

  const ConstV3s X(cells.X_reference);
  const std::size_t triangles = padded(cells.triangles.size());
  for (auto* array : {&reference_.G11, &reference_.G12, &reference_.G22, &reference_.inverse_det, &reference_.area}) {
    array->resize(triangles, 1.0);
  }
  for (std::int32_t t = 0; t < triangles_; ++t) {
    const V3 a = X[corner_[0][t]];
    const ReferenceMetric reference = reference_metric(metric(X[corner_[1][t]] - a, X[corner_[2][t]] - a));
    if (!(reference.area > 0) || !std::isfinite(reference.inverse_det)) {
      fail(Exit::bad_input, "membrane: triangle {} of the reference shape has the area {}; mend the mesh.", t,
           reference.area);
    }
    reference_.G11[t] = reference.G.g11;
    reference_.G12[t] = reference.G.g12;
    reference_.G22[t] = reference.G.g22;
    reference_.inverse_det[t] = reference.inverse_det;
    reference_.area[t] = reference.area;
  }
}

void MembraneForces::compute(Cells& cells, const Moduli& moduli, std::span<const std::uint8_t> needed) {
  work_.select(needed);
  pack_positions(cells);
  std::fill(curvature_.begin(), curvature_.end(), Packed{});
  for (const std::int32_t block : work_.curvature_triangles()) add_curvatures(block);
  for (const std::int32_t block : work_.curvature_vertices()) divide_by_areas(block, moduli.kappa_B);
  std::fill(F_.begin(), F_.end(), Packed{});
  with_law(moduli, [&](const auto& law) {
    for (const std::int32_t block : work_.force_triangles()) add_forces(block, law);
  });
  for (const std::int32_t block : work_.force_vertices()) unpack_forces(cells, block);
}

void MembraneForces::pack_positions(const Cells& cells) {
  for (std::size_t v = 0; v < cells.vertices(); ++v) X_[v] = packed(cells.X, v);
}

/// Adds what a block of triangles gives to L and A of its corners.
void MembraneForces::add_curvatures(std::int32_t triangle_block) {
  const BlockCorners corners(corner_, triangle_block);
  PackedRows u, v, at_a, at_b, at_c;
  gather_edges(X_.data(), corners, u, v);
  BLOCK_LOOP
  for (int t = 0; t < block_size; ++t) {
    const CornerCurvatures c = corner_curvatures(vector(u, t), vector(v, t));
    set(at_a, t, c.L_a, c.A_a);
    set(at_b, t, c.L_b, c.A_b);
    set(at_c, t, c.L_c, c.A_c);
  }
  scatter(at_a, at_b, at_c, corners, curvature_.data());
}

/// Replaces L and A of a block of vertices by P and S.
void MembraneForces::divide_by_areas(std::int32_t vertex_block, double kappa_B) {
  Packed* curvature = curvature_.data() + vertex_block * block_size;
  PackedRows rows;
  for (int i = 0; i < block_size; i += 4) {
    set_rows(rows, i, curvature[i], curvature[i + 1], curvature[i + 2], curvature[i + 3]);
  }
  BLOCK_LOOP
  for (int i = 0; i < block_size; ++i) {
    const VertexCurvature vertex = vertex_curvature(vector(rows, i), rows.w[i], kappa_B);
    set(rows, i, vertex.P, vertex.S);
  }
  for (int i = 0; i < block_size; i += 4) {
    get_rows(rows, i, curvature[i], curvature[i + 1], curvature[i + 2], curvature[i + 3]);
  }
}

/// Adds the forces of a block of triangles to those of their corners.
template <class Law>
void MembraneForces::add_forces(std::int32_t triangle_block, const Law& law_of_all) {
  const BlockCorners corners(corner_, triangle_block);
  PackedRows u, v, at_a, at_b, at_c;
  gather_edges(X_.data(), corners, u, v);
  gather(curvature_.data(), corners.a, at_a);
  gather(curvature_.data(), corners.b, at_b);
  gather(curvature_.data(), corners.c, at_c);
  const std::int32_t first = triangle_block * block_size;
  const double *G11 = reference_.G11.data() + first, *G12 = reference_.G12.data() + first;
  const double *G22 = reference_.G22.data() + first, *inverse_det = reference_.inverse_det.data() + first;
  const double* area = reference_.area.data() + first;
  const Law law = law_of_all;  // a copy, which no store of the loop can change
  BLOCK_LOOP
  for (int t = 0; t < block_size; ++t) {
    const V3 u_t = vector(u, t), v_t = vector(v, t);
    const Metric g = metric(u_t, v_t);
    const ReferenceMetric reference{{G11[t], G12[t], G22[t]}, inverse_det[t], area[t]};
    const BendingGradient bending = bending_gradient(g, u_t, v_t, {vector(at_a, t), at_a.w[t]},
                                                     {vector(at_b, t), at_b.w[t]}, {vector(at_c, t), at_c.w[t]});
    const CornerForces in_plane = metric_forces(law.gradient(g, reference) + bending.by_metric, u_t, v_t);
    const V3 F_b = in_plane.b - bending.by_u, F_c = in_plane.c - bending.by_v;
    set(at_a, t, -(F_b + F_c), 0);
    set(at_b, t, F_b, 0);
    set(at_c, t, F_c, 0);
  }
  scatter(at_a, at_b, at_c, corners, F_.data());
}

/// Sets cells.F of a block of vertices.
void MembraneForces::unpack_forces(Cells& cells, std::int32_t vertex_block) const {
  const std::size_t first = static_cast<std::size_t>(vertex_block) * block_size;
  const std::size_t last = std::min(first + block_size, cells.vertices());
  for (std::size_t v = first; v < last; ++v) {
    cells.F.x[v] = F_[v][0];
    cells.F.y[v] = F_[v][1];
    cells.F.z[v] = F_[v][2];
  }
}

MembraneEnergy MembraneForces::energy(const Cells& cells, const Moduli& moduli) {
  pack_positions(cells);
  std::fill(curvature_.begin(), curvature_.end(), Packed{});
  const auto blocks = static_cast<std::int32_t>(corner_[0].size()) / block_size;
  for (std::int32_t block = 0; block < blocks; ++block) add_curvatures(block);
  MembraneEnergy energy;
  energy.in_plane = with_law(moduli, [&](const auto& law) { return in_plane_energy(cells, law); });
  energy.bending = ordered_sum(0, static_cast<std::ptrdiff_t>(cells.vertices()), [&](std::ptrdiff_t v) {
    const Packed L_A = curvature_[static_cast<std::size_t>(v)];
    return bending_energy({L_A[0], L_A[1], L_A[2]}, L_A[3], moduli.kappa_B);
  });
  return energy;
}

template <class Law>
double MembraneForces::in_plane_energy(const Cells& cells, const Law& law) const {
  const ConstV3s X(cells.X);
  const auto &a = corner_[0], &b = corner_[1], &c = corner_[2];
  return ordered_sum(0, triangles_, [&](std::ptrdiff_t t) {
    const ReferenceMetric reference{
        {reference_.G11[t], reference_.G12[t], reference_.G22[t]}, reference_.inverse_det[t], reference_.area[t]};
    return law.energy(metric(X[b[t]] - X[a[t]], X[c[t]] - X[a[t]]), reference);
  });
}

}  // namespace rouleau
