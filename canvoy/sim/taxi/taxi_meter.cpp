#include "canvoy/sim/taxi/taxi_meter.hpp"

#include <algorithm>

#include "canvoy/devices/cia447/taximeter/receipt.hpp"

namespace canvoy::taxi {

namespace {

/// Of what the meter keeps itself people are told what somebody has done to it.
bool is_told(const cia447::AuditEntry& entry) {
  using enum cia447::AuditEvent;
  constexpr cia447::AuditEvent told[] = {write_refused, settings_refused, clock_step,
                                         clock_refused, seal_opened,      seal_closed};
  const bool is_error =
      entry.what == error &&
      entry.detail >= static_cast<std::uint32_t>(cia447::TaximeterError::extra_pulses);
  return is_error || std::ranges::find(told, entry.what) != std::end(told);
}

}  // namespace

void TaxiMeter::offer(Site& site) {
  site.offer(Callback<cia447::TaximeterHardware()>::to<&TaxiMeter::hardware>(*this));
  site.offer(Callback<cia447::TaximeterSettings()>::to<&TaxiMeter::settings>(*this));
  site.watch(Callback<void(cia447::TaximeterUnit&, Node&)>::to<&TaxiMeter::is_unit>(*this));
  site.offer(Callback<FareDisplaySettings()>::to<&TaxiMeter::fare_display_settings>(*this));
  site.watch(Callback<void(FareDisplay&, Node&)>::to<&TaxiMeter::is_fare_display>(*this));
}

void TaxiMeter::offer_outputs(Site& site) {
  site.watch(Callback<void(cia447::CarNetwork&, Node&)>::to<&TaxiMeter::is_network>(*this));
}

/// Its supply sinks slowly enough for it to keep what it has; its display is dark then.
void TaxiMeter::power_changes(bool is_on) {
  if (!is_on && bus_.has_power(taximeter_id)) {
    unit_->power_fails();
    display_ = {.state = cia447::Taximeter::not_available, .trip = {}};
  }
  outputs_.reset();
  fare_display_ = nullptr;
}

cia447::TaximeterHardware TaxiMeter::hardware() {
  return {.clock = clock_,
          .seal_is_open = Callback<bool()>::to<&TaxiMeter::seal_is_open>(*this),
          .show = Callback<void(const cia447::TaximeterDisplay&)>::to<&TaxiMeter::show>(*this),
          .recorded = Callback<void(const cia447::AuditEntry&)>::to<&TaxiMeter::note>(*this),
          .turned_off = {},
          .flash = &flash_.flash()};
}

cia447::TaximeterSettings TaxiMeter::settings() {
  cia447::TaximeterSettings settings = options_.meter;
  settings.clock_node = driver_id;
  settings.memory = {.address = 0, .slot_size = sector_size};
  settings.audit_memory = {.address = 2 * sector_size, .slot_size = sector_size};
  return settings;
}

FareDisplaySettings TaxiMeter::fare_display_settings() {
  return {.terminal = terminal_id, .currency = options_.meter.currency};
}

void TaxiMeter::is_network(cia447::CarNetwork& network, Node& /*node*/) {
  outputs_.emplace(network, cia447::MeterOutputs::Settings{.printer = printer_id, .sign = sign_id});
}

/// Of what is repeated the first time.
void TaxiMeter::note(const cia447::AuditEntry& entry) {
  recorded_(entry);
  if (entry.times == 1 && is_told(entry)) events_.note(bus_.world().now(), MeterRecorded{entry});
}

void TaxiMeter::show(const cia447::TaximeterDisplay& display) {
  const Time now = bus_.world().now();
  if (display.state != display_.state) events_.note(now, MeterChanged{display.state});
  const bool is_hired = display.state == cia447::Taximeter::hired;
  if (is_hired && display.trip.level != display_.trip.level) {
    events_.note(now, TariffChanged{display.trip.level});
  }
  display_ = display;
  if (outputs_) outputs_->show(display);
  if (fare_display_ != nullptr) fare_display_->show(display);
}

bool TaxiMeter::has_passengers() const {
  return display_.state == cia447::Taximeter::hired || display_.state == cia447::Taximeter::stopped;
}

bool TaxiMeter::heard(cia447::Taximeter state) {
  if (state == display_.state) return false;
  events_.note(bus_.world().now(), MeterChanged{state});
  display_.state = state;
  return true;
}

void TaxiMeter::print_receipt(std::uint32_t number) {
  if (!outputs_) return;
  const cia447::Receipt receipt(display_.trip, {.number = number,
                                                .taxi = "M-TX 447",
                                                .currency = options_.meter.currency,
                                                .distance_unit = options_.meter.distance_unit});
  outputs_->print(receipt.text());
}

MeterKeys TaxiMeter::keys() {
  if (!bus_.is_played(taximeter_id)) return keys_of_others();
  const auto press = [this](auto key) {
    return [this, key](auto... with) {
      if (!bus_.has_power(taximeter_id) || sabotage_.blocks_keys) return false;
      return (unit_->*key)(with...);
    };
  };
  return {.sign_on = press(&cia447::TaximeterUnit::sign_on),
          .hire = press(&cia447::TaximeterUnit::hire),
          .stop = press(&cia447::TaximeterUnit::stop),
          .add_supplement = press(&cia447::TaximeterUnit::add_supplement),
          .for_hire = press(&cia447::TaximeterUnit::for_hire),
          .sign_off = press(&cia447::TaximeterUnit::sign_off)};
}

MeterKeys TaxiMeter::keys_of_others() {
  const auto says = [this](cia447::Taximeter state) {
    return [this, state] { return display_.state == state; };
  };
  return {.sign_on = says(cia447::Taximeter::for_hire),
          .hire = says(cia447::Taximeter::hired),
          .stop = says(cia447::Taximeter::stopped),
          .add_supplement = [](std::uint32_t) { return false; },
          .for_hire = says(cia447::Taximeter::for_hire),
          .sign_off = says(cia447::Taximeter::signed_off)};
}

}  // namespace canvoy::taxi
