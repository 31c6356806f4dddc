// An operator environment at the wire: frames typed from the tables of CiA 852, clause 9 and 12,
// with errata 16 to 31, and from CiA 301.
#include <gtest/gtest.h>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/profiles/cia852/handles.hpp"
#include "canvoy/profiles/cia852/operator_environment.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::wire_test {
namespace {

using cia852::Switch;

constexpr cia852::OperatorEnvironment elements = {.joysticks = 1,
                                                  .foot_pedals = 2,
                                                  .encoders = 2,
                                                  .wheels = 2,
                                                  .push_button_clusters = 1,
                                                  .indicator_clusters = 1,
                                                  .displays = 1};
constexpr auto seat = describe(cia852::operator_environment<elements>(),
                               cia301::identity({.vendor_id = 1}), cia301::heartbeat_producer(0));
constexpr auto seat_layout = lay_out_device<seat>();

/// A seat, node 10; the master has made one of its PDOs valid.
class OperatorEnvironmentWire : public testing::Test {
 protected:
  OperatorEnvironmentWire() {
    cable_.connect(0, device_.node());
    cable_.start_all();
  }
  /// `sub` 01h of a communication parameter record.
  void make_valid(const char* request, const char* answer) {
    cable_.send(request);
    EXPECT_EQ(cable_.last(0x58A), answer);
  }
  void start() { cable_.send("000#01 0A"); }
  Values values() { return Values(device_.node().dictionary()); }
  /// Runs until the node has done its work.
  void settle() { cable_.run_for(1ms); }

