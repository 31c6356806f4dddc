#include "canvoy/sim/excavator/excavator_invariant.hpp"

#include <array>

namespace canvoy::excavator {

namespace {

constexpr auto excavator_invariants = std::to_array<InvariantName>({
    {"unwanted_motion", "the machine moved as no hand wanted it for at most", "s"},
    {"lost_seat", "the machine moved without a sign of the seat for at most", "s"},
    {"lost_host", "the machine moved without a sign of the host for at most", "s"},
    {"lost_armrest", "the machine moved without a sign of the armrest for at most", "s"},
    {"presses", "presses without their one effect, or effects without a press", ""},
    {"axis_delta", "an axis was away from the host's value by at most", "digits"},
    {"indicators", "a lamp said what is not so for at most", "s"},
    {"display", "the display said what is not so for at most", "s"},
    {"service", "no earth came to the heap at work for at most", "s"},
    {"device_missing", "a device was missing without an excuse for at most", "s"},
});
static_assert(excavator_invariants.size() == invariant_kinds);

}  // namespace

std::span<const InvariantName> invariant_names() {
  return excavator_invariants;
}

const InvariantName& invariant_name(InvariantKind kind) {
  return excavator_invariants.at(static_cast<std::size_t>(kind));
}

}  // namespace canvoy::excavator
