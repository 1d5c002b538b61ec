// SPDX-License-Identifier: BSD-3-Clause
// A written campaign of three points with its database, and `rouleau` called on it in this process.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "../campaign_ingest/written_campaign.hpp"
#include "commands/verbs.hpp"
#include "executor/process.hpp"

namespace rouleau::campaign::testing {

struct Answer {
  int code = 0;
  std::string out, err;
};

/// `rouleau WORDS`.
inline Answer call(const std::vector<std::string>& words) {
  std::ostringstream out, err;
  Streams io{out, err};
  const int code = run_command_line(all_verbs, words, io);
  return {code, out.str(), err.str()};
}

/// λ = 1 is done, λ = 5 crashed in its first attempt, λ = 9 waits. The database is made by `rebuild`.
class ThreePoints : public WrittenCampaign {
 public:
  ThreePoints() {
    host = host_name();  // and of another boot: their processes are known to be gone
    for (const int lambda : {1, 5, 9}) add_point(lambda);
    for (const char* key : {"000000abc001", "000000abc005"}) {
      add_attempt(key, 1);
      ::rouleau::testing::set_content(log(key), log_header + log_lines(0, 100000));
    }
    end_attempt("000000abc001", 1, 0, 0, 100000);
    made = call({"rebuild", path()});
  }

  Answer made;  ///< what `rebuild` said
};

}  // namespace rouleau::campaign::testing
