// SPDX-License-Identifier: BSD-3-Clause
// File operations as a run needs them: whole or an Error(io) that names path, call, reason and remedy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "storage/file_system.hpp"

namespace rouleau {

/// Throws Error(io) for a call that failed with `error` (an errno). `needed` bytes are named when the disk is full.
[[noreturn]] void fail_call(FileSystem& files, const std::filesystem::path& path, const char* call, int error,
                            std::uint64_t needed = 0);

/// An open file, closed at the end of its life. Every call that fails throws Error(io).
class File {
 public:
  static File read(FileSystem& files, const std::filesystem::path& path);       ///< must exist
  static File update(FileSystem& files, const std::filesystem::path& path);     ///< must exist; read and write in place
  static File append(FileSystem& files, const std::filesystem::path& path);     ///< must exist; writes go to the end
  static File overwrite(FileSystem& files, const std::filesystem::path& path);  ///< made, or emptied
  ~File();
  File(File&& other) noexcept;
  File(const File&) = delete;
  File& operator=(File&& other) noexcept;
  File& operator=(const File&) = delete;

  void write(std::string_view bytes);  ///< one system call, more only after a short write
  void write_at(std::uint64_t offset, std::string_view bytes);
  /// Returns less than `count` only at the end. Bytes that the medium cannot read (EIO) are asked for again, for most
  /// of a second; then they are an Error with the code `lost`: bad_input where another file can take this one's place.
  [[nodiscard]] std::size_t read_at(std::uint64_t offset, void* bytes, std::size_t count, Exit lost = Exit::io) const;
  void truncate(std::uint64_t length);
  void allocate(std::uint64_t length);  ///< reserves the blocks, so that later writes cannot find the disk full
  void sync();
  void close();  ///< reports what the destructor cannot

 private:
  File(FileSystem& files, std::filesystem::path path, int flags);
  FileSystem* files_;
  std::filesystem::path path_;
  int file_;
};

[[nodiscard]] std::string read_file(FileSystem& files, const std::filesystem::path& path);
/// Same, but no value if the file does not exist.
[[nodiscard]] bool read_file_if_there(FileSystem& files, const std::filesystem::path& path, std::string& content);
/// Hands the first `bytes` of a file on, block by block; fewer if it is shorter.
void read_blocks(const File& file, std::uint64_t bytes, const std::function<void(std::string_view)>& take);
[[nodiscard]] std::uint64_t file_size(FileSystem& files, const std::filesystem::path& path);
[[nodiscard]] bool exists(FileSystem& files, const std::filesystem::path& path);

/// Names in a directory, sorted; none if the directory does not exist.
[[nodiscard]] std::vector<std::string> list_directory(FileSystem& files, const std::filesystem::path& directory);
/// Makes a directory (its parent must exist) and syncs the parent. Returns false if it was there already.
bool make_directory(FileSystem& files, const std::filesystem::path& directory);
void sync_directory(FileSystem& files, const std::filesystem::path& directory);
void sync_file(FileSystem& files, const std::filesystem::path& path);
/// Renames within a directory and syncs the directory.
void rename_synced(FileSystem& files, const std::filesystem::path& from, const std::filesystem::path& to);
void remove_file(FileSystem& files, const std::filesystem::path& path);  ///< no error if it is not there

/// Replaces `path` as a whole: writes `<path>.tmp`, syncs it, renames it, syncs the directory.
/// After a crash at any moment the old or the new content is there.
void write_aside(FileSystem& files, const std::filesystem::path& path, std::string_view bytes);

/// Throws Error(io) "a checkpoint needs ..." (`what`) if less than `needed` bytes are free where `directory` lies.
void require_free_space(FileSystem& files, const std::filesystem::path& directory, const char* what,
                        std::uint64_t needed);

}  // namespace rouleau
