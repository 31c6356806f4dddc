// The taximeter of a taxi, as the driver has it before him: its keys, what it shows, what it keeps
// without power, and what it has printer, tariff display and terminal do. Of one that is not played
// it is what others have heard of it.
//
//     TaxiMeter meter(bus, options, sabotage, clock, events);
//     meter.offer(site);
//     meter.keys().hire();
//     meter.display().trip.fare
#pragma once

#include <optional>

#include "canvoy/devices/cia447/taximeter/meter_outputs.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/sim/car/car_bus.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/taxi/fare_display.hpp"
#include "canvoy/sim/taxi/kept_flash.hpp"
#include "canvoy/sim/taxi/shift.hpp"
#include "canvoy/sim/taxi/taxi_event.hpp"
#include "canvoy/sim/taxi/taxi_options.hpp"

namespace canvoy::taxi {

class TaxiMeter {
 public:
  using Clock = Callback<std::optional<cia447::LocalTime>()>;

  /// All must outlive this. `clock` is the meter's own.
  TaxiMeter(car::CarBus& bus, const TaxiOptions& options, const Sabotage& sabotage,
            const Clock& clock, EventLog<TaxiEvent>& events)
      : bus_(bus), options_(options), sabotage_(sabotage), clock_(clock), events_(events) {}
  TaxiMeter(const TaxiMeter&) = delete;
  TaxiMeter& operator=(const TaxiMeter&) = delete;

  /// What the device finds at its place.
  void offer(Site& site);
  /// What it has others do, of those that are made from now on.
  void offer_outputs(Site& site);
  /// It is about to lose or get its power.
  void power_changes(bool is_on);

  /// The driver has the meter in his hands: a key of one without power does nothing. Keys of a real
  /// one are pressed by somebody else: the driver does what goes with them.
  MeterKeys keys();
  const cia447::TaximeterDisplay& display() const { return display_; }
  bool has_passengers() const;
  /// What a real one tells. False: nothing new.
  bool heard(cia447::Taximeter state);
  void heard(const cia447::TripData& trip) { display_.trip = trip; }
  /// The receipt with this number, of the trip that it shows.
  void print_receipt(std::uint32_t number);
  /// Whoever has the right tool.
  void open_seal(bool is_open) { is_seal_open_ = is_open; }
  /// Called for all that the meter records.
  void on_recorded(Callback<void(const cia447::AuditEntry&)> recorded) { recorded_ = recorded; }
  cia447::TaximeterUnit& unit() { return *unit_; }
  const cia447::TaximeterUnit& unit() const { return *unit_; }

 private:
  cia447::TaximeterHardware hardware();
  cia447::TaximeterSettings settings();
  FareDisplaySettings fare_display_settings();
  void is_unit(cia447::TaximeterUnit& unit, Node& /*node*/) { unit_ = &unit; }
  void is_fare_display(FareDisplay& display, Node& /*node*/) { fare_display_ = &display; }
  void is_network(cia447::CarNetwork& network, Node& node);
  void show(const cia447::TaximeterDisplay& display);
  bool seal_is_open() { return is_seal_open_; }
  void note(const cia447::AuditEntry& entry);
  MeterKeys keys_of_others();

  car::CarBus& bus_;
  const TaxiOptions& options_;
  const Sabotage& sabotage_;
  Clock clock_;
  EventLog<TaxiEvent>& events_;
  static constexpr std::uint32_t sector_size = 1024;
  KeptFlash flash_{4, sector_size};
  bool is_seal_open_ = false;
  Callback<void(const cia447::AuditEntry&)> recorded_;
  cia447::TaximeterUnit* unit_ = nullptr;
  std::optional<cia447::MeterOutputs> outputs_;
  FareDisplay* fare_display_ = nullptr;  ///< null while it has no power
  cia447::TaximeterDisplay display_;
};

}  // namespace canvoy::taxi
