// SPDX-License-Identifier: BSD-3-Clause
// Writing and checking the seal of a checkpoint file.
#include "storage/seal.hpp"

#include <xxhash.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "storage/checksum.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t chunk_bytes = 1U << 20U;
constexpr const char* first_line = "rouleau checkpoint\n";

/// All 512 bytes, so that comparing them also finds a changed byte in the seal itself.
std::string seal_text(std::uint64_t length, std::uint64_t sum) {
  std::string text = fmt::format("{}bytes {}\nseal {}\n", first_line, length, hex(sum));
  text.resize(seal_bytes, '\0');
  return text;
}

std::string read_seal(FileSystem& files, const fs::path& path) {
  std::string head(seal_bytes, '\0');
  head.resize(File::read(files, path).read_at(0, head.data(), head.size(), Exit::bad_input));
  return head;
}

void compare(const fs::path& path, const std::string& head, std::uint64_t length, std::uint64_t sum) {
  if (head == seal_text(length, sum)) return;
  if (!head.starts_with(first_line)) {
    fail(Exit::bad_input, "{}: not a checkpoint, or its first bytes are damaged", path.string());
  }
  fail(Exit::bad_input, "{}: damaged: its {} bytes are not those that were sealed", path.string(), length);
}

}  // namespace

std::uint64_t seal_part(FileSystem& files, const fs::path& path, std::uint64_t length, Share share) {
  const File file = File::read(files, path);
  std::vector<char> buffer(std::min(chunk_bytes, length));
  std::uint64_t sum = 0;
  const auto parts = static_cast<std::uint64_t>(share.parts);
  for (auto chunk = static_cast<std::uint64_t>(share.part);; chunk += parts) {
    const std::uint64_t begin = seal_bytes + chunk * chunk_bytes;
    if (begin >= length) return sum;
    const auto count = static_cast<std::size_t>(std::min(chunk_bytes, length - begin));
    const std::size_t have = file.read_at(begin, buffer.data(), count, Exit::bad_input);
    if (have != count) {
      fail(Exit::bad_input, "{}: ends at byte {}, {} expected", path.string(), begin + have, length);
    }
    sum += mix(chunk, XXH3_64bits(buffer.data(), count));
  }
}

void write_seal(FileSystem& files, const fs::path& path, const Communicator& comm) {
  std::uint64_t length = 0;
  std::vector<std::uint64_t> sum(1);
  comm.all_agree([&] {
    length = file_size(files, path);
    sum[0] = seal_part(files, path, length, {comm.rank(), comm.size()});
  });
  sum_over_ranks(comm, sum);
  comm.on_root([&] {
    File file = File::update(files, path);
    file.write_at(0, seal_text(length, sum[0]));
    file.sync();
    file.close();
  });
}

void require_seal(FileSystem& files, const fs::path& path) {
  const std::uint64_t length = file_size(files, path);
  compare(path, read_seal(files, path), length, seal_part(files, path, length, {}));
}

void require_seal(FileSystem& files, const fs::path& path, const Communicator& comm) {
  std::uint64_t length = 0;
  std::string head;
  std::vector<std::uint64_t> sum(1);
  comm.all_agree([&] {
    length = file_size(files, path);
    head = read_seal(files, path);
    sum[0] = seal_part(files, path, length, {comm.rank(), comm.size()});
  });
  sum_over_ranks(comm, sum);
  comm.all_agree([&] { compare(path, head, length, sum[0]); });
}

}  // namespace rouleau
