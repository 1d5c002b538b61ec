// SPDX-License-Identifier: BSD-3-Clause
// JSON of the run directory, field by field.
#include "ingest/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>
#include <functional>
#include <sstream>

#include "study/error.hpp"
#include "study/record.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {
namespace {

using Json = nlohmann::json;

constexpr std::size_t longest_line = 4096;
constexpr std::size_t longest_quotation = 80;
constexpr std::int64_t largest_status = 255;

/// A field that may be missing or null; of another type it is damage.
template <class T>
std::optional<T> field(const Json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return std::nullopt;
  return strictly<T>(*found);
}

std::string text_field(const Json& json, const char* name) { return field<std::string>(json, name).value_or(""); }

/// Reads a file by `take`; damage becomes a warning.
template <class File>
std::optional<File> read_json(const std::filesystem::path& file, std::vector<std::string>& warnings,
                              const std::function<File(const Json&)>& take) {
  try {
    const std::optional<std::string> text = read_whole_file(file, largest_record);
    if (!text) return std::nullopt;
    return read_record(*text, file, " and left aside", take);
  } catch (const Error& error) {
    warnings.push_back(error.what());
  }
  return std::nullopt;
}

/// Reads a file of one short line by `take`; one that it does not take becomes a warning.
template <class Content>
std::optional<Content> read_line(const std::filesystem::path& file, std::vector<std::string>& warnings,
                                 const char* trouble,
                                 const std::function<std::optional<Content>(const std::string&)>& take) {
  try {
    const std::optional<std::string> text = read_whole_file(file, longest_line);
    if (!text) return std::nullopt;
    const std::string line = text->substr(0, text->find('\n'));
    if (std::optional<Content> content = take(line)) return content;
    warnings.push_back(
        fmt::format("{}: `{}` {}; left aside", file.string(), line.substr(0, longest_quotation), trouble));
  } catch (const Error& error) {
    warnings.push_back(error.what());
  }
  return std::nullopt;
}

/// The number of a name that is nothing but digits.
std::optional<std::int64_t> whole_number(const std::string& name) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool whole = error == std::errc() && end == name.data() + name.size() && number >= 0;
  return whole ? std::optional(number) : std::nullopt;
}

/// A file of one whole number up to `largest`.
std::optional<int> read_number(const std::filesystem::path& file, std::vector<std::string>& warnings,
                               const char* trouble, std::int64_t largest) {
  return read_line<int>(file, warnings, trouble, [largest](const std::string& line) {
    const std::optional<std::int64_t> number = whole_number(line);
    const bool is_one = number && *number <= largest;
    return is_one ? std::optional<int>(static_cast<int>(*number)) : std::nullopt;
  });
}

}  // namespace

std::optional<ProcessFile> read_process_file(const std::filesystem::path& file, std::vector<std::string>& warnings) {
  return read_json<ProcessFile>(file, warnings, [](const Json& json) {
    ProcessFile process;
    process.host = strictly<std::string>(json.at("host"));
    process.boot_id = strictly<std::string>(json.at("boot_id"));
    process.pid = strictly<std::int64_t>(json.at("pid"));
    process.start_ticks = strictly<std::int64_t>(json.at("start_ticks"));
    process.ranks = field<int>(json, "ranks").value_or(0);
    process.checkpoint_step = field<std::int64_t>(json, "checkpoint_step");
    process.started_unix_s = field<double>(json, "started_unix_s");
    return process;
  });
}

std::optional<ExitFile> read_exit_file(const std::filesystem::path& file, std::vector<std::string>& warnings) {
  return read_json<ExitFile>(file, warnings, [](const Json& json) {
    ExitFile record;
    record.code = strictly<int>(json.at("code"));
    record.reason = text_field(json, "reason");
    record.host = text_field(json, "host");
    record.resumed_from = text_field(json, "resumed_from");
    record.version = text_field(json, "version");
    record.git = text_field(json, "git");
    record.start_step = field<std::int64_t>(json, "start_step");
    record.step = field<std::int64_t>(json, "step");
    record.end_step = field<std::int64_t>(json, "end_step");
    record.wall_s = field<double>(json, "wall_s");
    record.core_s = field<double>(json, "core_s");
    record.mlups = field<double>(json, "mlups");
    record.finished_unix_s = field<double>(json, "finished_unix_s");
    record.ranks = field<int>(json, "ranks");
    return record;
  });
}

