// Network files in tests: reading, writing, and the events of their runs.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "canvoy/tools/play/world.hpp"

namespace canvoy::tools {

inline const WorldEntry& world_of(std::string_view name) {
  for (const WorldEntry& world : worlds()) {
    if (world.name == name) return world;
  }
  throw Failure("no such world");
}

/// The file as written again, or the error.
inline std::string rewritten_file(std::string_view world, const std::string& text) {
  TomlFile file("car.toml", fmt::format("network = \"{}\"\n{}", world, text));
  std::string network;
  file.table().take("network", network);
  try {
    return world_of(world).rewrite(file.table(), "");
  } catch (const Failure& failure) {
    return failure.what();
  }
}
/// The events of its run, as JSON Lines.
inline std::string events_of(std::string_view world, const std::string& text, Time until) {
  TomlFile file("car.toml", fmt::format("network = \"{}\"\n{}", world, text));
  std::string network;
  file.table().take("network", network);
  const HeardWorld made = world_of(world).make(file.table(), "");
  made.network->run_until(until);
  std::string events;
  for (std::size_t i = 0; i < made.network->event_count(); ++i) {
    events += made.network->event(i).json + "\n";
  }
  return events;
}

}  // namespace canvoy::tools
