// What the maker of a taximeter gives it: its hardware, and what it is set to when it is sealed for
// the first time (CiA 447-3, 4.2.12).
//
//     TaximeterUnit meter(network, {.show = ...}, {.k = 8000, .tariff = my_tariff});
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/devices/cia447/taximeter/bus_clock.hpp"
#include "canvoy/devices/cia447/taximeter/tariff.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_memory.hpp"
#include "canvoy/devices/cia447/taximeter/trip_data.hpp"

namespace canvoy::cia447 {

/// What a passenger reads.
struct TaximeterDisplay {
  Taximeter state = Taximeter::signed_off;
  TripData trip = {};
  bool has_error = false;
  bool has_wheel_signal = false;

  bool operator==(const TaximeterDisplay&) const = default;
};

struct TaximeterHardware {
  /// The meter's own clock, where none on the bus tells the time: it goes on from what that one
  /// said last. Nothing: it is not set.
  Callback<std::optional<LocalTime>()> clock = {};
  /// Service mode wants it to be open, and its end wants it to be closed.
  Callback<bool()> seal_is_open = {};
  /// When something of it has changed.
  Callback<void(const TaximeterDisplay&)> show = {};
  /// For each event, its entry in the audit log: how often it was by now is in it.
  Callback<void(const AuditEntry&)> recorded = {};
  /// The end of "changing to off mode": power may be cut.
  Callback<void()> turned_off = {};
  /// Keeps totals, trip and audit log; null: they end with power. It must outlive the unit.
  const Flash* flash = nullptr;
};

/// A tariff of day, and of night, Sundays and holidays: an example.
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
inline constexpr TariffHours example_hours[] = {
    {.days = on_sundays | on_holidays, .level = 1},
    {.from = time_of_day(22, 0), .to = time_of_day(6, 0), .level = 1}};
inline constexpr Tariff example_tariff = {
    .id = 1, .levels = example_levels, .hours = example_hours};

/// What texts and tariffs refer to must outlive the unit.
struct TaximeterSettings {
  /// Pulses for a local distance unit (60DAh:01h), until it was set in service mode.
  std::uint32_t k = 8000;
  TaximeterMode mode = TaximeterMode::taximeter_operation;
  /// Single or double.
  FareMode calculation = FareMode::single_calculation;
  Tariff tariff = example_tariff;
  /// Takes the other's place at this local time (seconds since 1970-01-01), between two trips.
  Tariff future_tariff = {};
  std::int64_t future_from = INT64_MAX;
  std::string_view taxi_identifier = "";
  std::string_view currency = "EUR";
  std::string_view distance_unit = "km";
  /// Local distance units an hour: pulses that were faster are none of this car.
  std::uint32_t fastest_speed = 300;
  /// A trip goes on after a loss of power that was not longer; else it ended with it.
  Duration longest_power_cut = 30s;
  /// How often totals and trip are kept, beside every change of state.
  Duration keeping_period = 60s;
  /// How long it changes to off mode.
  Duration turning_off = 3s;
  TaximeterMemory::Place memory = {};
  /// Of the audit log, in the same flash.
  AuditMemory::Place audit_memory = {};
  /// Who provides wheels and engine (6050h to 6057h): it is asked, by SDO, for 6054h and 6056h,
  /// which no PDO brings, and it alone may write them. 0: nobody.
  NodeId wheel_node = gateway_node_id;
  /// Who provides date and time (60F0h, 60F2h, 60F4h), likewise.
  NodeId clock_node = 0;
  Duration asking_period = 10s;
};

}  // namespace canvoy::cia447
