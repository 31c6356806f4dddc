#include "canvoy/tools/argument/remote_argument.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "canvoy/formats/trace/trace_format.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

/// 1 to `most`, or 0.
unsigned place_number(std::string_view text, unsigned most) {
  unsigned number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stop == end && number <= most ? number : 0;
}

/// `2:7`; nothing for another text.
std::optional<RemotePlace> find_remote_place(std::string_view text) {
  constexpr unsigned networks = 0xFFFF;
  constexpr unsigned nodes = 127;
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const unsigned network = place_number(text.substr(0, colon), networks);
  const unsigned node = place_number(text.substr(colon + 1), nodes);
  if (network == 0 || node == 0) return std::nullopt;
  return RemotePlace{static_cast<std::uint16_t>(network), static_cast<NodeId>(node)};
}

/// `tpc:HOST:PORT`: opening it reports the error.
bool is_of_unknown_kind(std::string_view bus) {
  return bus.find(':') != std::string_view::npos && !bus.starts_with("udp:") &&
         !bus.starts_with("tcp:");
}
/// The path of a log, which is refused when the bus is opened.
bool is_path(std::string_view text) {
  return text.starts_with('/') || text.starts_with('.') || formats::names_trace(text);
}

}  // namespace

RemotePlace parse_remote_place(std::string_view text) {
  const std::optional<RemotePlace> place = find_remote_place(text);
  return place ? *place : RemotePlace{.node = parse_node_id(text)};
}

void split_remote_bus(std::vector<std::string>& words) {
  if (words.empty()) return;
  const std::string bus = words.front();
  // tcp:HOST:PORT/can0 has a slash of its own.
  const std::size_t begin = bus.starts_with("tcp:") ? bus.find('/') : std::string::npos;
  const std::size_t slash = bus.find('/', begin == std::string::npos ? 0 : begin + 1);
  if (slash == std::string::npos || (bus.starts_with("tcp:") && begin == std::string::npos)) return;
  if (is_path(bus)) return;
  if (!find_remote_place(std::string_view(bus).substr(slash + 1))) {
    if (is_of_unknown_kind(bus.substr(0, slash))) return;
    throw UsageError(fmt::format(
        "'{}' is no node of a network behind another: write can0/2:7 for node 7 of network 2",
        bus));
  }
  words.front() = bus.substr(0, slash);
  words.insert(words.begin() + 1, bus.substr(slash + 1));
}

void RemoteOptions::add_to(Verb& command) {
  command.add({
      {"--through", through, "of a node 2:7: the node behind which that network is (default 10)"},
      {"--indication", indication,
       "the SDO command by which that node is told of the network (default 0xE0)",
       between(0xE0U, 0xFFU)},
  });
}

}  // namespace canvoy::tools
