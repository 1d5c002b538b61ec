// SPDX-License-Identifier: BSD-3-Clause
// Figures measured round after round, and what is said of them: median and spread.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace rouleau::speed {

struct Spread {
  double median = 0;
  double lower_quartile = 0, upper_quartile = 0;
  double min = 0, max = 0;
  std::size_t count = 0;
  /// Distance of the quartiles over the median.
  [[nodiscard]] double relative() const { return (upper_quartile - lower_quartile) / median; }
};

/// Quartiles between two values are interpolated. `values` must not be empty.
Spread spread_of(std::vector<double> values);

/// Slope of the straight line of least squares through (log x, log y).
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

/// The values of each figure, one a round.
class Series {
 public:
  void add(const std::string& name, double value) { values_[name].push_back(value); }
  [[nodiscard]] bool has(const std::string& name) const { return values_.contains(name); }
  [[nodiscard]] double median(const std::string& name) const { return spread_of(values_.at(name)).median; }
  [[nodiscard]] const std::map<std::string, std::vector<double>>& all() const { return values_; }

  /// Adds a figure made from others, round by round: what disturbed a round disturbs both sides of a ratio.
  /// Does nothing if one of `sources` was not measured.
  void derive(const std::string& name, const std::vector<std::string>& sources,
              const std::function<double(const std::vector<double>&)>& formula);
  void derive_ratio(const std::string& name, const std::string& numerator, const std::string& denominator);

 private:
  std::map<std::string, std::vector<double>> values_;
};

}  // namespace rouleau::speed
