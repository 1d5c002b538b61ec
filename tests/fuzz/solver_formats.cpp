// SPDX-License-Identifier: BSD-3-Clause
// What the solver reads: run files, meshes, checkpoints, its own sample log.
#include <xxhash.h>

#include <string>

#include "base/error.hpp"
#include "fuzz/formats.hpp"
#include "membrane/check_surface.hpp"
#include "membrane/surface_file.hpp"
#include "run/feasibility.hpp"
#include "run/lattice_parameters.hpp"
#include "storage/checkpoint_write.hpp"
#include "storage/checksum.hpp"
#include "storage/inspect.hpp"
#include "storage/manifest.hpp"
#include "storage/sample_log.hpp"
#include "support/memory_file.hpp"
#include "support/small_state.hpp"

namespace rouleau::fuzz {

namespace {

const std::string name = "fuzzed";

void look_at_checkpoint(FileSystem& files) {
  const Verification verification = verify_checkpoint(files, name);
  try {
    static_cast<void>(inspect_checkpoint(files, name));
  } catch (const Error&) {
    require(!verification.sound || verification.lines.size() > 1, "a sound checkpoint cannot be inspected");
  }
  static_cast<void>(read_cell(files, name, 1));
}

}  // namespace

void read_run_file(std::string_view bytes) {
  const RunFile run = parse_run_file(bytes, "run.ini");
  require(run.identity.size() == 32, "an identity has 32 hex digits");
  const Units units(run.parameters);
  const LatticeParameters lattice = lattice_parameters(run, units);
  static_cast<void>(check_feasibility(run, lattice, units));
}

void read_off(std::string_view bytes) { check_surface(parse_off(bytes, name), name); }
void read_stl(std::string_view bytes) { check_surface(parse_stl(bytes, name), name); }

void read_manifest(std::string_view bytes) {
  const Manifest manifest = manifest_from_json(std::string(bytes), name);
  if (manifest.layout != checkpoint_layout) return;
  require(manifest_from_json(to_json(manifest), name) == manifest, "a manifest does not survive being written");
  static_cast<void>(digest(manifest));
}

void read_metadata(std::string_view bytes) {
  const CheckpointMetadata metadata = metadata_from_json(std::string(bytes), name);
  if (metadata.layout != checkpoint_layout) return;
  require(metadata_from_json(to_json(metadata), name) == metadata, "metadata do not survive being written");
}

void read_checkpoint(std::string_view bytes) {
  testing::MemoryFile files{std::string(bytes)};
  look_at_checkpoint(files);
}

void read_checkpoint_texts(std::string_view bytes) {
  const std::size_t zero = bytes.find('\0');
  CheckpointTexts texts{"{}", std::string(bytes.substr(0, zero))};
  if (zero != std::string_view::npos && zero + 1 < bytes.size()) texts.metadata = bytes.substr(zero + 1);
  const std::string placeholder(16, 'm');
  if (const std::size_t at = texts.manifest.find(placeholder); at != std::string::npos)
    texts.manifest.replace(at, placeholder.size(), hex(text_checksum(texts.metadata)));
  if (texts.manifest.empty()) texts.manifest = "{}";

  const Int3 size{2, 2, 2};
  static testing::SmallState<double> state(size, {{0, 0, 0}, size});
  testing::MemoryFile files;
  static_cast<void>(lay_out_checkpoint(files, name, state.list(), texts));
  testing::reseal(files);
  look_at_checkpoint(files);
}

void read_solver_log(std::string_view bytes) {
  testing::MemoryFile files{std::string(bytes)};
  const SampleScan scan = scan_samples(files, name);
  require(scan.valid_bytes <= bytes.size(), "the valid part is longer than the log");
  SampleLog log(files, name, {"step", "cell", "d_um"}, 1, [] {});
  const std::string_view sound = bytes.substr(0, scan.valid_bytes);
  const SampleLogPosition counted{scan.valid_bytes, hex(XXH64(sound.data(), sound.size(), 0))};
  if (log.obstacle(counted)) return;
  log.cut_back(counted);
  require(files.content == sound, "a log that was cut back is not what was counted");
}

}  // namespace rouleau::fuzz
