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

/// The driver has logged in the next journey of the block.
struct JourneyBegan {
  std::uint32_t journey = 0;  ///< its number, 6195h
  std::string destination{};  ///< as shown, UTF-8
};
/// The bus stands at a stop, leaves it, or passes it.
struct StopReached {
  /// What the bus does at the stop.
  enum class How : std::uint8_t { arrives, leaves, passes } how = How::arrives;  ///< which of them
  std::string stop{};   ///< name of the stop
  Duration delay{};     ///< behind the timetable; negative: early
  unsigned aboard = 0;  ///< people aboard at that moment
};
/// The vehicle has done the journeys of the day.
struct BlockEnded {};
/// The text on a display changes; its lines follow each other; empty: it is dark.
struct DisplayShows {
  NodeId node = 0;     ///< of the display
  std::string text{};  ///< UTF-8
};
/// A stop is announced in a car.
struct Announced {
  std::uint32_t stop_point = 0;  ///< its number, 6109h
  std::string stop{};            ///< empty: no stop of the line
  unsigned car = 1;              ///< 1 to 4
};
/// The sign "stop requested" goes on or off.
struct StopSignLit {
  bool is_lit = false;  ///< true: on
  unsigned car = 1;     ///< 1 to 4
};
/// A passenger has a new valid ticket.
struct TicketIssued {
  bool is_printed = false;          ///< false: it is cancelled
  std::uint8_t fare_zone = 0;       ///< as printed on it
  std::uint16_t route_segment = 0;  ///< as printed on it
};

/// A fault of the plan begins.
using FaultBegan = canvoy::FaultBegan<FaultKind>;
/// A fault of the plan is over.
using FaultEnded = canvoy::FaultEnded<FaultKind>;
/// An invariant is broken for the first time.
using InvariantBroken = canvoy::InvariantBroken<InvariantKind>;

/// What happened, and when.
struct NetworkEvent {
  Time at{};  ///< since the start of the run
  /// One of the types above, or of sim/event_log.hpp.
  std::variant<BootedUp, NmtStateSeen, NmtCommandSeen, EmergencySeen, BusStateChanged, JourneyBegan,
               StopReached, BlockEnded, DisplayShows, Announced, StopSignLit, TicketIssued,
               FaultBegan, FaultEnded, InvariantBroken>
      what;
};

}  // namespace canvoy::bus_line
