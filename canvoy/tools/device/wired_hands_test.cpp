// Hands of modules, lifts, charger and battery: their values, and the resulting frames.
#include "canvoy/tools/device/wired_hands.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/catalogue.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/device_wires.hpp"
#include "canvoy/tools/device/seat/seat_hands.hpp"

namespace canvoy::tools::wired_hands_test {
namespace {

/// A device of the catalogue alone on a cable, operational, with hands on it.
class Wired {
 public:
  explicit Wired(std::string_view name) : kind_(*find_device_kind(name)) {
    environment.floor = 2;
    hardware_.join(environment);
    wires_ = std::make_unique<DeviceWires>(name, hardware_, environment, output_);
    device_ = std::make_unique<CatalogueDevice>(kind_, cable.port(0), kind_.node_id(environment),
                                                environment);
    cable.connect(0, device_->node());
    cable.start_all();
    cable.send("000#01 00");
    pass(10ms);
    cable.clear();
  }
  Wired(const Wired&) = delete;
  Wired& operator=(const Wired&) = delete;

  void take(std::string_view order) { wires_->take(order); }
  /// Hands and plants are served every 10 ms, as on a real bus.
  void pass(Duration time) {
    for (const Time end = cable.now + time; cable.now < end;) {
      hardware_.step(cable.now);
      wires_->step(device_->node(), cable.now);
      cable.run_until(std::min(end, cable.now + 10ms));
    }
  }
  /// The answer to an SDO upload, without the CAN-ID.
  std::string read(unsigned index, unsigned sub) {
    return ask(fmt::format("40 {:02X} {:02X} {:02X} 00 00 00 00", index & 0xFFU, index >> 8U, sub));
  }
  std::string ask(std::string_view request) {
    const unsigned id = device_->node().id();
    cable.send(fmt::format("{:03X}#{}", 0x600 + id, request));
    const std::string answer = cable.last(0x580 + id);
    return answer.empty() ? answer : answer.substr(4);
  }
  /// Lets this time pass; returns the output of the device.
  std::string said_in(Duration time) {
    testing::internal::CaptureStdout();
    pass(time);
    return testing::internal::GetCapturedStdout();
  }

  Cable cable;
  Environment environment;

 private:
  Time now() { return cable.now; }

