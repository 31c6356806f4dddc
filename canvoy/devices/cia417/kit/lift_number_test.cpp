// The lift number of devices of one lift, changed on the bus: objects and PDOs go to the new lift
// (CiA 417-4, 4.1.1 and 4.2.2; numbers and CAN-IDs of the PDOs from public sources).
#include "canvoy/devices/cia417/kit/lift_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/door/car_door_test.hpp"
#include "canvoy/devices/cia417/drive/car_drive_controller_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_test.hpp"
#include "canvoy/devices/cia417/load/load_measuring_device.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_device.hpp"

namespace canvoy::cia417::lift_number_test {
namespace {

constexpr LiftDeviceOptions lift_3 = {.lift = 3};

/// Node 13 weighs, laid out for the lift of `options`; node 6 is a door.
template <LiftDeviceOptions options>
struct Bench {
  Bench() {
    cable.connect(0, load.node());
    cable.connect(1, door.node());
    cable.start_all();
    cable.send("000#01 00");
    cable.clear();
  }
  std::optional<double> weigh(unsigned) { return kilograms; }
  void weigh_down(double wanted) {
    kilograms = wanted;
    cable.run_for(100ms);
  }
  std::string ask(unsigned node, std::string_view request) {
    char id[8];
    std::snprintf(id, sizeof id, "%03X#", 0x600 + node);
    cable.send(std::string(id) + std::string(request));
    return cable.last(0x580 + node).substr(4);
  }
  /// True if the load unit has the object, read by SDO.
  bool has(unsigned index, unsigned sub = 0) {
    char request[40];
    std::snprintf(request, sizeof request, "40 %02X %02X %02X 00 00 00 00", index & 0xFF,
                  index >> 8, sub);
    const std::string answer = ask(13, request);
    if (answer.substr(0, 2) == "80") {
      EXPECT_EQ(answer.substr(12), "00 00 02 06") << index;
      return false;
    }
    return true;
  }
  std::string write_lift(unsigned node, unsigned lift) {
    char request[40];
    std::snprintf(request, sizeof request, "2F 01 60 00 %02X 00 00 00", 1U << (lift - 1));
    return ask(node, request);
  }

