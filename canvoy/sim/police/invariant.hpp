// What must hold in a police car, whatever happens, and by how much it did.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "canvoy/sim/invariant.hpp"

namespace canvoy::police {

enum class InvariantKind : std::uint8_t {
  keypad,         ///< keys that another client acted on than the one for which they were pressed
  terminal_wait,  ///< the longest time that somebody at the terminal waited for a client; in s
  blue_light,     ///< the longest time that the blue light was not as the crew wished; in s
  siren,          ///< the same of the siren
  speech,         ///< the longest time that somebody spoke and was not heard; in s
  carrier,  ///< the longest time that the radio blocked the channel with nobody speaking; in s
  display,  ///< the longest time that display 2 said what is not so; in s
  locks,    ///< the longest time that the car was not locked, or unlocked, as wished; in s
  power,    ///< the longest time that there was no power with the ignition on, or some when the
            ///< after-run was over; in s
  silence,  ///< frames that were sent while all slept
  calls,    ///< calls for help that were not attended to, and reported, in time
  device_missing,  ///< the longest time that a device was not operational without an excuse; in s
};
inline constexpr std::size_t invariant_kinds =
    static_cast<std::size_t>(InvariantKind::device_missing) + 1;

/// All kinds, in the order of InvariantKind.
std::span<const InvariantName> invariant_names();
const InvariantName& invariant_name(InvariantKind kind);

using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::police
