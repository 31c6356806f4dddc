// A bench with the hardware of every device of the catalogue, and a person who operates it and
// looks at it: for tests of device behaviour.
//
//     Workshop workshop;
//     CheckedDevice device(*find_device_kind("lift-door"), workshop.environment);
//     Check check(device.line(), device.node(), {.moves = true, .hand = workshop.hands.answer()});
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/devices/cia401/io_unit.hpp"
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"
#include "canvoy/devices/cia417/door/car_door_test.hpp"
#include "canvoy/devices/cia417/drive/car_drive_test.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_unit.hpp"
#include "canvoy/devices/cia419/charger_hardware.hpp"
#include "canvoy/devices/cia447/hands_free/hands_free_unit.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"
#include "canvoy/devices/cia852/operator_unit_test.hpp"
#include "canvoy/text/check/testing/hands.hpp"
#include "canvoy/text/check/testing/transport_hands.hpp"

namespace canvoy::conformance {

/// Contacts, valves and a voltage of a module of CiA 401.
struct BoardOnBench {
  std::uint8_t contacts = 0;
  std::uint8_t valves = 0;
  std::int32_t volts = 0;

  std::uint8_t contact(unsigned group) { return group == 1 ? contacts : std::uint8_t{0}; }
  void valve(unsigned group, std::uint8_t on) {
    if (group == 1) valves = on;
  }
  std::int32_t volt(unsigned channel) { return channel == 1 ? volts : 0; }
  void drive(unsigned /*channel*/, std::int32_t /*value*/) {}
  cia401::IoHardware hardware() {
    using Self = BoardOnBench;
    return {.digital_inputs = Callback<std::uint8_t(unsigned)>::to<&Self::contact>(*this),
            .drive_digital = Callback<void(unsigned, std::uint8_t)>::to<&Self::valve>(*this),
            .analogue_input = Callback<std::int32_t(unsigned)>::to<&Self::volt>(*this),
            .drive_analogue = Callback<void(unsigned, std::int32_t)>::to<&Self::drive>(*this)};
  }
};

/// A power stage of a charger that delivers the requested power, and its pilot contact.
struct PowerStageOnBench {
  double ampere = 0;
  bool is_plugged = false;

  void deliver(double now) { ampere = now; }
  double current() { return ampere; }
  bool pilot_signal() { return is_plugged; }
  cia419::ChargerHardware hardware() { return cia419::hardware_of(*this); }
};

/// Content of a display of a bus.
struct DisplayOnBench {
  std::vector<std::string> texts;
  bool is_stop_wanted = false;

  void show(std::span<const cia407::ShownElement> elements) {
    texts.clear();
    for (const cia407::ShownElement& each : elements) {
      texts.emplace_back(each.octets.begin(), each.octets.end());
    }
  }
  void stop(bool is_wanted) { is_stop_wanted = is_wanted; }
  cia407::DisplayHardware hardware() {
    using Self = DisplayOnBench;
    return {.show = Callback<void(std::span<const cia407::ShownElement>)>::to<&Self::show>(*this),
            .show_stop_request = Callback<void(bool)>::to<&Self::stop>(*this)};
  }
};

struct Workshop {
  Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  Environment environment;
  Hands hands;
  cia852::OperatorSeatHands seat;
  BoardOnBench board;
  PowerStageOnBench stage;
  DisplayOnBench display;
  cia417::DoorBench door;
  cia417::DriveBench drive;
  cia417::Detection beam = cia417::Detection::no;
  bool is_led_lit = false;
  cia447::HandsFreeUnit* hands_free = nullptr;
  cia447::TaxiAlarmUnit* alarm = nullptr;
  std::optional<TransportHands> transport;

 private:
  void provide_all();
  void learn_to_move();
  void learn_to_see();

