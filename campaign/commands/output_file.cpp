// SPDX-License-Identifier: BSD-3-Clause
// What may be written over.
#include "commands/output_file.hpp"

#include "study/error.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {
namespace {

void check(const std::filesystem::path& file, bool may_overwrite) {
  const std::filesystem::path directory = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(directory))
    fail(Exit::usage, "{}: there is no directory {}; make it first", file.string(), directory.string());
  const std::filesystem::file_status status = std::filesystem::symlink_status(file);
  if (!std::filesystem::exists(status)) return;
  if (!std::filesystem::is_regular_file(status))
    fail(Exit::usage, "{}: is no regular file, so it is not replaced; name another one", file.string());
  if (file.filename() == "campaign.db")
    fail(Exit::usage, "{}: is the database of a campaign; name another file", file.string());
  if (!may_overwrite)
    fail(Exit::usage, "{}: exists already; --overwrite replaces it, or name another file", file.string());
}

}  // namespace

void write_output_file(const std::filesystem::path& file, bool may_overwrite,
                       const std::function<void(const std::filesystem::path& aside)>& write) {
  check(file, may_overwrite);
  make_whole_file(file, write);
}

}  // namespace rouleau::campaign
