// SPDX-License-Identifier: BSD-3-Clause
#include "membrane/fold_resistance.hpp"

#include <cmath>

#include "membrane/ordered_sum.hpp"
#include "membrane/v3.hpp"

namespace rouleau {
namespace {

constexpr double c_0 = 0.5;

double dot3(Packed a, Packed b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Is cos theta below c_0? Without the square roots.
bool is_sharp(Packed N_left, Packed N_right) {
  const double d = dot3(N_left, N_right);
  return d < 0 || d * d < c_0 * c_0 * (N_left[3] * N_right[3]);
}

double cosine(Packed N_left, Packed N_right) { return dot3(N_left, N_right) / std::sqrt(N_left[3] * N_right[3]); }

/// The vertex of triangle t that is neither a nor b.
std::int32_t facing(const Triangles& triangles, std::int32_t t, std::int32_t a, std::int32_t b) {
  for (const std::int32_t v : {triangles.a[t], triangles.b[t]})
    if (v != a && v != b) return v;
  return triangles.c[t];
}

void subtract(VectorArray& F, std::int32_t v, Packed by) {
  F.x[v] -= by[0];
  F.y[v] -= by[1];
  F.z[v] -= by[2];
}

}  // namespace

FoldResistance::FoldResistance(const Cells& cells, double k_kappa_B)
    : k_kappa_B_(k_kappa_B),
      edges_(find_edges(cells.triangles, "cells")),
      left_corner_(edges_.size()),
      right_corner_(edges_.size()),
      X_(cells.vertices()),
      N_(cells.triangles.size()) {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    left_corner_[e] = facing(cells.triangles, edges_.left[e], edges_.a[e], edges_.b[e]);
    right_corner_[e] = facing(cells.triangles, edges_.right[e], edges_.a[e], edges_.b[e]);
  }
}

void FoldResistance::find_normals(const Cells& cells) {
  const auto &a = cells.triangles.a, &b = cells.triangles.b, &c = cells.triangles.c;
  for (std::size_t v = 0; v < X_.size(); ++v) X_[v] = packed(cells.X, v);
  for (std::size_t t = 0; t < N_.size(); ++t) {
    N_[t] = cross(X_[b[t]] - X_[a[t]], X_[c[t]] - X_[a[t]]);
    N_[t][3] = dot3(N_[t], N_[t]);
  }
}

void FoldResistance::add(Cells& cells) {
  if (k_kappa_B_ == 0) return;
  find_normals(cells);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Packed N_left = N_[edges_.left[e]], N_right = N_[edges_.right[e]];
    if (!is_sharp(N_left, N_right)) continue;
    const double c = cosine(N_left, N_right);
    const double dE_dc = -k_kappa_B_ * (c_0 - c) * (2 + c_0 + c) / ((1 + c) * (1 + c));
    // dc = (n_right - c n_left) . dN_left / |N_left| + the same with the sides exchanged.
    const double left = std::sqrt(N_left[3]), right = std::sqrt(N_right[3]);
    const Packed by_left = (dE_dc / left) * (N_right / right - (c / left) * N_left);
    const Packed by_right = (dE_dc / right) * (N_left / left - (c / right) * N_right);
    // N_left = (b - a) x (p - a), N_right = (a - b) x (q - b); the corners' gradients of G . N.
    const std::int32_t a = edges_.a[e], b = edges_.b[e], p = left_corner_[e], q = right_corner_[e];
    const Packed at_p = cross(by_left, X_[b] - X_[a]), at_q = cross(by_right, X_[a] - X_[b]);
    const Packed at_a = cross(X_[b] - X_[p], by_left) + cross(X_[q] - X_[b], by_right);
    subtract(cells.F, p, at_p);
    subtract(cells.F, q, at_q);
    subtract(cells.F, a, at_a);
    subtract(cells.F, b, -(at_p + at_q + at_a));
  }
}

double FoldResistance::energy(const Cells& cells) {
  find_normals(cells);
  return ordered_sum(0, static_cast<std::ptrdiff_t>(edges_.size()), [&](std::ptrdiff_t e) {
    const Packed N_left = N_[edges_.left[e]], N_right = N_[edges_.right[e]];
    if (!is_sharp(N_left, N_right)) return 0.0;
    const double c = cosine(N_left, N_right);
    return k_kappa_B_ * (c_0 - c) * (c_0 - c) / (1 + c);
  });
}

}  // namespace rouleau
