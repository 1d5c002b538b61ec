// SPDX-License-Identifier: BSD-3-Clause
#include "speed/sphere_mesh.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "membrane/assemble.hpp"

namespace rouleau::speed {
namespace {

Cells cell_of(int frequency) {
  const std::vector<CellStart> starts{{red_blood_cell_of_frequency(frequency, 4, Vec3(1, 2, 3)), std::nullopt}};
  return assemble(starts);
}

TEST(CellOfFrequency, HasTwentyTrianglesAFrequencySquared) {
  for (const int frequency : {1, 3, 8, 16}) {  // the mesh checks itself: closed, oriented, no vertex twice
    const Cells cells = cell_of(frequency);
    EXPECT_EQ(cells.triangles.size(), static_cast<std::size_t>(20 * frequency * frequency));
    EXPECT_EQ(cells.vertices(), static_cast<std::size_t>(10 * frequency * frequency + 2));
  }
}

TEST(CellOfFrequency, ApproachesTheRedBloodCell) {
  constexpr double volume = 100.665, area = 140.301;  // of the smooth shape, R = 4 [Lehmann2020] Eqs. 14, 15
  const auto volume_error = [&](int frequency) { return std::abs(cell_of(frequency).ranges[0].volume_0 - volume); };
  EXPECT_LT(volume_error(20) / volume, 2e-3);
  EXPECT_LT(volume_error(20) / volume_error(10), 0.3);  // second order
  EXPECT_NEAR(cell_of(20).ranges[0].area_0, area, 2e-3 * area);
}

}  // namespace
}  // namespace rouleau::speed
