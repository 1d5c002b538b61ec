// SPDX-License-Identifier: BSD-3-Clause
// What a test asks of a page: its tags and attributes, ids, and whether it loads anything.
#pragma once

#include <cctype>
#include <map>
#include <string>
#include <vector>

namespace rouleau::testing {

struct Tag {
  std::string name;                               ///< lower case, without `/`
  std::map<std::string, std::string> attributes;  ///< without quotes, entities as written
};

/// All opening tags. Understands what a page of ours may hold: quoted attributes, no comments, style as raw text.
inline std::vector<Tag> tags_of(const std::string& page) {
  std::vector<Tag> tags;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at)) {
    ++at;
    if (at >= page.size() || std::isalpha(static_cast<unsigned char>(page[at])) == 0) continue;
    Tag tag;
    while (at < page.size() && std::isalnum(static_cast<unsigned char>(page[at])) != 0)
      tag.name += static_cast<char>(std::tolower(static_cast<unsigned char>(page[at++])));
    while (at < page.size() && page[at] != '>') {
      if (std::isspace(static_cast<unsigned char>(page[at])) != 0 || page[at] == '/') {
        ++at;
        continue;
      }
      std::string name, value;
      while (at < page.size() && page[at] != '=' && page[at] != '>' && page[at] != '/' &&
             std::isspace(static_cast<unsigned char>(page[at])) == 0)
        name += page[at++];
      while (at < page.size() && std::isspace(static_cast<unsigned char>(page[at])) != 0) ++at;
      if (at < page.size() && page[at] == '=') {
        ++at;
        while (at < page.size() && std::isspace(static_cast<unsigned char>(page[at])) != 0) ++at;
        const char quote = at < page.size() ? page[at] : '>';
        if (quote == '"' || quote == '\'') {
          const std::size_t end = page.find(quote, at + 1);
          value = page.substr(at + 1, end - at - 1);
          at = end == std::string::npos ? page.size() : end + 1;
        }
      }
      tag.attributes[name] = value;
    }
    tags.push_back(tag);
    if (tag.name == "style") at = page.find("</style", at);
  }
  return tags;
}

/// Why the page is not complete in itself; nothing if it is.
inline std::vector<std::string> needs_of(const std::string& page) {
  std::vector<std::string> needs;
  for (const Tag& tag : tags_of(page)) {
    for (const char* loader : {"script", "link", "iframe", "object", "embed", "img", "image", "video", "audio", "base"})
      if (tag.name == loader) needs.push_back("<" + tag.name + ">");
    for (const auto& [name, value] : tag.attributes) {
      const bool is_link = name == "href" || name == "xlink:href";
      if (name == "src" || name == "srcset" || name == "action" || name.starts_with("on"))
        needs.push_back(name + "=" + value);
      else if (is_link && value.find(':') != std::string::npos)
        needs.push_back(name + "=" + value);
      else if (is_link && tag.name != "a" && !value.starts_with('#'))
        needs.push_back(tag.name + " " + name + "=" + value);
      else if (value.find("url(") != std::string::npos && value.find("url(#") == std::string::npos)
        needs.push_back(name + "=" + value);
    }
  }
  for (const char* text : {"@import", "url(h", "url(/", "url(\""})
    if (page.find(text) != std::string::npos) needs.push_back(text);
  return needs;
}

}  // namespace rouleau::testing
