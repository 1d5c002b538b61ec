// SPDX-License-Identifier: BSD-3-Clause
// Checkpoint metadata as JSON text and back.
#include "storage/metadata.hpp"

#include <cmath>

#include "base/error.hpp"
#include "storage/json_entry.hpp"

namespace rouleau {
namespace {

using Json = nlohmann::ordered_json;

double finite(double value, const char* name, std::int64_t step) {
  if (!std::isfinite(value)) {
    fail(Exit::physics, "step {}: metadata entry `{}` is not finite ({}); no checkpoint was written.", step, name,
         value);
  }
  return value;
}

template <class T>
T entry(const Json& object, const char* name, const std::string& file) {
  try {
    return strictly<T>(object.at(name));
  } catch (const Json::exception& e) {
    fail(Exit::bad_input, "{}: metadata entry `{}` cannot be read: {}", file, name, e.what());
  } catch (const std::invalid_argument& e) {
    fail(Exit::bad_input, "{}: metadata entry `{}` cannot be read: {}", file, name, e.what());
  }
}

}  // namespace

std::string to_json(const CheckpointMetadata& metadata) {
  Json parameters = Json::object();
  for (const auto& [name, parameter] : metadata.parameters) {
    parameters[name] = {
        {"value", parameter.value}, {"default", parameter.default_value}, {"identity", parameter.identity}};
  }
  const Json object = {
      {"layout", metadata.layout},
      {"contract", metadata.contract},
      {"step", metadata.step},
      {"time_s", finite(metadata.time_s, "time_s", metadata.step)},
      {"attempt", metadata.attempt},
      {"version", metadata.version},
      {"git", metadata.git},
      {"identity", metadata.identity},
      {"mesh_digest", metadata.mesh_digest},
      {"node_spacing_um", finite(metadata.node_spacing_um, "node_spacing_um", metadata.step)},
      {"samples", {{"bytes", metadata.samples.bytes}, {"hash", metadata.samples.hash}}},
      {"parameters", parameters},
  };
  return object.dump(2) + "\n";
}

CheckpointMetadata metadata_from_json(const std::string& text, const std::string& file) {
  const Json object = Json::parse(text, nullptr, false);
  if (!object.is_object()) fail(Exit::bad_input, "{}: the metadata is not a JSON object", file);
  CheckpointMetadata metadata;
  metadata.layout = entry<int>(object, "layout", file);
  metadata.version = entry<std::string>(object, "version", file);
  metadata.git = entry<std::string>(object, "git", file);
  if (metadata.layout != checkpoint_layout) return metadata;
  metadata.contract = entry<int>(object, "contract", file);
  metadata.step = entry<std::int64_t>(object, "step", file);
  metadata.time_s = entry<double>(object, "time_s", file);
  metadata.attempt = entry<int>(object, "attempt", file);
  metadata.identity = entry<std::string>(object, "identity", file);
  metadata.mesh_digest = entry<std::string>(object, "mesh_digest", file);
  metadata.node_spacing_um = entry<double>(object, "node_spacing_um", file);
  const auto samples = entry<Json>(object, "samples", file);
  metadata.samples.bytes = entry<std::uint64_t>(samples, "bytes", file);
  metadata.samples.hash = entry<std::string>(samples, "hash", file);
  const auto parameters = entry<Json>(object, "parameters", file);
  for (const auto& [name, parameter] : parameters.items()) {
    metadata.parameters[name] = {entry<std::string>(parameter, "value", file),
                                 entry<std::string>(parameter, "default", file),
                                 entry<bool>(parameter, "identity", file)};
  }
  return metadata;
}

}  // namespace rouleau
