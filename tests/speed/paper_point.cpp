// SPDX-License-Identifier: BSD-3-Clause
#include "paper_point.hpp"

#include <set>

#include "run/ini.hpp"
#include "storage/files.hpp"

namespace rouleau::speed {

namespace {

/// Of a study file, what is no run's business.
const std::set<std::string> sections_of_the_manager{"study", "sweep", "execution", "analysis"};

std::string run_file_text(const Changes& values) {
  std::string text, section;
  for (const auto& [name, value] : values) {
    const auto dot = name.find('.');
    if (name.substr(0, dot) != section) text += "[" + (section = name.substr(0, dot)) + "]\n";
    text += name.substr(dot + 1) + " = " + value + "\n";
  }
  return text;
}

}  // namespace

Setup paper_point(const std::filesystem::path& study, const std::filesystem::path& directory, const Changes& changes) {
  FileSystem& files = posix_file_system();
  Changes values{{"fluid.lambda", "5"}};
  for (const IniEntry& entry : read_ini(read_file(files, study), study.string()).entries)
    if (!sections_of_the_manager.contains(entry.section)) values[entry.section + "." + entry.name] = entry.value;
  for (const auto& [name, value] : changes) values[name] = value;
  std::filesystem::create_directories(directory);
  write_aside(files, directory / "run.ini", run_file_text(values));
  return set_up(directory / "run.ini", files);
}

PointRun::PointRun(Setup setup, const Communicator& comm)
    : setup_(std::make_unique<Setup>(std::move(setup))),
      comm_(comm),
      simulation_(make_simulation(*setup_, comm, Decomposition(setup_->lattice.lattice, comm))) {
  simulation_->start();
}

}  // namespace rouleau::speed
