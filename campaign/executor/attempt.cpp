// SPDX-License-Identifier: BSD-3-Clause
// Claiming attempts.
#include "executor/attempt.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>

#include "study/error.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

std::string new_token() {
  std::random_device device;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", device());
  return token;
}

std::filesystem::path attempt_directory(const std::filesystem::path& run_directory, int number) {
  return run_directory / "attempts" / std::to_string(number);
}

void claim_attempt(const std::filesystem::path& run_directory, int number, const std::string& token) {
  make_directories(run_directory / "attempts");
  const std::filesystem::path attempt = attempt_directory(run_directory, number);
  if (::mkdir(attempt.c_str(), 0777) != 0) {
    fail(Exit::failed, "{}: cannot make the attempt: {}. Somebody else may have started this point; run again to see.",
         attempt.string(), std::strerror(errno));
  }
  sync_directory(run_directory / "attempts");
  write_whole_file(attempt / "owner", token + "\n");
}

void make_stop_file(const std::filesystem::path& run_directory) {
  write_whole_file(run_directory / "stop", "stop requested by rouleau\n");
}

void remove_stop_file(const std::filesystem::path& run_directory) {
  std::error_code error;
  std::filesystem::remove(run_directory / "stop", error);
  if (error) {
    fail(Exit::failed, "{}: cannot remove: {}. Check the permissions.", (run_directory / "stop").string(),
         error.message());
  }
}

std::string last_line(const std::filesystem::path& file) {
  constexpr std::streamoff most_bytes = 300;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return "";
  const std::streamoff size = in.tellg();
  in.seekg(std::max<std::streamoff>(0, size - most_bytes));
  std::string line, last;
  while (std::getline(in, line)) {
    if (line.find_first_not_of(" \t\r-") != std::string::npos) last = line;
  }
  return last;
}

}  // namespace rouleau::campaign
