// SPDX-License-Identifier: BSD-3-Clause
// HDF5 identifiers that close themselves, and HDF5 failures as errors.
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>

#include "base/error.hpp"
#include "storage/persistent.hpp"

namespace rouleau::hdf5 {

/// Owns an HDF5 identifier; `closer` is the function of its kind.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), close_(closer) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  [[nodiscard]] hid_t id() const { return id_; }
  /// Closes now and returns what the library says: writing may fail as late as here.
  [[nodiscard]] herr_t close() { return close_(std::exchange(id_, -1)); }

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

/// The innermost description on the library's error stack, which it empties.
[[nodiscard]] std::string last_failure();

/// Returns `value` of an HDF5 call, or throws Error(code) "FILE: WHAT failed: ..." if it is negative.
template <class T>
T check(T value, const std::string& file, const std::string& what, Exit code) {
  if (value < 0) fail(code, "{}: {} failed: {}", file, what, last_failure());
  return value;
}

/// Keeps the library from printing its error stack: our errors carry what it says.
void silence();

/// Type in memory and in the file (the same, so nothing is converted).
[[nodiscard]] hid_t element_type(ElementType type);

}  // namespace rouleau::hdf5
