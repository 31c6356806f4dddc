#include "canvoy/tools/device/wired_hands.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "canvoy/profiles/cia401.hpp"
#include "canvoy/profiles/cia417.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/tools/device/device_lift_unit.hpp"
#include "canvoy/tools/device/hand/hand_rows.hpp"
#include "canvoy/tools/device/io_wires.hpp"
#include "canvoy/tools/device/wired_things.hpp"

namespace canvoy::tools {

namespace {

using hand_rows::choice, hand_rows::key, hand_rows::number, hand_rows::numbered, hand_rows::whole;
using HandRows = std::vector<DeviceHand>;
using Things = WiredThings;

/// Condition of a part that may fail in one or more ways.
constexpr std::string_view works = "working";

/// Words of an input, with the conditions that a panel or a sensor unit reports.
std::vector<HandWord> input_words(std::string_view off, std::string_view on) {
  return {{std::string(off), 0},
          {std::string(on), 1},
          {"defective", 2, Meaning::failure},
          {"not-installed", 3, Meaning::not_implemented},
          {std::string(works), 4, Meaning::padding}};
}

std::int16_t integer_of(const HandValue& value) {
  return static_cast<std::int16_t>(std::lround(value.number));
}

// CiA 401.

HandRows io_hands(const Environment& /*environment*/) {
  constexpr double least = -32768;
  constexpr double most = 32767;
  const auto set_input = [](Things& things, const HandValue& value, const HandTarget& target) {
    return things.set_input(target.number, value.code != 0);
  };
  const auto set_analogue = [](Things& things, const HandValue& value, const HandTarget& target) {
    return things.set_analogue_input(target.number, integer_of(value));
  };
  return {
      numbered(IoWires::digital_inputs, key<Things>("input", whole(cia401::read_input_8_bit_object),
                                                    set_input, hand_rows::two_words("off", "on"))),
      numbered(IoWires::analogue_inputs,
               number<Things>("analogue-input", whole(cia401::read_analogue_input_16_bit_object),
                              {least, most}, set_analogue))};
}

// CiA 417-4.

/// A fault of a door: `field` of DoorFaults is set for the second word.
DeviceHand door_fault(std::string name, std::string_view broken, bool lift::DoorFaults::*field) {
  return choice<Things>(std::move(name), whole(cia417::door_statusword_object), {works, broken},
                        [field](Things& things, const HandValue& value, const HandTarget& target) {
                          return things.set_door_fault(field, value.code != 0, target.now);
                        });
}

DeviceHand obstacle(const cia447::FieldPlace& changes) {
  return choice<Things>("obstacle", changes, {"no", "yes"},
                        [](Things& things, const HandValue& value, const HandTarget& target) {
                          return things.put_in_door(value.code != 0, target.now);
                        });
}

HandRows door_hands(const Environment& /*environment*/) {
  using Faults = lift::DoorFaults;
  const auto door = whole(cia417::door_statusword_object);
  const auto approach = [](Things& things, const HandValue& value) {
    return things.approach_door(value.code != 0);
  };
  const auto touch = [](Things& things, const HandValue& value) {
    return things.touch_door(value.code != 0);
  };
  return {obstacle(door),
          choice<Things>("person-near", door, {"no", "yes"}, approach),
          choice<Things>("finger", door, {"no", "yes"}, touch),
          door_fault("panels", "stuck", &Faults::is_stuck),
          door_fault("belt", "broken", &Faults::belt_is_broken),
          door_fault("drive", "failure", &Faults::drive_fails),
          door_fault("lock", "stuck", &Faults::lock_is_stuck),
          door_fault("lock-bolt", "sprung", &Faults::lock_is_open),
          door_fault("safety-contact", "broken", &Faults::contact_is_broken),
          door_fault("finger-protector", "failure", &Faults::finger_protector_is_broken),
          door_fault("motion-detector", "failure", &Faults::motion_detector_is_broken)};
}

HandRows barrier_hands(const Environment& /*environment*/) {
  const auto place = whole(cia417::light_barrier_status_object);
  DeviceHand beam = door_fault("beam", "failure", &lift::DoorFaults::barrier_is_broken);
  DeviceHand lens = door_fault("lens", "dirty", &lift::DoorFaults::barrier_is_covered);
  beam.changes = lens.changes = {place};
  return {obstacle(place), beam, lens};
}

HandRows load_hands(const Environment& /*environment*/) {
  const auto load = [](Things& things, const HandValue& value) {
    return things.set_load(value.number);
  };
  const auto sensor = [](Things& things, const HandValue& value) {
    return things.break_rope_sensor(value.code != 0);
  };
  const auto place = whole(cia417::load_value_object);
  return {number<Things>("load", place, {0, lift_load_kg_max, "kg"}, load),
          choice<Things>("rope-sensor", place, {works, "failure"}, sensor)};
}

/// A fault of the car or its drive, made by `set` from faults and value.
template <class Act>
auto on_car(Act set) {
  return [set](Things& things, const HandValue& value) {
    lift::CarPlant* const car = things.car();
    if (car == nullptr) return false;
    lift::CarPlantFaults faults = car->faults();
    set(faults, value);
    car->set_faults(faults);
    return true;
  };
}

template <class Act>
DeviceHand car_fault(std::string name, const cia447::FieldPlace& changes, std::string_view broken,
                     Act set) {
  return choice<Things>(std::move(name), changes, {works, broken},
                        on_car([set](lift::CarPlantFaults& faults, const HandValue& value) {
                          set(faults, value.code != 0);
                        }));
}

HandRows drive_hands(const Environment& /*environment*/) {
  using Faults = lift::CarPlantFaults;
  const auto place = whole(cia417::statusword_object);
  const auto chain = [](Things& things, const HandValue& value) {
    return things.open_safety_chain(value.code != 0);
  };
  const auto gear = [](Things& things, const HandValue& value) {
    return things.catch_safety_gear(value.code != 0);
  };
  const auto fault = on_car([](Faults& faults, const HandValue& value) {
    faults.drive_fault = static_cast<std::uint16_t>(std::lround(value.number));
  });
  return {choice<Things>("safety-chain", place, {"closed", "open"}, chain),
          choice<Things>("safety-gear", place, {"released", "caught"}, gear),
          number<Things>("fault", place, {0, 0xFFFF, "(an error code; 0: none)"}, fault),
          car_fault("encoder", place, "failure",
                    [](Faults& faults, bool is) { faults.drive_encoder_is_dead = is; }),
          car_fault("motor", place, "runs-away",
                    [](Faults& faults, bool is) { faults.motor_runs_away = is; }),
          car_fault("brake", place, "stuck",
                    [](Faults& faults, bool is) { faults.brake_is_stuck = is; }),
          car_fault("brake-lining", place, "worn",
                    [](Faults& faults, bool is) { faults.brake_share = is ? 0.2 : 1.0; })};
}

HandRows position_hands(const Environment& /*environment*/) {
  using Faults = lift::CarPlantFaults;
  const auto place = whole(cia417::position_value_object);
  const auto slip = on_car([](Faults& faults, const HandValue& value) {
    constexpr double percent = 100;
    faults.slip = value.number / percent;
  });
  return {car_fault("encoder", place, "failure",
                    [](Faults& faults, bool is) { faults.position_encoder_is_dead = is; }),
          car_fault("encoder-alarm", place, "alarm",
                    [](Faults& faults, bool is) { faults.position_encoder_alarms = is; }),
          number<Things>("rope-slip", place, {0, 99, "%"}, slip)};
}

HandRows sensor_hands(const Environment& /*environment*/) {
  constexpr double least = -8192;
  constexpr double most = 8191;
  HandRows hands;
  for (unsigned i = 0; i < wired_sensor_names.size(); ++i) {
    const auto function = cia417::sensors_at(1, 1).at(i).function;
    const auto set = [function](Things& things, const HandValue& value, const HandTarget& target) {
      return things.set_sensor(function, value, target.now);
    };
    const std::string name(wired_sensor_names.at(i));
    const auto place = whole(cia417::sensor_group_object);
    const auto words = input_words("no-signal", "signal");
    if (cia417::is_measured(function)) {
      hands.push_back(number<Things>(name, place, {least, most, "units of parameter 3"}, set));
      hands.back().words.assign(words.begin() + 2, words.end());
    } else {
      hands.push_back(choice<Things>(name, place, {}, set));
      hands.back().words = words;
    }
  }
  return hands;
}

DeviceHand button(std::string name, cia417::BasicFunction function, std::uint8_t sub_function) {
  return key<Things>(
      std::move(name), whole(cia417::input_group_object),
      [function, sub_function](Things& things, const HandValue& value, const HandTarget& target) {
        const auto floor = static_cast<std::uint8_t>(target.number);
        return things.press(function, floor == 0 ? sub_function : floor, value, target.now);
      },
      input_words("released", "pressed"));
}

HandRows landing_hands(const Environment& environment) {
  using cia417::BasicFunction;
  HandRows hands;
  if (environment.floor < environment.floors) {
    hands.push_back(button("up", BasicFunction::standard_hall_call, cia417::hall_up));
  }
  if (environment.floor > 1) {
    hands.push_back(button("down", BasicFunction::standard_hall_call, cia417::hall_down));
  }
  return hands;
}

HandRows car_panel_hands(const Environment& environment) {
  using cia417::BasicFunction, cia417::SpecialFunction, cia417::sub_function_of;
  return {
      numbered(environment.floors, button("", BasicFunction::standard_car_call, 0)),
      button("open", BasicFunction::special_function, sub_function_of(SpecialFunction::door_open)),
      button("close", BasicFunction::special_function,
             sub_function_of(SpecialFunction::door_close))};
}

// CiA 418 and 419.

template <class Act>
auto on_charging(Act set) {
  return [set](Things& things, const HandValue& value) {
    ChargingPlant* const plant = things.charging();
    if (plant == nullptr) return false;
    set(*plant, value);
    return true;
  };
}

HandRows charger_hands(const Environment& /*environment*/) {
  const auto place = whole(cia419::charger_status_object);
  return {choice<Things>("plug", place, {"out", "in"},
                         on_charging([](ChargingPlant& plant, const HandValue& value) {
                           plant.is_plugged = value.code != 0;
                         })),
          choice<Things>("pilot-signal", place, {works, "lost"},
                         on_charging([](ChargingPlant& plant, const HandValue& value) {
                           plant.stage.faults.pilot_signal_is_lost = value.code != 0;
                         }))};
}

HandRows battery_hands(const Environment& /*environment*/) {
  constexpr double coldest = -55;
  constexpr double hottest = 125;
  DeviceHand temperature = number<Things>(
      "temperature", whole(cia418::temperature_object), {coldest, hottest, "degrees Celsius"},
      on_charging([](ChargingPlant& plant, const HandValue& value) {
        BatteryFaults& of = plant.battery.faults;
        of.temperature_is_invalid = value.meaning == Meaning::failure;
        of.shown_celsius.reset();
        const bool is_number = value.meaning == Meaning::state;
        if (is_number) of.shown_celsius = value.number;
      }));
  temperature.words = {{"failure", 1, Meaning::failure}, {std::string(works), 2, Meaning::padding}};
  return {std::move(temperature),
          choice<Things>("voltage-sensor", whole(cia418::voltage_object), {works, "failure"},
                         on_charging([](ChargingPlant& plant, const HandValue& value) {
                           plant.battery.faults.voltage_is_invalid = value.code != 0;
                         })),
          choice<Things>("ready", whole(cia418::battery_status_object), {"no", "yes"},
                         on_charging([](ChargingPlant& plant, const HandValue& value) {
                           plant.battery.faults.is_not_ready = value.code == 0;
                         }))};
}

struct WiredKind {
  std::string_view device;
  const Profile& profile;
  HandRows (*hands)(const Environment& environment);
};
const WiredKind wired_kinds[] = {
    {"io-401", cia401::profile, io_hands},
    {"lift-door", cia417::profile, door_hands},
    {"lift-light-barrier", cia417::profile, barrier_hands},
    {"lift-load", cia417::profile, load_hands},
    {"lift-drive", cia417::profile, drive_hands},
    {"lift-position", cia417::profile, position_hands},
    {"lift-sensors", cia417::profile, sensor_hands},
    {"lift-car-panel", cia417::profile, car_panel_hands},
    {"lift-landing-panel", cia417::profile, landing_hands},
    {"lift-input-panel", cia417::profile, landing_hands},
    {"charger", cia419::profile, charger_hands},
    {"battery", cia418::profile, battery_hands},
};

}  // namespace

HandRows wired_hands(std::string_view device, const Environment& environment) {
  const auto found = std::ranges::find(wired_kinds, device, &WiredKind::device);
  if (found == std::end(wired_kinds)) return {};
  HandRows hands = found->hands(environment);
  hand_rows::take_clauses(hands, found->profile);
  return hands;
}

}  // namespace canvoy::tools
