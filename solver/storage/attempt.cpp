// SPDX-License-Identifier: BSD-3-Clause
// Claiming an attempt, joining one, and noticing a newer one.
#include "storage/attempt.hpp"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <utility>

#include "base/error.hpp"
#include "storage/checksum.hpp"
#include "storage/files.hpp"
#include "storage/unfinished.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

std::string random_token() {
  std::array<std::uint64_t, 2> bits{};
  if (::getrandom(bits.data(), sizeof bits, 0) != static_cast<ssize_t>(sizeof bits)) {
    fail(Exit::io, "the system gives no random bits for the attempt's token (errno {})", errno);
  }
  return hex(bits[0]) + hex(bits[1]);
}

/// The number a folder's name stands for; 0 if it is none.
int attempt_number(const std::string& name) {
  int number = 0;
  const auto result = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool whole = result.ec == std::errc{} && result.ptr == name.data() + name.size();
  return whole && number > 0 && name == std::to_string(number) ? number : 0;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

int newest_attempt(FileSystem& files, const fs::path& run_directory) {
  int newest = 0;
  for (const std::string& name : list_directory(files, run_directory / "attempts")) {
    newest = std::max(newest, attempt_number(name));
  }
  return newest;
}

bool owns_attempt(FileSystem& files, const fs::path& run_directory, int number, const std::string& token) {
  std::string owner;
  return read_file_if_there(files, run_directory / "attempts" / std::to_string(number) / "owner", owner) &&
         first_line(owner) == token;
}

Attempt::Attempt(FileSystem& files, fs::path run, int number, std::string token)
    : files_(&files), run_(std::move(run)), number_(number), token_(std::move(token)) {}

Attempt Attempt::claim(FileSystem& files, const fs::path& run_directory) {
  make_directory(files, run_directory / "attempts");
  // mkdir decides between two that claim at once; the loser takes the next number.
  int number = newest_attempt(files, run_directory) + 1;
  while (!make_directory(files, run_directory / "attempts" / std::to_string(number))) ++number;
  Attempt attempt(files, run_directory, number, random_token());
  write_aside(files, attempt.directory() / "owner", attempt.token_ + "\n");
  attempt.disarm_older();
  return attempt;
}

Attempt Attempt::join(FileSystem& files, const fs::path& run_directory, int number, const std::string& token) {
  Attempt attempt(files, run_directory, number, token);
  const fs::path owner = attempt.directory() / "owner";
  if (number < 1 || token.empty() || !exists(files, owner)) {
    fail(Exit::usage, "{}: no such attempt. Make it with its owner file before --attempt {} --token is used.",
         owner.string(), number);
  }
  attempt.fence();
  attempt.disarm_older();
  return attempt;
}

void Attempt::disarm_older() const {
  remove_unfinished(*files_, run_, number_);
  remove_unfinished(*files_, run_ / "checkpoints", number_);
  remove_unfinished(*files_, run_ / "snapshots", number_);
}

fs::path Attempt::directory() const { return run_ / "attempts" / std::to_string(number_); }

bool Attempt::is_newest() const {
  return newest_attempt(*files_, run_) == number_ && owns_attempt(*files_, run_, number_, token_);
}

void Attempt::fence() const {
  if (is_newest()) return;
  const int newest = newest_attempt(*files_, run_);
  if (newest > number_) {
    fail(Exit::superseded, "{}: attempt {} has taken over from attempt {}, which stops here", run_.string(), newest,
         number_);
  }
  fail(Exit::superseded, "{}: attempt {} belongs to another owner now, this one stops here", run_.string(), number_);
}

}  // namespace rouleau