  cia852::OperatorHardware seat_hardware() { return seat.hardware(); }
  cia401::IoHardware board_hardware() { return board.hardware(); }
  cia419::ChargerHardware stage_hardware() { return stage.hardware(); }
  cia407::DisplayHardware display_hardware() { return display.hardware(); }
  cia417::DoorHardware door_hardware() { return door.hardware(); }
  cia417::CarDriveHardware drive_hardware() { return drive.hardware(); }
  cia417::Detection seen(unsigned) { return beam; }
  cia417::LightBarrierHardware barrier_hardware() {
    return {.sense = Callback<cia417::Detection(unsigned)>::to<&Workshop::seen>(*this)};
  }
  void show_led(bool is_lit) { is_led_lit = is_lit; }
  void mute(bool /*is_muted*/) {}
  cia447::HandsFreeHardware hands_free_hardware() {
    return {.show_led = Callback<void(bool)>::to<&Workshop::show_led>(*this),
            .mute = Callback<void(bool)>::to<&Workshop::mute>(*this)};
  }
  void has_hands_free(cia447::HandsFreeUnit& unit, Node& /*node*/) { hands_free = &unit; }
  void has_alarm(cia447::TaxiAlarmUnit& unit, Node& /*node*/) { alarm = &unit; }
};

inline Workshop::Workshop() {
  provide_all();
  learn_to_move();
  learn_to_see();
  transport.emplace(environment, hands);
}

inline void Workshop::provide_all() {
  using Self = Workshop;
  environment.floors = 4;
  environment.provide(Callback<cia852::OperatorHardware()>::to<&Self::seat_hardware>(*this));
  environment.provide(Callback<cia401::IoHardware()>::to<&Self::board_hardware>(*this));
  environment.provide(Callback<cia419::ChargerHardware()>::to<&Self::stage_hardware>(*this));
  environment.provide(Callback<cia407::DisplayHardware()>::to<&Self::display_hardware>(*this));
  environment.provide(Callback<cia417::DoorHardware()>::to<&Self::door_hardware>(*this));
  environment.provide(Callback<cia417::CarDriveHardware()>::to<&Self::drive_hardware>(*this));
  environment.provide(Callback<cia417::LightBarrierHardware()>::to<&Self::barrier_hardware>(*this));
  environment.provide(Callback<cia447::HandsFreeHardware()>::to<&Self::hands_free_hardware>(*this));
  environment.watch(
      Callback<void(cia447::HandsFreeUnit&, Node&)>::to<&Self::has_hands_free>(*this));
  environment.watch(Callback<void(cia447::TaxiAlarmUnit&, Node&)>::to<&Self::has_alarm>(*this));
}

inline void Workshop::learn_to_move() {
  constexpr std::int16_t end = 0x7FFF;
  hands.learn("push joystick 1 along x to its positive end", [this] { seat.axes[{1, 1}] = end; });
  hands.learn("push joystick 1 along y to its positive end", [this] { seat.axes[{1, 2}] = end; });
  hands.learn("turn joystick 1 about z to its positive end", [this] { seat.axes[{1, 3}] = end; });
  hands.learn("let joystick 1 go", [this] { seat.axes.clear(); });
  hands.learn("press button 1 of joystick 1", [this] { seat.buttons[1] = 1; });
  hands.learn("let button 1 of joystick 1 go", [this] { seat.buttons[1] = 0; });
  hands.learn("press foot pedal 1 to its end", [this] { seat.pedals[1] = end; });
  hands.learn("let foot pedal 1 go", [this] { seat.pedals[1] = 0; });
  hands.learn("turn wheel 1 to its positive end", [this] { seat.wheels[1] = end; });
  hands.learn("turn wheel 1 to its middle", [this] { seat.wheels[1] = 0; });
  hands.learn("turn encoder 1", [this] { seat.encoders[1] += 77; });
  hands.learn("press push-button 1 of cluster 1", [this] { seat.push_buttons[{1, 1}] = 1; });
  hands.learn("let push-button 1 of cluster 1 go", [this] { seat.push_buttons[{1, 1}] = 0; });
  hands.learn("press push-button 64 of cluster 1", [this] { seat.push_buttons[{1, 8}] = 0x80; });
  hands.learn("let push-button 64 of cluster 1 go", [this] { seat.push_buttons[{1, 8}] = 0; });
  hands.learn("switch input 1 of group 1 on", [this] { board.contacts = 1; });
  hands.learn("switch input 1 of group 1 off", [this] { board.contacts = 0; });
  hands.learn("switch inputs 1 to 8 off", [this] { board.contacts = 0; });
  hands.learn("set analogue input 1 to nothing", [this] { board.volts = 0; });
  hands.learn("set analogue input 1 to its highest value",
              [this] { board.volts = std::numeric_limits<std::int32_t>::max(); });
  hands.learn("close the pilot contact of the charger", [this] { stage.is_plugged = true; });
  hands.learn("put something into the light barrier of door 1",
              [this] { beam = cia417::Detection::yes; });
  hands.learn("take it out of the light barrier of door 1",
              [this] { beam = cia417::Detection::no; });
  hands.learn_at(hands_free, "press the key of the hand-free equipment",
                 [this] { hands_free->press_key(true); });
  hands.learn_at(hands_free, "let the key of the hand-free equipment go",
                 [this] { hands_free->press_key(false); });
  hands.learn_at(alarm, "press the alarm key", [this] { alarm->press_key(true); });
  hands.learn_at(alarm, "let the alarm key go", [this] { alarm->press_key(false); });
}

inline void Workshop::learn_to_see() {
  const auto is_lit = [this](unsigned group, std::uint8_t bit, bool lit) {
    return [this, group, bit, lit] { return ((seat.lit[{1, group}] & bit) != 0) == lit; };
  };
  // True if the module or the seat, whichever exists, drives the output; the other drives nothing.
  const auto is_driven = [this](std::uint8_t bit, bool on) {
    return [this, bit, on] {
      const unsigned all = board.valves | unsigned{seat.lit[{1, 1}]};
      return ((all & bit) != 0) == on;
    };
  };
  const auto shows_number = [this](std::int16_t value) {
    return [this, value] { return seat.shown[{1, 1}] == value; };
  };
  const auto shows = [this](const char* text) {
    return [this, text] { return display.texts == std::vector<std::string>{text}; };
  };
  hands.sees = {
      {"indicator 1 of cluster 1 is lit", is_lit(1, 0x01, true)},
      {"indicator 1 of cluster 1 is dark", is_lit(1, 0x01, false)},
      {"indicator 64 of cluster 1 is lit", is_lit(8, 0x80, true)},
      {"indicator 64 of cluster 1 is dark", is_lit(8, 0x80, false)},
      {"parameter 1 of display 1 is 321", shows_number(321)},
      {"parameter 1 of display 1 is -1", shows_number(-1)},
      {"parameter 1 of display 1 is 100", shows_number(100)},
      {"output 1 of group 1 is on", is_driven(0x01, true)},
      {"output 1 of group 1 is off", is_driven(0x01, false)},
      {"output 2 of group 1 is off", is_driven(0x02, false)},
      {"the display shows Zoo", shows("Zoo")},
      {"the display shows Market", shows("Market")},
      {"the display is dark", [this] { return display.texts.empty(); }},
      {"the display shows that a stop is wanted", [this] { return display.is_stop_wanted; }},
      {"the display shows that no stop is wanted", [this] { return !display.is_stop_wanted; }},
      {"the LED of the hand-free equipment is lit", [this] { return is_led_lit; }},
      {"the LED of the hand-free equipment is dark", [this] { return !is_led_lit; }}};
}

}  // namespace canvoy::conformance
