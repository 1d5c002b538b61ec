// SPDX-License-Identifier: BSD-3-Clause
// The functions of the C library by which programs change and read files, under their own names: a library loaded first
// takes the place of the C library's, and calls it. (What the C library reads for itself, as by fread, is not seen.)
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <string>

#include "watch.hpp"

using rouleau::testing::absolute_path;
using rouleau::testing::count_call;
using rouleau::testing::is_watched;
using rouleau::testing::path_of;
using rouleau::testing::record_call;
using rouleau::testing::Treatment;
using rouleau::testing::Turn;
using rouleau::testing::Watch;
using rouleau::testing::WatchedCall;

namespace {

/// The C library's own function of that name.
template <class Function>
Function* original(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

/// Does a call that is no write, unless it is to fail.
template <class Do>
auto watched(const WatchedCall& call, const Do& work) -> decltype(work()) {
  if (!is_watched(call.path) && !(call.is_read && is_watched(call.path, Watch::reads))) return work();
  const Turn turn;
  if (const Treatment treatment = count_call(call); treatment.error_number != 0) {
    errno = treatment.error_number;
    return -1;
  }
  const auto result = work();
  record_call(call, static_cast<std::int64_t>(result));
  return result;
}

/// Writes or reads `call.count` bytes by `work(count)`, all of them, half, or none.
template <class Do>
ssize_t watched_transfer(const WatchedCall& call, const Do& work) {
  if (!is_watched(call.path, call.is_read ? Watch::reads : Watch::changes)) return work(call.count);
  const Turn turn;
  const Treatment treatment = count_call(call);
  if (treatment.error_number != 0) {
    errno = treatment.error_number;
    return -1;
  }
  const ssize_t result = work(treatment.is_halved ? call.count / 2 : call.count);
  if (treatment.is_fatal) ::kill(::getpid(), SIGKILL);
  record_call(call, result);
  return result;
}

using OpenAt = int(int, const char*, int, mode_t);

int open_watched(int directory, const char* name, int flags, mode_t mode) {
  static OpenAt* const real = reinterpret_cast<OpenAt*>(original<int(int, const char*, int, ...)>("openat"));
  const WatchedCall call{(flags & O_TRUNC) != 0 ? "open_empty" : "open",
                         absolute_path(directory, name),
                         {},
                         flags,
                         nullptr,
                         0,
                         (flags & O_CREAT) != 0,
                         (flags & (O_ACCMODE | O_CREAT)) == O_RDONLY};
  return watched(call, [&] { return real(directory, name, flags, mode); });
}

/// Asks for a name or for what is known of a file, unless that is to fail.
template <class Do>
auto watched_read(const char* name, const std::string& path, const Do& work) -> decltype(work()) {
  if (!is_watched(path, Watch::reads)) return work();
  WatchedCall call{name, path};
  call.is_read = true;
  return watched(call, work);
}

/// The same where a failure is a null pointer.
template <class Pointer, class Do>
Pointer watched_pointer(const char* name, const std::string& path, const Do& work) {
  Pointer result = nullptr;
  watched_read(name, path, [&] {
    result = work();
    return 0;
  });
  return result;
}

mode_t mode_of(int flags, va_list list) {
  return (flags & (O_CREAT | __O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(list, unsigned)) : 0;
}

off_t position_of(int file) {
  if ((::fcntl(file, F_GETFL) & O_APPEND) != 0) return -1;
  return ::lseek(file, 0, SEEK_CUR);
}

ssize_t pwrite_watched(int file, const void* bytes, std::size_t count, off_t offset) {
  static auto* const real = original<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  return watched_transfer({"pwrite", path_of(file), {}, offset, bytes, count, true},
                          [&](std::size_t some) { return real(file, bytes, some, offset); });
}

int truncate_watched(int file, off_t length) {
  static auto* const real = original<int(int, off_t)>("ftruncate");
  return watched({"ftruncate", path_of(file), {}, length}, [&] { return real(file, length); });
}

int allocate_watched(int file, off_t offset, off_t length) {
  static auto* const real = original<int(int, off_t, off_t)>("posix_fallocate");
  const WatchedCall call{"posix_fallocate", path_of(file), {}, offset, nullptr, static_cast<std::size_t>(length), true};
  int error = 0;
  const int result = watched(call, [&] {
    error = real(file, offset, length);
    return error == 0 ? 0 : -1;
  });
  return result == 0 ? 0 : error != 0 ? error : errno;
}

}  // namespace

// clang-format off
extern "C" {

#define OPEN(name)                                                   \
  int name(const char* path, int flags, ...) {                       \
    va_list list;                                                    \
    va_start(list, flags);                                           \
    const mode_t mode = mode_of(flags, list);                        \
    va_end(list);                                                    \
    return open_watched(AT_FDCWD, path, flags, mode);                \
  }
#define OPEN_AT(name)                                                \
  int name(int directory, const char* path, int flags, ...) {        \
    va_list list;                                                    \
    va_start(list, flags);                                           \
    const mode_t mode = mode_of(flags, list);                        \
    va_end(list);                                                    \
    return open_watched(directory, path, flags, mode);               \
  }
// clang-format on
OPEN(open)
OPEN(open64)
OPEN_AT(openat)
OPEN_AT(openat64)
int __open_2(const char* path, int flags) { return open_watched(AT_FDCWD, path, flags, 0); }
int __open64_2(const char* path, int flags) { return open_watched(AT_FDCWD, path, flags, 0); }
int __openat_2(int directory, const char* path, int flags) { return open_watched(directory, path, flags, 0); }
int __openat64_2(int directory, const char* path, int flags) { return open_watched(directory, path, flags, 0); }
int creat(const char* path, mode_t mode) { return open_watched(AT_FDCWD, path, O_CREAT | O_WRONLY | O_TRUNC, mode); }

ssize_t write(int file, const void* bytes, size_t count) {
  static auto* const real = original<ssize_t(int, const void*, size_t)>("write");
  const std::string path = path_of(file);
  if (!is_watched(path)) return real(file, bytes, count);
  return watched_transfer({"write", path, {}, position_of(file), bytes, count, true},
                          [&](std::size_t some) { return real(file, bytes, some); });
}

/// As single writes: nobody may rely on a writev that does everything.
ssize_t writev(int file, const iovec* parts, int count) {
  static auto* const real = original<ssize_t(int, const iovec*, int)>("writev");
  if (!is_watched(path_of(file))) return real(file, parts, count);
  ssize_t all = 0;
  for (int i = 0; i < count; ++i) {
    const ssize_t done = write(file, parts[i].iov_base, parts[i].iov_len);
    if (done < 0) return all > 0 ? all : -1;
    all += done;
    if (static_cast<size_t>(done) < parts[i].iov_len) break;
  }
  return all;
}

ssize_t pwrite(int file, const void* bytes, size_t count, off_t offset) {
  return pwrite_watched(file, bytes, count, offset);
}
ssize_t pwrite64(int file, const void* bytes, size_t count, off64_t offset) {
  return pwrite_watched(file, bytes, count, offset);
}
/// By which the C++ library copies files. As one write: what it does to the target can fail, halve and kill like any.
ssize_t sendfile(int target, int source, off_t* offset, size_t count) noexcept {
  static auto* const real = original<ssize_t(int, int, off_t*, size_t)>("sendfile");
  if (!is_watched(path_of(target))) return real(target, source, offset, count);
  std::string bytes(count, '\0');
  const ssize_t got =
      offset != nullptr ? ::pread(source, bytes.data(), count, *offset) : ::read(source, bytes.data(), count);
  if (got <= 0) return got;
  const ssize_t done = write(target, bytes.data(), static_cast<size_t>(got));
  if (done > 0 && offset != nullptr) *offset += done;
  return done;
}
ssize_t sendfile64(int target, int source, off64_t* offset, size_t count) noexcept {
  return sendfile(target, source, offset, count);
}
int ftruncate(int file, off_t length) noexcept { return truncate_watched(file, length); }
int ftruncate64(int file, off64_t length) noexcept { return truncate_watched(file, length); }
int posix_fallocate(int file, off_t offset, off_t length) { return allocate_watched(file, offset, length); }
int posix_fallocate64(int file, off64_t offset, off64_t length) { return allocate_watched(file, offset, length); }

int fsync(int file) {
  static auto* const real = original<int(int)>("fsync");
  return watched({"fsync", path_of(file)}, [&] { return real(file); });
}
int fdatasync(int file) {
  static auto* const real = original<int(int)>("fdatasync");
  return watched({"fsync", path_of(file)}, [&] { return real(file); });
}

/// The file is closed even when close is to fail: so Linux does.
int close(int file) {
  static auto* const real = original<int(int)>("close");
  const std::string path = path_of(file);
  if (!is_watched(path)) return real(file);
  const Turn turn;
  const WatchedCall call{"close", path};
  const Treatment treatment = count_call(call);
  const int result = real(file);
  if (treatment.error_number != 0) {
    errno = treatment.error_number;
    return -1;
  }
  record_call(call, result);
  return result;
}

int rename(const char* from, const char* to) noexcept {
  static auto* const real = original<int(const char*, const char*)>("rename");
  return watched({"rename", absolute_path(AT_FDCWD, from), absolute_path(AT_FDCWD, to)},
                 [&] { return real(from, to); });
}
int unlink(const char* path) noexcept {
  static auto* const real = original<int(const char*)>("unlink");
  return watched({"unlink", absolute_path(AT_FDCWD, path)}, [&] { return real(path); });
}
int unlinkat(int directory, const char* path, int flags) noexcept {
  static auto* const real = original<int(int, const char*, int)>("unlinkat");
  return watched({"unlink", absolute_path(directory, path)}, [&] { return real(directory, path, flags); });
}
int remove(const char* path) noexcept {
  static auto* const real = original<int(const char*)>("remove");
  return watched({"unlink", absolute_path(AT_FDCWD, path)}, [&] { return real(path); });
}
int mkdir(const char* path, mode_t mode) noexcept {
  static auto* const real = original<int(const char*, mode_t)>("mkdir");
  const WatchedCall call{"mkdir", absolute_path(AT_FDCWD, path), {}, -1, nullptr, 0, true};
  return watched(call, [&] { return real(path, mode); });
}
int link(const char* from, const char* to) noexcept {
  static auto* const real = original<int(const char*, const char*)>("link");
  return watched({"link", absolute_path(AT_FDCWD, from), absolute_path(AT_FDCWD, to)}, [&] { return real(from, to); });
}

ssize_t read(int file, void* bytes, size_t count) {
  static auto* const real = original<ssize_t(int, void*, size_t)>("read");
  return watched_transfer({"read", path_of(file), {}, -1, bytes, count, false, true},
                          [&](std::size_t some) { return real(file, bytes, some); });
}
ssize_t pread(int file, void* bytes, size_t count, off_t offset) {
  static auto* const real = original<ssize_t(int, void*, size_t, off_t)>("pread");
  return watched_transfer({"read", path_of(file), {}, offset, bytes, count, false, true},
                          [&](std::size_t some) { return real(file, bytes, some, offset); });
}
ssize_t pread64(int file, void* bytes, size_t count, off64_t offset) { return pread(file, bytes, count, offset); }

DIR* opendir(const char* path) {
  static auto* const real = original<DIR*(const char*)>("opendir");
  return watched_pointer<DIR*>("opendir", absolute_path(AT_FDCWD, path), [&] { return real(path); });
}
dirent* readdir(DIR* directory) {
  static auto* const real = original<dirent*(DIR*)>("readdir");
  return watched_pointer<dirent*>("readdir", path_of(::dirfd(directory)), [&] { return real(directory); });
}
dirent64* readdir64(DIR* directory) {
  static auto* const real = original<dirent64*(DIR*)>("readdir64");
  return watched_pointer<dirent64*>("readdir", path_of(::dirfd(directory)), [&] { return real(directory); });
}

int stat(const char* path, struct stat* found) noexcept {
  static auto* const real = original<int(const char*, struct stat*)>("stat");
  return watched_read("stat", absolute_path(AT_FDCWD, path), [&] { return real(path, found); });
}
int stat64(const char* path, struct stat64* found) noexcept {
  static auto* const real = original<int(const char*, struct stat64*)>("stat64");
  return watched_read("stat", absolute_path(AT_FDCWD, path), [&] { return real(path, found); });
}
int lstat(const char* path, struct stat* found) noexcept {
  static auto* const real = original<int(const char*, struct stat*)>("lstat");
  return watched_read("stat", absolute_path(AT_FDCWD, path), [&] { return real(path, found); });
}
int lstat64(const char* path, struct stat64* found) noexcept {
  static auto* const real = original<int(const char*, struct stat64*)>("lstat64");
  return watched_read("stat", absolute_path(AT_FDCWD, path), [&] { return real(path, found); });
}

}  // extern "C"
