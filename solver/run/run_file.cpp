// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "base/read_error.hpp"
#include "run/identity.hpp"
#include "run/ini.hpp"
#include "run/parameter_table.hpp"
#include "run/value_text.hpp"

namespace rouleau {
namespace {

constexpr std::size_t largest_file = std::size_t{1} << 20;  // bytes
constexpr std::size_t most_cells = 1000;

// A parameter of one cell or of the run, on the way from text to value.
struct Slot {
  const ParameterSpec* parameter = nullptr;
  std::string section;  // `cell.2` for the second cell
  std::size_t cell = 0;
  const IniEntry* entry = nullptr;
  std::string default_text;
  TypedValue typed;
  std::string canonical_value, canonical_default;
  bool applies = true;

  [[nodiscard]] std::string name() const { return section + "." + std::string(parameter->name); }
};

std::string suggestion(const std::string& near) { return near.empty() ? "" : fmt::format("; did you mean {}?", near); }

class Reader {
 public:
  Reader(std::string_view text, const std::filesystem::path& path) : path_(path), ini_(read_ini(text, path.string())) {
    for (const auto& e : ini_.entries) entries_[{e.section, e.name}] = &e;
  }

  RunFile read() {
    lay_out_slots();
    refuse_unknown_entries();
    for (Slot& slot : slots_) read_value(slot);
    for (Slot& slot : slots_) apply_conditions(slot);
    return filled();
  }

 private:
  [[nodiscard]] std::string at(int line) const { return fmt::format("{}:{}", path_.string(), line); }

  // The number behind `cell.`, 2 or more; nothing if the section is no further cell.
  std::optional<std::size_t> further_cell(const IniSection& section) const {
    constexpr std::string_view prefix = "cell.";
    if (!section.name.starts_with(prefix)) return std::nullopt;
    const std::string digits = section.name.substr(prefix.size());
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc{} || end != digits.data() + digits.size() || number < 2 || digits[0] == '0')
      fail(Exit::bad_input, "{}: section [{}] is no cell; the first is [cell], further ones are [cell.2], [cell.3] ...",
           at(section.line), section.name);
    return number;
  }

  void lay_out_slots() {
    std::vector<const IniSection*> further;
    for (const auto& s : ini_.sections)
      if (further_cell(s)) further.push_back(&s);
    std::sort(further.begin(), further.end(), [&](auto* a, auto* b) { return further_cell(*a) < further_cell(*b); });
    for (std::size_t i = 0; i < further.size(); ++i)
      if (*further_cell(*further[i]) != i + 2)
        fail(Exit::bad_input, "{}: section [{}] without [cell.{}]; number further cells 2, 3 ... without a gap",
             at(further[i]->line), further[i]->name, i + 2);
    cells_ = 1 + further.size();
    if (cells_ > most_cells)
      fail(Exit::bad_input, "{}: section [{}]; at most {} cells are taken. Remove some.",
           at(further[most_cells - 1]->line), further[most_cells - 1]->name, most_cells);

    const auto table = parameter_table();
    for (auto p = table.begin(); p != table.end();) {
      const auto section_end = std::find_if(p, table.end(), [&](const auto& q) { return q.section != p->section; });
      for (std::size_t c = 0; c < (p->section == "cell" ? cells_ : 1); ++c)
        for (auto q = p; q != section_end; ++q) add_slot(*q, c);
      p = section_end;
    }
  }

  void add_slot(const ParameterSpec& parameter, std::size_t cell) {
    Slot slot;
    slot.parameter = &parameter;
    slot.cell = cell;
    slot.section = cell == 0 ? std::string(parameter.section) : fmt::format("cell.{}", cell + 1);
    slot.default_text = parameter.default_text;
    // A further cell is there because its section is; without this a cell of defaults would not enter the identity.
    if (cell > 0 && parameter.name == "shape") slot.default_text.clear();
    const auto entry = entries_.find({slot.section, parameter.name});
    if (entry != entries_.end()) slot.entry = entry->second;
    slots_.push_back(std::move(slot));
  }

  void refuse_unknown_entries() const {
    std::vector<std::string> sections;
    for (const auto& s : slots_)
      if (std::find(sections.begin(), sections.end(), s.section) == sections.end()) sections.push_back(s.section);
    for (const auto& s : ini_.sections)
      if (std::find(sections.begin(), sections.end(), s.name) == sections.end()) {
        const std::string near = nearest(s.name, sections);
        fail(Exit::bad_input, "{}: unknown section [{}]{}", at(s.line), s.name,
             near.empty() ? fmt::format("; there are {}", fmt::join(sections, ", ")) : suggestion("[" + near + "]"));
      }
    for (const auto& e : ini_.entries) {
      const auto known = std::any_of(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.entry == &e; });
      if (!known) fail(Exit::bad_input, "{}: unknown parameter {} in [{}]{}", at(e.line), e.name, e.section, hint(e));
    }
  }

