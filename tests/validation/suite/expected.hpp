// SPDX-License-Identifier: BSD-3-Clause
// What a measured value is held against: a reference and how far from it is still right.
#pragma once

#include <string>

namespace rouleau::validation {

/// `ours` is right if |ours - reference| <= tolerance; never if it is not a number.
struct Expected {
  double reference = 0;
  double tolerance = 0;
  std::string text;  ///< the same for people: `2.0886 ± 0.2 %`

  [[nodiscard]] bool holds(double ours) const;
};

/// Within `tolerance` of the reference.
Expected near(double reference, double tolerance);
/// Within a share of the reference; 0.02 is 2 %.
Expected near_relative(double reference, double share);
/// From low to high, both included: reference and tolerance are the middle and half the width.
Expected between(double low, double high);
/// An error that should be zero: |ours| <= limit.
Expected at_most(double limit);

}  // namespace rouleau::validation
