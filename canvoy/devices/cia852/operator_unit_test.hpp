// Common parts of tests of operator environments: a seat that the test operates and observes, and
// node 5 with elements selected at run time, on its wire.
//
//     OperatorBench bench({.joysticks = 1});
//     bench.seat.axes[{1, 1}] = 100;
//     bench.change();
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/devices/cia852/operator_unit.hpp"
#include "canvoy/devices/testing/operator_cabin.hpp"

namespace canvoy::cia852 {

/// The operator's side: inputs and indications.
struct OperatorSeatHands {
  std::map<std::pair<unsigned, unsigned>, std::int16_t> axes;
  std::map<unsigned, std::uint8_t> buttons;
  std::map<unsigned, std::uint8_t> memory;
  std::map<unsigned, std::int16_t> pedals;
  std::map<unsigned, bool> pedal_memory;
  std::map<unsigned, std::uint32_t> encoders;
  std::map<unsigned, std::int16_t> wheels;
  std::map<std::pair<unsigned, unsigned>, std::uint8_t> push_buttons;
  std::map<std::pair<unsigned, unsigned>, std::uint8_t> lit;
  std::map<std::pair<unsigned, unsigned>, std::int16_t> shown;

  std::int16_t axis(unsigned joystick, unsigned of) { return axes[{joystick, of}]; }
  std::uint8_t joystick_buttons(unsigned joystick) { return buttons[joystick]; }
  std::uint8_t joystick_memory(unsigned joystick) { return memory[joystick]; }
  std::int16_t pedal(unsigned number) { return pedals[number]; }
  bool has_pedal_memory(unsigned number) { return pedal_memory[number]; }
  std::uint32_t encoder(unsigned number) { return encoders[number]; }
  std::int16_t wheel(unsigned number) { return wheels[number]; }
  std::uint8_t pressed(unsigned cluster, unsigned group) { return push_buttons[{cluster, group}]; }
  void light(unsigned cluster, unsigned group, std::uint8_t on) { lit[{cluster, group}] = on; }
  void show(unsigned display, unsigned parameter, std::int16_t value) {
    shown[{display, parameter}] = value;
  }
  OperatorHardware hardware() {
    return {.joystick_axis = callback<&OperatorSeatHands::axis>(*this),
            .joystick_buttons = callback<&OperatorSeatHands::joystick_buttons>(*this),
            .joystick_memory = callback<&OperatorSeatHands::joystick_memory>(*this),
            .foot_pedal = callback<&OperatorSeatHands::pedal>(*this),
            .foot_pedal_memory = callback<&OperatorSeatHands::has_pedal_memory>(*this),
            .encoder = callback<&OperatorSeatHands::encoder>(*this),
            .wheel = callback<&OperatorSeatHands::wheel>(*this),
            .push_buttons = callback<&OperatorSeatHands::pressed>(*this),
            .show_indicators = callback<&OperatorSeatHands::light>(*this),
            .show_parameter = callback<&OperatorSeatHands::show>(*this)};
  }
};

inline constexpr std::uint32_t emergency = 0x085;

/// Node 5, operational, with elements selected at run time.
class OperatorBench {
 public:
  explicit OperatorBench(const OperatorEnvironment& has) : elements_(has), device(made()) {
    cable.connect(0, device->node());
    cable.start_all();
    operational();
  }

  void operational() {
    cable.send("000#01 05");
    cable.run_for(5ms);
    cable.clear();
  }
  void change() {
    unit->hardware_changed();
    cable.run_for(0s);
  }
  /// The answer of the SDO server, from the command on.
  std::string ask(std::string_view request) {
    cable.send("605#" + std::string(request));
    return cable.last(0x585).substr(4);
  }
  void write(std::string_view request) { ASSERT_EQ(ask(request).substr(0, 2), "60") << request; }
  /// Sets the CAN-ID of a PDO, by its COB-ID object.
  void enable_tpdo_1() { write("23 00 18 01 85 01 00 00"); }
  void enable_analogue() { write("2F 23 64 00 01 00 00 00"); }

  OperatorSeatHands seat;
  Cable cable;
  OperatorUnit* unit = nullptr;

 private:
  OperatorEnvironment elements() { return elements_; }
  OperatorHardware hardware() { return seat.hardware(); }
  OperatorSettings settings() { return {.sensing_period = Duration::zero()}; }
  std::unique_ptr<CatalogueDevice> made() {
    environment_.provide(callback<&OperatorBench::elements>(*this));
    environment_.provide(callback<&OperatorBench::hardware>(*this));
    environment_.provide(callback<&OperatorBench::settings>(*this));
    environment_.watch(unit);
    return std::make_unique<CatalogueDevice>(operator_kind, cable.port(0), NodeId{5}, environment_);
  }

  OperatorEnvironment elements_;
  Environment environment_;

 public:
  std::unique_ptr<CatalogueDevice> device;
};

struct OperatorEverything : testing::Test, OperatorBench {
  OperatorEverything() : OperatorBench(OperatorCabin::everything) {}
};
struct OperatorSeat : testing::Test, OperatorBench {
  OperatorSeat()
      : OperatorBench({.joysticks = 2,
                       .foot_pedals = 1,
                       .wheels = 1,
                       .push_button_clusters = 1,
                       .indicator_clusters = 1,
                       .displays = 1,
                       .display_parameters = 6,
                       .configuration = true}) {}
};
struct OperatorRemote : testing::Test, OperatorBench {
  OperatorRemote() : OperatorBench({.push_button_clusters = 1}) {}
};

}  // namespace canvoy::cia852
