// SPDX-License-Identifier: BSD-3-Clause
// Wishes of the user that the holder of the lock carries out: files in DIR/requests, so that `cancel` works while `run`
// runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rouleau::campaign {

enum class Wish { cancel, retry };

struct Request {
  Wish wish = Wish::cancel;
  std::string key;
  std::filesystem::path file;  ///< to be removed once it is carried out
};

/// Leaves a request; a newer one for the same point replaces an older.
void leave_request(const std::filesystem::path& campaign, Wish wish, const std::string& key);

/// Whether a request for the point waits to be carried out.
[[nodiscard]] bool is_left(const std::filesystem::path& campaign, const std::string& key);

/// All requests, by key. One that cannot be read, or is none, stays where it is and becomes a warning.
[[nodiscard]] std::vector<Request> requests_in(const std::filesystem::path& campaign,
                                               std::vector<std::string>& warnings);

}  // namespace rouleau::campaign
