// SPDX-License-Identifier: BSD-3-Clause
// Plain text as the input of man(1): nothing of it is taken for a command, and it can be copied from the page as it
// was.
#pragma once

#include <string>
#include <string_view>

namespace rouleau::campaign {

/// Text that is filled; what stands in `backquotes` becomes bold. It must not be empty.
[[nodiscard]] std::string roff_text(std::string_view text);

/// Lines that stay as they are, in a typewriter's letters.
[[nodiscard]] std::string roff_lines(std::string_view lines);

/// Paragraphs of filled text, parted by empty lines; lines that begin with a blank stay as they are.
[[nodiscard]] std::string roff_paragraphs(std::string_view text);

}  // namespace rouleau::campaign
