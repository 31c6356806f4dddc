#include "canvoy/sim/bus/bus_fault.hpp"

#include <array>

namespace canvoy::bus {

namespace {

constexpr std::array fault_names{
    FaultName{"lost-node", "a device has no power (default: the next stop indicator)"},
    FaultName{"restart", "a device boots again (default: the on-board computer)"},
    FaultName{"cable-cut", "the bus cable is cut behind a device (default: the on-board computer)"},
    FaultName{"babbling-node", "a stranger fills the bus with frames of the highest priority"},
    FaultName{"corrupted-frames", "one frame in a hundred is disturbed, and sent again"},
    FaultName{"wrong-clock", "the clock of the on-board computer is an hour fast"},
    FaultName{"no-satellites", "there is no signal of satellites: no position, no time"},
    FaultName{"broken-door", "the second door stays as it is"},
    FaultName{"blocked-door", "something lies in the second door"},
    FaultName{"no-paper", "the ticket printer has no paper"},
    FaultName{"train-bus-cut", "the train bus to the second car is cut"},
};
static_assert(fault_names.size() == fault_kinds);

constexpr FaultPlaceName places[] = {{"node", node_id_max}};

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

}  // namespace canvoy::bus
