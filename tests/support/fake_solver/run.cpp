// SPDX-License-Identifier: BSD-3-Clause
// The loop of a fake run.
#include "run.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "run_directory.hpp"

namespace fake {

namespace {

using Json = nlohmann::ordered_json;

volatile sig_atomic_t stop_signal = 0;
void on_signal(int) { stop_signal = 1; }

long long environment(const char* name, long long otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atoll(text);
}

/// What the file `fake` has for this start: "crash 120", "exit 70 50", "mute 9", "hang 30". The line is used up.
struct Script {
  std::string word;
  long long first = -1, second = -1;
};

Script take_script() {
  Script script;
  std::istringstream in(read_whole("fake"));
  std::string line, rest;
  if (!std::getline(in, line)) return script;
  while (std::getline(in, rest)) script.word += rest + "\n";
  write_whole("fake", script.word);
  script.word.clear();
  std::istringstream(line) >> script.word >> script.first >> script.second;
  return script;
}

std::string host() {
  char name[256] = {};
  ::gethostname(name, sizeof name - 1);
  return name;
}

long long start_ticks() {
  const std::string stat = read_whole("/proc/self/stat");
  std::istringstream fields(stat.substr(stat.rfind(')') + 1));
  std::string skipped;
  for (int field = 3; field < 22; ++field) fields >> skipped;
  long long ticks = 0;
  fields >> ticks;
  return ticks;
}

class Run {
 public:
  explicit Run(const Options& options) : attempt_(options.attempt, options.token), begin_(unix_s()) {
    if (options.deadline_s) deadline_ = begin_ + *options.deadline_s;
  }

  int operator()() {
    int code = 0;
    std::string reason;
    try {
      reason = steps();
      code = reason.empty() ? 0 : 75;
    } catch (const Failure& failure) {
      code = failure.code;
      reason = failure.what();
    }
    if (code != 76) record(code, reason.empty() ? "end time reached" : reason);
    if (code != 0 && code != 75) fmt::print(stderr, "{}\n", reason);
    return code;
  }

 private:
  /// returns why it stopped early, or ""
  std::string steps() {
    script_ = take_script();
    if (script_.word == "mute") ::_exit(static_cast<int>(script_.first));
    run_ = read_run_file("run.ini");
    position_ = newest_checkpoint();
    if (position_.step >= 0) resumed_from_ = fmt::format("checkpoints/{:012d}.h5", position_.step);
    attempt_.check_fence();
    cut_samples(position_);
    start_step_ = position_.step;
    const Json started = {{"contract", 1},        {"host", host()}, {"pid", ::getpid()}, {"start_ticks", start_ticks()},
                          {"boot_id", boot_id()}, {"ranks", 1}};
    write_whole(attempt_.directory() / "started.json", started.dump());
    const long long end = run_.steps();
    const auto every = static_cast<long long>(run_.number("output.sample_interval_steps"));
    const long long checkpoint_every = environment("FAKE_CHECKPOINT_STEPS", 50);
    if (position_.step == 0) sample();
    while (position_.step < end) {
      play_script();
      std::this_thread::sleep_for(std::chrono::microseconds(environment("FAKE_STEP_US", 100)));
      ++position_.step;
      if (position_.step % every == 0) sample();
      if (position_.step % checkpoint_every == 0) {
        checkpoint();
        progress(end);
      }
      if (const std::string reason = stop_reason(); !reason.empty() && position_.step < end) {
        checkpoint();
        return reason;
      }
    }
    checkpoint();
    progress(end);
    return "";
  }

  void play_script() {
    if (script_.word == "crash" && position_.step >= script_.first) ::kill(::getpid(), SIGKILL);
    if (script_.word == "exit" && position_.step >= script_.second) {
      throw Failure(static_cast<int>(script_.first), fmt::format("scripted end at step {}", position_.step));
    }
    while (script_.word == "hang" && position_.step >= script_.first && stop_reason().empty()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  std::string stop_reason() {
    if (stop_signal != 0) return "stop requested by signal";
    if (std::filesystem::exists("stop")) return "stop requested by file";
    if (deadline_ > 0 && unix_s() > deadline_) return "deadline";
    return "";
  }

  void sample() {
    attempt_.check_fence();
    const std::string line = sample_line(run_, position_.step);
    std::ofstream("samples.csv", std::ios::binary | std::ios::app) << line;
    position_.log_bytes += static_cast<long long>(line.size());
  }

  void checkpoint() {
    write_checkpoint(attempt_, position_, static_cast<int>(run_.number("output.checkpoints_kept")));
    checkpoint_step_ = position_.step;
  }

  void progress(long long end) {
    const double speed = static_cast<double>(position_.step - start_step_) / (unix_s() - begin_);
    const Json json = {{"contract", 1},
                       {"attempt", attempt_.number()},
                       {"token", attempt_.token()},
                       {"step", position_.step},
                       {"end_step", end},
                       {"time_s", 0.0},
                       {"end_time_s", run_.number("time.end_time_s")},
                       {"steps_per_s", speed},
                       {"mlups", speed * 1e-3},
                       {"eta_s", static_cast<double>(end - position_.step) / speed},
                       {"checkpoint_step", checkpoint_step_},
                       {"checkpoint_unix_s", unix_s()},
                       {"checkpoint_ms", 0.1},
                       {"d_um", 0.5},
                       {"asphericity", 0.15},
                       {"updated_unix_s", unix_s()}};
    write_whole("progress.json", json.dump());
  }

  void record(int code, const std::string& reason) {
    const double wall = unix_s() - begin_;
    const Json json = {{"contract", 1},
                       {"code", code},
                       {"reason", reason},
                       {"step", position_.step},
                       {"end_step", run_.given.empty() ? 0 : run_.steps()},
                       {"start_step", start_step_},
                       {"wall_s", wall},
                       {"core_s", wall},
                       {"ranks", 1},
                       {"mlups", 1e-3 * static_cast<double>(position_.step - start_step_) / wall},
                       {"host", host()},
                       {"resumed_from", resumed_from_},
                       {"rejected_checkpoints", Json::array()},
                       {"version", "0.0.1"},
                       {"git", "fake"},
                       {"finished_unix_s", unix_s()}};
    write_whole(attempt_.directory() / "exit.json", json.dump());
  }

  static std::string boot_id() {
    const std::string id = read_whole("/proc/sys/kernel/random/boot_id");
    return id.substr(0, id.find('\n'));
  }

  Attempt attempt_;
  double begin_;
  double deadline_ = 0;
  Script script_;
  RunFile run_;
  Position position_;
  long long start_step_ = 0;
  long long checkpoint_step_ = 0;
  std::string resumed_from_;
};

}  // namespace

int run(const Options& options) {
  for (const int signal : {SIGTERM, SIGINT, SIGUSR2}) ::signal(signal, on_signal);
  return Run(options)();
}

}  // namespace fake