  Cable cable_;
  DeviceNode<seat_layout> device_{cable_.port(0), 10};
};

TEST_F(OperatorEnvironmentWire, SaysWhatItHasIn1000h) {
  // Table 8: specific functionality FFh, M, analogue output and input, digital output and input.
  cable_.send("60A#40 00 10 00 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#43 00 10 00 91 01 8F FF");
}

TEST_F(OperatorEnvironmentWire, SendsNoPdoBeforeItsCobIdIsValid) {
  cable_.send("60A#40 00 18 01 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#43 00 18 01 8A 01 00 80") << "8000 0180h + node-ID";
  start();
  values()[cia852::joystick_x(1)] = 1;
  settle();
  EXPECT_EQ(cable_.last(0x18A), "");
}

TEST_F(OperatorEnvironmentWire, Tpdo1IsTheFirstJoystick) {
  make_valid("60A#23 00 18 01 8A 01 00 00", "58A#60 00 18 01 00 00 00 00");
  start();
  EXPECT_EQ(cable_.last(0x18A), "18A#00 00 00 00 00 00 00 00");
  values()[cia852::joystick_x(1)] = 1000;    // 03E8h
  values()[cia852::joystick_y(1)] = -12000;  // D120h
  values()[cia852::joystick_z(1)] = 0x1234;
  values()[cia852::joystick_memory_y(1)] = Switch::on;
  values()[cia852::joystick_button<8>(1)] = Switch::on;
  settle();
  EXPECT_EQ(cable_.last(0x18A), "18A#E8 03 20 D1 34 12 02 80");
}

TEST_F(OperatorEnvironmentWire, Tpdo20IsTheFirstTwoFootPedals) {
  make_valid("60A#23 13 18 01 11 02 00 00", "58A#60 13 18 01 00 00 00 00");
  start();
  values()[cia852::foot_pedal_position(1)] = 0x0102;
  values()[cia852::foot_pedal_memory(2)] = Switch::on;
  values()[cia852::foot_pedal_position(2)] = -1;
  settle();
  EXPECT_EQ(cable_.last(0x211), "211#00 02 01 01 FF FF") << "memory, position, memory, position";
}

TEST_F(OperatorEnvironmentWire, Tpdo28IsTheFirstTwoEncoders) {
  make_valid("60A#23 1B 18 01 12 02 00 00", "58A#60 1B 18 01 00 00 00 00");
  start();
  values()[cia852::encoder_position(1)] = 0x12345678;
  values()[cia852::encoder_position(2)] = 7;
  settle();
  EXPECT_EQ(cable_.last(0x212), "212#78 56 34 12 07 00 00 00");
}

TEST_F(OperatorEnvironmentWire, Tpdo32IsTheWheelsAsFarAsThereAreSome) {
  make_valid("60A#23 1F 18 01 13 02 00 00", "58A#60 1F 18 01 00 00 00 00");
  start();
  values()[cia852::wheel_position(1)] = 0x1122;
  values()[cia852::wheel_position(2)] = 0x3344;
  settle();
  EXPECT_EQ(cable_.last(0x213), "213#22 11 44 33");
}

TEST_F(OperatorEnvironmentWire, Tpdo34IsTheFirstClusterOfPushButtons) {
  make_valid("60A#23 21 18 01 14 02 00 00", "58A#60 21 18 01 00 00 00 00");
  start();
  values()[cia852::push_button<1>(1)] = Switch::on;
  values()[cia852::push_button<64>(1)] = Switch::on;
  settle();
  EXPECT_EQ(cable_.last(0x214), "214#01 00 00 00 00 00 00 80");
}

TEST_F(OperatorEnvironmentWire, Rpdo1IsTheFirstClusterOfIndicators) {
  make_valid("60A#23 00 14 01 15 02 00 00", "58A#60 00 14 01 00 00 00 00");
  start();
  cable_.send("215#01 00 00 00 00 00 00 80");
  EXPECT_TRUE(values()[cia852::indicator<1>(1)].is(Switch::on));
  EXPECT_TRUE(values()[cia852::indicator<2>(1)].is(Switch::off));
  EXPECT_TRUE(values()[cia852::indicator<64>(1)].is(Switch::on));
}

TEST_F(OperatorEnvironmentWire, Rpdos2And4And12AreTheFirstDisplay) {
  make_valid("60A#23 01 14 01 16 02 00 00", "58A#60 01 14 01 00 00 00 00");
  make_valid("60A#23 03 14 01 17 02 00 00", "58A#60 03 14 01 00 00 00 00");
  make_valid("60A#23 0B 14 01 18 02 00 00", "58A#60 0B 14 01 00 00 00 00");
  start();
  cable_.send("216#01 00 02 00 03 00 04 00");
  cable_.send("217#05 00 06 00 07 00 08 00");
  cable_.send("218#09 00 0A 00 0B 00 FF FF");
  // 6411h, sub-indices 01h, 08h and 0Ch: Integer16.
  cable_.send("60A#40 11 64 01 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#4B 11 64 01 01 00 00 00");
  cable_.send("60A#40 11 64 08 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#4B 11 64 08 08 00 00 00");
  cable_.send("60A#40 11 64 0C 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#4B 11 64 0C FF FF 00 00");
}

TEST_F(OperatorEnvironmentWire, AnRpdoThatIsTooShortIsToldAndNotTaken) {
  make_valid("60A#23 00 14 01 15 02 00 00", "58A#60 00 14 01 00 00 00 00");
  start();
  cable_.send("215#01 00 00 00");
  EXPECT_TRUE(values()[cia852::indicator<1>(1)].is(Switch::off));
  EXPECT_EQ(cable_.last(0x08A).substr(0, 12), "08A#10 82 11") << "8210h, communication error";
}

TEST_F(OperatorEnvironmentWire, InputsAreReadOnlyAndElementsThatAreNotThereAreNoEntries) {
  cable_.send("60A#2B 01 64 01 E8 03 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#80 01 64 01 02 00 01 06");
  cable_.send("60A#40 01 64 04 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#80 01 64 04 11 00 09 06") << "joystick 2";
  cable_.send("60A#40 01 64 00 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#4F 01 64 00 42 00 00 00") << "the second wheel is the last";
}

TEST_F(OperatorEnvironmentWire, IndicatorsAndDisplaysSayWhatAnErrorDoes) {
  // 6206h 01h, 6207h 00h, 6443h 01h, 6444h 0 by default (9.7, 9.8).
  cable_.send("60A#40 06 62 01 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#4F 06 62 01 01 00 00 00");
  cable_.send("60A#40 07 62 01 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#4F 07 62 01 00 00 00 00");
  cable_.send("60A#40 43 64 01 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#4F 43 64 01 01 00 00 00");
  cable_.send("60A#40 44 64 01 00 00 00 00");
  EXPECT_EQ(cable_.last(0x58A), "58A#43 44 64 01 00 00 00 00");
}

}  // namespace
}  // namespace canvoy::wire_test
