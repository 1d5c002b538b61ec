// SPDX-License-Identifier: BSD-3-Clause
// Cells for the membrane tests: single ones, pairs, and deformed shapes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "membrane/assemble.hpp"
#include "membrane/shapes.hpp"

namespace rouleau::test {

inline Cells one_cell(const Surface& shape, const std::optional<Surface>& reference = std::nullopt) {
  const CellStart start{shape, reference};
  return assemble({&start, 1});
}

/// Stretched, sheared, bent and rough: strains up to about 0.3, edges turned by tens of degrees.
inline Surface strongly_deformed(const Surface& shape, double roughness, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-roughness, roughness);
  Surface result = shape;
  double size = 0;
  for (std::size_t v = 0; v < shape.X.size(); ++v) size = std::max(size, at(shape.X, v).norm());
  for (std::size_t v = 0; v < shape.X.size(); ++v) {
    const Vec3 x = at(shape.X, v) / size;
    const Vec3 bent{1.2 * x[0] + 0.3 * x[2], 0.8 * x[1] + 0.15 * std::sin(2 * x[0]), 1.1 * x[2] + 0.4 * x[0] * x[0]};
    set(result.X, v, size * (bent + Vec3(noise(random), noise(random), noise(random))));
  }
  return result;
}

inline Vec3 total(const VectorArray& values) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < values.size(); ++v) sum += at(values, v);
  return sum;
}

/// Square root of the sum of squares over all vertices.
inline double norm(const VectorArray& values) {
  double sum = 0;
  for (std::size_t v = 0; v < values.size(); ++v) sum += at(values, v).squaredNorm();
  return std::sqrt(sum);
}

/// -dE/dX by fourth-order central differences with the step h, one vertex and axis at a time.
template <class Energy>
VectorArray numerical_force(Cells& cells, double h, Energy&& energy) {
  VectorArray force(cells.vertices());
  for (auto [x, f] :
       {std::pair(&cells.X.x, &force.x), std::pair(&cells.X.y, &force.y), std::pair(&cells.X.z, &force.z)}) {
    for (std::size_t v = 0; v < cells.vertices(); ++v) {
      const double start = (*x)[v];
      const auto energy_at = [&](double shift) {
        (*x)[v] = start + shift;
        return energy();
      };
      const double near = energy_at(h) - energy_at(-h), far = energy_at(2 * h) - energy_at(-2 * h);
      (*f)[v] = -(8 * near - far) / (12 * h);
      (*x)[v] = start;
    }
  }
  return force;
}

inline double relative_difference(const VectorArray& one, const VectorArray& other) {
  VectorArray difference(one.size());
  for (std::size_t v = 0; v < one.size(); ++v) set(difference, v, at(one, v) - at(other, v));
  return norm(difference) / norm(other);
}

}  // namespace rouleau::test
