// SPDX-License-Identifier: BSD-3-Clause
// The options of a verb, taken apart: what help, manual page and completion say of them.
#pragma once

#include <string>
#include <vector>

#include "commands/cli.hpp"

namespace rouleau::campaign {

/// An option of a verb.
struct OptionEntry {
  std::string short_name;    ///< "-o", or ""
  std::string long_name;     ///< "--output"
  std::string value_name;    ///< "FILE", "csv|json"; "" for a switch
  std::string default_text;  ///< "300"; "" = none
  bool value_may_miss;       ///< --watch or --watch=SECONDS
  std::string meaning;

  [[nodiscard]] bool is_switch() const { return value_name.empty(); }
  /// "--output FILE", "--watch[=SECONDS]", "--quiet"
  [[nodiscard]] std::string usage() const;
};

/// The options that only this verb has.
[[nodiscard]] std::vector<OptionEntry> own_options(const Verb& verb);
/// Those that it has like others of its kind: --dir, --format, --quiet, --help.
[[nodiscard]] std::vector<OptionEntry> common_options(const Verb& verb);
/// All of them, for parsing.
[[nodiscard]] boost::program_options::options_description parsed_options(const Verb& verb);

}  // namespace rouleau::campaign
