// SPDX-License-Identifier: BSD-3-Clause
// The model: a tree of nodes, each with what it is now and what it was when it was synced last.
#include "support/fault_shim/disk_model.hpp"

#include <fcntl.h>

#include <algorithm>
#include <stdexcept>

#include "support/temporary_directory.hpp"

namespace rouleau::testing {

namespace fs = std::filesystem;

namespace {

std::shared_ptr<const std::string> shared(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

bool has_survived(std::mt19937_64& lots) { return lots() % 2 == 0; }

/// All, nothing, or the blocks in front of what was not synced has reached the disk.
std::string mixed_data(const std::string& now, const std::string& synced, std::mt19937_64& lots) {
  constexpr std::size_t block = 4096;
  const std::size_t lot = lots() % 3;
  if (lot < 2) return lot == 0 ? now : synced;
  const std::size_t cut = block * (lots() % (now.size() / block + 1));
  return now.substr(0, cut) + (synced.size() > cut ? synced.substr(cut) : "");
}

std::string name_in(const std::string& path) { return fs::path(path).lexically_normal().filename().string(); }

}  // namespace

DiskModel::DiskModel(fs::path root) : root_path_(std::move(root)), root_(read(root_path_)) {}

DiskModel::NodePointer DiskModel::read(const fs::path& path) {
  auto node = std::make_shared<Node>();
  node->is_directory = fs::is_directory(path);
  if (node->is_directory) {
    for (const auto& entry : fs::directory_iterator(path)) {
      node->entries[entry.path().filename().string()] = read(entry.path());
    }
    node->synced_entries = node->entries;
  } else {
    node->data = node->synced_data = shared(content_of(path));
  }
  return node;
}

DiskModel::NodePointer DiskModel::find(const std::string& path) const {
  NodePointer node = root_;
  for (const fs::path& part : fs::path(path).lexically_normal().lexically_relative(root_path_)) {
    if (part == "." || part.empty()) continue;
    const auto next = node->entries.find(part.string());
    if (next == node->entries.end()) return nullptr;
    node = next->second;
  }
  return node;
}

DiskModel::Node& DiskModel::parent_of(const std::string& path) const {
  const NodePointer parent = find(fs::path(path).lexically_normal().parent_path());
  if (!parent) throw std::logic_error("a recorded call has no directory: " + path);
  return *parent;
}

void DiskModel::apply(const RecordedCall& call) {
  if (call.result < 0) return;
  if (call.name == "rename") {
    Node& from = parent_of(call.path);
    const auto entry = from.entries.extract(name_in(call.path));
    parent_of(call.other).entries[name_in(call.other)] = entry.mapped();
    return;
  }
  if (call.name == "unlink") {
    parent_of(call.path).entries.erase(name_in(call.path));
    return;
  }
  NodePointer node = find(call.path);
  const bool is_new = call.name == "mkdir" || (call.name.starts_with("open") && (call.offset & O_CREAT) != 0 && !node);
  if (is_new) {
    node = std::make_shared<Node>();
    node->is_directory = call.name == "mkdir";
    node->data = node->synced_data = shared("");
    parent_of(call.path).entries[name_in(call.path)] = node;
  }
  if (!node) return;  // a file that has lost its name: nothing of it will be left
  std::string content = node->data ? *node->data : "";
  if (call.name == "open_empty") {
    content.clear();
  } else if (call.name == "write" || call.name == "pwrite") {
    const std::size_t at = call.offset < 0 ? content.size() : static_cast<std::size_t>(call.offset);
    content.resize(std::max(content.size(), at + call.bytes.size()));
    content.replace(at, call.bytes.size(), call.bytes);
  } else if (call.name == "ftruncate") {
    content.resize(static_cast<std::size_t>(call.offset));
  } else if (call.name == "posix_fallocate") {
    content.resize(std::max(content.size(), static_cast<std::size_t>(call.offset + call.count)));
  } else if (call.name == "fsync") {
    node->synced_data = node->data;
    node->synced_entries = node->entries;
    return;
  } else {
    return;
  }
  node->data = shared(std::move(content));
}

void DiskModel::write(const Node& node, Loss loss, std::mt19937_64& lots, const fs::path& target) {
  const bool with_names = loss == Loss::nothing || loss == Loss::data;
  const bool with_data = loss == Loss::nothing || loss == Loss::names;
  if (!node.is_directory) {
    const bool is_drawn = loss == Loss::mixed && *node.data != *node.synced_data;
    set_content(target, is_drawn    ? mixed_data(*node.data, *node.synced_data, lots)
                        : with_data ? *node.data
                                    : *node.synced_data);
    return;
  }
  fs::create_directories(target);
  std::map<std::string, NodePointer> entries = with_names ? node.entries : node.synced_entries;
  if (loss == Loss::mixed) {
    // What has happened to a name since the directory was synced, a removal included, has reached the disk or not.
    for (const auto& [name, child] : node.entries)
      if (const auto before = node.synced_entries.find(name);
          (before == node.synced_entries.end() || before->second != child) && has_survived(lots))
        entries[name] = child;
    for (const auto& [name, child] : node.synced_entries)
      if (!node.entries.contains(name) && has_survived(lots)) entries.erase(name);
  }
  for (const auto& [name, child] : entries) write(*child, loss, lots, target / name);
}

void DiskModel::restore(Loss loss, const fs::path& target, std::uint64_t seed) const {
  fs::remove_all(target);
  std::mt19937_64 lots(seed);
  write(*root_, loss, lots, target);
}

void DiskModel::collect(const Node& node, const std::string& prefix, std::map<std::string, std::string>& found) {
  for (const auto& [name, child] : node.entries) {
    if (child->is_directory) {
      collect(*child, prefix + name + "/", found);
    } else {
      found[prefix + name] = *child->data;
    }
  }
}

std::map<std::string, std::string> DiskModel::files() const {
  std::map<std::string, std::string> found;
  collect(*root_, "", found);
  return found;
}

}  // namespace rouleau::testing
