// Devices of CiA 407 in memory that is known at compile time: they have the objects of those that
// are composed at run time, and answer alike at the wire.
#include "canvoy/devices/cia407/kit/bus_board.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"
#include "canvoy/devices/testing/board_tables.hpp"

namespace canvoy::cia407::bus_board_test {
namespace {

using DestinationText =
    PassengerInformationKind<InformationClass::destination, InformationSubclass::text>;

/// Bits of the default of each entry, its access, limits and places, in the order of the tables.
template <class Kind>
void expect_the_same_tables() {
  const PartTables composed(bus_parts(only_bus_unit<Kind>));
  expect_same_tables(DeviceNode<layout_of<BusBoard<Kind>>>::tables, composed.tables());
}

TEST(BusBoard, HasTheObjectsOfTheCatalogue) {
  expect_the_same_tables<TicketCancellerKind>();
  expect_the_same_tables<DestinationText>();
  expect_the_same_tables<MainOnBoardComputerKind>();
}

/// The frames of 8.1.1, 9.2.4 and 9.2.5, as in bus_device_test.cpp.
TEST(BusBoard, AnEventIsSentAsItArises) {
  Cable cable;
  Device<BusBoard<TicketCancellerKind>> device(cable.port(0), 5, {});
  cable.connect(0, device.node());
  cable.start_all();
  EXPECT_EQ(cable.last(0x705), "705#00");
  cable.send("605#40 00 10 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x585), "585#43 00 10 00 97 01 00 04");
  cable.send("000#01 00");
  cable.send("605#23 02 60 01 01 00 00 04");
  EXPECT_EQ(cable.last(0x585), "585#60 02 60 01 00 00 00 00");
  EXPECT_EQ(cable.last(0x185), "185#01 00 00 00 01 00 00 04");
}

}  // namespace
}  // namespace canvoy::cia407::bus_board_test
