// SPDX-License-Identifier: BSD-3-Clause
// Choosing, checking and loading the checkpoint a run goes on from.
#include "storage/resume.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "base/error.hpp"
#include "storage/checkpoint_file.hpp"
#include "storage/files.hpp"
#include "storage/generations.hpp"
#include "storage/seal.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

/// What rank 0 thinks of an intact file.
enum class Verdict : char { load, reject, foreign };
struct Opinion {
  Verdict verdict = Verdict::load;
  std::string why;
};

/// How the items of a file differ from those of the state; nothing if they are the same.
std::optional<std::string> item_conflict(const Manifest& file, const Manifest& state) {
  if (file.lattice != state.lattice) {
    return fmt::format("its lattice is {} x {} x {}, the run's is {} x {} x {}", file.lattice[0], file.lattice[1],
                       file.lattice[2], state.lattice[0], state.lattice[1], state.lattice[2]);
  }
  const auto same_name = [](const ManifestItem& a) { return [&a](const ManifestItem& b) { return a.name == b.name; }; };
  for (const ManifestItem& wanted : state.items) {
    const auto found = std::find_if(file.items.begin(), file.items.end(), same_name(wanted));
    if (found == file.items.end()) return fmt::format("it lacks {}", wanted.name);
    if (found->on_lattice != wanted.on_lattice || found->type != wanted.type || found->shape != wanted.shape) {
      return fmt::format("{} has another type or shape than in this run", wanted.name);
    }
  }
  for (const ManifestItem& item : file.items) {
    const bool known = std::any_of(state.items.begin(), state.items.end(), same_name(item));
    if (!known) return fmt::format("it holds {}, which this run does not have", item.name);
  }
  return {};
}

Opinion judge(const CheckpointFile& file, const fs::path& path, const Expected& expected, const Manifest& state) {
  const CheckpointMetadata& metadata = file.metadata();
  if (!file.readable()) {
    return {Verdict::reject,
            fmt::format("layout version {} (written by rouleau {}), this solver reads {}; continue with that version",
                        metadata.layout, metadata.version, checkpoint_layout)};
  }
  if (step_of_checkpoint(path.filename().string()) != metadata.step) {
    return {Verdict::reject, fmt::format("its name does not belong to the step {} it holds", metadata.step)};
  }
  if (const auto why = identity_conflict(metadata, expected)) return {Verdict::foreign, *why};
  if (const auto why = item_conflict(file.manifest(), state)) return {Verdict::reject, *why};
  if (expected.obstacle) {
    if (const auto why = expected.obstacle(metadata)) return {Verdict::reject, *why};
  }
  return {};
}

/// Rank 0's opinion, given to all.
Opinion agree_on(const Communicator& comm, const std::function<Opinion()>& judge_on_root) {
  Opinion opinion;
  comm.on_root([&] { opinion = judge_on_root(); });
  comm.broadcast(&opinion.verdict, sizeof(opinion.verdict));
  comm.broadcast(opinion.why);
  return opinion;
}

void unpack(const std::vector<std::byte>& packed, LatticeItem& item, std::size_t component, const Block& block) {
  const std::size_t size = element_size(item.type);
  const std::size_t row = static_cast<std::size_t>(block.size[0]) * size;
  auto* bytes = static_cast<std::byte*>(item.data[component]);
  const std::byte* from = packed.data();
  for (int k = 0; k < block.size[2]; ++k) {
    for (int j = 0; j < block.size[1]; ++j, from += row) {
      std::memcpy(bytes + static_cast<std::size_t>(item.layout.index(0, j, k)) * size, from, row);
    }
  }
}

/// Fills the state and checks what memory then holds against the file's checksums. Collective.
void load_values(const CheckpointFile& file, const fs::path& path, const Communicator& comm, PersistentState& state) {
  comm.all_agree([&] {
    std::vector<std::byte> packed;
    for (LatticeItem& item : state.lattice_items) {
      const ManifestItem& stored = *file.find(item.name);
      packed.resize(node_count(state.block) * element_size(item.type));
      for (std::size_t c = 0; c < item.data.size(); ++c) {
        file.read_block(stored, c, state.block, packed.data());
        unpack(packed, item, c, state.block);
      }
    }
    for (ReplicatedItem& item : state.replicated_items) file.read_all(*file.find(item.name), item.data);
  });
  const Manifest loaded = take_checksums(state, comm);
  for (const ManifestItem& item : loaded.items) {
    if (*file.find(item.name) != item) {
      fail(Exit::bad_input, "{}: {} does not match its checksum", path.string(), item.name);
    }
  }
}

/// Verifies and loads one file.
struct Attempted {
  std::optional<CheckpointMetadata> metadata;
  RejectedCheckpoint rejected;
  bool intact = false;
};

