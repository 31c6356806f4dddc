// Invariants of a taxi: what must hold whatever happens, and by what margin it held.
#pragma once

#include "canvoy/sim/invariant.hpp"

namespace canvoy::taxi {

/// In the order of invariant_rows.
enum class InvariantKind : std::uint8_t {
  fare,
  distance,
  duration,
  waiting,
  total,
  totals,
  receipts,
  receipt_lines,
  shift_slip,
  roof_sign,
  alarm,
  terminal_fare,
  terminal_place,
  silence,
  no_service,
  carried,
  device_missing,
  power_cut,  ///< only where the meter has lost its power in a trip
  tampering,  ///< only where meter or car were tampered with
};

/// All kinds, in the order of InvariantKind.
inline constexpr InvariantRow invariant_rows[] = {
    {"fare", "fares outside of the tariff's by at most", "cents", "2014/32/EU, annex IX"},
    {"distance", "distances of trips beyond their limit by at most", "m", "2014/32/EU, annex IX"},
    {"duration", "durations of trips beyond their limit by at most", "s", "2014/32/EU, annex IX"},
    {"waiting", "waiting times of trips outside of the tariff's by at most", "s",
     "2014/32/EU, annex IX"},
    {"total", "TOTAL and what fare and extras come to differ by at most", "cents"},
    {"totals", "income of the shift and what was paid differ by", "cents"},
    {"receipts", "receipts and what was paid differ by", "cents"},
    {"receipt_lines", "lines of receipts that were wrong", ""},
    {"shift_slip", "lines of the shift slip that were wrong", ""},
    {"roof_sign", "the roof sign was wrong for at most", "s"},
    {"alarm", "an alarm was not seen on the roof, or heard by radio, for at most", "s"},
    {"terminal_fare", "the terminal showed another fare than the meter for at most", "s"},
    {"terminal_place", "the terminal named a place where the car was not for at most", "s"},
    {"silence", "frames sent while all slept", ""},
    {"no_service", "passengers waited for the meter for at most", "s"},
    {"carried", "shifts without a passenger", ""},
    {"device_missing", "a device was missing without an excuse for at most", "s"},
    {"power_cut", "trips without a defined end after a loss of power", "", "2014/32/EU, annex IX"},
    {"tampering", "acts of tampering that neither meter nor passengers have found", ""},
};
/// Number of invariants.
inline constexpr std::size_t invariant_kinds = std::size(invariant_rows);
static_assert(invariant_kinds == static_cast<std::size_t>(InvariantKind::tampering) + 1);
/// The rows of the table above; found by the type of the argument.
constexpr std::span<const InvariantRow> rows_of(InvariantKind) {
  return invariant_rows;
}

/// Verdict on one invariant: whether it held, and by what margin.
using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::taxi
