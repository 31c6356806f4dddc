// What must hold in a police car, whatever happens, and by how much it did.
#pragma once

#include "canvoy/sim/invariant.hpp"

namespace canvoy::police {

enum class InvariantKind : std::uint8_t {
  keypad,
  terminal_wait,
  blue_light,
  siren,
  speech,
  carrier,
  display,
  locks,
  power,
  silence,
  calls,
  device_missing
};

/// All kinds, in the order of InvariantKind.
inline constexpr InvariantRow invariant_rows[] = {
    {"keypad", "keys on which another client acted than they were pressed for", ""},
    {"terminal_wait", "somebody waited at the terminal for at most", "s"},
    {"blue_light", "the blue light was not as wished for at most", "s"},
    {"siren", "the siren was not as wished for at most", "s"},
    {"speech", "somebody spoke and was not heard for at most", "s"},
    {"carrier", "the radio blocked the channel with nobody speaking for at most", "s"},
    {"display", "display 2 said what is not so for at most", "s"},
    {"locks", "the locks were not as wished for at most", "s"},
    {"power", "radio and periphery were powered wrongly for at most", "s"},
    {"silence", "frames sent while all slept", ""},
    {"calls", "calls for help that were not attended to and reported", ""},
    {"device_missing", "a device was missing without an excuse for at most", "s"},
};
inline constexpr std::size_t invariant_kinds = std::size(invariant_rows);
static_assert(invariant_kinds == static_cast<std::size_t>(InvariantKind::device_missing) + 1);
constexpr std::span<const InvariantRow> rows_of(InvariantKind) {
  return invariant_rows;
}

using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::police
