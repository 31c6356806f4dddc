// What is chosen for a shift of a taxi: the plan of faults and the seed, the car and its meter, the
// town, who is not played here; and the node-IDs of its devices.
//
//     TaxiOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .start = Time(20min), .node = 2}};
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/canopen/sync/time_of_day.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/navigation/gazetteer.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/sim/car/drive_record.hpp"
#include "canvoy/sim/taxi/fault.hpp"
#include "canvoy/sim/taxi/shift.hpp"
#include "canvoy/sim/taxi/town.hpp"

namespace canvoy::taxi {

inline constexpr NodeId printer_id = 3;
inline constexpr NodeId driver_id = 4;
inline constexpr NodeId sign_id = 5;
inline constexpr NodeId terminal_id = 6;
inline constexpr NodeId navigation_id = 7;
inline constexpr NodeId alarm_id = 8;
/// In the order of their node-IDs, from 1 on.
inline constexpr std::array<std::string_view, 8> device_names = {
    "ivn-gateway",    "taximeter", "printer",        "driver-and-clock",
    "tariff-display", "terminal",  "gps-navigation", "taxi-alarm"};

/// What we assume of the network of a car.
struct CarNetworkOptions {
  cia447::CarNetworkSettings nodes{};
  cia447::CarMasterSettings master{};
  cia447::CarSleepSettings sleep{};
};

struct TaxiOptions {
  FaultPlan faults{};  ///< and the seed
  std::uint32_t bit_rate = 125'000;
  /// What clocks show at the start.
  CivilTime begin = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + 18h;
  Duration clock_ahead{};        ///< of what is right: of the real time clock on the bus
  Duration meter_clock_ahead{};  ///< of the meter's own
  Duration length = 12h;         ///< of the whole run
  Duration alarm = 4h;           ///< from the start to the press of the alarm key
  ShiftOptions shift{};          ///< its end and presses_max follow from the rest
  CarNetworkOptions car_network{};
  cia447::CarSettings car{};
  cia447::TaximeterSettings meter{.k = 24'000};
  /// What passengers owe; the meter's own is in its settings, and has to be the same.
  cia447::Tariff tariff_of_town = cia447::example_tariff;
  /// How the car goes; null: as the people want it by chance.
  std::shared_ptr<const car::DriveRecord> record{};
  /// What the navigation system knows; who gives them keeps them.
  std::span<const cia447::NamedPlace> places = town_places;
  std::vector<NodeId> real{};  ///< who is not played here
};

/// What no fault of a plan does, so that each referee has something to see.
struct Sabotage {
  double pocketed = 0;           ///< beside what the meter shows, from each passenger
  bool cuts_sign = false;        ///< the wires from the tariff display to its lamps
  bool speaks_asleep = false;    ///< somebody sends a frame while all sleep
  bool blocks_keys = false;      ///< the keys of the meter
  bool cuts_screen = false;      ///< the wires to display 1 of the terminal
  bool blinds_receiver = false;  ///< the GPS receiver says where the car was at the start
};

}  // namespace canvoy::taxi
