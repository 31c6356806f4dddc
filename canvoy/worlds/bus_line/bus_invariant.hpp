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
  third_car,
  third_announcements,
  third_stop_sign,
  fourth_car,
  fourth_announcements,
  fourth_stop_sign,
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
    {"third_car", "destination or next stop were not to be read in the third car for at most", "s"},
    {"third_announcements", "stops that were announced wrongly or not in the third car", ""},
    {"third_stop_sign",
     "the stop button was pressed and no sign was lit in or for the third car for at most", "s"},
    {"fourth_car", "destination or next stop were not to be read in the fourth car for at most",
     "s"},
    {"fourth_announcements", "stops that were announced wrongly or not in the fourth car", ""},
    {"fourth_stop_sign",
     "the stop button was pressed and no sign was lit in or for the fourth car for at most", "s"},
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

/// Number of kinds of each car behind the first.
inline constexpr unsigned kinds_of_a_car = 3;
/// The kind for car 2, 3 or 4, by that for the second one.
constexpr InvariantKind kind_in(unsigned car, InvariantKind second) {
  return static_cast<InvariantKind>(static_cast<unsigned>(second) + (car - 2) * kinds_of_a_car);
}
/// Destination and next stop can be read in car 2, 3 or 4.
constexpr InvariantKind car_kind(unsigned car) {
  return kind_in(car, InvariantKind::second_car);
}
/// Announcements in any car.
constexpr InvariantKind announcements_in(unsigned car) {
  return car == 1 ? InvariantKind::announcements
                  : kind_in(car, InvariantKind::second_announcements);
}
/// Stop signs in or for car 2, 3 or 4.
constexpr InvariantKind stop_sign_in(unsigned car) {
  return kind_in(car, InvariantKind::second_stop_sign);
}
static_assert(stop_sign_in(4) == InvariantKind::fourth_stop_sign);
/// Car of which the kind is, where that is not the first; 1 for all other kinds.
constexpr unsigned car_of(InvariantKind kind) {
  if (kind < InvariantKind::second_car || kind > InvariantKind::fourth_stop_sign) return 1;
  const auto place = static_cast<unsigned>(kind) - static_cast<unsigned>(InvariantKind::second_car);
  return 2 + place / kinds_of_a_car;
}

/// Verdict on one invariant: whether it held, and by what margin.
using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::bus_line
