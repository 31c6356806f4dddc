#include "canvoy/sim/police/fault.hpp"

#include <array>

#include "canvoy/profiles/cia447/network.hpp"

namespace canvoy::police {

namespace {

constexpr std::array fault_names{
    FaultName{"lost-node", "a device has no power (default: the terminal)"},
    FaultName{"restart", "a device boots again (default: the terminal)"},
    FaultName{"cable-cut", "the bus cable is cut behind a device (default: the gateway)"},
    FaultName{"babbling-node", "a stranger fills the bus with frames of the highest priority"},
    FaultName{"corrupted-frames", "one frame in a hundred is disturbed, and sent again"},
    FaultName{"burnt-lamp", "a blue flasher in front gives no light"},
    FaultName{"overload", "the power supply has no power for the radio"},
    FaultName{"dead-client", "who holds the number pad next has no power from then on"},
};
static_assert(fault_names.size() == fault_kinds);

constexpr FaultPlaceName places[] = {{"node", cia447::node_id_max}};

}  // namespace

FaultGrammar fault_grammar() {
  return {fault_names, places};
}

std::string_view fault_name(FaultKind kind) {
  return fault_names.at(static_cast<std::size_t>(kind)).name;
}

ScheduledFault scheduled(const WrittenFault& fault) {
  return scheduled_at_node<ScheduledFault>(fault);
}

WrittenFault written(const ScheduledFault& fault) {
  return written_at_node(fault);
}

}  // namespace canvoy::police