  [[nodiscard]] std::string hint(const IniEntry& e) const {
    std::vector<std::string> here, anywhere;
    for (const auto& s : slots_) {
      if (s.parameter->name == e.name) return fmt::format("; it belongs into [{}]", s.section);
      (s.section == e.section ? here : anywhere).emplace_back(s.parameter->name);
    }
    const std::string near = nearest(e.name, here);
    return near.empty() ? "; rouleau-solver --help-run-file lists all" : suggestion(near);
  }

  void read_value(Slot& slot) const {
    if (!slot.default_text.empty()) slot.canonical_default = convert(slot, slot.default_text, slot.typed);
    slot.canonical_value = slot.canonical_default;
    if (!slot.entry) return;
    const auto refuse = [&](const std::string& why) {
      fail(Exit::bad_input, "{}: {} = {} {}", at(slot.entry->line), slot.parameter->name, slot.entry->value, why);
    };
    try {
      slot.canonical_value = convert(slot, slot.entry->value, slot.typed);
    } catch (const std::invalid_argument& e) {
      refuse(e.what());
    }
    const ParameterSpec& p = *slot.parameter;
    const auto outside = [&](double v) { return v < p.min || v > p.max; };
    const bool bad =
        (p.type == ParameterType::real && outside(slot.typed.real)) ||
        (p.type == ParameterType::integer && outside(static_cast<double>(slot.typed.integer))) ||
        (p.type == ParameterType::vector &&
         (outside(slot.typed.vector[0]) || outside(slot.typed.vector[1]) || outside(slot.typed.vector[2])));
    if (bad) refuse(fmt::format("is outside its range, {} to {}", canonical(p.min), canonical(p.max)));
  }

  // Sets `typed` and returns the canonical text. Throws std::invalid_argument.
  std::string convert(const Slot& slot, const std::string& text, TypedValue& typed) const {
    const auto& choices = slot.parameter->choices;
    switch (slot.parameter->type) {
      case ParameterType::real:
        return canonical(typed.real = parse_real(text));
      case ParameterType::integer:
        return std::to_string(typed.integer = parse_integer(text));
      case ParameterType::vector:
        return canonical(typed.vector = parse_vector(text));
      case ParameterType::file:
        typed.file = path_.parent_path() / text;
        return text;
      case ParameterType::choice:
        break;
    }
    const auto chosen = std::find(choices.begin(), choices.end(), text);
    if (chosen == choices.end())
      throw std::invalid_argument(fmt::format("is none of {}", fmt::join(choices, ", ")) +
                                  suggestion(nearest(text, {choices.begin(), choices.end()})));
    typed.choice = static_cast<std::size_t>(chosen - choices.begin());
    return text;
  }

  [[nodiscard]] const Slot& slot_of(const std::string& section, std::string_view name) const {
    return *std::find_if(slots_.begin(), slots_.end(),
                         [&](const Slot& s) { return s.section == section && s.parameter->name == name; });
  }

  // Refuses what is given but means nothing, and what is missing but needed.
  void apply_conditions(Slot& slot) const {
    const std::string_view name = slot.parameter->name;
    const Slot* because = nullptr;  // the choice that makes the parameter necessary
    for (const auto& condition : slot.parameter->conditions) {
      const bool by_cells = condition.selector == "cells";
      const Slot& selector = by_cells ? slot_of("cell", "shape") : slot_of(slot.section, condition.selector);
      const auto& admitted = condition.admitted;
      const bool holds = by_cells
                             ? selector.canonical_value != "none"
                             : std::find(admitted.begin(), admitted.end(), selector.canonical_value) != admitted.end();
      if (!holds && slot.entry)
        fail(Exit::bad_input, "{}: {} means nothing with {} = {}; {}", at(slot.entry->line), name,
             by_cells ? selector.name() : std::string(condition.selector), selector.canonical_value,
             by_cells ? "remove it, or choose a shape"
                      : fmt::format("remove it, or choose {} = {}", condition.selector, fmt::join(admitted, " or ")));
      slot.applies = slot.applies && holds;
      because = &selector;
    }
    if (slot.cell > 0 && name == "shape" && slot.canonical_value == "none")
      fail(Exit::bad_input, "{}: shape = none in [{}]; remove the section", at(slot.entry->line), slot.section);
    const bool needed = slot.default_text.empty() && !has_computed_default(name);
    if (!slot.applies || slot.entry || !needed) return;
    fail(Exit::bad_input, "{}: {} is missing in [{}]{}; add for example `{} = {}`", at(line_for_missing(slot, because)),
         name, slot.section,
         because ? fmt::format(", {} = {} needs it", because->parameter->name, because->canonical_value) : "", name,
         slot.parameter->example.empty() ? slot.parameter->default_text : slot.parameter->example);
  }

