// SPDX-License-Identifier: BSD-3-Clause
// Lines, checks and columns of samples.csv.
#include "ingest/sample_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "study/whole_file.hpp"

namespace rouleau::campaign {
namespace {

constexpr std::int64_t tail_bytes = 4096;

/// A damaged line; the message says what is wrong with it.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class T>
using Measure = std::pair<std::string_view, std::optional<T> SampleRow::*>;

constexpr std::array<Measure<double>, 24> real_measures = {{
    {"d_um", &SampleRow::d_um},
    {"x_um", &SampleRow::x_um},
    {"y_um", &SampleRow::y_um},
    {"z_um", &SampleRow::z_um},
    {"asphericity", &SampleRow::asphericity},
    {"volume_ratio", &SampleRow::volume_ratio},
    {"area_ratio", &SampleRow::area_ratio},
    {"inclination_deg", &SampleRow::inclination_deg},
    {"inside_ratio", &SampleRow::inside_ratio},
    {"mean_velocity_mm_per_s", &SampleRow::mean_velocity_mm_per_s},
    {"pressure_gradient_Pa_per_m", &SampleRow::pressure_gradient_Pa_per_m},
    {"velocity_x_mm_per_s", &SampleRow::velocity_x_mm_per_s},
    {"taylor_deformation", &SampleRow::taylor_deformation},
    {"angle_xz_deg", &SampleRow::angle_xz_deg},
    {"angle_xy_deg", &SampleRow::angle_xy_deg},
    {"extent_x_um", &SampleRow::extent_x_um},
    {"extent_y_um", &SampleRow::extent_y_um},
    {"extent_z_um", &SampleRow::extent_z_um},
    {"marker_y_dx_um", &SampleRow::marker_y_dx_um},
    {"marker_y_dy_um", &SampleRow::marker_y_dy_um},
    {"marker_y_dz_um", &SampleRow::marker_y_dz_um},
    {"marker_z_dx_um", &SampleRow::marker_z_dx_um},
    {"marker_z_dy_um", &SampleRow::marker_z_dy_um},
    {"marker_z_dz_um", &SampleRow::marker_z_dz_um},
}};
constexpr std::array<Measure<std::int64_t>, 2> whole_measures = {{
    {"inside_nodes", &SampleRow::inside_nodes},
    {"flips", &SampleRow::flips},
}};

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    fields.push_back(line.substr(begin, comma == std::string_view::npos ? comma : comma - begin));
    if (comma == std::string_view::npos) return fields;
    begin = comma + 1;
  }
}

template <class T>
T number_of(std::string_view text) {
  T number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw Damage(fmt::format("`{}` is no number of its column", text));
  return number;
}

/// The columns of a log by name. Columns that we do not know are passed by: the contract allows more.
class Columns {
 public:
  explicit Columns(std::string_view header) : names_(fields_of(header)) {
    if (names_.back() != "check") throw Damage("the last column of the header is not `check`");
    step_ = require_column("step");
    time_ = require_column("time_s");
    cell_ = require_column("cell");
    require_column("d_um");
    require_column("asphericity");
    for (const auto& [name, measure] : real_measures)
      if (const std::size_t i = find(name); i < names_.size()) reals_.emplace_back(i, measure);
    for (const auto& [name, measure] : whole_measures)
      if (const std::size_t i = find(name); i < names_.size()) wholes_.emplace_back(i, measure);
  }

  [[nodiscard]] SampleRow row_of(std::string_view line) const {
    const std::size_t comma = line.rfind(',');
    if (comma == std::string_view::npos || digest_of(line.substr(0, comma)) != line.substr(comma + 1))
      throw Damage("its check does not match");
    const std::vector<std::string_view> fields = fields_of(line);
    if (fields.size() != names_.size())
      throw Damage(fmt::format("it has {} fields, the header has {}", fields.size(), names_.size()));
    SampleRow row;
    row.step = number_of<std::int64_t>(fields[step_]);
    row.cell = number_of<int>(fields[cell_]);
    row.time_s = number_of<double>(fields[time_]);
    if (row.step < 0 || row.cell < 0 || !std::isfinite(row.time_s))
      throw Damage(fmt::format("step {}, cell {}, time {} s cannot be", row.step, row.cell, row.time_s));
    for (const auto& [i, measure] : reals_) {
      const double value = number_of<double>(fields[i]);
      if (std::isfinite(value))
        row.*measure = value;
      else
        row.finite = false;
    }
    for (const auto& [i, measure] : wholes_) row.*measure = number_of<std::int64_t>(fields[i]);
    return row;
  }

 private:
  [[nodiscard]] std::size_t find(std::string_view name) const {
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }
  std::size_t require_column(std::string_view name) const {
    const std::size_t i = find(name);
    if (i == names_.size()) throw Damage(fmt::format("the header has no column `{}`", name));
    return i;
  }

  std::vector<std::string_view> names_;
  std::size_t step_, time_, cell_;
  std::vector<std::pair<std::size_t, std::optional<double> SampleRow::*>> reals_;
  std::vector<std::pair<std::size_t, std::optional<std::int64_t> SampleRow::*>> wholes_;
};

