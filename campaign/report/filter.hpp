// SPDX-License-Identifier: BSD-3-Clause
// The language of --where: parsed by ourselves, compiled to SQL in which every value is bound.
#pragma once

#include <string>
#include <string_view>

#include "report/columns.hpp"

namespace rouleau::campaign {

/// Compiles a condition:
///
///     condition   conjunction { "or" conjunction }
///     conjunction factor { "and" factor }
///     factor      "not" factor | "(" condition ")" | comparison
///     comparison  name ( "=" | "!=" | "<" | "<=" | ">" | ">=" ) value
///               | name [ "not" ] "between" value "and" value
///               | name [ "not" ] "in" "(" value { "," value } ")"
///               | name "is" [ "not" ] "null"
///     value       number | fraction such as 1/3 | word | 'text' | "text"
///
/// Words of the language are known in any case. A column without a value fits no comparison but `is null`.
/// throws  Error (usage) naming the place and what was expected there, an unknown name, or a value of the wrong type
std::string compile_condition(std::string_view condition, const Columns& columns, BoundValues& values);

}  // namespace rouleau::campaign