Attempted try_to_load(FileSystem& files, const fs::path& path, const Communicator& comm, const Expected& expected,
                      PersistentState& state) {
  Attempted attempted;
  attempted.rejected.file = path.filename().string();
  std::optional<CheckpointFile> file;
  Opinion opinion;
  try {
    require_seal(files, path, comm);
    comm.all_agree([&] { file.emplace(files, path); });
    attempted.intact = true;
    opinion = agree_on(comm, [&] { return judge(*file, path, expected, describe(state)); });
    if (opinion.verdict == Verdict::load) load_values(*file, path, comm, state);
  } catch (const Error& error) {
    if (error.code() != Exit::bad_input) throw;
    attempted.intact = false;
    attempted.rejected.why = error.what();
    return attempted;
  }
  if (opinion.verdict != Verdict::load) {
    attempted.rejected.why = opinion.why;
    attempted.rejected.foreign = opinion.verdict == Verdict::foreign;
    return attempted;
  }
  attempted.metadata = file->metadata();
  return attempted;
}

/// What was read and is wrong stays so; what the medium cannot read may come back.
void require_readable(FileSystem& files, const fs::path& directory, const std::vector<RejectedCheckpoint>& rejected) {
  for (const RejectedCheckpoint& checkpoint : rejected) {
    const fs::path path = directory / checkpoint.file;
    read_blocks(File::read(files, path), file_size(files, path), [](std::string_view) {});
  }
}

}  // namespace

std::vector<fs::path> find_checkpoints(FileSystem& files, const fs::path& directory) {
  std::vector<fs::path> found;
  for (const std::string& name : list_directory(files, directory)) {
    if (step_of_checkpoint(name)) found.push_back(directory / name);
  }
  std::sort(found.begin(), found.end(), [](const fs::path& a, const fs::path& b) {
    return step_of_checkpoint(a.filename().string()) > step_of_checkpoint(b.filename().string());
  });
  return found;
}

Resumed load_newest(FileSystem& files, const fs::path& directory, const Communicator& comm, const Expected& expected,
                    PersistentState& state) {
  require_well_formed(state);
  // Rank 0 looks once, so that all ranks try the same files whatever appears meanwhile.
  std::string names;
  comm.on_root([&] {
    for (const fs::path& file : find_checkpoints(files, directory)) names += file.filename().string() + '\n';
  });
  comm.broadcast(names);

  Resumed resumed;
  std::string intact;
  for (std::size_t begin = 0; begin < names.size();) {
    const std::size_t end = names.find('\n', begin);
    const fs::path path = directory / names.substr(begin, end - begin);
    begin = end + 1;
    Attempted attempted = try_to_load(files, path, comm, expected, state);
    if (attempted.metadata) {
      resumed.metadata = std::move(attempted.metadata);
      resumed.file = path;
      return resumed;
    }
    if (attempted.intact && intact.empty()) {
      intact = fmt::format("{}: {}. {}", path.string(), attempted.rejected.why,
                           attempted.rejected.foreign
                               ? "Restart with the old values, or start a new run in another directory."
                               : "No checkpoint can be continued; move the directory away to start anew.");
    }
    resumed.rejected.push_back(std::move(attempted.rejected));
  }
  comm.on_root([&] { require_readable(files, directory, resumed.rejected); });
  // Starting anew would in time delete a checkpoint that nothing is wrong with.
  if (!intact.empty()) throw NoneCanBeContinued(intact, std::move(resumed.rejected));
  return resumed;
}

std::optional<std::string> identity_conflict(const CheckpointMetadata& recorded, const Expected& expected) {
  std::string conflict;
  const auto note = [&](const std::string& name, const std::string& was, const std::string& is) {
    conflict += fmt::format("{}`{}` was {}, the run has {}", conflict.empty() ? "" : "; ", name, was, is);
  };
  for (const auto& [name, parameter] : expected.parameters) {
    if (!parameter.identity) continue;
    const auto found = recorded.parameters.find(name);
    const std::string& was = found == recorded.parameters.end() ? parameter.default_value : found->second.value;
    if (was != parameter.value) note(name, was, parameter.value);
  }
  for (const auto& [name, parameter] : recorded.parameters) {
    if (expected.parameters.contains(name) || !parameter.identity || parameter.value == parameter.default_value)
      continue;
    note(name, parameter.value, "no such parameter");
  }
  if (conflict.empty() && !expected.identity.empty() && recorded.identity != expected.identity) {
    note("identity", recorded.identity, expected.identity + " (a file named in the run file has changed)");
  }
  if (conflict.empty()) return {};
  return conflict;
}

}  // namespace rouleau
