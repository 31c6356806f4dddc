// Invariants of a bus: what must hold whatever happens, and by what margin it held.
#pragma once

#include "canvoy/sim/invariant.hpp"

namespace canvoy::bus_line {

/// What must hold; invariant_rows has name, unit and source of the bound of each.
enum class InvariantKind : std::uint8_t {
  next_stop,
  destination,
  information,
  lie,
  texts,
  stop_sign,
  announcements,
  tickets,
  clock,
  passengers,
  pdo_tables,
  service,
  second_car,
  second_announcements,
  second_stop_sign,
  false_stop_sign,
  early_departure,
  left_behind,
  overcrowded,
  device_missing
};

/// All kinds, in the order of InvariantKind.
inline constexpr InvariantRow invariant_rows[] = {
    {"next_stop", "the next stop was not to be read for at most", "s"},
    {"destination", "the destination was not to be read for at most", "s"},
    {"information", "the route was not to be read for at most", "s"},
    {"lie", "a display said what is not so for at most", "s"},
    {"texts", "texts shown that are none of the line's", ""},
    {"stop_sign", "the stop button was pressed and no sign was lit for at most", "s"},
    {"announcements", "stops that were announced wrongly or not", ""},
    {"tickets", "tickets with a wrong place, line or block", ""},
    {"clock", "the right time was not told for at most", "s"},
    {"passengers", "others were counted than are aboard for at most", "s"},
    {"pdo_tables", "pre-defined messages with other than their table's contents", ""},
    {"service", "people who were carried past their stop, or got no ticket", ""},
    {"second_car", "destination or next stop were not to be read in the second car for at most",
     "s"},
    {"second_announcements", "stops that were announced wrongly or not in the second car", ""},
    {"second_stop_sign",
     "the stop button was pressed and no sign was lit in or for the second car for at most", "s"},
    {"false_stop_sign", "a stop sign was lit without a press for at most", "s"},
    {"early_departure", "departures from a timing point before its time", ""},
    {"left_behind", "people who stood at a stop and were left there with room aboard", ""},
    {"overcrowded", "more people were aboard than there is room for, for at most", "s"},
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

}  // namespace canvoy::bus_line
