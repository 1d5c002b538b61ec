// SPDX-License-Identifier: BSD-3-Clause
#include "suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <ostream>

#include "base/error.hpp"
#include "report.hpp"

namespace rouleau::validation {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  if (!out) fail(Exit::io, "{}: cannot be written. See that its directory exists and has room", file.string());
}

}  // namespace

void Suite::add(Finding finding) {
  const auto now = std::chrono::steady_clock::now();
  finding.case_name = case_name_;
  finding.time_s = std::chrono::duration<double>(now - last_).count();
  last_ = now;
  fmt::print(stderr, "  {}\n", line_of(finding));
  findings_.push_back(std::move(finding));
}

void Suite::check(const std::string& quantity, double ours, const Expected& expected, const std::string& source,
                  const std::string& note) {
  add({"", quantity, ours, expected, source, note});
}

void Suite::figure(const std::string& quantity, double value, const std::string& note) {
  add({"", quantity, value, std::nullopt, "", note});
}

void Suite::run(const std::string& case_name, const std::function<void(Suite&)>& work) {
  case_name_ = case_name;
  last_ = std::chrono::steady_clock::now();
  const std::size_t before = findings_.size();
  const auto fails = [&](const std::string& why) { check("runs to its end", 0, near(1, 0), "the suite itself", why); };
  try {
    work(*this);
    const auto is_check = [](const Finding& finding) { return finding.expected.has_value(); };
    if (std::none_of(findings_.begin() + static_cast<std::ptrdiff_t>(before), findings_.end(), is_check))
      fails("the case has checked nothing");
  } catch (const std::exception& error) {
    fails(error.what());
  }
}

bool Suite::has_passed() const {
  return std::all_of(findings_.begin(), findings_.end(), [](const Finding& finding) { return finding.has_passed(); });
}

int run_cases(std::span<const Case> cases, const Places& places, const std::filesystem::path& results,
              std::ostream& out) {
  Suite suite(places);
  for (const Case& each : cases) {
    fmt::print(stderr, "== {}: {}\n", each.name, each.title);
    suite.run(each.name, each.work);
  }
  const std::string table = table_of(suite.findings());
  out << table;
  write(results.string() + ".txt", table);
  write(results.string() + ".json", json_of(suite.findings()));
  return suite.has_passed() ? 0 : 1;
}

}  // namespace rouleau::validation
