// SPDX-License-Identifier: BSD-3-Clause
// Counting, failing, killing, recording. Uses raw system calls, since the library's functions lead back here.
#include "watch.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace rouleau::testing {
namespace {

int open_raw(const char* path, int flags) {
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags | O_CLOEXEC, 0666));
}

std::string environment(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? "" : text;
}

std::string link_target(const std::string& link) {
  std::array<char, 4096> text;
  const ssize_t length = ::readlink(link.c_str(), text.data(), text.size());
  return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length)) : "";
}

/// What the environment asks of this process.
class Orders {
 public:
  Orders() : directory_(environment(fault_directory_variable)), log_(environment(fault_log_variable)) {
    const std::string program = link_target("/proc/self/exe");
    const std::string wanted = environment(fault_program_variable);
    if (directory_.empty() || (!wanted.empty() && program.substr(program.rfind('/') + 1) != wanted)) return;
    const int file = open_raw(environment(fault_state_variable).c_str(), O_RDWR);
    if (file < 0) return;
    void* memory = ::mmap(nullptr, sizeof(FaultState), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::syscall(SYS_close, file);
    if (memory != MAP_FAILED) state_ = static_cast<FaultState*>(memory);
  }
  [[nodiscard]] FaultState* state() const { return state_; }
  [[nodiscard]] const std::string& directory() const { return directory_; }
  [[nodiscard]] const std::string& log() const { return log_; }

 private:
  std::string directory_, log_;
  FaultState* state_ = nullptr;
};

const Orders& orders() {
  static const Orders the_orders;
  return the_orders;
}

/// The open record; each process opens it for itself, so that the lock on it is this process's own.
int log_file() {
  thread_local int file = -1;
  thread_local pid_t owner = 0;
  if (orders().log().empty()) return -1;
  if (owner != ::getpid()) {
    file = open_raw(orders().log().c_str(), O_WRONLY | O_APPEND | O_CREAT);
    owner = ::getpid();
  }
  return file;
}

thread_local std::int64_t number = 0;  // of the call under way

template <std::size_t size>
void note(const std::string& text, std::array<char, size>& place) {
  place[text.copy(place.data(), size - 1)] = '\0';
}

}  // namespace

bool is_watched(const std::string& path, Watch kind) {
  const std::string& directory = orders().directory();
  return orders().state() != nullptr && orders().state()->watch == kind && path.starts_with(directory) &&
         (path.size() == directory.size() || path[directory.size()] == '/');
}

std::string absolute_path(int directory, const char* name) {
  if (name == nullptr) return "";
  if (*name == '/') return name;
  return (directory == AT_FDCWD ? link_target("/proc/self/cwd") : path_of(directory)) + "/" + name;
}

std::string path_of(int file) {
  if (orders().state() == nullptr) return "";
  return link_target("/proc/self/fd/" + std::to_string(file));
}

Treatment count_call(const WatchedCall& call) {
  FaultState& state = *orders().state();
  number = ++state.calls;
  const bool is_due = state.at > 0 && number == state.at;
  const bool is_late = state.lasts != 0 && state.at > 0 && number > state.at &&
                       (state.watch == Watch::reads ? call.path == state.path.data() : call.needs_room);
  if (!is_due && !is_late) return {};
  const bool is_transfer = call.bytes != nullptr && call.count > 1;
  if (state.fault == Fault::none || (!is_transfer && (state.fault == Fault::brief || state.fault == Fault::torn)))
    return {};
  if (is_due) {
    note(call.name, state.name);
    note(call.path, state.path);
    note(call.other, state.other);
  }
  state.victim = ::getpid();
  ++state.injected;
  switch (state.fault) {
    case Fault::error:
      return {state.error_number, false, false};
    case Fault::brief:
      return {0, true, false};
    case Fault::torn:
      return {0, true, true};
    case Fault::kill:
      ::kill(::getpid(), SIGKILL);
      break;
    case Fault::stop:
      ::kill(::getpid(), SIGSTOP);
      break;
    case Fault::none:
      break;
  }
  return {};
}

void record_call(const WatchedCall& call, std::int64_t result) {
  const int file = log_file();
  if (file < 0) return;
  const bool has_written = call.bytes != nullptr && !call.is_read && result > 0;
  const std::size_t done = has_written ? static_cast<std::size_t>(result) : 0;
  const std::string head = std::to_string(number) + '\t' + std::to_string(::getpid()) + '\t' + call.name + '\t' +
                           std::to_string(call.offset) + '\t' + std::to_string(call.count) + '\t' +
                           std::to_string(result) + '\t' + call.path + '\t' + call.other + '\t' + std::to_string(done) +
                           '\n';
  std::array<iovec, 2> parts{iovec{const_cast<char*>(head.data()), head.size()},
                             iovec{const_cast<void*>(call.bytes), done}};
  const int before = errno;
  if (::syscall(SYS_writev, file, parts.data(), parts.size()) < 0) std::abort();
  errno = before;
}

Turn::Turn() {
  if (const int file = log_file(); file >= 0) ::flock(file, LOCK_EX);
}

Turn::~Turn() {
  const int before = errno;
  if (const int file = log_file(); file >= 0) ::flock(file, LOCK_UN);
  errno = before;
}

}  // namespace rouleau::testing
