// SPDX-License-Identifier: BSD-3-Clause
// From options to the campaign's engine.
#include "commands/engine_choice.hpp"

#include <ostream>

#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace po = boost::program_options;

void describe_engine(po::options_description& options) {
  options.add_options()  //
      ("engine", po::value<std::string>()->value_name("local|slurm"),
       "this machine's cores, or jobs of a cluster; kept for later passes")  //
      ("cluster", po::value<std::string>()->value_name("FILE"),
       "how jobs are handed to Slurm; copied to cluster.ini of the campaign, where it may be edited")  //
      ("self-sustaining", po::bool_switch(),
       "Slurm: each job makes a pass over the campaign at its end; return at once")  //
      ("dry-run", po::bool_switch(), "print the job scripts that would be submitted, submit nothing");
}

void choose_engine(const CommandLine& line, Manager& manager) {
  Engine engine = manager.engine();
  if (line.has("engine")) engine = {line.get<std::string>("engine"), false};
  if (line.is_set("self-sustaining")) engine.self_sustaining = true;
  if (engine.name != local_engine && engine.name != slurm_engine)
    fail(Exit::usage, "--engine {}: is not known; there are {} and {}.", engine.name, local_engine, slurm_engine);
  if (engine.self_sustaining && engine.name != slurm_engine)
    fail(Exit::usage, "--self-sustaining needs --engine slurm; jobs of this machine are kept going by `rouleau run`.");
  if (!line.has("engine") && !line.has("cluster") && !line.is_set("self-sustaining")) return;

  const std::filesystem::path kept = cluster_file(manager.directory());
  const std::filesystem::path file =
      line.has("cluster") ? std::filesystem::path(line.get<std::string>("cluster")) : kept;
  manager.use_engine(engine, file);
  if (line.is_set("dry-run")) return;
  if (line.has("cluster")) write_whole_file(kept, read_whole_file(file).value());
  manager.keep_engine();
}

int print_scripts(const CommandLine& line, Manager& manager) {
  const std::vector<std::string> scripts = manager.scripts();
  for (const std::string& script : scripts) line.io.out << script << '\n';
  if (manager.engine().name != slurm_engine)
    line.io.err << "the engine is local: jobs are started without scripts; `rouleau plan` shows what would run\n";
  else if (scripts.empty())
    line.io.err << "nothing would be submitted now\n";
  return static_cast<int>(Exit::ok);
}

}  // namespace rouleau::campaign
