// SPDX-License-Identifier: BSD-3-Clause
// Choosing columns by their importance, then writing line by line.
#include "commands/watch_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "commands/duration.hpp"
#include "report/fit_text.hpp"
#include "report/parameter_words.hpp"
#include "report/table.hpp"

namespace rouleau::campaign {

namespace {

constexpr const char* gap = "  ";
constexpr std::size_t gap_width = 2, least_note = 20, most_bar_growth = 20;
constexpr int most_rank = 10;

using TextOf = std::function<std::string(const PointStatus&)>;

struct Field {
  std::string title;
  int rank = 0;  ///< of importance: 0 is always there
  bool to_the_right = false;
  std::size_t width = 0;  ///< at least; grows with what is in it
  TextOf text;
  bool is_chosen = false;
};

/// The parts of a terminal's 256 colours that are nearest to those of the figures, which the colour-blind tell apart.
const char* code_of(Tint tint) {
  switch (tint) {
    case Tint::running:
      return "\033[38;5;74m";
    case Tint::trouble:
      return "\033[1;38;5;166m";
    case Tint::finished:
      return "\033[38;5;36m";
    case Tint::faint:
      return "\033[2m";
    case Tint::none:
      break;
  }
  return "";
}

Tint tint_of(const PointStatus& status) {
  switch (standing_of(status)) {
    case Standing::running:
      return Tint::running;
    case Standing::trouble:
      return Tint::trouble;
    case Standing::finished:
      return status.point.state == State::done ? Tint::finished : Tint::faint;
    default:
      return Tint::none;
  }
}

/// "lambda", "mean_velocity_mm_per_s"; in UTF-8 "λ", "mean velocity, mm/s".
std::string title_of(const std::string& axis, bool utf8) {
  return utf8 ? axis_title(axis) : axis.substr(axis.rfind('.') + 1);
}

/// What is measured while it runs; empty when it does not or the solver does not say.
TextOf of_life(std::optional<double> ProgressFile::*measure, std::function<std::string(double)> text_of) {
  return [measure, text_of](const PointStatus& s) {
    return s.lives && s.progress && (*s.progress).*measure ? text_of(*((*s.progress).*measure)) : std::string();
  };
}

std::string checkpoint_age(const PointStatus& s, double now_unix_s) {
  const bool has_one = s.lives && s.progress && s.progress->checkpoint_step.value_or(0) > 0;
  if (!has_one || !s.progress->checkpoint_unix_s) return "";
  return duration_text(now_unix_s - *s.progress->checkpoint_unix_s) + " ago";
}

constexpr const char* bar_title = "";

/// In the order of the line. Least widths keep the columns from moving at every redraw.
std::vector<Field> fields_of(const WatchFacts& facts, const Look& look) {
  std::vector<Field> fields = {
      {"point", 0, false, 0, [](const PointStatus& s) { return fmt::format("#{}", s.point.ordinal); }}};
  for (std::size_t i = 0; i < facts.axes.size(); ++i)
    fields.push_back(
        {title_of(facts.axes[i], look.utf8), 1, true, 0, [i](const PointStatus& s) { return short_text(s.swept[i]); }});
  const auto two_digits = [](double value) { return fmt::format("{:.1f}", value); };
  const std::vector<Field> others = {
      {"state", 0, false, 9, [](const PointStatus& s) { return s.state_word(); }},
      {bar_title, 4, false, 10, [](const PointStatus&) { return std::string(); }},
      {"done", 2, true, 5,
       [](const PointStatus& s) { return fmt::format("{:.0f} %", std::min(100.0, 100 * s.fraction())); }},
      {"step / end", 8, true, 0, [](const PointStatus& s) { return fmt::format("{} / {}", s.step, s.point.end_step); }},
      {"MLUPS", 7, true, 5, of_life(&ProgressFile::mlups, two_digits)},
      {"left", 3, true, 12, of_life(&ProgressFile::eta_s, duration_text)},
      {"checkpoint", 9, true, 12, [&](const PointStatus& s) { return checkpoint_age(s, facts.now_unix_s); }},
      {look.utf8 ? "d, µm" : "d, um", 5, true, 6,
       [](const PointStatus& s) {
         return s.progress && s.progress->d_um ? fmt::format("{:.3f}", *s.progress->d_um) : std::string();
       }},
      {"class", 6, false, 9,
       [&](const PointStatus& s) {
         const auto found = facts.classes.find(s.point.key);
         return found == facts.classes.end() ? std::string() : found->second;
       }},
      {"attempts", most_rank, true, 0, [](const PointStatus& s) { return fmt::format("{}", s.attempts); }}};
  fields.insert(fields.end(), others.begin(), others.end());
  return fields;
}

/// Chooses what finds room, the most important first.   returns the room left
std::size_t choose(std::vector<Field>& fields, std::size_t columns) {
  std::size_t used = 0;
  for (int rank = 0; rank <= most_rank; ++rank) {
    for (Field& field : fields) {
      const std::size_t needed = (used == 0 ? 0 : gap_width) + field.width;
      if (field.rank != rank || (rank > 0 && used + needed > columns)) continue;
      field.is_chosen = true;
      used += needed;
    }
  }
  return columns - std::min(columns, used);
}

}  // namespace

Standing standing_of(const PointStatus& status) {
  if (is_in_trouble(status)) return Standing::trouble;
  if (status.is_queued) return Standing::queued;
  if (status.point.state == State::running || status.lives) return Standing::running;
  return is_final(status.point.state) || !status.point.in_study ? Standing::finished : Standing::unfinished;
}

FittedLine& FittedLine::add(const std::string& piece, Tint tint) {
  const std::string text = fitted(piece, room_);
  room_ -= std::min(room_, shown_width(text));
  text_ += colour_ && tint != Tint::none ? code_of(tint) + text + "\033[0m" : text;
  return *this;
}

std::string bar_text(double fraction, std::size_t width, bool utf8) {
  // Rounded down: a full bar is one that is done.
  const auto full = static_cast<std::size_t>(std::clamp(fraction, 0.0, 1.0) * static_cast<double>(width) + 1e-9);
  std::string bar;
  for (std::size_t i = 0; i < width; ++i) bar += utf8 ? (i < full ? "█" : "░") : (i < full ? "#" : ".");
  return bar;
}

std::vector<std::string> table_lines(const WatchFacts& facts, const std::vector<const PointStatus*>& shown,
                                     const Look& look) {
  std::vector<Field> fields = fields_of(facts, look);
  for (Field& field : fields) {
    if (look.header) field.width = std::max(field.width, shown_width(field.title));
    for (const PointStatus* s : shown) field.width = std::max(field.width, shown_width(field.text(*s)));
  }
  std::size_t room = choose(fields, static_cast<std::size_t>(look.columns));
  const bool has_notes = std::any_of(shown.begin(), shown.end(), [](const PointStatus* s) { return !s->note.empty(); });
  const bool has_note_column = has_notes && room >= gap_width + least_note;
  Field& bar = *std::find_if(fields.begin(), fields.end(), [](const Field& f) { return f.title == bar_title; });
  const std::size_t growth = has_note_column ? (room - gap_width - least_note) / 3 : has_notes ? 0 : room;
  bar.width += std::min(most_bar_growth, growth);

  std::vector<std::string> lines;
  const auto write = [&](const std::function<bool(FittedLine&, const Field&)>& add_field, const std::string& note) {
    FittedLine line(look);
    for (const Field& field : fields) {
      if (!field.is_chosen) continue;
      if (line.room() < static_cast<std::size_t>(look.columns)) line.add(gap);
      if (!add_field(line, field)) break;
    }
    if (has_note_column && !note.empty()) line.add(gap).add(note);
    lines.push_back(line.text().substr(0, line.text().find_last_not_of(' ') + 1));
  };
  const auto write_titles = [&](FittedLine& line, const Field& field) {
    line.add(filled(field.title, field.width, field.to_the_right), Tint::faint);
    return true;
  };
  if (look.header) write(write_titles, has_note_column ? "note" : "");
  for (const PointStatus* s : shown) {
    const bool is_note_in_place = !has_note_column && !s->note.empty() && !s->lives;
    const auto write_field = [&](FittedLine& line, const Field& field) {
      if (is_note_in_place && field.rank > 1) {
        line.add(s->note);
        return false;
      }
      const bool is_bar = &field == &bar;
      const std::string text = is_bar ? bar_text(s->fraction(), field.width, look.utf8) : field.text(*s);
      line.add(filled(text, field.width, field.to_the_right), is_bar || field.rank == 0 ? tint_of(*s) : Tint::none);
      return true;
    };
    write(write_field, s->note);
  }
  return lines;
}

}  // namespace rouleau::campaign
