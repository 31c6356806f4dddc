#include "canvoy/sim/charging/invariant.hpp"

#include <array>

namespace canvoy::charging {

namespace {

constexpr auto invariants = std::to_array<InvariantName>({
    {"ampere_hours", "ampere-hours of charger and plant differ by", "%"},
    {"energy", "energy of charger and plant differs by", "%"},
    {"current_outside_handshake", "current outside of a handshake for at most", "s"},
    {"current_before_ready", "currents that began before ready", ""},
    {"battery_left_waiting", "battery left without current for at most", "s"},
    {"fault_seen", "seen after", "s"},
});
static_assert(invariants.size() == static_cast<std::size_t>(InvariantKind::fault_seen) + 1);

}  // namespace

std::span<const InvariantName> invariant_names() {
  return invariants;
}

const InvariantName& invariant_name(InvariantKind kind) {
  return invariants.at(static_cast<std::size_t>(kind));
}

}  // namespace canvoy::charging
