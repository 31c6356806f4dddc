// Arbitrary text as a network file: it is read or refused with a line, and what was read is written
// as a file with the same meaning.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/play/world.hpp"

namespace {

using namespace canvoy::tools;

/// The file that is written for this text.
std::string written(std::string_view text) {
  TomlFile file("network.toml", text);
  TomlTable& table = file.table();
  std::string network;
  table.take("network", network);
  for (const WorldEntry& world : worlds()) {
    if (world.name == network) return world.rewrite(table, "");
  }
  throw Failure("there is no such network");
}

void check(std::string_view text) {
  std::string once;
  try {
    once = written(text);
  } catch (const Failure&) {
    return;
  }
  if (written(once) != once) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // These keys name other files, which could be any of this machine.
  for (const std::string_view key :
       {"list", "configuration", "nmea", "places", "gtfs", "recorded"}) {
    if (text.find(key) != std::string_view::npos) return 0;
  }
  check(text);
  return 0;
}
