#include "canvoy/sim/police/invariant.hpp"

#include <array>

namespace canvoy::police {

namespace {

constexpr auto invariants = std::to_array<InvariantName>({
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
});
static_assert(invariants.size() == invariant_kinds);

}  // namespace

std::span<const InvariantName> invariant_names() {
  return invariants;
}

const InvariantName& invariant_name(InvariantKind kind) {
  return invariants.at(static_cast<std::size_t>(kind));
}

}  // namespace canvoy::police
