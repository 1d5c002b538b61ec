// SPDX-License-Identifier: BSD-3-Clause
// The report in a real browser (Debian's chromium, headless): no message on its console, no request, no sideways
// scrolling on a phone, pages on paper. Run by share/validate.sh.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "small_report.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::set_content;
using rouleau::testing::small_study;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// chromium over a page to its end, without a way to any network; `more` comes before the page.
Capture browse(const std::filesystem::path& page, std::vector<std::string> more) {
  std::vector<std::string> command = {"chromium",
                                      "--headless",
                                      "--no-sandbox",
                                      "--disable-gpu",
                                      "--no-first-run",
                                      "--host-resolver-rules=MAP * ~NOTFOUND",
                                      "--enable-logging=stderr"};
  command.insert(command.end(), more.begin(), more.end());
  command.push_back("file://" + page.string());
  const std::filesystem::path directory = page.parent_path();
  return run_and_capture(command, {.directory = directory, .time_out_s = 120, .environment = {}});
}

/// The addresses that a page asked for, besides files and what chromium asks its maker for by itself.
std::set<std::string> requests_of(const std::filesystem::path& page) {
  const std::filesystem::path log = page.parent_path() / "net.json";
  static_cast<void>(browse(page, {"--log-net-log=" + log.string(), "--dump-dom"}));
  const std::string text = content_of(log);
  EXPECT_THAT(text, HasSubstr("\"events\""));
  std::set<std::string> requests;
  constexpr std::string_view key = "\"url\":\"";
  for (std::size_t at = 0; (at = text.find(key, at)) != std::string::npos;) {
    at += key.size();
    const std::string url = text.substr(at, text.find('"', at) - at);
    const std::size_t host = url.find("://") + 3;
    const std::string name = url.substr(host, url.find('/', host) - host);
    const bool is_its_own =
        name.ends_with(".googleapis.com") || name.ends_with(".google.com") || name.ends_with(".gvt1.com");
    if (url.starts_with("http") && !is_its_own) requests.insert(url);
  }
  return requests;
}

std::vector<std::string> console_of(const std::filesystem::path& page) {
  const Capture capture = browse(page, {"--dump-dom"});
  EXPECT_THAT(capture.out, HasSubstr("<html")) << capture.err;
  std::vector<std::string> lines;
  for (std::size_t at = 0; (at = capture.err.find(":CONSOLE", at)) != std::string::npos; ++at)
    lines.push_back(capture.err.substr(at, capture.err.find('\n', at) - at));
  return lines;
}

class ReportInBrowser : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    program_ = new CampaignProgram(REAL_SOLVER_PROGRAM);
    set_content(program_->study(), small_study("0.008"));
    ASSERT_EQ(program_->init().status, 0);
    ASSERT_EQ(program_->run().status, 0);
    const Capture report = program_->rouleau({"report", "c", "-o", "report.html"});
    ASSERT_EQ(report.status, 0) << report.err;
    ASSERT_THAT(report.err, ::testing::Not(HasSubstr("note:")));
  }
  static void TearDownTestSuite() {
    delete program_;
    program_ = nullptr;
  }
  static std::filesystem::path report() { return program_->path() / "report.html"; }
  static std::filesystem::path beside(const std::string& name) { return program_->path() / name; }

  /// Width of a frame and of what the report takes in it, as a script appended to a copy measures them. (A window of
  /// chromium's own is never narrower than 500.)
  static std::pair<int, int> widths(int frame) {
    set_content(beside("measured.html"), content_of(report()) +
                                             "<script>parent.postMessage(innerWidth + ' ' + "
                                             "document.documentElement.scrollWidth, '*')</script>");
    set_content(beside("frame.html"),
                fmt::format("<!DOCTYPE html><title>none</title><script>onmessage = e => document.title = 'widths ' + "
                            "e.data</script><iframe src=\"measured.html\" width=\"{}\" height=\"844\" "
                            "style=\"border: 0\"></iframe>",
                            frame));
    const Capture capture = browse(beside("frame.html"), {"--virtual-time-budget=10000", "--dump-dom"});
    std::pair<int, int> found;
    const std::size_t at = capture.out.find("<title>widths ");
    EXPECT_NE(at, std::string::npos) << capture.out.substr(0, 500);
    if (at != std::string::npos)
      std::sscanf(capture.out.c_str() + at, "<title>widths %d %d", &found.first, &found.second);
    return found;
  }

 private:
  static inline CampaignProgram* program_ = nullptr;
};

TEST_F(ReportInBrowser, AsksNobodyForAnything) {
  EXPECT_THAT(requests_of(report()), IsEmpty());
  set_content(beside("asking.html"), "<!DOCTYPE html><title>a</title><img src=\"http://example.invalid/x.png\">");
  EXPECT_THAT(requests_of(beside("asking.html")), ::testing::ElementsAre("http://example.invalid/x.png"));
}

TEST_F(ReportInBrowser, LeavesTheConsoleEmpty) {
  EXPECT_THAT(console_of(report()), IsEmpty());
  set_content(beside("loud.html"), "<!DOCTYPE html><title>a</title><script>console.error('oh')</script>");
  EXPECT_THAT(console_of(beside("loud.html")), ::testing::SizeIs(1));
}

TEST_F(ReportInBrowser, FitsPhoneAndDesk) {
  for (const int window : {390, 1280}) {
    const auto [inner, shown] = widths(window);
    EXPECT_EQ(inner, window);
    EXPECT_LE(shown, inner);
  }
}

TEST_F(ReportInBrowser, IsShownAndPrinted) {
  static_cast<void>(browse(report(), {"--window-size=390,844", "--screenshot=" + beside("phone.png").string()}));
  EXPECT_TRUE(content_of(beside("phone.png")).starts_with("\x89PNG"));
  static_cast<void>(browse(report(), {"--no-pdf-header-footer", "--print-to-pdf=" + beside("report.pdf").string()}));
  EXPECT_TRUE(content_of(beside("report.pdf")).starts_with("%PDF"));

  // On paper nothing can be opened: what is folded on the screen is printed.
  const std::string page = content_of(report());
  std::smatch identity;
  const std::string folded = page.substr(page.find("<summary>Digests"));
  ASSERT_TRUE(std::regex_search(folded, identity, std::regex("[0-9a-f]{32}")));
  ASSERT_EQ(page.find(identity.str()), page.size() - folded.size() + static_cast<std::size_t>(identity.position()))
      << "it stands elsewhere, too";
  const Capture paper = run_and_capture({"pdftotext", "-layout", beside("report.pdf").string(), "-"});
  EXPECT_THAT(paper.out, HasSubstr(identity.str()));
}

}  // namespace
}  // namespace rouleau::campaign