std::optional<ProgressFile> read_progress_file(const std::filesystem::path& file, std::vector<std::string>& warnings) {
  return read_json<ProgressFile>(file, warnings, [](const Json& json) {
    ProgressFile progress;
    progress.attempt = field<int>(json, "attempt").value_or(0);
    progress.step = strictly<std::int64_t>(json.at("step"));
    progress.end_step = strictly<std::int64_t>(json.at("end_step"));
    progress.time_s = field<double>(json, "time_s").value_or(0);
    progress.end_time_s = field<double>(json, "end_time_s").value_or(0);
    progress.checkpoint_step = field<std::int64_t>(json, "checkpoint_step");
    progress.steps_per_s = field<double>(json, "steps_per_s");
    progress.mlups = field<double>(json, "mlups");
    progress.eta_s = field<double>(json, "eta_s");
    progress.checkpoint_unix_s = field<double>(json, "checkpoint_unix_s");
    if (progress.checkpoint_unix_s == 0) progress.checkpoint_unix_s.reset();  // this attempt has written none yet
    progress.checkpoint_ms = field<double>(json, "checkpoint_ms");
    progress.d_um = field<double>(json, "d_um");
    progress.asphericity = field<double>(json, "asphericity");
    progress.updated_unix_s = field<double>(json, "updated_unix_s");
    return progress;
  });
}

std::optional<JobFile> read_job_file(const std::filesystem::path& file, std::vector<std::string>& warnings) {
  return read_line<JobFile>(file, warnings, "is not of the form `slurm ID NAME`", [](const std::string& line) {
    std::istringstream words(line);
    std::string engine, id, name, more;
    words >> engine >> id >> name;
    const bool is_known = id == "-" || whole_number(id);
    if (engine != "slurm" || !is_known || name.empty() || (words >> more)) return std::optional<JobFile>();
    return std::optional<JobFile>({id == "-" ? "" : id, name});
  });
}

std::optional<int> read_status_file(const std::filesystem::path& file, std::vector<std::string>& warnings) {
  return read_number(file, warnings, "is no exit status", largest_status);
}

std::optional<int> read_start_file(const std::filesystem::path& file, std::vector<std::string>& warnings) {
  return read_number(file, warnings, "is no count of restarts", INT_MAX);
}

std::optional<std::string> read_first_line(const std::filesystem::path& file) {
  const std::optional<std::string> text = read_whole_file(file);
  return text ? std::optional(text->substr(0, text->find('\n'))) : std::nullopt;
}

std::vector<std::filesystem::directory_entry> entries_of(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::directory_entry> entries;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    entries.push_back(*it);
  if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
    fail(Exit::failed, "{}: cannot be listed: {}. See that the disk is sound, has room and is yours to read.",
         folder.string(), error.message());
  return entries;
}

std::vector<int> attempt_numbers(const std::filesystem::path& run_directory) {
  std::vector<int> numbers;
  for (const auto& entry : entries_of(run_directory / "attempts")) {
    const std::optional<std::int64_t> number = whole_number(entry.path().filename().string());
    std::error_code vanished;
    if (number && *number >= 1 && *number <= INT_MAX && entry.is_directory(vanished))
      numbers.push_back(static_cast<int>(*number));
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::vector<std::int64_t> checkpoint_steps(const std::filesystem::path& run_directory) {
  std::vector<std::int64_t> steps;
  for (const auto& entry : entries_of(run_directory / "checkpoints")) {
    const std::optional<std::int64_t> step = whole_number(entry.path().stem().string());
    if (step && entry.path().extension() == ".h5") steps.push_back(*step);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

}  // namespace rouleau::campaign
