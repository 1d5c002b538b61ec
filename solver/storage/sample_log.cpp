// SPDX-License-Identifier: BSD-3-Clause
// Writing, cutting back and scanning the sample log.
#include "storage/sample_log.hpp"

#include <xxhash.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "storage/checksum.hpp"
#include "storage/unfinished.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t check_digits = 16;
constexpr std::size_t longest_line = 1U << 16U;  // bytes; the header has some 500

std::string line_check(std::string_view line) { return hex(XXH64(line.data(), line.size(), 0)); }

std::string with_check(const std::string& line) { return line + "," + line_check(line) + "\n"; }

std::string header_line(const std::vector<std::string>& columns) {
  std::string line;
  for (const std::string& column : columns) line += column + ",";
  return line + "check\n";
}

/// From `begin` on as many bytes as a line may have, none from `end` on.
std::string part_of(const File& file, std::uint64_t begin, std::uint64_t end) {
  std::string part(std::min<std::uint64_t>(longest_line, end - begin), '\0');
  part.resize(file.read_at(begin, part.data(), part.size()));
  return part;
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    fields.push_back(line.substr(begin, comma - begin));
    if (comma == std::string_view::npos) return fields;
    begin = comma + 1;
  }
}

void append_number(std::string& line, const SampleValue& value) {
  // Room for the longest shortest-form double, "-2.2250738585072014e-308".
  char text[32];
  const auto result = std::visit([&](auto number) { return std::to_chars(text, text + sizeof text, number); }, value);
  line.append(text, result.ptr);
}

/// Indices of the log's columns among `known`, in the order of its header; empty if that is incomplete, does not begin
/// with the first of them, lacks `cell`, or names one that is not known.
std::vector<std::size_t> columns_in(std::string_view content, const std::vector<std::string>& known) {
  const std::size_t end = content.find('\n');
  if (end == std::string_view::npos) return {};
  const std::vector<std::string_view> names = split(content.substr(0, end));
  if (names.front() != known.front() || names.back() != "check" || std::count(names.begin(), names.end(), "cell") != 1)
    return {};
  std::vector<std::size_t> columns;
  for (auto name = names.begin(); name + 1 != names.end(); ++name) {
    const auto found = std::find(known.begin(), known.end(), *name);
    if (found == known.end()) return {};
    columns.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  return columns;
}

bool sound_line(std::string_view line, std::size_t fields) {
  if (line.size() < check_digits + 1 || line[line.size() - check_digits - 1] != ',') return false;
  const std::string_view content = line.substr(0, line.size() - check_digits - 1);
  return line.substr(line.size() - check_digits) == line_check(content) &&
         static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1 == fields;
}

}  // namespace

/// How many bytes of a log there are, and their hash.
struct SampleLog::Counted {
  Counted() : hash(XXH64_createState(), XXH64_freeState) { XXH64_reset(hash.get(), 0); }
  void add(std::string_view bytes) {
    length += bytes.size();
    XXH64_update(hash.get(), bytes.data(), bytes.size());
  }
  [[nodiscard]] std::string digest() const { return hex(XXH64_digest(hash.get())); }

  std::uint64_t length = 0;
  std::unique_ptr<XXH64_state_t, decltype(&XXH64_freeState)> hash;
};

/// A log under way: its file, what it holds and the last sample in it.
struct SampleLog::Open {
  File file;
  Counted counted;
  std::int64_t step = -1, cell = -1;
};

SampleLog::SampleLog(FileSystem& files, fs::path file, std::vector<std::string> columns, int attempt,
                     std::function<void()> fence)
    : files_(&files),
      path_(std::move(file)),
      columns_(std::move(columns)),
      attempt_(attempt),
      fence_(std::move(fence)) {
  const auto cell = std::find(columns_.begin(), columns_.end(), "cell");
  require(!columns_.empty() && columns_[0] == "step" && cell != columns_.end(),
          "SampleLog: the columns must begin with `step` and contain `cell`");
  cell_column_ = static_cast<std::size_t>(cell - columns_.begin());
}

SampleLog::~SampleLog() = default;
SampleLog::SampleLog(SampleLog&&) noexcept = default;
SampleLog& SampleLog::operator=(SampleLog&&) noexcept = default;

void SampleLog::start() {
  replace([this](const auto& take) { take(header_line(columns_)); });
}

bool SampleLog::has_samples() const {
  if (!exists(*files_, path_)) return false;
  const std::uint64_t length = file_size(*files_, path_);
  const std::size_t header_end = part_of(File::read(*files_, path_), 0, length).find('\n');
  return header_end == std::string::npos ? length > 0 : length > header_end + 1;
}

std::optional<std::string> SampleLog::obstacle(const SampleLogPosition& position) const {
  if (!exists(*files_, path_)) return fmt::format("{} is missing", path_.string());
  const std::uint64_t length = file_size(*files_, path_);
  if (length < position.bytes) {
    return fmt::format("{} has {} bytes, the checkpoint had counted {}", path_.string(), length, position.bytes);
  }
  const File file = File::read(*files_, path_);
  Counted counted;
  read_blocks(file, position.bytes, [&](std::string_view block) { counted.add(block); });
  if (counted.digest() != position.hash) {
    return fmt::format("the first {} bytes of {} are not those that the checkpoint had counted", position.bytes,
                       path_.string());
  }
  if (columns_in(part_of(file, 0, position.bytes), columns_).empty()) {
    return fmt::format("{} has other columns than this solver writes", path_.string());
  }
  return {};
}