  double kilograms = 0;
  Cable cable;
  LoadMeasuringDevice<options> load{
      cable.port(0), 13, {.rope_load = callback<&Bench::weigh>(*this)}};
  DoorBench plant;
  CarDoorDevice<> door{cable.port(1), 6, {plant.hardware()}};
};
using FromLift1 = Bench<LiftDeviceOptions{}>;
using FromLift3 = Bench<lift_3>;

constexpr const char* written = "60 01 60 00 00 00 00 00";

TEST(LiftNumberOnTheBus, ObjectsStand0800hHigherForEachLift) {
  FromLift1 bench;
  for (unsigned lift = 1; lift <= 8; ++lift) {
    ASSERT_EQ(bench.write_lift(13, lift), written);
    for (unsigned other = 1; other <= 8; ++other) {
      const unsigned block = (other - 1) * 0x800;
      for (unsigned index = 0x6480; index <= 0x6485; ++index) {
        EXPECT_EQ(bench.has(index + block), other == lift) << std::hex << index + block;
      }
      EXPECT_EQ(bench.has(0x6001 + block), other == 1) << "6001h stays";
    }
  }
}

TEST(LiftNumberOnTheBus, NothingElseIsFoundFrom6000hTo9FFFh) {
  FromLift1 bench;
  bench.write_lift(13, 8);
  unsigned found = 0;
  for (unsigned index = 0x6000; index <= 0x9FFF; ++index) found += bench.has(index) ? 1U : 0U;
  EXPECT_EQ(found, 7u) << "6001h, 9C80h to 9C85h";
}

TEST(LiftNumberOnTheBus, ParametersOfPredefinedPdosStand10hHigherForEachLift) {
  FromLift1 bench;
  bench.write_lift(13, 2);
  EXPECT_FALSE(bench.has(0x1902));
  EXPECT_FALSE(bench.has(0x1B02));
  EXPECT_EQ(bench.ask(13, "40 12 19 01 00 00 00 00"), "43 12 19 01 98 01 00 00") << "198h";
  EXPECT_EQ(bench.ask(13, "40 12 1B 01 00 00 00 00"), "43 12 1B 01 08 01 82 6C") << "6C82h";
  EXPECT_EQ(bench.ask(13, "40 12 1B 00 00 00 00 00"), "4F 12 1B 00 01 00 00 00");
}

TEST(LiftNumberOnTheBus, ATpdoIsSentForTheNewLiftAtOnce) {
  FromLift1 bench;
  bench.write_lift(13, 5);
  EXPECT_EQ(bench.cable.last(0x1C8), "1C8#01") << "it begins anew: zero load";
  bench.cable.clear();
  bench.weigh_down(400);
  EXPECT_EQ(bench.cable.last(0x1C8), "1C8#02");
  EXPECT_EQ(bench.cable.count(0x188), 0u);
}

TEST(LiftNumberOnTheBus, AnRpdoIsReceivedForTheNewLiftAtOnce) {
  FromLift1 bench;
  bench.write_lift(6, 3);
  bench.cable.run_for(1s);
  bench.cable.send("200#FF 4F FF FF FF FF FF FF");
  bench.cable.run_for(4s);
  EXPECT_DOUBLE_EQ(bench.plant.position_mm, 0) << "that was for the door of lift 1";
  bench.cable.send("220#FF 4F FF FF FF FF FF FF");
  bench.cable.run_for(4s);
  EXPECT_DOUBLE_EQ(bench.plant.position_mm, 900);
  EXPECT_EQ(bench.cable.last(0x221).substr(10), "84 03") << "900 mm, told for lift 3";
  EXPECT_EQ(bench.ask(6, "40 01 73 01 00 00 00 00").substr(0, 2), "4B");
}

TEST(LiftNumberOnTheBus, WhatAnObjectDoesItDoesInItsNewPlace) {
  FromLift1 bench;
  bench.write_lift(13, 4);
  bench.weigh_down(450);
  EXPECT_EQ(bench.ask(13, "40 80 7C 01 00 00 00 00"), "4B 80 7C 01 C2 01 00 00") << "450 kg";
  EXPECT_EQ(bench.ask(13, "2B 83 7C 04 C2 01 00 00"), "60 83 7C 04 00 00 00 00");
  EXPECT_EQ(bench.cable.last(0x1B8), "1B8#0A") << "overload from 450 kg on";
  EXPECT_EQ(bench.ask(13, "2B 80 7C 01 00 00 00 00"), "80 80 7C 01 02 00 01 06") << "ro";
  EXPECT_EQ(bench.ask(13, "40 80 7C 03 00 00 00 00"), "80 80 7C 03 11 00 09 06");
}

TEST(LiftNumberOnTheBus, MappingParametersNameObjectsWhereTheyAreNow) {
  FromLift1 bench;
  bench.write_lift(13, 2);
  bench.ask(13, "23 12 19 01 98 01 00 80");
  bench.ask(13, "2F 12 1B 00 00 00 00 00");
  EXPECT_EQ(bench.ask(13, "23 12 1B 01 10 01 80 64"), "80 12 1B 01 00 00 02 06");
  EXPECT_EQ(bench.ask(13, "23 12 1B 01 10 01 80 6C"), "60 12 1B 01 00 00 00 00");
  EXPECT_EQ(bench.ask(13, "2F 12 1B 00 01 00 00 00"), "60 12 1B 00 00 00 00 00");
  bench.ask(13, "23 12 19 01 98 01 00 00");
  bench.cable.clear();
  bench.weigh_down(260);
  EXPECT_EQ(bench.cable.last(0x198), "198#04 01");
  bench.write_lift(13, 3);
  bench.weigh_down(261);
  EXPECT_EQ(bench.cable.last(0x1A8), "1A8#05 01") << "the mapping went with it";
  EXPECT_EQ(bench.ask(13, "40 22 1B 01 00 00 00 00"), "43 22 1B 01 10 01 80 74");
}

TEST(LiftNumberOnTheBus, ACobIdThatSomebodyChoseStays) {
  FromLift1 bench;
  bench.ask(13, "23 02 19 01 88 01 00 80");
  bench.ask(13, "23 02 19 01 C0 01 00 00");
  bench.write_lift(13, 2);
  EXPECT_EQ(bench.ask(13, "40 12 19 01 00 00 00 00"), "43 12 19 01 C0 01 00 00");
  bench.weigh_down(400);
  EXPECT_EQ(bench.cable.last(0x1C0), "1C0#02");
}

TEST(LiftNumberOnTheBus, APdoThatIsOffStaysOff) {
  FromLift1 bench;
  bench.ask(13, "23 02 19 01 88 01 00 80");
  bench.cable.clear();
  bench.write_lift(13, 2);
  bench.weigh_down(400);
  EXPECT_EQ(bench.cable.count(0x198), 0u);
  EXPECT_EQ(bench.ask(13, "40 12 19 01 00 00 00 00"), "43 12 19 01 98 01 00 80");
}

TEST(LiftNumberOnTheBus, ItGoesBack) {
  FromLift1 bench;
  for (const unsigned lift : {8U, 1U}) EXPECT_EQ(bench.write_lift(13, lift), written);
  EXPECT_TRUE(bench.has(0x6482, 1));
  EXPECT_EQ(bench.ask(13, "40 02 19 01 00 00 00 00"), "43 02 19 01 88 01 00 00");
  bench.weigh_down(400);
  EXPECT_EQ(bench.cable.last(0x188), "188#02");
}

TEST(LiftNumberOnTheBus, ADeviceOfAnyLiftGoesToAnyOther) {
  FromLift3 bench;
  EXPECT_TRUE(bench.has(0x7480));
  EXPECT_EQ(bench.write_lift(13, 1), written);
  EXPECT_TRUE(bench.has(0x6480));
  EXPECT_FALSE(bench.has(0x7480));
  bench.weigh_down(400);
  EXPECT_EQ(bench.cable.last(0x188), "188#02");
}

TEST(LiftNumberOnTheBus, AResetOfCommunicationKeepsTheLift) {
  FromLift1 bench;
  bench.write_lift(13, 2);
  bench.cable.send("000#82 0D");
  bench.cable.send("000#01 0D");
  EXPECT_EQ(bench.ask(13, "40 12 1B 01 00 00 00 00"), "43 12 1B 01 08 01 82 6C");
  bench.cable.clear();
  bench.weigh_down(400);
  EXPECT_EQ(bench.cable.last(0x198), "198#02");
  EXPECT_EQ(bench.cable.count(0x188), 0u);
}

TEST(LiftNumberOnTheBus, AResetOfTheNodeRestoresTheDefaultLiftWhereNothingIsStored) {
  FromLift1 bench;
  bench.write_lift(13, 2);
  bench.cable.send("000#81 0D");
  bench.cable.send("000#01 0D");
  EXPECT_EQ(bench.ask(13, "40 01 60 00 00 00 00 00"), "4F 01 60 00 01 00 00 00");
  EXPECT_TRUE(bench.has(0x6480));
  bench.cable.clear();
  bench.weigh_down(400);
  EXPECT_EQ(bench.cable.last(0x188), "188#02");
}

TEST(LiftNumberOnTheBus, SeveralLiftsAreRefusedAndNothingMoves) {
  FromLift1 bench;
  for (unsigned lifts = 0; lifts <= 0xFF; ++lifts) {
    if (std::has_single_bit(lifts)) continue;
    char request[40];
    std::snprintf(request, sizeof request, "2F 01 60 00 %02X 00 00 00", lifts);
    EXPECT_EQ(bench.ask(13, request),
              lifts == 0 ? "80 01 60 00 32 00 09 06" : "80 01 60 00 30 00 09 06");
  }
  EXPECT_TRUE(bench.has(0x6480));
  EXPECT_EQ(bench.cable.count(0x188), 0u);
}

// Controllers

TEST(LiftNumberOnTheBus, ACallControllerServesThePanelsOfItsNewLift) {
  Cable cable;
  CallControllerDevice<> device(cable.port(0), 1, {.served = {FloorSet::between(1, 20)}});
  cable.connect(0, device.node());
  cable.start_all();
  cable.send("000#01 01");
  cable.send("495#02 01 01 03 10 01");
  cable.run_for(10ms);
  ASSERT_EQ(cable.last(0x400), "400#02 01 01 03 10 81");
  cable.clear();
  cable.send("601#2F 01 60 00 04 00 00 00");
  EXPECT_EQ(cable.last(0x581), "581#60 01 60 00 00 00 00 00");
  cable.run_for(10ms);
  const auto tells_lamp = [](const Cable::Heard& heard) {
    return wire_text(heard.frame) == "400#02 01 04 03 10 81";
  };
  EXPECT_TRUE(std::ranges::any_of(cable.heard, tells_lamp)) << "what is lit there";
  cable.clear();
  cable.send("495#02 02 04 05 10 01");
  cable.run_for(10ms);
  EXPECT_EQ(cable.last(0x400), "400#02 02 04 05 10 81");
  cable.clear();
  cable.send("495#02 02 01 06 10 01");
  cable.run_for(10ms);
  EXPECT_EQ(cable.count(0x400), 0u) << "lift 1 is another one";
  cable.send("601#2F 01 60 00 06 00 00 00");
  EXPECT_EQ(cable.last(0x581), "581#80 01 60 00 30 00 09 06");
  cable.send("000#81 01");
  cable.send("000#01 01");
  cable.clear();
  cable.send("495#02 02 01 06 10 01");
  cable.run_for(10ms);
  EXPECT_EQ(cable.last(0x400), "400#02 02 01 06 10 81");
}

TEST(LiftNumberOnTheBus, ADriveControllerCommandsTheDriveOfItsNewLift) {
  DriveBench bench;
  CarDriveControllerDevice<> device(bench.port(), 1);
  bench.boot(device.node());
  bench.send("601#2F 01 60 00 02 00 00 00");
  bench.send("19C#00 00 00 00");
  bench.send("195#50 02 00 00 00 00");
  device.node().advance(bench.now);
  device.unit().controller().run(300'000);
  bench.settle();
  EXPECT_TRUE(bench.has_sent("194#06 00 00 00 00 00"));
  bench.send("191#31 02 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("602#2F 03 6C 00 03 00 00 00")) << "6C03h of its drive";
}

TEST(LiftNumberOnTheBus, ADriveObeysTheControllerOfItsNewLift) {
  DriveBench bench;
  CarDriveDevice<> device(bench.port(), 2, bench.hardware());
  bench.boot(device.node());
  EXPECT_EQ(bench.ask("2F 01 60 00 02 00 00 00"), 0u);
  bench.send("180#06 00 00 00 00 00");
  EXPECT_EQ(bench.ask("40 01 6C 00 00 00 00 00"), 0x0250u) << "not for this drive";
  bench.send("190#06 00 00 00 00 00");
  EXPECT_TRUE(bench.has_sent("191#31 02 00 00 00 00"));
  EXPECT_EQ(bench.ask("40 01 64 00 00 00 00 00"), 0x0602'0000u);
  EXPECT_EQ(bench.ask("23 23 6C 00 00 00 00 00"), 0x0609'0032u);
}

TEST(LiftNumberOnTheBus, ADriveWithPowerStaysWhereItIs) {
  DriveBench bench;
  CarDriveDevice<> device(bench.port(), 2, bench.hardware());
  bench.boot(device.node());
  for (const char* word : {"180#06 00 00 00 00 00", "180#0F 00 00 00 00 00"}) bench.send(word);
  EXPECT_EQ(bench.ask("2F 01 60 00 02 00 00 00"), 0x0800'0022u) << "no configuration now";
  EXPECT_EQ(bench.ask("40 01 64 00 00 00 00 00"), 0x0237u);
  bench.send("180#00 00 00 00 00 00");
  EXPECT_EQ(bench.ask("2F 01 60 00 02 00 00 00"), 0u);
}

TEST(LiftNumberOnTheBus, LightBarrier4OfLift8HasNoPdoParameters) {
  // 1981h is that of virtual sensors of node 1.
  static constexpr LiftDeviceOptions fourth = {.doors = 0b1000};
  Cable cable;
  LightBarrierDevice<fourth> device(
      cable.port(0), 9, {.sense = {[](void*, unsigned) { return Detection::no; }, nullptr}});
  cable.connect(0, device.node());
  cable.start_all();
  cable.send("609#2F 01 60 00 40 00 00 00");
  cable.send("609#40 71 19 01 00 00 00 00");
  EXPECT_EQ(cable.last(0x589), "589#43 71 19 01 68 02 00 00") << "of lift 7";
  cable.send("609#2F 01 60 00 80 00 00 00");
  cable.send("609#40 81 19 01 00 00 00 00");
  EXPECT_EQ(cable.last(0x589), "589#80 81 19 01 00 00 02 06");
}

}  // namespace
}  // namespace canvoy::cia417::lift_number_test
