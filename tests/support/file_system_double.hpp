// SPDX-License-Identifier: BSD-3-Clause
// A file system for tests: it passes calls on to the real one, counts them, and fails or dies where it is told to.
#pragma once

#include <cerrno>
#include <cstdint>
#include <string>
#include <vector>

#include "storage/file_system.hpp"

namespace rouleau::testing {

class FileSystemDouble final : public FileSystem {
 public:
  /// Changing calls (all but reads and questions) are counted from 1. At number `die_at` the process "dies": that call
  /// does half of its work (a write) or none, and no later call changes anything.
  int die_at = 0;
  int calls = 0;
  /// errno of a named call ("fsync", "rename", ...), every time.
  std::string failing_call;
  int failing_errno = 0;
  /// How many preads fail that are to fail; -1: every one.
  int failing_preads = -1;
  std::uint64_t bytes_read = 0;
  /// What free_space says, instead of the truth; 0: the truth.
  std::uint64_t claimed_space = 0;
  /// Pretends to reserve blocks.
  bool skip_allocation = false;

  [[nodiscard]] bool dead() const { return die_at > 0 && calls >= die_at; }

  int open(const std::string& path, int flags, unsigned mode) override {
    const bool changes = (flags & 0100) != 0;  // O_CREAT
    if (changes ? refuse("open") : dead()) return lost();
    return real_.open(path, flags, mode);
  }
  ssize_t write(int file, const void* bytes, std::size_t count) override {
    const bool alive = !dead();
    if (refuse("write")) {
      if (alive && dead()) static_cast<void>(real_.write(file, bytes, count / 2));
      return lost();
    }
    return real_.write(file, bytes, count);
  }
  ssize_t pwrite(int file, const void* bytes, std::size_t count, std::uint64_t offset) override {
    const bool alive = !dead();
    if (refuse("pwrite")) {
      if (alive && dead()) static_cast<void>(real_.pwrite(file, bytes, count / 2, offset));
      return lost();
    }
    return real_.pwrite(file, bytes, count, offset);
  }
  ssize_t pread(int file, void* bytes, std::size_t count, std::uint64_t offset) override {
    if (dead() || (failing_call == "pread" && failing_preads != 0)) {
      if (failing_preads > 0) --failing_preads;
      return lost();
    }
    const ssize_t done = real_.pread(file, bytes, count, offset);
    if (done > 0) bytes_read += static_cast<std::uint64_t>(done);
    return done;
  }
  int truncate(int file, std::uint64_t length) override {
    return refuse("truncate") ? lost() : real_.truncate(file, length);
  }
  int allocate(int file, std::uint64_t length) override {
    if (refuse("allocate")) return lost();
    return skip_allocation ? 0 : real_.allocate(file, length);
  }
  int fsync(int file) override { return refuse("fsync") ? lost() : real_.fsync(file); }
  int close(int file) override {
    const int result = real_.close(file);
    return refuse("close") ? lost() : result;
  }
  int rename(const std::string& from, const std::string& to) override {
    return refuse("rename") ? lost() : real_.rename(from, to);
  }
  int unlink(const std::string& path) override { return refuse("unlink") ? lost() : real_.unlink(path); }
  int mkdir(const std::string& path, unsigned mode) override {
    return refuse("mkdir") ? lost() : real_.mkdir(path, mode);
  }
  int size(const std::string& path, std::uint64_t& bytes) override { return dead() ? lost() : real_.size(path, bytes); }
  int list(const std::string& directory, std::vector<std::string>& names) override {
    return dead() ? lost() : real_.list(directory, names);
  }
  int free_space(const std::string& directory, std::uint64_t& bytes) override {
    if (dead()) return lost();
    if (claimed_space == 0) return real_.free_space(directory, bytes);
    bytes = claimed_space;
    return 0;
  }

 private:
  bool refuse(const char* call) {
    ++calls;
    return dead() || failing_call == call;
  }
  [[nodiscard]] int lost() const {
    errno = failing_errno != 0 ? failing_errno : ESHUTDOWN;
    return -1;
  }
  FileSystem& real_ = posix_file_system();
};

}  // namespace rouleau::testing
