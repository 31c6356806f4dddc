// Devices of CiA 447 in memory that is known at compile time: they have the objects of those that
// are composed at run time, and answer alike at the wire.
#include "canvoy/devices/cia447/kit/car_board.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/devices/testing/board_tables.hpp"

namespace canvoy::cia447::car_board_test {
namespace {

/// Shapes, defaults, limits and texts, in the order of the tables.
template <class Kind>
void expect_the_same_tables() {
  const PartTables composed(car_parts(only_unit<Kind>));
  expect_same_tables(DeviceNode<car_layout<Kind>>::tables, composed.tables());
}

TEST(CarBoard, HasTheObjectsOfTheCatalogue) {
  expect_the_same_tables<BlueLightKind>();
  expect_the_same_tables<TariffDisplayKind>();
  expect_the_same_tables<IvnGatewayKind>();
}

/// Power stages of flashers, as a maker has them.
struct Stages {
  bool drive(const Commanded& /*commanded*/) {
    ++commands;
    return false;  // as the table has it
  }
  void became(const FieldPlace& /*status*/, std::uint32_t code) { last = code; }

  int commands = 0;
  std::uint32_t last = 0;
};

/// The frames of blue_light_unit_test.cpp (CiA 447-3, 4.2.22), and a refused code (4.2).
TEST(CarBoard, AnswersAsTheDeviceOfTheCatalogue) {
  Cable cable;
  Stages stages;
  CarBoard<BlueLightKind> device(cable.port(0), 5, stages);
  cable.connect(0, device.node());
  cable.start_all();
  EXPECT_EQ(cable.last(0x705), "705#00");
  cable.send("000#01 00");
  cable.send("605#23 40 61 00 F1 FF FF FF");
  EXPECT_EQ(cable.last(0x585), "585#60 40 61 00 00 00 00 00");
  EXPECT_EQ(stages.commands, 2);
  cable.run_for(50ms);
  EXPECT_EQ(stages.last, 1u);
  cable.send("605#40 41 61 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x585), "585#43 41 61 00 01 00 F0 FF");
  cable.send("605#23 40 61 00 FE FF FF FF");
  EXPECT_EQ(cable.last(0x585), "585#80 40 61 00 30 00 09 06");
  EXPECT_EQ(device.master(), nullptr);
}

TEST(CarBoard, AGatewayIsTheMaster) {
  Cable cable;
  CarBoard<IvnGatewayKind> gateway(cable.port(0), gateway_node_id, CarHardware{});
  EXPECT_NE(gateway.master(), nullptr);
}

}  // namespace
}  // namespace canvoy::cia447::car_board_test
