#include "canvoy/sim/charging/fault.hpp"

#include <array>

namespace canvoy::charging {

namespace {

constexpr std::array fault_names{
    FaultName{"heartbeat-loss", "the battery's heartbeat does not arrive; all else does"},
    FaultName{"pdo-loss", "the battery's TPDOs do not arrive"},
    FaultName{"battery-silent", "the battery module has no power"},
    FaultName{"battery-restart", "the battery module boots again"},
    FaultName{"not-ready", "the battery says that it is not ready"},
    FaultName{"too-hot", "the battery's temperature sensor shows 55 °C"},
    FaultName{"too-cold", "the battery's temperature sensor shows -12 °C"},
    FaultName{"invalid-temperature", "the battery cannot measure its temperature"},
    FaultName{"invalid-voltage", "the battery cannot measure its voltage"},
    FaultName{"pilot-loss", "the charger's pilot signal is gone"},
    FaultName{"cable-cut", "the bus cable is cut between the charger and the battery"},
    FaultName{"corrupted-frames", "one frame in a hundred is disturbed, and sent again"},
    FaultName{"babbling-node", "a third node fills the bus with frames of the highest priority"},
    FaultName{"duplicate-node-id",
              "a second module at the battery boots with the node-ID of the first"},
    FaultName{"wrong-bit-rate", "the battery is set to 250 kbit/s"},
    FaultName{"clock-drift", "the battery's clock is fast by 0.5 %"},
};

static_assert(fault_names.size() == fault_kinds);

}  // namespace

FaultGrammar fault_grammar() {
  return {fault_names};
}

std::string_view fault_name(FaultKind kind) {
  return fault_names.at(static_cast<std::size_t>(kind)).name;
}

ScheduledFault scheduled(const WrittenFault& fault) {
  return {static_cast<FaultKind>(fault.kind), fault.start, fault.duration};
}

WrittenFault written(const ScheduledFault& fault) {
  return {.kind = static_cast<std::size_t>(fault.kind),
          .start = fault.start,
          .duration = fault.duration};
}

}  // namespace canvoy::charging
