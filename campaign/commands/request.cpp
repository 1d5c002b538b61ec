// SPDX-License-Identifier: BSD-3-Clause
// Requests as small files named by the point.
#include "commands/request.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "study/error.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {
constexpr std::size_t longest_request = 64;
}

void leave_request(const std::filesystem::path& campaign, Wish wish, const std::string& key) {
  make_directories(campaign / "requests");
  write_whole_file(campaign / "requests" / key, wish == Wish::cancel ? "cancel\n" : "retry\n");
}

bool is_left(const std::filesystem::path& campaign, const std::string& key) {
  std::error_code error;
  return std::filesystem::exists(campaign / "requests" / key, error) || error;
}

std::vector<Request> requests_in(const std::filesystem::path& campaign, std::vector<std::string>& warnings) {
  std::vector<Request> requests;
  const std::filesystem::path folder = campaign / "requests";
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::filesystem::path file = it->path();
    if (file.extension() == ".tmp") continue;
    try {
      const std::string text = read_whole_file(file, longest_request).value_or("");
      if (text == "cancel\n" || text == "retry\n")
        requests.push_back({text == "cancel\n" ? Wish::cancel : Wish::retry, file.filename().string(), file});
      else if (!text.empty())
        warnings.push_back(fmt::format("{}: holds neither `cancel` nor `retry`, and is left alone", file.string()));
    } catch (const Error& unreadable) {
      warnings.push_back(unreadable.what());
    }
  }
  if (error && error != std::errc::no_such_file_or_directory)
    warnings.push_back(fmt::format("{}: cannot be listed: {}", folder.string(), error.message()));
  std::sort(requests.begin(), requests.end(), [](const Request& a, const Request& b) { return a.key < b.key; });
  return requests;
}

}  // namespace rouleau::campaign
