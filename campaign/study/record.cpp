// SPDX-License-Identifier: BSD-3-Clause
// Writing and verifying the check of a record.
#include "study/record.hpp"

#include "study/whole_file.hpp"

namespace rouleau::campaign {

std::string record_text(const nlohmann::ordered_json& record) {
  std::string text = record.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  text.resize(text.rfind('\n'));  // the closing bracket stands alone in the last line
  return fmt::format("{},\n \"check\": \"{}\"\n}}\n", text, digest_of(text));
}

nlohmann::json parse_record(const std::string& text) {
  nlohmann::json record = nlohmann::json::parse(text);
  if (!record.is_object()) throw Damage("it is no JSON object");
  const auto check = record.find("check");
  if (check == record.end()) return record;
  // Inside a string the quotes would be escaped, so the last such word is the entry's name.
  const std::size_t comma = text.rfind(',', text.rfind("\"check\""));
  if (comma == std::string::npos || *check != digest_of(std::string_view(text).substr(0, comma)))
    throw Damage("its check does not match");
  return record;
}

}  // namespace rouleau::campaign
