// SPDX-License-Identifier: BSD-3-Clause
// The commit protocol of a checkpoint.
#include "storage/checkpoint.hpp"

#include <cstddef>

#include "base/error.hpp"
#include "storage/checkpoint_file.hpp"
#include "storage/checkpoint_write.hpp"
#include "storage/checksum.hpp"
#include "storage/generations.hpp"
#include "storage/manifest.hpp"
#include "storage/seal.hpp"
#include "storage/unfinished.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

/// Opens the unfinished file anew and compares every byte with the seal and every value with what memory held.
/// Collective.
void require_written(FileSystem& files, const fs::path& path, const Communicator& comm, const PersistentState& state,
                     const Manifest& manifest) {
  require_seal(files, path, comm);
  std::vector<std::uint64_t> sums;
  comm.all_agree([&] {
    const CheckpointFile file(files, path);
    if (file.manifest() != manifest) fail(Exit::io, "{}: the manifest reads back differently", path.string());
    std::vector<std::byte> packed;
    for (const ManifestItem& item : manifest.items) {
      if (!item.on_lattice) continue;
      packed.resize(node_count(state.block) * element_size(item.type));
      const std::ptrdiff_t stride_y = state.block.size[0];
      const BlockView values{item.type, packed.data(), stride_y, stride_y * state.block.size[1]};
      for (std::size_t c = 0; c < item.shape[0]; ++c) {
        file.read_block(item, c, state.block, packed.data());
        sums.push_back(block_checksum(values, state.lattice, state.block));
      }
    }
    for (const ManifestItem& item : manifest.items) {
      if (item.on_lattice || !comm.is_root()) continue;
      packed.resize(item_bytes(item, path.string()));
      file.read_all(item, packed.data());
      const std::size_t count = packed.size() / element_size(item.type);
      if (row_checksum(item.type, packed.data(), count, 0) != item.checksums[0]) {
        fail(Exit::io, "{}: {} reads back differently", path.string(), item.name);
      }
    }
  });
  sum_over_ranks(comm, sums);
  comm.all_agree([&] {
    std::size_t next = 0;
    for (const ManifestItem& item : manifest.items) {
      for (std::size_t c = 0; item.on_lattice && c < item.shape[0]; ++c) {
        if (sums[next++] == item.checksums[c]) continue;
        fail(Exit::io, "{}: {} component {} reads back differently", path.string(), item.name, c);
      }
    }
  });
}

/// A file that reads back wrongly right after it was written is an I/O failure, not bad input of the user's.
template <class Work>
void as_io_failure(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    if (error.code() != Exit::bad_input) throw;
    fail(Exit::io, "{}; it was just written. Check disk and memory, then start the run again.", error.what());
  }
}

}  // namespace

SavedCheckpoint save_checkpoint(const CheckpointPlace& place, const Communicator& comm, const PersistentState& state,
                                const CheckpointMetadata& metadata) {
  require_well_formed(state);
  require(place.keep >= 1, "save_checkpoint: at least one generation must be kept");
  require(metadata.layout == checkpoint_layout, "save_checkpoint: only this layout version can be written");
  comm.all_agree([&] { require_finite(state, metadata.step); });

  FileSystem& files = place.files;
  CheckpointTexts texts;
  comm.on_root([&] { texts.metadata = to_json(metadata); });
  comm.broadcast(texts.metadata);
  Manifest manifest = take_checksums(state, comm);
  manifest.metadata_checksum = text_checksum(texts.metadata);
  texts.manifest = to_json(manifest);

  const fs::path file = place.directory / checkpoint_name(metadata.step);
  const fs::path unfinished = place.directory / unfinished_name(checkpoint_name(metadata.step), metadata.attempt);
  SavedCheckpoint saved{file, 0};
  std::vector<std::uint64_t> places(state.lattice_items.size());
  bool begun = false;
  try {
    comm.on_root([&] {
      place.fence();
      make_directory(files, place.directory);
      remove_unfinished(files, place.directory, metadata.attempt);
      require_free_space(files, place.directory, "a checkpoint",
                         estimate_bytes(state) + texts.metadata.size() + texts.manifest.size());
      begun = true;
      places = lay_out_checkpoint(files, unfinished, state, texts);
    });
    comm.broadcast(places.data(), places.size() * sizeof(places[0]));
    write_lattice_items(files, unfinished, comm, state, places);
    as_io_failure([&] {
      write_seal(files, unfinished, comm);
      require_written(files, unfinished, comm, state, manifest);
    });
    comm.on_root([&] {
      saved.bytes = file_size(files, unfinished);
      const std::vector<fs::path> superfluous =
          superfluous_generations(files, place.directory, metadata.step, place.keep);
      place.fence();
      rename_synced(files, unfinished, file);
      begun = false;
      for (const fs::path& generation : superfluous) remove_file(files, generation);
      sync_directory(files, place.directory);
    });
  } catch (const Error&) {
    // The error under way matters more than a failure to tidy up; the next checkpoint removes what is left.
    if (begun) files.unlink(unfinished.string());
    throw;
  }
  comm.broadcast(&saved.bytes, sizeof(saved.bytes));
  return saved;
}

std::string digest(const PersistentState& state, const Communicator& comm) {
  require_well_formed(state);
  return digest(take_checksums(state, comm));
}

}  // namespace rouleau
