// SPDX-License-Identifier: BSD-3-Clause
// One table, three formats.
#include "commands/print.hpp"

namespace rouleau::campaign {

void print(const CommandLine& line, const Table& table) {
  switch (line.format) {
    case Format::table:
      return write_text(line.io.out, table, line.header,
                        line.io.out_is_terminal ? static_cast<std::size_t>(line.io.columns) : 0);
    case Format::csv:
      return write_csv(line.io.out, table, line.header);
    case Format::json:
      return write_json(line.io.out, table);
  }
}

}  // namespace rouleau::campaign
