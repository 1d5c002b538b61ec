// SPDX-License-Identifier: BSD-3-Clause
#include "series.hpp"

#include <algorithm>
#include <cmath>

namespace rouleau::speed {

Spread spread_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at_fraction = [&](double fraction) {
    const double place = fraction * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - static_cast<double>(below));
  };
  return {at_fraction(0.5), at_fraction(0.25), at_fraction(0.75), values.front(), values.back(), values.size()};
}

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double log_x = std::log(x[i]), log_y = std::log(y[i]);
    sum_x += log_x;
    sum_y += log_y;
    sum_xx += log_x * log_x;
    sum_xy += log_x * log_y;
  }
  return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

void Series::derive(const std::string& name, const std::vector<std::string>& sources,
                    const std::function<double(const std::vector<double>&)>& formula) {
  std::size_t rounds = std::size_t(-1);
  for (const std::string& source : sources) {
    if (!has(source)) return;
    rounds = std::min(rounds, values_.at(source).size());
  }
  for (std::size_t round = 0; round < rounds; ++round) {
    std::vector<double> arguments;
    for (const std::string& source : sources) arguments.push_back(values_.at(source)[round]);
    add(name, formula(arguments));
  }
}

void Series::derive_ratio(const std::string& name, const std::string& numerator, const std::string& denominator) {
  derive(name, {numerator, denominator}, [](const std::vector<double>& v) { return v[0] / v[1]; });
}

}  // namespace rouleau::speed
