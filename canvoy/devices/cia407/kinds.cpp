#include "canvoy/devices/cia407/kinds.hpp"

#include "canvoy/devices/cia407/acoustic/acoustic_announcer_unit.hpp"
#include "canvoy/devices/cia407/acoustic/acoustic_control_manager_unit.hpp"
#include "canvoy/devices/cia407/by_code/code_only_unit.hpp"
#include "canvoy/devices/cia407/console/driver_indicator_unit.hpp"
#include "canvoy/devices/cia407/console/keyboard_unit.hpp"
#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/cia407/diagnostics/diagnostics_unit.hpp"
#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/devices/cia407/gateway/vehicle_gateway_unit.hpp"
#include "canvoy/devices/cia407/generic_io/generic_io_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"
#include "canvoy/devices/cia407/positioning/positioning_unit.hpp"
#include "canvoy/devices/cia407/positioning/time_fixing_unit.hpp"
#include "canvoy/devices/cia407/tachograph/tachograph_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_printer_unit.hpp"

namespace canvoy::cia407 {

namespace {

using enum InformationClass;
using enum InformationSubclass;

template <InformationClass device_class, InformationSubclass subclass>
constexpr DeviceKind display() {
  return bus_device_kind<PassengerInformationKind<device_class, subclass>>();
}

const DeviceKind all[] = {
    bus_device_kind<MainOnBoardComputerKind>(),
    bus_device_kind<IdentificationKind>(),
    display<destination, simple>(),
    display<destination, text>(),
    display<destination, graphics>(),
    display<destination, extended>(),
    display<next_stop, simple>(),
    display<next_stop, text>(),
    display<next_stop, graphics>(),
    display<next_stop, extended>(),
    display<information, simple>(),
    display<information, text>(),
    display<information, graphics>(),
    display<information, extended>(),
    bus_device_kind<TicketCancellerKind>(),
    bus_device_kind<TicketPrinterKind>(),
    bus_device_kind<TicketReaderKind>(),
    bus_device_kind<AcousticAnnouncerKind>(),
    bus_device_kind<AcousticControlManagerKind>(),
    bus_device_kind<TrainBusGatewayKind>(),
    bus_device_kind<VehicleGatewayKind>(),
    bus_device_kind<DriverDisplayKind>(),
    bus_device_kind<DriverDisplayWithKeyboardKind>(),
    bus_device_kind<TachographKind>(),
    bus_device_kind<DataRadioKind>(),
    bus_device_kind<VoiceRadioKind>(),
    bus_device_kind<ShortRangeKind>(),
    bus_device_kind<PositioningKind>(),
    bus_device_kind<TimeFixingKind>(),
    bus_device_kind<ConsoleDisplayKind>(),
    bus_device_kind<KeyboardKind>(),
    bus_device_kind<PassengerCounterKind>(),
    bus_device_kind<CountingManagerKind>(),
    bus_device_kind<DiagnosticsKind>(),
    bus_device_kind<GenericIoKind>(),
    bus_device_kind<BusPowerSupplyKind>(),
};

}  // namespace

static_assert(std::size(all) == kind_count);

std::span<const DeviceKind> kinds() {
  return all;
}

}  // namespace canvoy::cia407
