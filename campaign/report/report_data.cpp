// SPDX-License-Identifier: BSD-3-Clause
// Rows of the database -> points with thinned series.
#include "report/report_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "report/columns.hpp"
#include "report/parameter_words.hpp"
#include "report/thin.hpp"

namespace rouleau::campaign {
namespace {

double number(const std::optional<double>& value) { return value.value_or(std::numeric_limits<double>::quiet_NaN()); }

Curve curve_of(const std::vector<SampleRow>& samples, int cell, std::size_t most) {
  Curve all{cell, {}, {}, {}};
  for (const SampleRow& sample : samples) {
    if (sample.cell != cell) continue;
    all.time_s.push_back(sample.time_s);
    all.d_um.push_back(number(sample.d_um));
    all.asphericity.push_back(number(sample.asphericity));
  }
  // One choice for both measures, half of it by the peaks of each.
  std::set<std::size_t> kept;
  const std::size_t share = all.time_s.size() > most ? most / 2 : all.time_s.size();
  for (const std::size_t i : thinned(all.d_um, share)) kept.insert(i);
  for (const std::size_t i : thinned(all.asphericity, share)) kept.insert(i);
  Curve curve{cell, {}, {}, {}};
  for (const std::size_t i : kept) {
    curve.time_s.push_back(all.time_s[i]);
    curve.d_um.push_back(all.d_um[i]);
    curve.asphericity.push_back(all.asphericity[i]);
  }
  return curve;
}

std::vector<Curve> curves_of(const std::vector<SampleRow>& samples, std::size_t most) {
  std::set<int> cells;
  for (const SampleRow& sample : samples) cells.insert(sample.cell);
  std::vector<Curve> curves;
  for (const int cell : cells) curves.push_back(curve_of(samples, cell, most));
  return curves;
}

/// λ of every point that has one, by key.
std::map<std::string, double> lambdas(const Store& store) {
  std::map<std::string, double> found;
  for (const std::vector<Value>& row : store.database().select("SELECT key, lambda FROM v_points").rows) {
    if (const double* lambda = std::get_if<double>(&row[1])) found[std::get<std::string>(row[0])] = *lambda;
  }
  return found;
}

bool is_before(const ReportData& data, const std::vector<std::string>& axes, const ReportPoint& a,
               const ReportPoint& b) {
  for (const std::string& axis : axes) {
    const double left = *data.value(a, axis), right = *data.value(b, axis);
    if (left != right) return left < right;
  }
  return a.row.ordinal < b.row.ordinal;
}

}  // namespace

std::string ReportPoint::label() const {
  std::string text;
  for (const ParameterRow& parameter : swept)
    text += (text.empty() ? "" : ", ") + parameter_words(parameter.name, parameter.text);
  return text.empty() ? row.key : text;
}

double ReportPoint::fraction() const {
  std::int64_t newest = step.value_or(0);
  for (const AttemptRow& attempt : attempts) newest = std::max(newest, attempt.step.value_or(0));
  for (const ResultRow& cell : results) newest = std::max(newest, cell.step);
  if (row.end_step <= 0) return 0;
  return std::min(1.0, static_cast<double>(newest) / static_cast<double>(row.end_step));
}

std::optional<double> ReportData::value(const ReportPoint& point, const std::string& axis) {
  for (const ParameterRow& parameter : point.swept) {
    if (parameter.name == axis) return parameter.value;
  }
  return std::nullopt;
}

std::vector<std::string> ReportData::numeric_axes() const {
  std::vector<std::string> axes;
  for (const std::string& axis : swept) {
    const bool is_numeric = std::all_of(points.begin(), points.end(),
                                        [&](const ReportPoint& point) { return value(point, axis).has_value(); });
    if (is_numeric && !points.empty() && axis != "cell.replica") axes.push_back(axis);
  }
  std::stable_partition(axes.begin(), axes.end(), [](const std::string& axis) { return axis == "fluid.lambda"; });
  return axes;
}

bool ReportData::is_finished() const {
  return std::all_of(points.begin(), points.end(),
                     [](const ReportPoint& point) { return is_final(point.row.state) || !point.row.in_study; });
}

ReportData read_report(const Store& store, std::size_t most) {
  ReportData data;
  data.campaign = store.campaign();
  data.swept = Columns(store).swept();
  const std::map<std::string, double> lambda_of = lambdas(store);
  std::map<std::string, std::vector<ParameterRow>> swept = store.swept_parameters();
  for (const PointRow& row : store.points()) {
    ReportPoint point;
    point.row = row;
    point.swept = std::move(swept[row.key]);
    if (const auto found = lambda_of.find(row.key); found != lambda_of.end()) point.lambda = found->second;
    point.results = store.results(row.key);
    point.attempts = store.attempts(row.key);
    point.curves = curves_of(store.samples(row.key), most);
    data.points.push_back(std::move(point));
  }
  const std::vector<std::string> axes = data.numeric_axes();
  std::sort(data.points.begin(), data.points.end(),
            [&](const ReportPoint& a, const ReportPoint& b) { return is_before(data, axes, a, b); });
  data.written_unix_s = now_unix_s();
  return data;
}

}  // namespace rouleau::campaign
