// SPDX-License-Identifier: BSD-3-Clause
#include "run/identity.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <system_error>

#include "base/read_error.hpp"

namespace rouleau {
namespace {

std::string hex(const XXH128_hash_t& hash) { return fmt::format("{:016x}{:016x}", hash.high64, hash.low64); }

}  // namespace

std::string content_digest(const std::filesystem::path& file) {
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(file, unknown);
  if (is_directory(status)) throw Error(Exit::bad_input, "is a directory");
  // A device or a pipe may have no end.
  if (exists(status) && !is_regular_file(status)) throw Error(Exit::bad_input, "is not a regular file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), std::fclose);
  if (!stream) throw Error(exit_of_read(errno), std::strerror(errno));
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), XXH3_freeState);
  if (!state) throw std::bad_alloc();
  XXH3_128bits_reset(state.get());
  std::vector<char> buffer(1 << 20);
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), stream.get()))
    XXH3_128bits_update(state.get(), buffer.data(), n);
  if (std::ferror(stream.get())) throw Error(exit_of_read(errno), std::strerror(errno));
  return hex(XXH3_128bits_digest(state.get()));
}

std::string identity_digest(const std::vector<ParameterValue>& values) {
  std::vector<std::string> lines;
  for (const auto& v : values)
    if (v.kind == ParameterKind::identity && v.value != v.default_value)
      lines.push_back(v.name + "=" + v.identity_value + "\n");
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const auto& line : lines) text += line;
  return hex(XXH3_128bits(text.data(), text.size()));
}

}  // namespace rouleau