  static bool has_computed_default(std::string_view name) { return name == "position_x_um" || name == "frequency"; }

  void refuse_both(const Slot& slot, const Slot& other) const {
    if (slot.entry && other.entry)
      fail(Exit::bad_input, "{}: {} = {} and {} = {} (line {}) say the same thing twice; remove one",
           at(slot.entry->line), slot.parameter->name, slot.entry->value, other.parameter->name, other.entry->value,
           other.entry->line);
  }

  [[nodiscard]] int line_for_missing(const Slot& slot, const Slot* because) const {
    if (because && because->entry) return because->entry->line;
    for (const auto& s : ini_.sections)
      if (s.name == slot.section) return s.line;
    return std::max(ini_.lines, 1);
  }

  RunFile filled() const {
    RunFile run;
    run.path = path_;
    run.parameters.cells.resize(cells_);
    for (const Slot& slot : slots_) {
      slot.parameter->store(run.parameters, slot.cell, slot.typed);
      ParameterValue v{
          slot.name(),          slot.canonical_value,  slot.canonical_default,           slot.canonical_value,
          slot.parameter->kind, slot.entry != nullptr, slot.entry ? slot.entry->line : 0};
      if (slot.parameter->name == "position_x_um" && slot.applies) {
        const double half = 0.5 * run.parameters.channel.length_x_um;
        v.default_value = canonical(half);
        if (!slot.entry) {
          run.parameters.cells[slot.cell].position_x_um = half;
          v.value = v.identity_value = v.default_value;
        }
      }
      if (slot.parameter->name == "frequency" && slot.applies) {
        const Slot& subdivisions = slot_of(slot.section, "subdivisions");
        refuse_both(slot, subdivisions);
        const int frequency = 1 << subdivisions.typed.integer;
        v.default_value = std::to_string(frequency);
        if (!slot.entry) {
          run.parameters.cells[slot.cell].frequency = frequency;
          v.value = v.identity_value = v.default_value;
        }
      }
      if (slot.parameter->type == ParameterType::file && slot.entry) v.identity_value = digest_of(slot);
      run.values.push_back(std::move(v));
    }
    const auto& first = run.parameters.cells.front();
    if (first.shape == Shape::none && cells_ > 1)
      fail(Exit::bad_input, "{}: [cell] shape = none, but there are further cells; begin with [cell]",
           run.where("cell.shape"));
    if (first.shape == Shape::none) run.parameters.cells.clear();
    run.identity = identity_digest(run.values);
    return run;
  }

  [[nodiscard]] std::string digest_of(const Slot& slot) const {
    try {
      return "xxh3:" + content_digest(slot.typed.file);
    } catch (const Error& e) {
      fail(e.code(), "{}: {} = {} cannot be read: {}; paths are relative to the run file's folder",
           at(slot.entry->line), slot.parameter->name, slot.entry->value, e.what());
    }
  }

  std::filesystem::path path_;
  Ini ini_;
  std::map<std::pair<std::string_view, std::string_view>, const IniEntry*> entries_;
  std::size_t cells_ = 1;
  std::vector<Slot> slots_;
};

}  // namespace

const ParameterValue& RunFile::value(std::string_view name) const {
  const auto found = std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.name == name; });
  require(found != values.end(), "RunFile::value: no such parameter");
  return *found;
}

std::string RunFile::where(std::string_view name) const {
  const int line = value(name).line;
  return line > 0 ? fmt::format("{}:{}", path.string(), line) : path.string();
}

RunFile parse_run_file(std::string_view text, const std::filesystem::path& path) {
  if (text.size() > largest_file)
    fail(Exit::bad_input, "{}: the file has more than the {} bytes that a run file may have; is it one?", path.string(),
         largest_file);
  return Reader(text, path).read();
}

RunFile read_run_file(const std::filesystem::path& path) {
  const auto unreadable = [&](Exit code, const char* why) {
    fail(code, "{}: the run file cannot be read: {}", path.string(), why);
  };
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown))
    unreadable(Exit::bad_input, "it is a directory; name the run.ini in it");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!stream) unreadable(exit_of_read(errno), std::strerror(errno));
  std::string text(largest_file + 1, '\0');  // one byte more than allowed shows that there are more
  text.resize(std::fread(text.data(), 1, text.size(), stream.get()));
  if (std::ferror(stream.get())) unreadable(exit_of_read(errno), std::strerror(errno));
  return parse_run_file(text, path);
}

}  // namespace rouleau
