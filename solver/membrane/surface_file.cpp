// SPDX-License-Identifier: BSD-3-Clause
// Choosing the reader of a surface file, and reading its bytes.
#include "membrane/surface_file.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

#include "base/read_error.hpp"

namespace rouleau {
namespace {

constexpr std::uintmax_t largest_file_bytes = std::uintmax_t{1} << 30;

[[noreturn]] void cannot_open(const std::filesystem::path& path, int error) {
  fail(exit_of_read(error),
       "{}: the mesh file cannot be opened: {} (errno {}). Check its permissions and the file system.", path.string(),
       std::strerror(error), error);
}

std::string read_bytes(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    if (error && exit_of_read(error.value()) == Exit::io) cannot_open(path, error.value());
    fail(Exit::bad_input, "{}: no such mesh file, or not a regular file. Check the path in the run file.",
         path.string());
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) fail(Exit::io, "{}: its size cannot be read: {}.", path.string(), error.message());
  if (size > largest_file_bytes) {
    fail(Exit::bad_input, "{}: {} bytes; at most {} are read. Coarsen the mesh.", path.string(), size,
         largest_file_bytes);
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) cannot_open(path, errno);
  std::string bytes(size, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(file.gcount()) != size) {
    fail(Exit::io, "{}: only {} of {} bytes could be read.", path.string(), file.gcount(), size);
  }
  return bytes;
}

}  // namespace

Surface read_surface(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension != ".off" && extension != ".stl") {
    fail(Exit::bad_input, "{}: unknown kind of mesh file '{}'; .off and .stl are read.", path.string(), extension);
  }
  const std::string bytes = read_bytes(path);
  return extension == ".off" ? parse_off(bytes, path.string()) : parse_stl(bytes, path.string());
}

}  // namespace rouleau
