// Hardware of a taximeter, and its settings when it is first sealed, from its maker (CiA 447-3,
// 4.2.12).
//
//     TaximeterUnit meter(network, {.show = ...}, {.k = 8000, .tariff = my_tariff});
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/devices/cia447/taximeter/bus_clock.hpp"
#include "canvoy/devices/cia447/taximeter/currency.hpp"
#include "canvoy/devices/cia447/taximeter/tariff.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_memory.hpp"
#include "canvoy/devices/cia447/taximeter/trip_data.hpp"

namespace canvoy::cia447 {

/// The display for the passenger.
struct TaximeterDisplay {
  Taximeter state = Taximeter::signed_off;  ///< of the taximeter
  TripData trip = {};                       ///< present or last trip
  bool has_error = false;                   ///< an error stops it
  bool has_wheel_signal = false;            ///< pulses come, or the car stands

  bool operator==(const TaximeterDisplay&) const = default;
};

/// What the taximeter shows and senses.
struct TaximeterHardware {
  /// The meter's own clock, used if no clock on the bus sends the time: it continues from the last
  /// time on the bus. Nothing: it is not set.
  Callback<std::optional<LocalTime>()> clock = {};
  /// Service mode requires an open seal, and its end a closed one.
  Callback<bool()> seal_is_open = {};
  /// Called on each change of the display.
  Callback<void(const TaximeterDisplay&)> show = {};
  /// Called for each event, with its entry in the audit log, including its count.
  Callback<void(const AuditEntry&)> recorded = {};
  /// Called at the end of "changing to off mode": power may be cut.
  Callback<void()> turned_off = {};
  /// Keeps totals, trip and audit log; null: they are lost with power. Must outlive the unit.
  const Flash* flash = nullptr;
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(TaximeterHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::clock; } || requires { &Plain::seal_is_open; } ||
          requires { &Plain::show; } || requires { &Plain::recorded; } ||
          requires { &Plain::turned_off; },
      "the class has no member function of TaximeterHardware: clock, seal_is_open, show, recorded "
      "or turned_off");
  if constexpr (requires { &Plain::clock; }) hardware.clock = callback<&Plain::clock>(plain);
  if constexpr (requires { &Plain::seal_is_open; })
    hardware.seal_is_open = callback<&Plain::seal_is_open>(plain);
  if constexpr (requires { &Plain::show; }) hardware.show = callback<&Plain::show>(plain);
  if constexpr (requires { &Plain::recorded; })
    hardware.recorded = callback<&Plain::recorded>(plain);
  if constexpr (requires { &Plain::turned_off; })
    hardware.turned_off = callback<&Plain::turned_off>(plain);
}

/// Example tariffs for day, and for night, Sundays and holidays.
inline constexpr TariffLevel example_levels[] = {{.name = {'1', 0},
                                                  .initial_fare = 3900,
                                                  .distance_rate = 2300,
                                                  .time_rate = 33'000,
                                                  .increment = 100},
                                                 {.name = {'2', 0},
                                                  .initial_fare = 4900,
                                                  .distance_rate = 2600,
                                                  .time_rate = 33'000,
                                                  .increment = 100}};
/// For tests and the catalogue.
inline constexpr TariffHours example_hours[] = {
    {.days = on_sundays | on_holidays, .level = 1},
    {.from = time_of_day(22, 0), .to = time_of_day(6, 0), .level = 1}};
/// New Year's Day, Labour Day and Christmas.
inline constexpr Holiday example_holidays[] = {{.month = 1, .day = 1},
                                               {.month = 5, .day = 1},
                                               {.month = 12, .day = 25},
                                               {.month = 12, .day = 26}};
/// For tests and the catalogue.
inline constexpr SupplementKind example_supplements[] = {{.name = "Luggage", .price = 1000},
                                                         {.name = "Booking", .price = 1500},
                                                         {.name = "Airport", .price = 5000}};
/// For tests and the catalogue.
inline constexpr Tariff example_tariff = {.id = 1,
                                          .levels = example_levels,
                                          .hours = example_hours,
                                          .holidays = example_holidays,
                                          .supplements = example_supplements};

/// Everything to which texts and tariffs refer must outlive the unit.
struct TaximeterSettings {
  /// Pulses for a local distance unit (60DAh:01h), until it is set in service mode.
  std::uint32_t k = 8000;
  /// Until it is set in service mode.
  TaximeterMode mode = TaximeterMode::taximeter_operation;
  /// Single or double calculation.
  FareMode calculation = FareMode::single_calculation;
  Tariff tariff = example_tariff;  ///< in force
  /// Replaces the present tariff at this local time (seconds since 1970-01-01), between two trips.
  Tariff future_tariff = {};
  /// Time from which the next tariff is in force; seconds since 1970-01-01.
  std::int64_t future_from = INT64_MAX;
  std::string_view taxi_identifier = "";  ///< on receipts
  Currency currency = {};                 ///< of the tariff
  std::string_view distance_unit = "km";  ///< of the tariff, as printed
  /// In local distance units per hour: faster pulses are not from this car.
  std::uint32_t fastest_speed = 300;
  /// A trip continues after a loss of power up to this duration; after a longer one, it has ended
  /// with it.
  Duration longest_power_cut = 30s;
  /// Period in which totals and trip are kept, in addition to every change of state.
  Duration keeping_period = 60s;
  /// Duration of the change to off mode.
  Duration turning_off = 3s;
  TaximeterMemory::Place memory = {};  ///< of the record
  /// Location of the audit log, in the same flash.
  AuditMemory::Place audit_memory = {};
  /// Provider of wheels and engine (6050h to 6057h): 6054h and 6056h, which no PDO carries, are
  /// read from it by SDO, and only it may write them. 0: none.
  NodeId wheel_node = gateway_node_id;
  /// Provider of date and time (60F0h, 60F2h, 60F4h), with the same rules.
  NodeId clock_node = 0;
  Duration asking_period = 10s;  ///< of the date and the time, if no PDO carries them
};

}  // namespace canvoy::cia447
