// SPDX-License-Identifier: BSD-3-Clause
// The environment of the shim and the memory shared with it.
#include "support/fault_shim/faults.hpp"

#include <fcntl.h>
#include <sys/mman.h>

#include <chrono>
#include <cstring>
#include <new>
#include <thread>

namespace rouleau::testing {

namespace fs = std::filesystem;

Faults::Faults(const fs::path& directory, const std::string& program, const Injection& injection) {
  const fs::path file = place_.path() / "state";
  set_content(file, std::string(sizeof(FaultState), '\0'));
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
  void* memory = ::mmap(nullptr, sizeof(FaultState), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  ::close(descriptor);
  if (memory == MAP_FAILED) std::abort();
  state_ = new (memory) FaultState{};
  state_->at = injection.at;
  state_->watch = injection.watch;
  state_->fault = injection.fault;
  state_->error_number = injection.error_number;
  state_->lasts = injection.lasts ? 1 : 0;
  ::setenv(fault_directory_variable, directory.c_str(), 1);
  ::setenv(fault_program_variable, program.c_str(), 1);
  ::setenv(fault_state_variable, file.c_str(), 1);
  ::setenv("LD_PRELOAD", FAULT_SHIM, 1);
}

Faults::~Faults() {
  let_go();
  ::munmap(state_, sizeof(FaultState));
}

void Faults::let_go() {
  for (const char* name :
       {fault_directory_variable, fault_program_variable, fault_state_variable, fault_log_variable, "LD_PRELOAD"}) {
    ::unsetenv(name);
  }
}

void Faults::record() { ::setenv(fault_log_variable, log().c_str(), 1); }

std::string name_of(const Injection& injection) {
  switch (injection.fault) {
    case Fault::none:
      return "nothing";
    case Fault::error:
      return std::string(::strerrorname_np(injection.error_number)) + (!injection.lasts ? ""
                                                                       : injection.watch == Watch::reads
                                                                           ? ", and at each later read of the file"
                                                                           : ", and no room from there on");
    case Fault::brief:
      return injection.watch == Watch::reads ? "short read" : "short write";
    case Fault::kill:
      return "kill";
    case Fault::torn:
      return "kill in the middle of a write";
    case Fault::stop:
      return "stop";
  }
  return "";
}

bool has_stopped(const Faults& faults, const std::function<bool()>& is_over) {
  for (;; std::this_thread::sleep_for(std::chrono::milliseconds(2))) {
    if (is_over()) return false;
    if (faults.injected() == 0) continue;
    const std::string stat = content_of("/proc/" + std::to_string(faults.victim()) + "/stat");
    const std::size_t bracket = stat.rfind(')');
    if (bracket != std::string::npos && stat[bracket + 2] == 'T') return true;
  }
}

}  // namespace rouleau::testing
