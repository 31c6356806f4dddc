#include "canvoy/tools/bus/remote_argument.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>

#include "canvoy/tools/bus/session.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

/// 1 to `most`, or 0.
unsigned place_number(std::string_view text, unsigned most) {
  unsigned number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stop == end && number <= most ? number : 0;
}

}  // namespace

BusArgument parse_bus_argument(std::string_view text) {
  const std::size_t slash = text.rfind('/');
  if (slash == std::string_view::npos) return {.bus = std::string(text)};
  const std::string_view place = text.substr(slash + 1);
  const std::size_t colon = place.find(':');
  constexpr unsigned networks = 0xFFFF;
  constexpr unsigned nodes = 127;
  const unsigned network = place_number(place.substr(0, colon), networks);
  const unsigned device =
      colon == std::string_view::npos ? 0 : place_number(place.substr(colon + 1), nodes);
  if (network == 0 || device == 0) {
    throw UsageError(fmt::format(
        "'{}' is no node of a network behind another: write can0/2:7 for node 7 of network 2",
        text));
  }
  return {std::string(text.substr(0, slash)), static_cast<std::uint16_t>(network),
          static_cast<NodeId>(device)};
}

void add_remote_options(CLI::App& command, RemoteOptions& options) {
  command.add_option("--through", options.through,
                     "of a bus as can0/2:7: the node behind which that network is (default 10)");
  command
      .add_option("--indication", options.indication,
                  "the SDO command by which that node is told of the network (default 0xE0)")
      ->check(CLI::Range(0xE0U, 0xFFU));
}

void reach(Session& session, const BusArgument& bus, const RemoteOptions& options) {
  if (!bus.is_remote()) return;
  RemoteSettings settings;
  settings.network = bus.network;
  settings.indication = static_cast<std::uint8_t>(options.indication);
  session.reach_behind(parse_node_id(options.through), settings);
}

}  // namespace canvoy::tools
