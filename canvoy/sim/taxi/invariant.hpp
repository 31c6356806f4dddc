// What must hold in a taxi, whatever happens, and by how much it did.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "canvoy/sim/invariant.hpp"

namespace canvoy::taxi {

enum class InvariantKind : std::uint8_t {
  fare,      ///< what a passenger paid outside of what the tariff asks for the true drive; in cents
  distance,  ///< of a trip, beyond the limit; in m
  duration,  ///< of a trip, beyond the limit; in s
  totals,    ///< income of the shift against the sum of what was paid; in cents
  receipts,  ///< what is read on receipts against what was paid; in cents
  roof_sign,       ///< the longest time that the light for a vacant taxi was wrong; in s
  terminal_fare,   ///< the longest time that the terminal showed another fare than the meter; in s
  terminal_place,  ///< the longest time that it named another place than where the car is; in s
  silence,         ///< frames that were sent while all slept
  no_service,  ///< the longest time that somebody who wants to ride or to pay had to wait for the
               ///< meter; in s
  carried,     ///< nobody was carried in a shift that was long enough for it: 1
  device_missing,  ///< the longest time that a device was not operational without an excuse; in s
};
inline constexpr std::size_t invariant_kinds =
    static_cast<std::size_t>(InvariantKind::device_missing) + 1;

/// All kinds, in the order of InvariantKind.
std::span<const InvariantName> invariant_names();
const InvariantName& invariant_name(InvariantKind kind);

using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::taxi
