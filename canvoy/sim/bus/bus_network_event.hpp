// What happens in the network of a bus, as typed events: words are made of them in the tools.
//
//     if (const auto* shown = std::get_if<DisplayShows>(&event.what)) print(shown->text);
#pragma once

#include <string>
#include <variant>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/bus/bus_fault.hpp"
#include "canvoy/sim/bus/bus_invariant.hpp"
#include "canvoy/sim/event.hpp"

namespace canvoy::bus {

struct JourneyBegan {
  std::uint32_t journey = 0;
  std::string destination{};
};
/// It stands at a stop, leaves it, or goes past.
struct StopReached {
  enum class How : std::uint8_t { arrives, leaves, passes } how = How::arrives;
  std::string stop{};
  Duration delay{};
  unsigned aboard = 0;
};
struct BlockEnded {};
/// What is read on a display from now on, lines after each other; empty: it is dark.
struct DisplayShows {
  NodeId node = 0;
  std::string text{};
};
struct Announced {
  std::uint32_t stop_point = 0;
  std::string stop{};  ///< empty: none of the line
  unsigned car = 1;
};
struct StopSignLit {
  bool is_lit = false;
  unsigned car = 1;
};
struct TicketIssued {
  bool is_printed = false;  ///< else cancelled
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

}  // namespace canvoy::bus
