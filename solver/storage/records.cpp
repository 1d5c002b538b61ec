// SPDX-License-Identifier: BSD-3-Clause
// The JSON records as the contract has them.
#include "storage/records.hpp"

#include <unistd.h>
#include <xxhash.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "storage/checksum.hpp"
#include "storage/files.hpp"
#include "storage/unfinished.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr int contract_version = 1;

/// JSON has no way to write such a number, and a reader would meet `null`.
double finite(double value, const char* name) {
  if (!std::isfinite(value)) fail(Exit::internal, "record entry `{}` is not finite ({})", name, value);
  return value;
}

/// The last entry vouches for all bytes before it, so that a reader knows a damaged record.
std::string record_text(const Json& record) {
  std::string text = record.dump(1, ' ', false, Json::error_handler_t::replace);
  text.resize(text.rfind('\n'));  // the closing bracket stands alone in the last line
  return fmt::format("{},\n \"check\": \"{}\"\n}}\n", text, hex(XXH64(text.data(), text.size(), 0)));
}

void write_record(FileSystem& files, const fs::path& path, const Json& record) {
  write_aside(files, path, record_text(record));
}

std::uint64_t start_ticks(const std::string& stat) {
  // Field 2 is the program's name in parentheses and may itself hold spaces and parentheses; field 22 is the 20th after
  // it.
  std::size_t at = stat.rfind(')');
  for (int field = 2; field < 22 && at != std::string::npos; ++field) at = stat.find(' ', at + 1);
  std::uint64_t ticks = 0;
  if (at == std::string::npos ||
      std::from_chars(stat.data() + at + 1, stat.data() + stat.size(), ticks).ec != std::errc{}) {
    fail(Exit::io, "/proc/self/stat has no field 22; is /proc mounted?");
  }
  return ticks;
}

}  // namespace

ProcessIdentity this_process(FileSystem& files) {
  ProcessIdentity process;
  char host[256] = {};
  if (::gethostname(host, sizeof host - 1) != 0) fail(Exit::io, "gethostname failed (errno {})", errno);
  process.host = host;
  process.pid = ::getpid();
  process.start_ticks = start_ticks(read_file(files, "/proc/self/stat"));
  process.boot_id = read_file(files, "/proc/sys/kernel/random/boot_id");
  process.boot_id.erase(process.boot_id.find_last_not_of('\n') + 1);
  return process;
}

void write_started(FileSystem& files, const Attempt& attempt, const ProcessIdentity& process, int ranks) {
  write_record(files, attempt.directory() / "started.json",
               {{"contract", contract_version},
                {"host", process.host},
                {"pid", process.pid},
                {"start_ticks", process.start_ticks},
                {"boot_id", process.boot_id},
                {"ranks", ranks}});
}

void write_exit_record(FileSystem& files, const fs::path& attempt_directory, const ExitRecord& record) {
  Json rejected = Json::array();
  for (const RejectedCheckpoint& checkpoint : record.rejected_checkpoints) {
    rejected.push_back({{"file", checkpoint.file}, {"why", checkpoint.why}});
  }
  write_record(files, attempt_directory / "exit.json",
               {{"contract", contract_version},
                {"code", static_cast<int>(record.code)},
                {"reason", record.reason},
                {"step", record.step},
                {"end_step", record.end_step},
                {"start_step", record.start_step},
                {"wall_s", finite(record.wall_s, "wall_s")},
                {"core_s", finite(record.core_s, "core_s")},
                {"ranks", record.ranks},
                {"mlups", finite(record.mlups, "mlups")},
                {"host", record.host},
                {"resumed_from", record.resumed_from},
                {"rejected_checkpoints", rejected},
                {"version", record.version},
                {"git", record.git},
                {"finished_unix_s", finite(record.finished_unix_s, "finished_unix_s")}});
}

void write_progress(FileSystem& files, const Attempt& attempt, const Progress& progress) {
  Json record = {{"contract", contract_version},
                 {"attempt", attempt.number()},
                 {"token", attempt.token()},
                 {"step", progress.step},
                 {"end_step", progress.end_step},
                 {"time_s", finite(progress.time_s, "time_s")},
                 {"end_time_s", finite(progress.end_time_s, "end_time_s")},
                 {"steps_per_s", finite(progress.steps_per_s, "steps_per_s")},
                 {"mlups", finite(progress.mlups, "mlups")}};
  if (progress.eta_s) record["eta_s"] = finite(*progress.eta_s, "eta_s");
  record["checkpoint_step"] = progress.checkpoint_step;
  record["checkpoint_unix_s"] = finite(progress.checkpoint_unix_s, "checkpoint_unix_s");
  record["checkpoint_ms"] = finite(progress.checkpoint_ms, "checkpoint_ms");
  if (progress.d_um) record["d_um"] = finite(*progress.d_um, "d_um");
  if (progress.asphericity) record["asphericity"] = finite(*progress.asphericity, "asphericity");
  record["updated_unix_s"] = finite(progress.updated_unix_s, "updated_unix_s");
  write_fenced(files, attempt.run_directory() / "progress.json", record_text(record), attempt.number(),
               [&] { attempt.fence(); });
}

}  // namespace rouleau
