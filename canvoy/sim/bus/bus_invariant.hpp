// What must hold in a bus, whatever happens, and by how much it did.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/sim/invariant.hpp"

namespace canvoy::bus {

enum class InvariantKind : std::uint8_t {
  next_stop,      ///< the longest time that the next stop was not to be read; in s
  destination,    ///< the same of line and destination
  information,    ///< the same of the route's text
  lie,            ///< the longest time that a display said what is not so; in s
  texts,          ///< texts that were shown and are none of the line's: mangled, cut
  stop_sign,      ///< the longest time that somebody had pressed the button and no sign lit; in s
  announcements,  ///< stops that were not announced, or another one was
  tickets,        ///< tickets with another zone, segment, line, block or stop than the bus is at
  clock,          ///< the longest time between two messages with the right time; in s
  passengers,     ///< the longest time that others were counted than are aboard; in s
  pdo_tables,     ///< pre-defined messages with anything but what their table says is so
  service,        ///< people who were carried past their stop, or got no ticket
  second_car,     ///< the longest time that line, destination or next stop were not to be read
                  ///< there; in s
  second_announcements,  ///< stops that were not announced there, or another one was
  second_stop_sign,  ///< the longest time that somebody had pressed a button and no sign lit there,
                     ///< or one of there, and none lit in the first car; in s
  false_stop_sign,   ///< the longest time on the way that a sign was lit, in either car, though
                     ///< nobody had pressed a button since the bus stood; in s
  device_missing,    ///< the longest time that a device was not operational without an excuse; in s
};
inline constexpr std::size_t invariant_kinds =
    static_cast<std::size_t>(InvariantKind::device_missing) + 1;

/// All kinds, in the order of InvariantKind.
std::span<const InvariantName> invariant_names();
const InvariantName& invariant_name(InvariantKind kind);

using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::bus
