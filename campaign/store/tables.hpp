// SPDX-License-Identifier: BSD-3-Clause
// The tables and views of schema version 2 as SQL. The views are for users and documented in store/README.md.
#pragma once

namespace rouleau::campaign {

extern const char* const table_statements;
extern const char* const view_statements;
extern const char* const drop_view_statements;

}  // namespace rouleau::campaign
