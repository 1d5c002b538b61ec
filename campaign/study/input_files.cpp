// SPDX-License-Identifier: BSD-3-Clause
// run.ini is known by its digest in point.json, the files that it names by the one in their own names.
#include "study/input_files.hpp"

#include "study/error.hpp"
#include "study/ini.hpp"
#include "study/run_file.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

void require_run_file(const std::filesystem::path& file, const std::string& expected) {
  if (expected.empty()) return;  // point.json of an earlier version
  const std::string digest = digest_of(read_whole_file(file).value_or(""));
  if (digest == expected) return;
  fail(Exit::damaged,
       "{}: is not the file that `rouleau init` wrote: its digest is {}, point.json has {}. It is damaged or was "
       "edited; `rouleau init STUDY DIR` writes it anew.",
       file.string(), digest, expected);
}

void require_named_file(const std::filesystem::path& file) {
  const std::optional<std::string> content = read_whole_file(file);
  if (!content)
    fail(Exit::damaged, "{}: is missing. `rouleau init STUDY DIR` copies it again from the study's own file.",
         file.string());
  const std::string digest = digest_of(*content).substr(0, digits_in_name);
  if (file.stem().string().ends_with("-" + digest)) return;
  fail(Exit::damaged,
       "{}: is not the file that `rouleau init` copied: its digest begins with {}, its name says otherwise. It is "
       "damaged or was edited; `rouleau init STUDY DIR` copies it again from the study's own file.",
       file.string(), digest);
}

}  // namespace

std::vector<std::string> input_files(const std::filesystem::path& run_directory) {
  const std::filesystem::path run_file = run_directory / "run.ini";
  std::vector<std::string> files = {"run.ini"};
  for (const IniEntry& entry : parse_ini(read_whole_file(run_file).value_or(""), run_file.string()))
    if (names_a_file(entry.name)) files.push_back(entry.value);
  return files;
}

std::string input_sums(const std::filesystem::path& run_directory) {
  std::string text;
  for (const std::string& file : input_files(run_directory))
    text += fmt::format("{} {}\n", cksum_of(read_whole_file(run_directory / file).value_or("")), file);
  return text;
}

void require_input_files(const std::filesystem::path& run_directory, const Point& point) {
  require_run_file(run_directory / "run.ini", point.run_file_digest);
  const std::vector<std::string> files = input_files(run_directory);
  for (std::size_t i = 1; i < files.size(); ++i) require_named_file((run_directory / files[i]).lexically_normal());

  const std::filesystem::path sums = run_directory / "inputs";
  const std::optional<std::string> stored = read_whole_file(sums);
  if (stored && *stored != input_sums(run_directory))  // campaigns of earlier versions have none
    fail(Exit::damaged,
         "{}: the sums in it are not those of run.ini and of the files that it names. `rouleau init STUDY DIR` "
         "writes it anew.",
         sums.string());
}

}  // namespace rouleau::campaign