  const DeviceKind& kind_;
  DeviceOutput output_;
  DeviceHardware hardware_{DeviceOptions{}, callback<&Wired::now>(*this), output_};
  std::unique_ptr<DeviceWires> wires_;
  std::unique_ptr<CatalogueDevice> device_;
};

std::string complaint_about(std::string_view device, std::string_view order) {
  Environment environment;
  const std::vector<DeviceHand> hands = wired_hands(device, environment);
  const HandTable table = {device, hands};
  try {
    parse_hand_order({&table, 1}, order);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

// -- all of the catalogue

/// Values of a hand: each word, and both ends of its range.
std::vector<std::string> values_of(const DeviceHand& hand) {
  std::vector<std::string> values;
  for (const HandWord& word : hand.words) values.push_back("=" + word.word);
  if (hand.form == HandForm::number) {
    for (const double end : {hand.least, hand.most}) values.push_back(fmt::format("={}", end));
  }
  if (hand.form == HandForm::key) values.emplace_back();
  return values;
}

/// Devices that only use data of the bus, or are described by a foreign sheet, have none.
TEST(WiredHands, EachDeviceThatSensesSomethingHasHands) {
  for (const DeviceKind* kind : device_catalogue()) {
    if (kind->car_unit != nullptr || kind->bus_unit != nullptr) continue;
    const std::string_view name = kind->info.name;
    constexpr std::string_view of_bus_alone[] = {"lift-controller",
                                                 "lift-call-controller",
                                                 "lift-drive-controller",
                                                 "lift-door-controller",
                                                 "lift-group-member",
                                                 "lift-group-controller",
                                                 "lift-cams",
                                                 "lift-output-panel",
                                                 "operator"};
    const bool is_of_bus = std::ranges::find(of_bus_alone, name) != std::end(of_bus_alone);
    Environment environment;
    EXPECT_EQ(wired_hands(name, environment).empty(), is_of_bus) << name;
  }
}

TEST(WiredHands, EachValueOfEachHandIsTakenAndTheDeviceGoesOn) {
  unsigned tried = 0;
  for (const DeviceKind* kind : device_catalogue()) {
    Environment middle;
    middle.floor = 2;
    const std::vector<DeviceHand> hands = wired_hands(kind->info.name, middle);
    if (hands.empty() || kind->car_unit != nullptr || kind->bus_unit != nullptr) continue;
    Wired device(kind->info.name);
    for (const DeviceHand& hand : hands) {
      const std::string name = hand.name + (hand.count == 0 ? "" : std::to_string(hand.count));
      for (const std::string& value : values_of(hand)) {
        device.take(fmt::format("{}{}@0s", name, value));
        const std::string said = device.said_in(500ms);
        EXPECT_EQ(said.find("not here"), std::string::npos) << name << value;
        EXPECT_EQ(device.read(0x1000, 0).substr(0, 11), "43 00 10 00") << name << value;
        ++tried;
      }
    }
  }
  EXPECT_GT(tried, 100u);
}

TEST(WiredHands, WhatADeviceDoesNotHaveIsRefusedWithWhatItHas) {
  EXPECT_EQ(complaint_about("io-401", "input65=on@1s"),
            "'input65=on@1s': nothing here is 'input65'; did you mean 'input'?: there is input1 to "
            "input64, analogue-input1 to analogue-input12=");
  EXPECT_EQ(complaint_about("io-401", "input0=on@1s").substr(0, 43),
            "'input0=on@1s': nothing here is 'input0'; d");
  EXPECT_EQ(complaint_about("io-401", "input5=high@1s"), "'input=high': input takes off, on");
  EXPECT_EQ(complaint_about("io-401", "analogue-input2=32768@1s"),
            "'analogue-input=32768': analogue-input takes -32768 to 32767");
  EXPECT_EQ(complaint_about("lift-load", "load@1s"),
            "'load@1s': load takes 0 to 50000 kg: write load=50000@2s");
  EXPECT_EQ(complaint_about("lift-landing-panel", "down@1s"),
            "'down@1s': nothing here is 'down': there is up");
  EXPECT_EQ(complaint_about("lift-call-controller", "up@1s"),
            "'up@1s': lift-call-controller has no hands: all that it does follows from the bus");
}

// -- some of them, byte by byte

TEST(WiredHands, AnInputOfAModuleIsInItsFirstTpdo) {
  Wired module("io-401");
  module.take("input5=on@20ms");
  module.take("input64@100ms");
  module.pass(60ms);
  EXPECT_EQ(module.cable.last(0x1A1), "1A1#10 00 00 00 00 00 00 00");
  module.pass(100ms);
  EXPECT_EQ(module.cable.last(0x1A1), "1A1#10 00 00 00 00 00 00 80");
  module.pass(400ms);
  EXPECT_EQ(module.cable.last(0x1A1), "1A1#10 00 00 00 00 00 00 00") << "released after 300 ms";
  module.take("input5=0@0s");
  module.pass(30ms);
  EXPECT_EQ(module.read(0x6000, 1), "4F 00 60 01 00 00 00 00");
}

TEST(WiredHands, AnAnalogueInputIsWhatItWasSetTo) {
  Wired module("io-401");
  module.take("analogue-input2=-2@0s");
  module.take("analogue-input12=0x1234@0s");
  module.pass(30ms);
  EXPECT_EQ(module.read(0x6401, 2), "4B 01 64 02 FE FF 00 00");
  EXPECT_EQ(module.read(0x6401, 12), "4B 01 64 0C 34 12 00 00");
}

TEST(WiredHands, WhatAModuleDrivesIsSaid) {
  Wired module("io-401");
  const auto said_of = [&module](std::string_view frame) {
    testing::internal::CaptureStdout();
    module.cable.send(frame);
    return testing::internal::GetCapturedStdout();
  };
  EXPECT_EQ(said_of("221#04 00 00 00 00 00 00 00"), "io-401: output 3 on\n");
  EXPECT_EQ(said_of("321#00 00 FF 7F 00 00 00 00"), "io-401: analogue output 2: 32767\n");
  EXPECT_EQ(said_of("221#00 00 00 00 00 00 00 00"), "io-401: output 3 off\n");
}

/// Function 03h, lift 1, floor 2, position 0; only the signal bit of the data is set (CiA 417-4,
/// 4.13.1).
TEST(WiredHands, ASmokeSensorTellsItsSignalAndItsDefect) {
  Wired unit("lift-sensors");
  ASSERT_EQ(unit.ask("23 81 19 01 8E 03 00 00"), "60 81 19 01 00 00 00 00");
  unit.take("smoke=signal@0s");
  unit.pass(20ms);
  EXPECT_EQ(unit.cable.last(0x38E), "38E#03 01 02 80 FD FF");
  unit.take("smoke=defective@0s");
  unit.pass(20ms);
  EXPECT_EQ(unit.cable.last(0x38E), "38E#03 01 02 80 FE FF");
  // -5 in 14 bits, left-aligned.
  unit.take("temperature=-5@0s");
  unit.pass(20ms);
  EXPECT_EQ(unit.cable.last(0x38E), "38E#06 01 02 80 EC FF");
}

/// Bits 7 and 6; the others are 1 (CiA 417-4, 4.8.1).
TEST(WiredHands, ALightBarrierSeesWhoStandsThereAndFails) {
  Wired barrier("lift-light-barrier");
  EXPECT_EQ(barrier.read(0x6310, 1), "4F 10 63 01 3F 00 00 00");
  barrier.take("obstacle=yes@0s");
  barrier.pass(20ms);
  EXPECT_EQ(barrier.read(0x6310, 1), "4F 10 63 01 7F 00 00 00");
  barrier.take("beam=failure@0s");
  barrier.pass(20ms);
  EXPECT_EQ(barrier.read(0x6310, 1), "4F 10 63 01 BF 00 00 00");
}

/// Kilograms; FFFFh if the sensor does not work (CiA 417-4, 4.12.1).
TEST(WiredHands, AScaleWeighsWhoIsInTheCar) {
  Wired scale("lift-load");
  scale.take("load=300@0s");
  scale.pass(300ms);
  EXPECT_EQ(scale.read(0x6480, 1), "4B 80 64 01 2C 01 00 00");
  scale.take("rope-sensor=failure@0s");
  scale.pass(300ms);
  EXPECT_EQ(scale.read(0x6480, 1), "4B 80 64 01 FF FF 00 00");
}

/// Eighths of a degree Celsius; FFFFh is invalid (CiA 419, 7.2.3). Bit 0 is "ready" (CiA 419,
/// 7.2.1).
TEST(WiredHands, ABatterySaysWhatItsSensorShows) {
  Wired battery("battery");
  battery.take("temperature=-10@0s");
  battery.pass(200ms);
  EXPECT_EQ(battery.read(0x6010, 0), "4B 10 60 00 B0 FF 00 00");
  battery.take("temperature=failure@0s");
  battery.pass(200ms);
  EXPECT_EQ(battery.read(0x6010, 0), "4B 10 60 00 FF FF 00 00");
  battery.take("ready=no@0s");
  battery.pass(200ms);
  EXPECT_EQ(battery.read(0x6000, 0), "4F 00 60 00 00 00 00 00");
}

// -- a seat

TEST(SeatHands, AreThoseOfItsElements) {
  const std::vector<DeviceHand> hands =
      seat_hands({.joysticks = 1, .encoders = 2, .push_button_clusters = 1});
  const HandTable table = {"operator", hands};
  SeatState seat;
  const auto move = [&](std::string_view text) {
    const HandOrder order = parse_hand_order({&table, 1}, text);
    order.hand->act({.unit = &seat, .number = order.number}, order.value);
  };
  move("joystick1.x=-12000@0s");
  move("joystick1.b3@0s");
  move("joystick1.hold-y=1@0s");
  move("encoder2=0xFFFFFFFF@0s");
  move("push-button-cluster1.b13=pressed@0s");
  const cia852::OperatorHardware inputs = seat.inputs();
  EXPECT_EQ(inputs.joystick_axis(1, 1), -12000);
  EXPECT_EQ(inputs.joystick_buttons(1), 0b100);
  EXPECT_EQ(inputs.joystick_memory(1), 0b010);
  EXPECT_EQ(inputs.encoder(2), 0xFFFF'FFFF);
  EXPECT_EQ(inputs.push_buttons(1, 2), 0b1'0000);
  EXPECT_THROW(move("joystick2.x=1@0s"), UsageError);
  EXPECT_THROW(move("joystick1.x=40000@0s"), UsageError);
  EXPECT_THROW(move("wheel1=1@0s"), UsageError);
}

}  // namespace
}  // namespace canvoy::tools::wired_hands_test
