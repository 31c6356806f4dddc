#include "canvoy/tools/device/car/device_car_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <utility>

#include "canvoy/devices/cia447/taximeter/receipt.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/car/car_words.hpp"
#include "canvoy/tools/device/car/device_car.hpp"
#include "canvoy/tools/device/car/gps_hands.hpp"
#include "canvoy/tools/device/store/car_store.hpp"

namespace canvoy::tools {

namespace {

constexpr double money_unit = 1000;  ///< 60D0h counts thousandths
/// Of 60DAh:04h, and on receipts.
constexpr std::string_view taxi_identifier = "Canvoy";
constexpr cia447::PaperHead paper_head = {.taxi = taxi_identifier, .distance_unit = "km"};

bool is_among(std::span<const cia447::CarUnit* const> units, std::string_view name) {
  return std::ranges::any_of(
      units, [name](const cia447::CarUnit* unit) { return unit->info.name == name; });
}

std::string check_meter_mode(const std::string& said) {
  const bool is_one = said == "taximeter" || said == "odometer";
  return is_one ? "" : fmt::format("'{}' is neither taximeter nor odometer", said);
}
std::string check_calculation(const std::string& said) {
  const bool is_one = said == "single" || said == "double";
  return is_one ? "" : fmt::format("'{}' is neither single nor double", said);
}

struct FutureTariff {
  std::uint16_t id = 0;  ///< 0: none
  std::int64_t from = INT64_MAX;
};

/// `7@2026-12-01T00:00:00`
FutureTariff parse_future_tariff(std::string_view text) {
  if (text.empty()) return {};
  constexpr std::uint16_t most = 0xFFFE;  // 60DAh:07h
  FutureTariff tariff;
  const std::size_t at = text.find('@');
  const char* const end = text.data() + std::min(at, text.size());
  const auto [stop, error] = std::from_chars(text.data(), end, tariff.id);
  const bool is_number = error == std::errc{} && stop == end && tariff.id >= 1 && tariff.id <= most;
  if (!is_number || at == std::string_view::npos) {
    throw UsageError(fmt::format(
        "--future-tariff: '{}' is no tariff with a date: write 7@2026-12-01T00:00:00", text));
  }
  tariff.from =
      std::chrono::floor<std::chrono::seconds>(parse_clock_text(text.substr(at + 1))).count();
  return tariff;
}

}  // namespace

void check_car_panel(const CarPanelOptions& options) {
  parse_future_tariff(options.future_tariff);
}

void add_car_panel_options(Verb& command, CarPanelOptions& options) {
  constexpr unsigned id_max = cia447::node_id_max;
  command.add({
      {"--k", options.k, "of a taximeter: pulses for a kilometre (default 24000)",
       between(1U, 10'000'000U)},
      {"--calibration", options.calibration,
       "of a taximeter: how long its calibration drive is, in 0.001 km (default 1000)",
       between(100U, 100'000U)},
      {"--meter-mode",
       options.mode,
       "of a taximeter: taximeter (default), or odometer: what is driven costs nothing; in service "
       "mode the hand mode= changes it",
       {.allowed = Check(check_meter_mode)}},
      {"--calculation",
       options.calculation,
       "of the fare of a taximeter: single (default), time or distance; or double, both",
       {.allowed = Check(check_calculation)}},
      {"--future-tariff", options.future_tariff,
       "of a taximeter: the number of its next tariff, with the rates of the present one, and from "
       "when on it holds: 7@2026-12-01T00:00:00"},
      {"--printer", options.printer, "node-ID of the printer of a taximeter", between(1U, id_max)},
      {"--sign", options.sign, "node-ID of the tariff display of a taximeter", between(1U, id_max)},
      {"--clock", options.clock, "node-ID of the real time clock of a taximeter",
       between(1U, id_max)},
  });
}

CarPanel::CarPanel(std::span<const cia447::CarUnit* const> units, const CarPanelOptions& options,
                   DeviceCar& car, Environment& environment, const DeviceOutput& output,
                   const Flash* flash)
    : options_(options),
      output_(output),
      flash_(flash),
      is_meter_(is_among(units, cia447::TaximeterKind::info.name)),
      is_gateway_(is_among(units, cia447::IvnGatewayKind::info.name)),
      car_(car),
      hands_(units,
             {.car = &car, .seal_is_open = &is_seal_open_, .calibration = options.calibration},
             output) {
  environment.provide(callback<&CarPanel::meter_hardware>(*this));
  environment.provide(callback<&CarPanel::meter_settings>(*this));
  environment.provide(callback<&CarPanel::printer>(*this));
  environment.provide(callback<&CarPanel::terminal>(*this));
  environment.provide(callback<&CarPanel::sign>(*this));
  environment.provide(callback<&CarPanel::alarm>(*this));
  environment.watch(callback<&CarPanel::has_network>(*this));
  environment.watch(callback<&CarPanel::has_master>(*this));
  hands_.join(environment);
}

void CarPanel::step(Node& node, Time now) {
  hands_.step(node, now);
  print_slip();
  if (std::exchange(told_seal_is_open_, is_seal_open_) == is_seal_open_) return;
  output_.say("taximeter", is_seal_open_ ? "the seal is open" : "the seal is closed");
}

void CarPanel::end() {
  if (auto* const meter = hands_.unit<cia447::TaximeterKind>()) meter->power_fails();
}

// The taximeter.

cia447::TaximeterHardware CarPanel::meter_hardware() {
  return {.clock = callback<&CarPanel::local_time>(*this),
          .seal_is_open = callback<&CarPanel::seal_is_open>(*this),
          .show = callback<&CarPanel::show_meter>(*this),
          .recorded = callback<&CarPanel::recorded>(*this),
          .turned_off = {},
          .flash = flash_};
}

cia447::TaximeterSettings CarPanel::meter_settings() {
  cia447::TaximeterSettings settings{.k = options_.k, .taxi_identifier = taxi_identifier};
  settings.clock_node = static_cast<NodeId>(options_.clock);
  using cia447::FareMode, cia447::TaximeterMode;
  if (options_.mode == "odometer") settings.mode = TaximeterMode::odometer_operation;
  if (options_.calculation == "double") settings.calculation = FareMode::double_calculation;
  const FutureTariff future = parse_future_tariff(options_.future_tariff);
  settings.future_from = future.from;
  settings.future_tariff = settings.tariff;
  settings.future_tariff.id = future.id;
  if (flash_ != nullptr) settings.memory = {.address = 0, .slot_size = flash_->sector_size};
  if (flash_ != nullptr && !is_gateway_) settings.audit_memory = CarStore::audit_place();
  return settings;
}

/// The first of repeated entries.
void CarPanel::recorded(const cia447::AuditEntry& entry) {
  if (entry.times != 1) return;
  output_.say("taximeter", fmt::format("recorded: {}", cia447::audit_text(entry).view()));
}

void CarPanel::has_network(cia447::CarNetwork& network, Node& /*node*/) {
  const bool has_outputs = options_.printer != 0 || options_.sign != 0;
  if (!is_meter_ || !has_outputs) return;
  outputs_.emplace(network,
                   cia447::MeterOutputs::Settings{.printer = static_cast<NodeId>(options_.printer),
                                                  .sign = static_cast<NodeId>(options_.sign)});
}

/// Reports each new state and each new fare.
void CarPanel::show_meter(const cia447::TaximeterDisplay& display) {
  if (outputs_) outputs_->show(display);
  if (state_ == cia447::Taximeter::stopped && display.state == cia447::Taximeter::for_hire) {
    print_receipt(display);
  }
  const bool is_on_shift = state_ == cia447::Taximeter::for_hire;
  if (is_on_shift && display.state == cia447::Taximeter::signed_off) has_slip_ = true;
  state_ = display.state;
  std::string text = taximeter_words(display.state);
  const bool has_trip =
      display.state == cia447::Taximeter::hired || display.state == cia447::Taximeter::stopped;
  if (has_trip && display.trip.total != cia447::TripData::unknown) {
    text += fmt::format(", {:.2f}", display.trip.total / money_unit);
  }
  if (text == told_) return;
  told_ = text;
  output_.say("taximeter", text);
}

void CarPanel::print_receipt(const cia447::TaximeterDisplay& display) {
  if (!outputs_) return;
  const auto* const meter = hands_.unit<cia447::TaximeterKind>();
  const cia447::Receipt receipt(display.trip,
                                {.number = ++receipts_,
                                 .head = paper_head,
                                 .kinds = meter->tariff().supplements,
                                 .of_kinds = meter->record().trip.supplements_of_kind});
  outputs_->print(receipt.text());
}

/// Prints after a receipt in progress.
void CarPanel::print_slip() {
  if (!has_slip_ || !outputs_ || outputs_->is_printing()) return;
  has_slip_ = false;
  const cia447::TaximeterRecord& record = hands_.unit<cia447::TaximeterKind>()->record();
  const std::optional<cia447::LocalTime> now = local_time();
  const cia447::ShiftSlip slip(
      record.shift, record.total,
      {.head = paper_head, .begin = record.shift_begin, .end = now ? now->utc() : cia447::no_time});
  outputs_->print(slip.text());
}

// The others.

cia447::PrinterHardware CarPanel::printer() {
  cia447::PrinterPaper paper;
  paper.put = callback<&CarPanel::put>(*this);
  paper.feed = callback<&CarPanel::feed>(*this);
  return {.paper = paper};
}
void CarPanel::put(const cia447::PrintedCharacter& printed) {
  constexpr char32_t last_ascii = 0x7E;
  line_ += printed.character <= last_ascii ? static_cast<char>(printed.character) : '?';
}
void CarPanel::feed(unsigned /*dots*/) {
  if (!line_.empty()) output_.say("printer", line_);
  line_.clear();
}

cia447::TerminalHardware CarPanel::terminal() {
  return {.show = callback<&CarPanel::show_text>(*this)};
}
void CarPanel::show_text(const cia447::DisplayContent& content) {
  std::string text(content.text);
  std::ranges::replace(text, '\n', '|');
  const unsigned number = content.display == cia447::TerminalDisplay::display_1 ? 1 : 2;
  output_.say("terminal",
              fmt::format("display {}: {}", number,
                          content.holder == 0 ? "of the car"
                                              : fmt::format("node {}: {}", content.holder, text)));
}

cia447::TariffDisplayHardware CarPanel::sign() {
  return {.drive = callback<&CarPanel::drive_lamp>(*this),
          .show_level = callback<&CarPanel::show_level>(*this)};
}
void CarPanel::show_level(const std::array<std::uint8_t, 2>& level) {
  std::string text;
  for (const std::uint8_t one : level) {
    if (one > ' ' && one < 0x7F) text += static_cast<char>(one);
  }
  output_.say("tariff-display", text.empty() ? "no level" : "level " + text);
}
void CarPanel::drive_lamp(unsigned lamp, cia447::Lamp wanted) {
  output_.say("tariff-display", fmt::format("lamp {} {}", lamp, lamp_words(wanted)));
}

cia447::TaxiAlarmHardware CarPanel::alarm() {
  return {.alarm = callback<&CarPanel::alarm_changed>(*this)};
}
void CarPanel::alarm_changed(bool silent, bool full) {
  output_.say("taxi-alarm", silent ? full ? "silent and full alarm" : "silent alarm"
                            : full ? "full alarm"
                                   : "no alarm");
}

void CarPanel::has_master(cia447::CarMaster& master, Node& /*node*/) {
  master.on_event(callback<&CarPanel::car_event>(*this));
}
/// Reported once while it lasts: a device without room sends its request repeatedly.
void CarPanel::car_event(const cia447::CarEvent& event) {
  const std::string text = car_event_words(event.kind, fmt::format("node {}", event.node));
  if (std::exchange(told_of_network_, text) != text) output_.say("ivn-gateway", text);
}

}  // namespace canvoy::tools
