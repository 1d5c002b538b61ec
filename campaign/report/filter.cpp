// SPDX-License-Identifier: BSD-3-Clause
// A recursive-descent parser from --where to SQL. No text of the user ever becomes part of the SQL.
#include "report/filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <vector>

#include "study/error.hpp"
#include "study/nearest.hpp"
#include "study/numbers.hpp"

namespace rouleau::campaign {
namespace {

constexpr int deepest_nesting = 50;

enum class TokenKind { word, quoted, symbol, end };

struct Token {
  TokenKind kind = TokenKind::end;
  std::string text;
  std::size_t place = 0;  ///< of its first character, from 1
};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' || c == '-' || c == '/' ||
         c == ':';
}

[[noreturn]] void fail_at(const Token& token, std::string_view expected) {
  const std::string what = token.kind == TokenKind::end ? "the end" : "`" + token.text + "`";
  fail(Exit::usage, "--where: character {}: {} where {} was expected", token.place, what, expected);
}

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t i = 0;
  while (i < text.size()) {
    const char c = text[i];
    const std::size_t begin = i;
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++i;
    } else if (c == '\'' || c == '"') {
      const std::size_t end = text.find(c, i + 1);
      if (end == std::string_view::npos)
        fail(Exit::usage, "--where: character {}: the quote {} is not closed", i + 1, c);
      tokens.push_back({TokenKind::quoted, std::string(text.substr(i + 1, end - i - 1)), begin + 1});
      i = end + 1;
    } else if (is_word_character(c)) {
      while (i < text.size() && is_word_character(text[i])) ++i;
      tokens.push_back({TokenKind::word, std::string(text.substr(begin, i - begin)), begin + 1});
    } else {
      static constexpr std::array<std::string_view, 11> symbols = {"<=", ">=", "!=", "<>", "==", "<",
                                                                   ">",  "=",  "(",  ")",  ","};
      const auto found = std::find_if(symbols.begin(), symbols.end(),
                                      [&](std::string_view symbol) { return text.substr(i).starts_with(symbol); });
      if (found == symbols.end())
        fail(Exit::usage, "--where: character {}: `{}` has no meaning here; conditions are joined by `and` and `or`",
             i + 1, c);
      tokens.push_back({TokenKind::symbol, std::string(*found), begin + 1});
      i += found->size();
    }
  }
  tokens.push_back({TokenKind::end, "", text.size() + 1});
  return tokens;
}

class Parser {
 public:
  Parser(std::string_view text, const Columns& columns, BoundValues& values)
      : tokens_(tokens_of(text)), columns_(columns), values_(values) {}

  std::string whole() {
    const std::string sql = condition(0);
    if (now().kind != TokenKind::end) fail_at(now(), "`and`, `or` or the end");
    return sql;
  }

 private:
  [[nodiscard]] const Token& now() const { return tokens_[next_]; }
  Token take() { return tokens_[now().kind == TokenKind::end ? next_ : next_++]; }
  bool take_word(std::string_view word) {
    const bool is_it = now().kind == TokenKind::word && lower(now().text) == word;
    if (is_it) ++next_;
    return is_it;
  }
  bool take_symbol(std::string_view symbol) {
    const bool is_it = now().kind == TokenKind::symbol && now().text == symbol;
    if (is_it) ++next_;
    return is_it;
  }

  std::string condition(int depth) {
    if (depth > deepest_nesting)
      fail(Exit::usage, "--where: more than {} parentheses inside one another", deepest_nesting);
    std::string sql = conjunction(depth);
    while (take_word("or")) sql += " OR " + conjunction(depth);
    return "(" + sql + ")";
  }

  std::string conjunction(int depth) {
    std::string sql = factor(depth);
    while (take_word("and")) sql += " AND " + factor(depth);
    return sql;
  }

  std::string factor(int depth) {
    if (depth > deepest_nesting) fail(Exit::usage, "--where: more than {} times `not` in a row", deepest_nesting);
    if (take_word("not")) return "NOT (" + factor(depth + 1) + ")";
    if (take_symbol("(")) {
      const std::string sql = condition(depth + 1);
      if (!take_symbol(")")) fail_at(now(), "`)`");
      return sql;
    }
    return comparison();
  }

  std::string comparison() {
    const Token name = take();
    if (name.kind == TokenKind::end || name.kind == TokenKind::symbol) fail_at(name, "the name of a column");
    const Column& column = columns_.find(name.text);
    const std::string expression = expression_of(column, values_);
    if (take_word("is")) {
      const bool negated = take_word("not");
      if (!take_word("null")) fail_at(now(), "`null`");
      return expression + (negated ? " IS NOT NULL" : " IS NULL");
    }
    const std::string negation = take_word("not") ? " NOT" : "";
    if (take_word("between")) {
      const std::string low = value(column);
      if (!take_word("and")) fail_at(now(), "`and` and the upper end of `between`");
      return expression + negation + " BETWEEN " + low + " AND " + value(column);
    }
    if (take_word("in")) {
      if (!take_symbol("(")) fail_at(now(), "`(` and the values of `in`");
      std::string list = value(column);
      while (take_symbol(",")) list += ", " + value(column);
      if (!take_symbol(")")) fail_at(now(), "`,` or `)`");
      return expression + negation + " IN (" + list + ")";
    }
    if (!negation.empty()) fail_at(now(), "`between` or `in`");
    static constexpr std::array<std::string_view, 8> operators = {"=", "==", "!=", "<>", "<=", ">=", "<", ">"};
    for (const std::string_view symbol : operators)
      if (take_symbol(symbol)) return expression + " " + std::string(symbol) + " " + value(column);
    fail_at(now(), "a comparison (=, !=, <, <=, >, >=, between, in, is null)");
  }

  /// The placeholder of a value that fits the column.
  std::string value(const Column& column) {
    const Token token = take();
    if (token.kind == TokenKind::end || token.kind == TokenKind::symbol) fail_at(token, "a value");
    if (column.type == ColumnType::number) {
      const std::optional<double> number = parse_number(token.text);
      if (!number)
        fail(Exit::usage, "--where: character {}: {} is a number, `{}` is none", token.place, column.name, token.text);
      return values_.add(*number);
    }
    const std::vector<std::string> words = words_of(column);
    if (!words.empty() && std::find(words.begin(), words.end(), token.text) == words.end())
      fail(Exit::usage, "--where: character {}: {} is never `{}`; it is one of {}.{}", token.place, column.name,
           token.text, fmt::join(words, ", "), did_you_mean(token.text, words));
    return values_.add(token.text);
  }

  std::vector<Token> tokens_;
  std::size_t next_ = 0;
  const Columns& columns_;
  BoundValues& values_;
};

}  // namespace

std::string compile_condition(std::string_view condition, const Columns& columns, BoundValues& values) {
  return Parser(condition, columns, values).whole();
}

}  // namespace rouleau::campaign