/// The bytes begin ... end as far as there are any: the solver may have cut the log back meanwhile.
std::string bytes_of(std::ifstream& in, std::int64_t begin, std::int64_t end) {
  std::string bytes(static_cast<std::size_t>(end - begin), '\0');
  in.clear();
  in.seekg(begin);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

std::string tail_of(std::ifstream& in, std::int64_t offset) {
  return bytes_of(in, std::max<std::int64_t>(0, offset - tail_bytes), offset);
}
std::string tail_hash_of(std::ifstream& in, std::int64_t offset) { return digest_of(tail_of(in, offset)); }

/// The whole lines from an offset on, a block in memory at a time: what a file claims to hold is never allocated.
class Lines {
 public:
  Lines(std::ifstream& in, std::int64_t offset) : in_(in), end_(offset) {}

  /// The next line without its newline, until the next call.   throws Damage if it is longer than a line may be
  std::optional<std::string_view> next() {
    for (std::size_t searched = 0;;) {
      const std::size_t newline = rest_.find('\n', searched);
      if (newline != std::string_view::npos) {
        const std::string_view line = rest_.substr(0, newline);
        rest_.remove_prefix(newline + 1);
        return line;
      }
      if (rest_.size() > longest_line) throw Damage(fmt::format("it does not end within {} bytes", longest_line));
      searched = rest_.size();
      const std::string block = bytes_of(in_, end_, end_ + block_bytes);
      if (in_.bad()) throw Damage("it cannot be read to its end");  // a fault of the medium: no log that was cut back
      if (block.empty()) return std::nullopt;
      end_ += static_cast<std::int64_t>(block.size());
      bytes_ = std::string(rest_) + block;
      rest_ = bytes_;
    }
  }
  [[nodiscard]] std::int64_t unfinished_bytes() const { return static_cast<std::int64_t>(rest_.size()); }

 private:
  static constexpr std::int64_t block_bytes = 1 << 20;
  static constexpr std::size_t longest_line = 1 << 16;

  std::ifstream& in_;
  std::int64_t end_;  ///< of what was read
  std::string bytes_;
  std::string_view rest_;
};

using StepAndCell = std::pair<std::int64_t, int>;

/// Of the last line before `offset`; below all others if that is the header.
StepAndCell last_before(std::ifstream& in, std::int64_t offset, const std::string& header, const Columns& columns) {
  if (offset <= static_cast<std::int64_t>(header.size()) + 1) return {-1, -1};
  std::string tail = tail_of(in, offset);
  if (!tail.empty()) tail.pop_back();
  const SampleRow row = columns.row_of(std::string_view(tail).substr(tail.rfind('\n') + 1));
  return {row.step, row.cell};
}

}  // namespace

LogPart read_sample_log(const std::filesystem::path& file, const SampleMark& mark) {
  LogPart part;
  part.from_start = true;
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    if (mark.offset > 0) part.warnings.push_back(fmt::format("{}: is gone", file.string()));
    return part;
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    part.warnings.push_back(fmt::format("{}: is not a regular file; it was not read", file.string()));
    return part;
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    part.warnings.push_back(fmt::format("{}: cannot be read; see its permissions", file.string()));
    return part;
  }

  std::int64_t offset = 0, line_number = 1;
  const auto note_damage = [&](const Damage& damage) {
    const std::string line = part.from_start ? fmt::format("line {}", line_number)
                                             : fmt::format("line {} behind byte {}", line_number, mark.offset);
    part.warnings.push_back(fmt::format("{}: {} (byte {}): {}; it and what follows is not read", file.string(), line,
                                        offset, damage.what()));
  };
  try {
    in.seekg(0, std::ios::end);
    const auto size = static_cast<std::int64_t>(in.tellg());
    if (mark.offset > 0 && size >= mark.offset && tail_hash_of(in, mark.offset) == mark.tail_hash) {
      part.from_start = false;
      part.mark = mark;
      if (size == mark.offset) return part;
    }
    Lines head(in, 0);
    const std::optional<std::string_view> first = head.next();
    if (!first) {
      // The solver puts a log in place with its header.
      if (mark.offset > 0) throw Damage("it is no whole line");
      part.unfinished_bytes = head.unfinished_bytes();
      return part;
    }
    const std::string header(*first);
    const Columns columns(header);
    offset = part.from_start ? static_cast<std::int64_t>(header.size()) + 1 : mark.offset;
    line_number = part.from_start ? 2 : 1;
    StepAndCell last = last_before(in, offset, header, columns);
    Lines lines(in, offset);
    while (const std::optional<std::string_view> line = lines.next()) {
      const SampleRow row = columns.row_of(*line);
      if (StepAndCell(row.step, row.cell) <= last)
        throw Damage(
            fmt::format("step {}, cell {} comes behind step {}, cell {}", row.step, row.cell, last.first, last.second));
      last = {row.step, row.cell};
      part.rows.push_back(row);
      offset += static_cast<std::int64_t>(line->size()) + 1;
      ++line_number;
    }
    part.unfinished_bytes = lines.unfinished_bytes();
  } catch (const Damage& damage) {
    note_damage(damage);
  }
  if (offset > 0) part.mark = {offset, tail_hash_of(in, offset)};
  return part;
}

bool may_replace(const LogPart& log, std::size_t stored, bool is_done) {
  return stored == 0 || (log.warnings.empty() && (!is_done || log.rows.size() >= stored));
}

}  // namespace rouleau::campaign
