#include "canvoy/sim/taxi/fault.hpp"

#include <array>

#include "canvoy/profiles/cia447/network.hpp"

namespace canvoy::taxi {

namespace {

constexpr std::array fault_names{
    FaultName{"lost-node", "a device has no power (default: the taximeter)"},
    FaultName{"restart", "a device boots again (default: the taximeter)"},
    FaultName{"cable-cut", "the bus cable is cut behind a device (default: the gateway)"},
    FaultName{"babbling-node", "a stranger fills the bus with frames of the highest priority"},
    FaultName{"corrupted-frames", "one frame in a hundred is disturbed, and sent again"},
    FaultName{"wheel-signal", "the wheel pulse counter does not know how far the car has gone"},
    FaultName{"paper-out", "the printer has no paper"},
    FaultName{"no-fix", "the GPS receiver sees no satellites"},
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

}  // namespace canvoy::taxi
