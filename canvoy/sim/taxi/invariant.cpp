#include "canvoy/sim/taxi/invariant.hpp"

#include <array>

namespace canvoy::taxi {

namespace {

constexpr auto invariants = std::to_array<InvariantName>({
    {"fare", "fares outside of the tariff's by at most", "cents"},
    {"distance", "distances of trips beyond their limit by at most", "m"},
    {"duration", "durations of trips beyond their limit by at most", "s"},
    {"totals", "income of the shift and what was paid differ by", "cents"},
    {"receipts", "receipts and what was paid differ by", "cents"},
    {"roof_sign", "the roof sign was wrong for at most", "s"},
    {"terminal_fare", "the terminal showed another fare than the meter for at most", "s"},
    {"terminal_place", "the terminal named a place where the car was not for at most", "s"},
    {"silence", "frames sent while all slept", ""},
    {"no_service", "passengers waited for the meter for at most", "s"},
    {"carried", "shifts in which nobody was carried", ""},
    {"device_missing", "a device was missing without an excuse for at most", "s"},
});
static_assert(invariants.size() == invariant_kinds);

}  // namespace

std::span<const InvariantName> invariant_names() {
  return invariants;
}

const InvariantName& invariant_name(InvariantKind kind) {
  return invariants.at(static_cast<std::size_t>(kind));
}

}  // namespace canvoy::taxi
