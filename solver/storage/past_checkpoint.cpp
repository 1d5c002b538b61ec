// SPDX-License-Identifier: BSD-3-Clause
// Reading the records of a run for traces of a checkpoint.
#include "storage/past_checkpoint.hpp"

#include <xxhash.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.hpp"
#include "storage/checksum.hpp"
#include "storage/files.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t longest_record = 1U << 20U;  // bytes; a record has some hundred

/// False if the last entry, `check`, is there and wrong.
bool passes_its_check(std::string_view text, const Json& record) {
  if (!record.contains("check")) return true;
  const std::string_view vouched = text.substr(0, text.rfind(',', text.rfind("\"check\"")));
  return record["check"] == hex(XXH64(vouched.data(), vouched.size(), 0));
}

/// A record as an object; discarded if it is damaged.
Json read_record(FileSystem& files, const fs::path& path) {
  const Json damaged = Json::parse("", nullptr, false);
  if (file_size(files, path) > longest_record) return damaged;
  const std::string text = read_file(files, path);
  Json record = Json::parse(text, nullptr, false);
  return record.is_object() && passes_its_check(text, record) ? record : damaged;
}

/// An entry of a record that is a number; `otherwise` if it is not there or none.
std::int64_t integer(const Json& record, const char* name, std::int64_t otherwise) {
  const auto found = record.find(name);
  return found != record.end() && found->is_number_integer() ? found->get<std::int64_t>() : otherwise;
}

std::optional<std::string> told_by_progress(FileSystem& files, const fs::path& path) {
  if (!exists(files, path)) return {};
  const Json progress = read_record(files, path);
  if (progress.is_discarded()) return path.string() + " is damaged and may have told of one";
  const std::int64_t step = integer(progress, "checkpoint_step", 0);
  if (step <= 0) return {};
  return fmt::format("{} tells of one of step {}", path.string(), step);
}

std::optional<std::string> told_by_exit(FileSystem& files, const fs::path& path) {
  if (!exists(files, path)) return {};
  const Json exit = read_record(files, path);
  if (exit.is_discarded()) return path.string() + " is damaged and may have told of one";
  const auto resumed_from = exit.find("resumed_from");
  if (resumed_from != exit.end() && resumed_from->is_string() && *resumed_from != "") {
    return fmt::format("{} tells of {}", path.string(), resumed_from->get<std::string>());
  }
  const auto code = static_cast<Exit>(integer(exit, "code", -1));
  if (code != Exit::finished && code != Exit::stopped) return {};
  return fmt::format("{} tells of one of step {}", path.string(), integer(exit, "step", 0));
}

}  // namespace

std::optional<std::string> past_checkpoint(FileSystem& files, const fs::path& run_directory) {
  if (auto told = told_by_progress(files, run_directory / "progress.json")) return told;
  for (const std::string& name : list_directory(files, run_directory / "attempts")) {
    if (auto told = told_by_exit(files, run_directory / "attempts" / name / "exit.json")) return told;
  }
  return {};
}

}  // namespace rouleau
