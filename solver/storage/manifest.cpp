// SPDX-License-Identifier: BSD-3-Clause
// Building, writing and reading the table of contents of a checkpoint.
#include "storage/manifest.hpp"

#include "base/error.hpp"
#include "storage/checksum.hpp"
#include "storage/json_entry.hpp"
#include "storage/metadata.hpp"

namespace rouleau {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t largest_item = std::uint64_t{1} << 62U;  // bytes; keeps every later product inside 63 bits

Json items_json(const Manifest& manifest) {
  Json items = Json::array();
  for (const ManifestItem& item : manifest.items) {
    Json checksums = Json::array();
    for (const std::uint64_t checksum : item.checksums) checksums.push_back(hex(checksum));
    items.push_back({{"name", item.name},
                     {"kind", item.on_lattice ? "lattice" : "replicated"},
                     {"type", element_name(item.type)},
                     {"shape", item.shape},
                     {"checksums", checksums}});
  }
  return items;
}

ElementType type_from_name(const std::string& name) {
  for (const ElementType type :
       {ElementType::f32, ElementType::f64, ElementType::u8, ElementType::i32, ElementType::i64}) {
    if (name == element_name(type)) return type;
  }
  throw std::invalid_argument(fmt::format("element type `{}` is not known", name));
}

std::uint64_t checksum_from_hex(const std::string& text) {
  std::uint64_t value = 0;
  if (!parse_hex(text, value)) throw std::invalid_argument(fmt::format("checksum `{}` is not 16 hex digits", text));
  return value;
}

ManifestItem item_from_json(const Json& entry, const Int3& lattice) {
  ManifestItem item;
  item.name = entry.at("name").get<std::string>();
  const auto kind = entry.at("kind").get<std::string>();
  if (kind != "lattice" && kind != "replicated") throw std::invalid_argument(fmt::format("item kind `{}`", kind));
  item.on_lattice = kind == "lattice";
  item.type = type_from_name(entry.at("type").get<std::string>());
  for (const Json& size : entry.at("shape")) item.shape.push_back(strictly<std::uint64_t>(size));
  for (const Json& checksum : entry.at("checksums")) {
    item.checksums.push_back(checksum_from_hex(checksum.get<std::string>()));
  }
  if (item.name.empty() || item.shape.empty() || item.shape.size() > 8) {
    throw std::invalid_argument(fmt::format("item `{}` has a bad name or shape", item.name));
  }
  if (item.on_lattice) {
    const bool fits = item.shape.size() == 4 && item.shape[1] == static_cast<std::uint64_t>(lattice[2]) &&
                      item.shape[2] == static_cast<std::uint64_t>(lattice[1]) &&
                      item.shape[3] == static_cast<std::uint64_t>(lattice[0]);
    if (!fits) throw std::invalid_argument(fmt::format("item `{}` does not have the lattice's shape", item.name));
  }
  const std::uint64_t wanted = item.on_lattice ? item.shape[0] : 1;
  if (item.checksums.size() != wanted) {
    throw std::invalid_argument(
        fmt::format("item `{}` has {} checksums, {} belong to its shape", item.name, item.checksums.size(), wanted));
  }
  return item;
}

}  // namespace

Manifest describe(const PersistentState& state) {
  Manifest manifest;
  manifest.layout = checkpoint_layout;
  manifest.lattice = state.lattice.size;
  const Int3& n = state.lattice.size;
  for (const LatticeItem& item : state.lattice_items) {
    manifest.items.push_back({item.name,
                              true,
                              item.type,
                              {item.data.size(), static_cast<std::uint64_t>(n[2]), static_cast<std::uint64_t>(n[1]),
                               static_cast<std::uint64_t>(n[0])},
                              {}});
  }
  for (const ReplicatedItem& item : state.replicated_items) {
    manifest.items.push_back({item.name, false, item.type, {item.shape.begin(), item.shape.end()}, {}});
  }
  return manifest;
}

Manifest take_checksums(const PersistentState& state, const Communicator& comm) {
  std::vector<std::uint64_t> on_lattice;
  for (const LatticeItem& item : state.lattice_items) {
    for (std::size_t c = 0; c < item.data.size(); ++c) {
      on_lattice.push_back(block_checksum(view(item, c), state.lattice, state.block));
    }
  }
  sum_over_ranks(comm, on_lattice);
  std::vector<std::uint64_t> own;
  for (const ReplicatedItem& item : state.replicated_items) {
    own.push_back(row_checksum(item.type, item.data, element_count(item), 0));
  }
  std::vector<std::uint64_t> root = own;
  comm.broadcast(root.data(), root.size() * sizeof(std::uint64_t));
  comm.all_agree([&] {
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (own[i] == root[i]) continue;
      fail(Exit::physics,
           "{} on rank {} differs from rank 0, though every rank must hold the same. "
           "One rank computed wrongly (memory fault or defect): start again from the last checkpoint.",
           state.replicated_items[i].name, comm.rank());
    }
  });
  Manifest manifest = describe(state);
  std::size_t next = 0;
  for (std::size_t i = 0; i < state.lattice_items.size(); ++i) {
    for (std::size_t c = 0; c < state.lattice_items[i].data.size(); ++c) {
      manifest.items[i].checksums.push_back(on_lattice[next++]);
    }
  }
  for (std::size_t i = 0; i < root.size(); ++i) {
    manifest.items[state.lattice_items.size() + i].checksums.push_back(root[i]);
  }
  return manifest;
}

std::string to_json(const Manifest& manifest) {
  const Json object = {{"layout", manifest.layout},
                       {"lattice", manifest.lattice},
                       {"items", items_json(manifest)},
                       {"metadata_checksum", hex(manifest.metadata_checksum)}};
  return object.dump(2) + "\n";
}

Manifest manifest_from_json(const std::string& text, const std::string& file) {
  const Json object = Json::parse(text, nullptr, false);
  if (!object.is_object()) fail(Exit::bad_input, "{}: the manifest is not a JSON object", file);
  try {
    Manifest manifest;
    manifest.layout = strictly<int>(object.at("layout"));
    // Another layout has another manifest; the caller reports the version.
    if (manifest.layout != checkpoint_layout) return manifest;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int n = strictly<int>(object.at("lattice").at(axis));
      if (n < 1) throw std::invalid_argument(fmt::format("lattice size {}", n));
      manifest.lattice[axis] = n;
    }
    for (const Json& entry : object.at("items")) {
      manifest.items.push_back(item_from_json(entry, manifest.lattice));
      static_cast<void>(item_bytes(manifest.items.back(), file));
    }
    manifest.metadata_checksum = checksum_from_hex(object.at("metadata_checksum").get<std::string>());
    return manifest;
  } catch (const Json::exception& e) {
    fail(Exit::bad_input, "{}: the manifest cannot be read: {}", file, e.what());
  } catch (const std::invalid_argument& e) {
    fail(Exit::bad_input, "{}: the manifest cannot be read: {}", file, e.what());
  }
}

std::string digest(const Manifest& manifest) { return text_digest(items_json(manifest).dump()); }

std::uint64_t item_bytes(const ManifestItem& item, const std::string& file) {
  std::uint64_t bytes = element_size(item.type);
  for (const std::uint64_t n : item.shape) {
    if (n != 0 && bytes > largest_item / n) {
      fail(Exit::bad_input, "{}: item {} is larger than any file can be", file, item.name);
    }
    bytes *= n;
  }
  return bytes;
}

}  // namespace rouleau
