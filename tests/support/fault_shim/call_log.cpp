// SPDX-License-Identifier: BSD-3-Clause
// Reading the record: a line of fields, then the bytes.
#include "support/fault_shim/call_log.hpp"

#include <sstream>

#include "support/temporary_directory.hpp"

namespace rouleau::testing {

std::vector<RecordedCall> read_calls(const std::filesystem::path& log) {
  std::istringstream in(content_of(log));
  std::vector<RecordedCall> calls;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    std::vector<std::string> parts;
    for (std::string part; std::getline(fields, part, '\t');) parts.push_back(part);
    RecordedCall call{std::stoll(parts.at(0)),
                      std::stoi(parts.at(1)),
                      parts.at(2),
                      std::stoll(parts.at(3)),
                      std::stoll(parts.at(4)),
                      std::stoll(parts.at(5)),
                      parts.at(6),
                      parts.at(7),
                      {}};
    call.bytes.resize(std::stoul(parts.at(8)));
    in.read(call.bytes.data(), static_cast<std::streamsize>(call.bytes.size()));
    calls.push_back(std::move(call));
  }
  return calls;
}

}  // namespace rouleau::testing
