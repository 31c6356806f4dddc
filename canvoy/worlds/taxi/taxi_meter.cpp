#include "canvoy/worlds/taxi/taxi_meter.hpp"

#include <algorithm>

#include "canvoy/devices/cia447/taximeter/receipt.hpp"
#include "canvoy/worlds/taxi/screen_text.hpp"

namespace canvoy::taxi {

FareDisplay::FareDisplay(cia447::CarNetwork& network, const car::NoHardware& /*hardware*/,
                         const FareDisplaySettings& settings)
    : settings_(settings), terminal_(network, {.terminal = settings.terminal}) {}

void FareDisplay::show(const cia447::TaximeterDisplay& display) {
  const std::string text = trip_text(display, settings_.currency);
  terminal_.want(cia447::TerminalPart::display_1, !text.empty());
  terminal_.show(cia447::TerminalText::text_1, text);
}

namespace {

/// True for a record of tampering, which is reported to people.
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

void TaxiMeter::provide(Environment& environment) {
  environment.provide(callback<&TaxiMeter::hardware>(*this));
  environment.provide(callback<&TaxiMeter::settings>(*this));
  environment.watch(unit_);
  environment.provide(callback<&TaxiMeter::fare_display_settings>(*this));
  environment.watch(fare_display_);
}

void TaxiMeter::provide_outputs(Environment& environment) {
  environment.watch(callback<&TaxiMeter::is_network>(*this));
}

/// Its supply falls slowly enough for it to save its values; then its display is dark.
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
          .seal_is_open = callback<&TaxiMeter::seal_is_open>(*this),
          .show = callback<&TaxiMeter::show>(*this),
          .recorded = callback<&TaxiMeter::note>(*this),
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

/// Notes a repeated event the first time.
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

const Business& TaxiMeter::printed_business() const {
  return sabotage_.printed ? *sabotage_.printed : options_.business;
}

cia447::PaperHead TaxiMeter::paper_head() const {
  const Business& business = printed_business();
  return {.taxi = options_.meter.taxi_identifier,
          .company = business.company,
          .driver = business.driver,
          .currency = options_.meter.currency,
          .distance_unit = options_.meter.distance_unit};
}

void TaxiMeter::print_receipt(std::uint32_t number, std::string_view payment) {
  if (!outputs_) return;
  const auto ahead = [this](std::uint32_t utc) {
    return static_cast<std::int32_t>(town_.ahead(utc));
  };
  const cia447::Receipt receipt(display_.trip,
                                {.number = number + sabotage_.receipts_skipped,
                                 .head = paper_head(),
                                 .utc_offset = ahead(display_.trip.finish),
                                 .utc_offset_at_start = ahead(display_.trip.start),
                                 .kinds = unit_->tariff().supplements,
                                 .of_kinds = unit_->record().trip.supplements_of_kind,
                                 .vat_permille = printed_business().vat_permille(),
                                 .payment = payment});
  outputs_->print(receipt.text());
}

void TaxiMeter::print_slip() {
  if (!outputs_) return;
  const cia447::TaximeterRecord& record = unit_->record();
  const auto local = [this](std::int64_t utc) {
    return utc == cia447::no_time ? utc : utc + town_.ahead(utc);
  };
  slip_ =
      cia447::ShiftSlip(
          record.shift, record.total,
          {.head = paper_head(), .begin = local(record.shift_begin), .end = local(record.saved_at)})
          .text();
}

void TaxiMeter::step() {
  if (slip_.empty() || !outputs_ || outputs_->is_printing()) return;
  outputs_->print(slip_);
  slip_.clear();
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
          .standby = press(&cia447::TaximeterUnit::standby),
          .wake = press(&cia447::TaximeterUnit::wake),
          .clear_supplements = press(&cia447::TaximeterUnit::clear_supplements),
          .begin_calibration = [this] { return begin_calibration(); },
          .end_calibration = [this](std::uint32_t metres) { return end_calibration(metres); },
          .charge = press(&cia447::TaximeterUnit::charge),
          .agree_price = press(&cia447::TaximeterUnit::agree_price),
          .for_hire = press(&cia447::TaximeterUnit::for_hire),
          .sign_off = press(&cia447::TaximeterUnit::sign_off)};
}

/// In a workshop that may open the seal.
bool TaxiMeter::begin_calibration() {
  if (!bus_.has_power(taximeter_id)) return false;
  is_seal_open_ = true;
  const bool is_in_service = unit_->record().state == cia447::Taximeter::service_mode;
  const bool begins = (is_in_service || unit_->enter_service()) && unit_->begin_calibration();
  is_seal_open_ = begins;
  return begins;
}

std::optional<std::uint32_t> TaxiMeter::end_calibration(std::uint32_t metres) {
  if (!bus_.has_power(taximeter_id)) return std::nullopt;
  const bool is_done = unit_->end_calibration(metres);
  is_seal_open_ = false;
  if (!unit_->leave_service() || !is_done) return std::nullopt;
  return unit_->record().k;
}

MeterKeys TaxiMeter::keys_of_others() {
  const auto says = [this](cia447::Taximeter state) {
    return [this, state] { return display_.state == state; };
  };
  return {.sign_on = says(cia447::Taximeter::for_hire),
          .hire = says(cia447::Taximeter::hired),
          .stop = says(cia447::Taximeter::stopped),
          .standby = [] { return false; },
          .wake = [] { return false; },
          .clear_supplements = [] { return false; },
          .begin_calibration = {},
          .end_calibration = {},
          .charge = [](unsigned) { return false; },
          .agree_price = [](std::uint32_t) { return false; },
          .for_hire = says(cia447::Taximeter::for_hire),
          .sign_off = says(cia447::Taximeter::signed_off)};
}

}  // namespace canvoy::taxi
