// SPDX-License-Identifier: BSD-3-Clause
// Text of others inside HTML and SVG: nothing that a study file, a host or a path says can become markup.
#pragma once

#include <string>
#include <string_view>

namespace rouleau::campaign {

/// `text` for the content of an element or the value of a quoted attribute: & < > " ' as entities. Bytes that are no
/// UTF-8, and characters that HTML does not allow, become U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// A relative path as the value of href: all but letters, digits and - . _ ~ / percent-encoded, so that no part of it
/// is taken for a scheme or a query.
[[nodiscard]] std::string link_to(std::string_view relative_path);

}  // namespace rouleau::campaign
