// SPDX-License-Identifier: BSD-3-Clause
// Cutting and replacing in the text that gnuplot writes, which is the same from version to version in what is cut.
#include "report/inline_svg.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "report/markup.hpp"

namespace rouleau::campaign {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  std::string out;
  std::size_t begin = 0;
  for (std::size_t at; (at = text.find(from, begin)) != std::string::npos; begin = at + from.size()) {
    out.append(text, begin, at - begin);
    out += to;
  }
  out.append(text, begin);
  text = std::move(out);
}

/// Removes every `from` ... `to`, both included.
void remove_all(std::string& text, std::string_view from, std::string_view to) {
  std::string out;
  std::size_t begin = 0;
  for (std::size_t at; (at = text.find(from, begin)) != std::string::npos;) {
    const std::size_t end = text.find(to, at + from.size());
    if (end == std::string::npos) break;
    out.append(text, begin, at - begin);
    begin = end + to.size();
  }
  out.append(text, begin);
  text = std::move(out);
}

/// Groups that draw nothing: gnuplot sets a pen and then another one.
void remove_empty_groups(std::string& text) {
  constexpr std::string_view open = "<g fill=\"none\" color=", close = "</g>";
  std::string out;
  std::size_t begin = 0;
  for (std::size_t at = 0; (at = text.find(open, at)) != std::string::npos;) {
    const std::size_t end_of_tag = text.find('>', at);
    if (end_of_tag == std::string::npos) break;
    const std::size_t next = text.find_first_not_of(" \t\n", end_of_tag + 1);
    if (next != std::string::npos && text.compare(next, close.size(), close) == 0) {
      out.append(text, begin, at - begin);
      begin = at = next + close.size();
    } else {
      at = end_of_tag;
    }
  }
  out.append(text, begin);
  text = std::move(out);
}

std::string view_box_of(const std::string& head) {
  const std::size_t at = head.find("viewBox=\"");
  if (at == std::string::npos) return "";
  const std::size_t begin = at + 9;
  return head.substr(begin, head.find('"', begin) - begin);
}

}  // namespace

std::string svg_head(const std::string& id, const std::string& view_box, const std::string& title,
                     const std::string& description) {
  return fmt::format(
      "<svg role=\"img\" viewBox=\"{1}\" aria-label=\"{2}\" aria-describedby=\"{0}-desc\"><title>{2}</title>"
      "<desc id=\"{0}-desc\">{3}</desc>\n",
      id, view_box, escaped(title), escaped(description));
}

std::optional<std::string> inline_svg(const Figure& figure, std::string text) {
  const std::size_t begin = text.find("<svg"), end = text.rfind("</svg>");
  if (begin == std::string::npos || end == std::string::npos) return std::nullopt;
  const std::size_t end_of_head = text.find('>', begin);
  const std::string box = view_box_of(text.substr(begin, end_of_head - begin));
  if (box.empty()) return std::nullopt;
  text = text.substr(end_of_head + 1, end - end_of_head - 1);

  remove_all(text, "<title>", "</title>");
  remove_all(text, "<desc>", "</desc>");
  remove_all(text, "<filter ", "</filter>");
  const std::size_t end_of_definitions = text.find("</defs>");
  const bool uses_signs =
      end_of_definitions != std::string::npos && text.find("<use ", end_of_definitions) != std::string::npos;
  if (!uses_signs && text.find("<pattern") == std::string::npos) remove_all(text, "<defs>", "</defs>");
  const std::array<std::pair<std::string, std::string>, 8> changes = {
      {{"xlink:href", "href"},
       {"id='gp", fmt::format("id='{}-gp", figure.name)},
       {"id = \"gp", fmt::format("id=\"{}-gp", figure.name)},
       {"id=\"gp", fmt::format("id=\"{}-gp", figure.name)},
       {"'#gp", fmt::format("'#{}-gp", figure.name)},
       {"(#gp", fmt::format("(#{}-gp", figure.name)},
       {"id=\"gnuplot_", fmt::format("id=\"{}-", figure.name)},
       {" stroke-linecap=\"butt\" stroke-linejoin=\"miter\"", ""}}};
  for (const auto& [from, to] : changes) replace_all(text, from, to);
  remove_empty_groups(text);
  remove_empty_groups(text);
  replace_all(text, "\n\t", "\n");
  return svg_head(figure.name, box, figure.title, figure.description) + text + "</svg>\n";
}

}  // namespace rouleau::campaign
