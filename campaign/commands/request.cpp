// SPDX-License-Identifier: BSD-3-Clause
// Requests as small files named by the point.
#include "commands/request.hpp"

#include <algorithm>

#include "study/whole_file.hpp"

namespace rouleau::campaign {

void leave_request(const std::filesystem::path& campaign, Wish wish, const std::string& key) {
  make_directories(campaign / "requests");
  write_whole_file(campaign / "requests" / key, wish == Wish::cancel ? "cancel\n" : "retry\n");
}

std::vector<Request> requests_in(const std::filesystem::path& campaign) {
  std::vector<Request> requests;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(campaign / "requests", error)) {
    if (entry.path().extension() == ".tmp") continue;
    const std::string text = read_whole_file(entry.path()).value_or("");
    if (text != "cancel\n" && text != "retry\n") continue;
    requests.push_back(
        {text == "cancel\n" ? Wish::cancel : Wish::retry, entry.path().filename().string(), entry.path()});
  }
  std::sort(requests.begin(), requests.end(), [](const Request& a, const Request& b) { return a.key < b.key; });
  return requests;
}

}  // namespace rouleau::campaign
