// SPDX-License-Identifier: BSD-3-Clause
// Which calls of this process are watched, what happens to them, and their record.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "shared_state.hpp"

namespace rouleau::testing {

/// One call that may change what is on the disk, or asks for it.
struct WatchedCall {
  const char* name;
  std::string path;          ///< absolute
  std::string other = {};    ///< the new name of a rename or link
  std::int64_t offset = -1;  ///< of a write, or the new length; -1: the end of the file
  const void* bytes = nullptr;
  std::size_t count = 0;  ///< of bytes, or reserved
  bool needs_room = false;
  bool is_read = false;  ///< an open that changes nothing is both
};

/// What is to become of a call.
struct Treatment {
  int error_number = 0;    ///< not 0: fail so
  bool is_halved = false;  ///< of a write or read
  bool is_fatal = false;   ///< die behind it
};

/// True if the absolute path lies below the watched directory and such calls are watched there.
[[nodiscard]] bool is_watched(const std::string& path, Watch kind = Watch::changes);
/// The absolute path of a name in a directory (AT_FDCWD: the current one), or of an open file. Empty if there is none.
[[nodiscard]] std::string absolute_path(int directory, const char* name);
[[nodiscard]] std::string path_of(int file);

/// Counts the call and kills or stops the process if its turn has come; or says what the caller is to do.
[[nodiscard]] Treatment count_call(const WatchedCall& call);
/// Records a call that was done. `result` is what it returned.
void record_call(const WatchedCall& call, std::int64_t result);

/// While one lives, no other process makes a watched call, if calls are recorded: the record is in their order.
class Turn {
 public:
  Turn();
  ~Turn();
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
};

}  // namespace rouleau::testing
