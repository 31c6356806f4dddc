// Invariants of a police car: what must hold whatever happens, and by what margin it held.
#pragma once

#include "canvoy/sim/invariant.hpp"

namespace canvoy::police {

/// In the order of invariant_rows.
enum class InvariantKind : std::uint8_t {
  keypad,
  terminal_wait,
  blue_light,
  siren,
  siren_alone,
  work_light,
  speech,
  carrier,
  display,
  locks,
  power,
  silence,
  calls,
  emergency,
  device_missing
};

/// All kinds, in the order of InvariantKind.
inline constexpr InvariantRow invariant_rows[] = {
    {"keypad", "keys on which another client acted than they were pressed for", ""},
    {"terminal_wait", "a person waited at the terminal for at most", "s"},
    {"blue_light", "the blue light was not as wished for at most", "s"},
    {"siren", "the siren was not as wished for at most", "s"},
    {"siren_alone", "the siren sounded without blue light for at most", "s"},
    {"work_light", "search lamp and alley lights were not as wished for at most", "s"},
    {"speech", "what was spoken was not heard for at most", "s"},
    {"carrier", "the radio blocked the channel without a word for at most", "s"},
    {"display", "display 2 said what is not so for at most", "s"},
    {"locks", "the locks were not as wished for at most", "s"},
    {"power", "radio and periphery were powered wrongly for at most", "s"},
    {"silence", "frames sent while all slept", ""},
    {"calls", "calls for help that were not attended to and reported", ""},
    {"emergency", "an emergency key was pressed, and status 0 not heard, for at most", "s"},
    {"device_missing", "a device was missing without an excuse for at most", "s"},
};
/// Number of invariants.
inline constexpr std::size_t invariant_kinds = std::size(invariant_rows);
static_assert(invariant_kinds == static_cast<std::size_t>(InvariantKind::device_missing) + 1);
/// The rows of the table above; found by the type of the argument.
constexpr std::span<const InvariantRow> rows_of(InvariantKind) {
  return invariant_rows;
}

/// Verdict on one invariant: whether it held, and by what margin.
using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::police
