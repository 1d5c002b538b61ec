// SPDX-License-Identifier: BSD-3-Clause
// rouleau-solver: options, MPI, the run, and an exit code for every error.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "parallel/version.hpp"
#include "run/attempt_run.hpp"
#include "run/command_line.hpp"
#include "run/completion.hpp"
#include "run/look.hpp"
#include "run/manual.hpp"
#include "run/parameter_table.hpp"
#include "run/shape.hpp"
#include "run/stop.hpp"
#include "run/version.hpp"
#include "storage/version.hpp"

namespace {

using namespace rouleau;

int print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  return std::fflush(stdout) == 0 ? 0 : static_cast<int>(Exit::io);
}

void print_error(const char* what) { fmt::print(stderr, "rouleau-solver: {}\n", what); }

int run(const RunOptions& options, int* argc, char*** argv) {
  catch_stop_signals();
  const MpiSession session(argc, argv);
  const Communicator comm;
  return comm.or_end_all([&] {
    try {
      return static_cast<int>(run_attempt(options, comm, posix_file_system()));
    } catch (const Error& error) {  // all ranks throw alike
      if (comm.is_root()) print_error(error.what());
      return static_cast<int>(error.code());
    }
  });
}

int answer(const CommandLine& line) {
  FileSystem& files = posix_file_system();
  switch (line.verb) {
    case Verb::help:
      return print(help_text());
    case Verb::help_run_file:
      return print(example_run_file());
    case Verb::manual:
      return print(manual_page());
    case Verb::manual_of_run_file:
      return print(manual_page_of_run_file());
    case Verb::complete:
      return print(completions(line.words));
    case Verb::version:
      return print(version_text(hdf5_version(), mpi_version()));
    case Verb::check:
      return print(check_text(line.file, line.json, files));
    case Verb::inspect:
      return print(inspect_text(line.file, line.json, files));
    case Verb::shape:
      return print(shape_text(line.file, line.slice_normal, files));
    case Verb::verify: {
      const VerifyAnswer answer = verify_text(line.file, files);
      print(answer.text);
      return answer.sound ? 0 : static_cast<int>(Exit::bad_input);
    }
    case Verb::run:
      break;
  }
  throw std::logic_error("a run is no question");
}

}  // namespace

int main(int argc, char** argv) try {
  const CommandLine line = parse_command_line(argc, argv);
  return line.verb == Verb::run ? run(line.run, &argc, &argv) : answer(line);
} catch (const Error& error) {
  print_error(error.what());
  return static_cast<int>(error.code());
} catch (const std::exception& error) {
  print_error(error.what());
  return static_cast<int>(Exit::internal);
}
