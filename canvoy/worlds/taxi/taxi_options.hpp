// Options for a shift of a taxi: the plan of faults and the seed, the car and its meter, the town,
// the devices that are not simulated here; and the node-IDs of its devices.
//
//     TaxiOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .start = Time(20min), .node = 2}};
#pragma once

#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/sync/time_of_day.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/navigation/gazetteer.hpp"
#include "canvoy/devices/cia447/real_time_clock/time_zone.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/worlds/car/drive_record.hpp"
#include "canvoy/worlds/car/real_identity.hpp"
#include "canvoy/worlds/taxi/fault.hpp"
#include "canvoy/worlds/taxi/shift.hpp"
#include "canvoy/worlds/taxi/town.hpp"

namespace canvoy::taxi {

inline constexpr NodeId printer_id = 3;     ///< printer
inline constexpr NodeId driver_id = 4;      ///< driver identification and clock
inline constexpr NodeId sign_id = 5;        ///< tariff display on the roof
inline constexpr NodeId terminal_id = 6;    ///< terminal
inline constexpr NodeId navigation_id = 7;  ///< GPS and navigation
inline constexpr NodeId alarm_id = 8;       ///< taxi alarm system
/// In the order of their node-IDs, from 1 on.
inline constexpr std::array<std::string_view, 8> device_names = {
    "ivn-gateway",    "taximeter", "printer",        "driver-and-clock",
    "tariff-display", "terminal",  "gps-navigation", "taxi-alarm"};

/// Duration of an alarm, from the key until the driver ends it.
inline constexpr Duration alarm_lasts = 1min;

/// Assumptions about the network of a car.
struct CarNetworkOptions {
  cia447::CarNetworkSettings nodes{};  ///< of each add-on device
  cia447::CarMasterSettings master{};  ///< of the gateway, for the others
  cia447::CarSleepSettings sleep{};    ///< of all devices
};

/// Licence, company and driver.
struct Business {
  std::string taxi = "M-TX 447";      ///< identifier of the taxi, on receipts and slips
  std::string company = "Isar Taxi";  ///< on receipts and slips
  std::string driver = "A. Driver";   ///< on the driver's card, and on papers
  double vat_percent = 7;             ///< percentage of fares, to tenths; 0: none is printed

  /// In tenths of a percent.
  std::uint32_t vat_permille() const {
    return static_cast<std::uint32_t>(std::lround(vat_percent * 10));
  }
};

struct TaxiOptions {
  FaultPlan faults{};                ///< faults, and the seed of all chance
  std::uint32_t bit_rate = 125'000;  ///< in bit/s
  /// Time on the clocks at the start.
  CivilTime begin = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + 18h;
  cia447::TimeZone zone{};          ///< of the town
  Duration clock_ahead{};           ///< advance of the real time clock on the bus before the right
                                    ///< time
  Duration meter_clock_ahead{};     ///< advance of the meter's own clock
  Duration length = 12h;            ///< of the whole run
  Duration alarm = 4h;              ///< time from the start to the press of the alarm key
  Business business{};              ///< on papers
  ShiftOptions shift{};             ///< its end and presses_max follow from the rest
  CarNetworkOptions car_network{};  ///< times of the network
  cia447::CarSettings car{};        ///< of the gateway: wheels and ranges
  /// Receipts show the taxi's identifier (60DAh:04h) and the currency as the meter has them.
  cia447::TaximeterSettings meter{.k = 24'000, .taxi_identifier = "M-TX 447"};
  /// Tariff for what passengers owe; that of the meter is in its settings, and must be the same.
  cia447::Tariff tariff_of_town = cia447::example_tariff;
  /// Currency that passengers pay with; that of the meter must be the same.
  cia447::Currency currency_of_town = {};
  /// Record of a drive; null: the drive follows from the people, by chance.
  std::shared_ptr<const car::DriveRecord> record{};
  /// Places of the navigation system; they must outlive this object.
  std::span<const cia447::NamedPlace> places = town_places;
  std::vector<NodeId> real{};                   ///< devices that are not simulated here
  std::vector<car::RealIdentity> identities{};  ///< of those among them that have one
};

/// Failures beyond those of the plan, so that each referee has something to detect.
struct Sabotage {
  double pocketed = 0;                ///< amount beyond the meter's, from each passenger
  bool mutes_alarm = false;           ///< the aerial of the alarm's radio
  bool cuts_sign = false;             ///< the wires from the tariff display to its lamps
  bool speaks_asleep = false;         ///< a frame is sent while all devices sleep
  bool blocks_keys = false;           ///< the keys of the meter
  bool cuts_screen = false;           ///< the wires to display 1 of the terminal
  std::optional<Business> printed{};  ///< on receipts and slips in place of the right one
  bool swaps_payment = false;         ///< receipts say the other kind of payment
  unsigned receipts_skipped = 0;      ///< is added to the numbers of receipts
  bool cuts_taxi_light = false;       ///< the wire to the taxi light
  bool cuts_level = false;            ///< the wires to the level on the roof
  bool blinds_receiver = false;  ///< the GPS receiver keeps reporting the position of the start
};

}  // namespace canvoy::taxi
