// Events in the network of a bus, as types; the tools turn them into words.
//
//     if (const auto* shown = std::get_if<DisplayShows>(&event.what)) print(shown->text);
#pragma once

#include <string>
#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/worlds/bus_line/bus_fault.hpp"
#include "canvoy/worlds/bus_line/bus_invariant.hpp"

namespace canvoy::bus_line {

struct JourneyBegan {
  std::uint32_t journey = 0;
  std::string destination{};
};
/// The bus stands at a stop, leaves it, or passes it.
struct StopReached {
  enum class How : std::uint8_t { arrives, leaves, passes } how = How::arrives;
  std::string stop{};
  Duration delay{};
  unsigned aboard = 0;
};
struct BlockEnded {};
/// The text on a display changes; its lines follow each other; empty: it is dark.
struct DisplayShows {
  NodeId node = 0;
  std::string text{};
};
struct Announced {
  std::uint32_t stop_point = 0;
  std::string stop{};  ///< empty: no stop of the line
  unsigned car = 1;
};
struct StopSignLit {
  bool is_lit = false;
  unsigned car = 1;
};
struct TicketIssued {
  bool is_printed = false;  ///< false: it is cancelled
  std::uint8_t fare_zone = 0;
  std::uint16_t route_segment = 0;
};

using FaultBegan = canvoy::FaultBegan<FaultKind>;
using FaultEnded = canvoy::FaultEnded<FaultKind>;
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

struct NetworkEvent {
  Time at{};
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged, JourneyBegan,
               StopReached, BlockEnded, DisplayShows, Announced, StopSignLit, TicketIssued,
               FaultBegan, FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::bus_line