void SampleLog::cut_back(const SampleLogPosition& position) {
  if (const auto why = obstacle(position)) {
    fail(Exit::bad_input, "{}; the samples cannot be continued exactly from this checkpoint", *why);
  }
  const File before = File::read(*files_, path_);
  replace([&](const auto& take) { read_blocks(before, position.bytes, take); });
}

void SampleLog::replace(const std::function<void(const std::function<void(std::string_view)>&)>& content) {
  Counted counted;
  // A file of our own, never the one that an older attempt may have open: what that one still writes goes nowhere.
  const auto fill = [&](File& file) {
    content([&](std::string_view block) {
      file.write(block);
      counted.add(block);
    });
  };
  write_fenced(*files_, path_, fill, attempt_, fence_);
  open_ = std::make_unique<Open>(Open{File::append(*files_, path_), std::move(counted)});
  const std::uint64_t length = open_->counted.length;
  written_ = columns_in(part_of(open_->file, 0, length), columns_);
  const std::string tail = part_of(open_->file, length - std::min<std::uint64_t>(length, longest_line), length);
  const std::size_t last = tail.rfind('\n', tail.size() - 2);
  if (last == std::string::npos) return;
  const std::vector<std::string_view> fields = split(std::string_view(tail).substr(last + 1));
  const auto number = [&](std::size_t column, std::int64_t& value) {
    const std::string_view field = column < fields.size() ? fields[column] : std::string_view();
    const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
    if (result.ec != std::errc{}) fail(Exit::bad_input, "{}: its last line has no step and cell", path_.string());
  };
  const auto cell = std::find(written_.begin(), written_.end(), cell_column_);
  number(0, open_->step);
  number(static_cast<std::size_t>(cell - written_.begin()), open_->cell);
}

void SampleLog::append(std::span<const SampleRow> rows) {
  require(open_ != nullptr, "SampleLog: append before start or cut_back");
  std::string batch;
  SampleRow line(written_.size());
  std::int64_t step = open_->step;
  std::int64_t cell = open_->cell;
  for (const SampleRow& row : rows) {
    require(row.size() == columns_.size(), "SampleLog: a row does not have one value a column");
    const auto* row_step = std::get_if<std::int64_t>(&row[0]);
    const auto* row_cell = std::get_if<std::int64_t>(&row[cell_column_]);
    require(row_step != nullptr && row_cell != nullptr, "SampleLog: step and cell must be integers");
    require(std::pair(*row_step, *row_cell) > std::pair(step, cell), "SampleLog: (step, cell) must increase");
    step = *row_step;
    cell = *row_cell;
    for (std::size_t column = 0; column < row.size(); ++column) {
      const auto* number = std::get_if<double>(&row[column]);
      if (number == nullptr || std::isfinite(*number)) continue;
      fail(Exit::physics,
           "step {}: sample `{}` of cell {} is not finite ({}); it was not written. Try a smaller time step.", step,
           columns_[column], cell, *number);
    }
    for (std::size_t i = 0; i < written_.size(); ++i) line[i] = row[written_[i]];
    batch += format_sample(line);
  }
  fence_();
  const std::uint64_t found = file_size(*files_, path_);
  if (found != open_->counted.length) {
    fail(Exit::io,
         "{}: has {} bytes, this run left {}; another program writes to it. Stop that, then start the run again.",
         path_.string(), found, open_->counted.length);
  }
  open_->file.write(batch);
  open_->counted.add(batch);
  open_->step = step;
  open_->cell = cell;
}

SampleLogPosition SampleLog::sync() {
  require(open_ != nullptr, "SampleLog: sync before start or cut_back");
  open_->file.sync();
  return {open_->counted.length, open_->counted.digest()};
}

std::string format_sample(const SampleRow& row) {
  std::string line;
  for (const SampleValue& value : row) {
    if (!line.empty()) line += ',';
    append_number(line, value);
  }
  return with_check(line);
}

SampleScan scan_samples(FileSystem& files, const fs::path& path) {
  const std::string content = read_file(files, path);
  SampleScan scan;
  const std::size_t header_end = content.find('\n');
  const std::string_view header = std::string_view(content).substr(0, header_end);
  if (header_end == std::string::npos || !header.ends_with(",check")) {
    scan.why_ended = "the header is incomplete";
    return scan;
  }
  const std::vector<std::string_view> names = split(header);
  scan.columns.assign(names.begin(), names.end() - 1);
  scan.valid_bytes = header_end + 1;
  while (scan.valid_bytes < content.size()) {
    const std::size_t end = content.find('\n', scan.valid_bytes);
    if (end == std::string::npos) {
      scan.why_ended = fmt::format("line {} has no newline", scan.rows + 2);
      return scan;
    }
    const std::string_view line = std::string_view(content).substr(scan.valid_bytes, end - scan.valid_bytes);
    if (!sound_line(line, names.size())) {
      scan.why_ended = fmt::format("line {} does not match its check", scan.rows + 2);
      return scan;
    }
    scan.valid_bytes = end + 1;
    ++scan.rows;
  }
  return scan;
}

}  // namespace rouleau
