// SPDX-License-Identifier: BSD-3-Clause
// Pages in the macros of man(7), which groff and mandoc read.
#include "commands/manual.hpp"

#include <cctype>

#include "commands/help.hpp"
#include "commands/option_list.hpp"
#include "commands/roff.hpp"
#include "commands/version.hpp"
#include "study/cluster.hpp"
#include "study/nearest.hpp"
#include "study/settings.hpp"

namespace rouleau::campaign {

namespace {

/// Without a date, which would change from build to build.
std::string heading(const char* name, int section, const char* summary) {
  return fmt::format(".TH {} {} \"\" \"rouleau {}\"\n.SH NAME\n", name, section, version()) +
         roff_text(fmt::format("{} - {}", name, summary));
}

std::string bold(const std::string& text) { return roff_text('`' + text + '`'); }

std::string items(std::span<const Meaning> meanings) {
  std::string text;
  for (const Meaning& entry : meanings) text += ".TP\n" + bold(entry.word) + roff_text(entry.meaning);
  return text;
}

std::string items(const std::vector<OptionEntry>& options) {
  std::string text;
  for (const OptionEntry& option : options) {
    text += ".TP\n" + bold(option.short_name.empty() ? option.usage() : option.short_name + ", " + option.usage());
    text += roff_text(option.meaning + (option.default_text.empty() ? "" : " (default: " + option.default_text + ")"));
  }
  return text;
}

std::string section_of(const Verb& verb) {
  std::string sentence = std::string(verb.summary) + '.';
  sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  return ".SS " + roff_text(fmt::format("rouleau {}", verb.name)) + roff_text(sentence) + ".PP\n" +
         bold("rouleau " + std::string(verb.name) + " " + verb.synopsis) + ".PP\n" + roff_paragraphs(verb.notes) +
         items(own_options(verb)) + ".PP\n" + roff_lines(verb.examples);
}

std::string program_page(std::span<const Verb* const> verbs) {
  std::string page = heading("rouleau", 1, program_summary);
  page += ".SH SYNOPSIS\n" + bold("rouleau VERB ...") + ".SH EXAMPLES\n" + roff_lines(first_examples) + ".SH VERBS\n";
  const Verb* with_all = verbs.front();  // the verb that has all of the common options
  for (const Verb* verb : verbs) {
    page += section_of(*verb);
    if (common_options(*verb).size() > common_options(*with_all).size()) with_all = verb;
  }
  page += ".SH OPTIONS OF EVERY VERB\n" +
          roff_text("Those that make sense for a verb; `rouleau` VERB `--help` lists them.") +
          items(common_options(*with_all));
  page += ".SH OPTIONS OF THE PROGRAM\n" + items(program_options);
  page += ".SH POINTS\n" + roff_text(how_points_are_named);
  page += ".SH EXIT STATUS\n" + items(exit_codes);
  page += ".SH ENVIRONMENT\n" + items(environment);
  return page + ".SH SEE ALSO\n" +
         roff_text("`rouleau-study`(5), `rouleau-cluster`(5), `rouleau-solver`(1), `rouleau-run-file`(5)");
}

std::string file_page(const char* name, const char* summary, const std::string& help) {
  return heading(name, 5, summary) + ".SH DESCRIPTION\n" + roff_paragraphs(help) + ".SH SEE ALSO\n" +
         roff_text("`rouleau`(1), `rouleau-run-file`(5)");
}

}  // namespace

std::vector<std::string> manual_page_names() { return {"rouleau", "study", "cluster"}; }

std::string manual_page(std::span<const Verb* const> verbs, const std::string& name) {
  if (name == "rouleau") return program_page(verbs);
  if (name == "study") return file_page("rouleau-study", "the study file of a campaign", study_help());
  if (name == "cluster") return file_page("rouleau-cluster", "how jobs are handed to Slurm", cluster_help());
  fail(Exit::usage, "rouleau --man: there is no page `{}`; there are rouleau, study and cluster.{}", name,
       did_you_mean(name, manual_page_names()));
}

}  // namespace rouleau::campaign
