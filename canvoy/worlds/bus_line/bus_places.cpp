#include "canvoy/worlds/bus_line/bus_places.hpp"

#include "canvoy/devices/cia407/acoustic/acoustic_announcer_unit.hpp"
#include "canvoy/devices/cia407/console/driver_indicator_unit.hpp"
#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/devices/cia407/gateway/vehicle_gateway_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"
#include "canvoy/devices/cia407/positioning/positioning_unit.hpp"
#include "canvoy/devices/cia407/positioning/time_fixing_unit.hpp"
#include "canvoy/devices/cia407/tachograph/tachograph_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_printer_unit.hpp"
#include "canvoy/sim/device_name.hpp"
#include "canvoy/worlds/bus_line/line_control.hpp"
#include "canvoy/worlds/bus_line/mirror_control.hpp"

namespace canvoy::bus_line {

namespace {

using namespace cia407;

template <class... Kind>
constexpr const BusUnit* units_of[] = {&bus_unit<Kind>...};

template <InformationClass device_class>
using TextDisplay = PassengerInformationKind<device_class, InformationSubclass::text>;

/// Virtual devices of each place.
struct PlaceUnits {
  NodeId id;
  std::span<const BusUnit* const> units;
};
constexpr PlaceUnits place_units[] = {
    {computer_id, units_of<MainOnBoardComputerKind, LineControlKind>},
    {identification_id, units_of<IdentificationKind>},
    {front_display_id, units_of<TextDisplay<InformationClass::destination>>},
    {next_stop_id, units_of<TextDisplay<InformationClass::next_stop>>},
    {canceller_id, units_of<TicketCancellerKind>},
    {printer_id, units_of<TicketPrinterKind>},
    {information_id, units_of<TextDisplay<InformationClass::information>>},
    {announcer_id, units_of<AcousticAnnouncerKind>},
    {side_display_id, units_of<TextDisplay<InformationClass::destination>>},
    {vehicle_gateway_id, units_of<VehicleGatewayKind>},
    {tachograph_id, units_of<TachographKind>},
    {driver_display_id, units_of<DriverDisplayKind>},
    {positioning_id, units_of<PositioningKind, TimeFixingKind>},
    {first_counter_id, units_of<PassengerCounterKind>},
    {counting_manager_id, units_of<CountingManagerKind>},
    {second_counter_id, units_of<PassengerCounterKind>},
    {train_gateway_id, units_of<TrainBusGatewayKind>},
    {gateway_of(2), units_of<TrainBusGatewayKind, MirrorControlKind>},
    {destination_of(2), units_of<TextDisplay<InformationClass::destination>>},
    {next_stop_of(2), units_of<TextDisplay<InformationClass::next_stop>>},
    {announcer_of(2), units_of<AcousticAnnouncerKind>},
    {gateway_of(3), units_of<TrainBusGatewayKind, MirrorControlKind>},
    {destination_of(3), units_of<TextDisplay<InformationClass::destination>>},
    {next_stop_of(3), units_of<TextDisplay<InformationClass::next_stop>>},
    {announcer_of(3), units_of<AcousticAnnouncerKind>},
    {gateway_of(4), units_of<TrainBusGatewayKind, MirrorControlKind>},
    {destination_of(4), units_of<TextDisplay<InformationClass::destination>>},
    {next_stop_of(4), units_of<TextDisplay<InformationClass::next_stop>>},
    {announcer_of(4), units_of<AcousticAnnouncerKind>},
};
static_assert(std::size(place_units) == device_places.size());

}  // namespace

std::span<const cia407::BusUnit* const> units_at(NodeId id) {
  return std::ranges::find(place_units, id, &PlaceUnits::id)->units;
}

std::string device_name_of(NodeId id) {
  return canvoy::device_name<cia407::BusUnit>(units_at(id), cia407::application);
}

}  // namespace canvoy::bus_line
