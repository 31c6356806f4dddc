#include "canvoy/tools/device/device_car_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "canvoy/devices/cia447/taximeter/receipt.hpp"
#include "canvoy/tools/car_words.hpp"
#include "canvoy/tools/device/car_store.hpp"
#include "canvoy/tools/device/device_car.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr double money_unit = 1000;  ///< 60D0h counts thousandths

struct CarKey {
  std::string_view device;
  std::string_view name;
};
constexpr CarKey car_keys[] = {{"taximeter", "sign-on"},
                               {"taximeter", "hire"},
                               {"taximeter", "stop"},
                               {"taximeter", "for-hire"},
                               {"taximeter", "sign-off"},
                               {"taximeter", "open-seal"},
                               {"taximeter", "enter-service"},
                               {"taximeter", "begin-calibration"},
                               {"taximeter", "end-calibration"},
                               {"taximeter", "close-seal"},
                               {"taximeter", "leave-service"},
                               {"taxi-alarm", "alarm"},
                               {"taxi-alarm", "reset"}};

bool is_among(std::span<const cia447::CarUnit* const> units, std::string_view name) {
  return std::ranges::any_of(
      units, [name](const cia447::CarUnit* unit) { return unit->info.name == name; });
}

bool has_key(std::span<const cia447::CarUnit* const> units, std::string_view name) {
  return std::ranges::any_of(
      car_keys, [&](const CarKey& key) { return key.name == name && is_among(units, key.device); });
}

}  // namespace

void check_car_presses(std::span<const cia447::CarUnit* const> units,
                       const std::vector<std::string>& presses) {
  for (const std::string& text : presses) {
    const std::size_t at = text.find('@');
    if (at != std::string::npos && has_key(units, text.substr(0, at))) {
      parse_duration_argument(text.substr(at + 1));
      continue;
    }
    std::string names;
    for (const CarKey& key : car_keys) {
      if (!is_among(units, key.device)) continue;
      names += fmt::format("{}{}@2s", names.empty() ? "" : ", ", key.name);
    }
    throw UsageError(fmt::format("--press: '{}' is no key with a time: {}", text,
                                 names.empty() ? "there is none here" : "write " + names));
  }
}

void add_car_panel_options(Verb& command, CarPanelOptions& options) {
  constexpr unsigned id_max = cia447::node_id_max;
  command.add({
      {"--k", options.k, "of a taximeter: pulses for a kilometre (default 24000)",
       between(1U, 10'000'000U)},
      {"--calibration", options.calibration,
       "of a taximeter: how long its calibration drive is, in 0.001 km (default 1000)",
       between(100U, 100'000U)},
      {"--printer", options.printer, "node-ID of the printer of a taximeter", between(1U, id_max)},
      {"--sign", options.sign, "node-ID of the tariff display of a taximeter", between(1U, id_max)},
      {"--clock", options.clock, "node-ID of the real time clock of a taximeter",
       between(1U, id_max)},
  });
}

CarPanel::CarPanel(std::span<const cia447::CarUnit* const> units,
                   const std::vector<std::string>& presses, const CarPanelOptions& options,
                   Site& site, const DeviceOutput& output, const Flash* flash)
    : options_(options),
      output_(output),
      flash_(flash),
      is_meter_(is_among(units, cia447::TaximeterKind::info.name)),
      is_gateway_(is_among(units, cia447::IvnGatewayKind::info.name)) {
  for (const std::string& text : presses) {
    const std::size_t at = text.find('@');
    if (!has_key(units, text.substr(0, at))) continue;
    presses_.push_back({text.substr(0, at), parse_duration_argument(text.substr(at + 1))});
  }
  site.offer(Callback<cia447::TaximeterHardware()>::to<&CarPanel::meter_hardware>(*this));
  site.offer(Callback<cia447::TaximeterSettings()>::to<&CarPanel::meter_settings>(*this));
  site.offer(Callback<cia447::PrinterHardware()>::to<&CarPanel::printer>(*this));
  site.offer(Callback<cia447::TerminalHardware()>::to<&CarPanel::terminal>(*this));
  site.offer(Callback<cia447::TariffDisplayHardware()>::to<&CarPanel::sign>(*this));
  site.offer(Callback<cia447::TaxiAlarmHardware()>::to<&CarPanel::alarm>(*this));
  site.watch(Callback<void(cia447::TaximeterUnit&, Node&)>::to<&CarPanel::has_meter>(*this));
  site.watch(Callback<void(cia447::TaxiAlarmUnit&, Node&)>::to<&CarPanel::has_alarm>(*this));
  site.watch(Callback<void(cia447::CarNetwork&, Node&)>::to<&CarPanel::has_network>(*this));
  site.watch(Callback<void(cia447::CarMaster&, Node&)>::to<&CarPanel::has_master>(*this));
}

void CarPanel::step(Time now) {
  const Time begin = begin_.value_or(now);
  begin_ = begin;
  for (Press& each : presses_) {
    if (each.is_done || now - begin < each.at) continue;
    each.is_done = true;
    press(each.key);
  }
}

void CarPanel::end() {
  if (meter_ != nullptr) meter_->power_fails();
}

void CarPanel::press(const std::string& key) {
  if (key == "alarm" || key == "reset") {
    if (alarm_ == nullptr) return;
    if (key == "reset") return alarm_->reset_alarm();
    alarm_->press_key(true);
    return alarm_->press_key(false);
  }
  if (meter_ == nullptr) return;
  if (key == "open-seal" || key == "close-seal") return open_seal(key == "open-seal");
  if (!press_at_meter(key)) output_.say("taximeter", fmt::format("{}: not in this state", key));
}

bool CarPanel::press_at_meter(const std::string& key) {
  if (key == "end-calibration") return meter_->end_calibration(options_.calibration);
  struct Press {
    std::string_view key;
    bool (cia447::TaximeterUnit::*press)();
  };
  using Meter = cia447::TaximeterUnit;
  constexpr Press keys[] = {{"sign-on", &Meter::sign_on},
                            {"hire", &Meter::hire},
                            {"stop", &Meter::stop},
                            {"for-hire", &Meter::for_hire},
                            {"sign-off", &Meter::sign_off},
                            {"enter-service", &Meter::enter_service},
                            {"begin-calibration", &Meter::begin_calibration},
                            {"leave-service", &Meter::leave_service}};
  const auto* const found = std::ranges::find(keys, key, &Press::key);
  return found != std::end(keys) && (meter_->*found->press)();
}

void CarPanel::open_seal(bool is_open) {
  is_seal_open_ = is_open;
  output_.say("taximeter", is_open ? "the seal is open" : "the seal is closed");
}

// The taximeter.

cia447::TaximeterHardware CarPanel::meter_hardware() {
  return {.clock = {[](void*) -> std::optional<cia447::LocalTime> { return host_local_time(); },
                    nullptr},
          .seal_is_open = Callback<bool()>::to<&CarPanel::seal_is_open>(*this),
          .show = Callback<void(const cia447::TaximeterDisplay&)>::to<&CarPanel::show_meter>(*this),
          .recorded = Callback<void(const cia447::AuditEntry&)>::to<&CarPanel::recorded>(*this),
          .turned_off = {},
          .flash = flash_};
}

cia447::TaximeterSettings CarPanel::meter_settings() {
  cia447::TaximeterSettings settings{.k = options_.k};
  settings.clock_node = static_cast<NodeId>(options_.clock);
  if (flash_ != nullptr) settings.memory = {.address = 0, .slot_size = flash_->sector_size};
  if (flash_ != nullptr && !is_gateway_) settings.audit_memory = CarStore::audit_place();
  return settings;
}

/// Of what is repeated the first time.
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

/// Each new state, and each new fare.
void CarPanel::show_meter(const cia447::TaximeterDisplay& display) {
  if (outputs_) outputs_->show(display);
  if (state_ == cia447::Taximeter::stopped && display.state == cia447::Taximeter::for_hire) {
    print_receipt(display);
  }
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
  const cia447::Receipt receipt(
      display.trip,
      {.number = ++receipts_, .taxi = "Canvoy", .currency = "EUR", .distance_unit = "km"});
  outputs_->print(receipt.text());
}

// The others.

cia447::PrinterHardware CarPanel::printer() {
  cia447::PrinterPaper paper;
  paper.put = Callback<void(const cia447::PrintedCharacter&)>::to<&CarPanel::put>(*this);
  paper.feed = Callback<void(unsigned)>::to<&CarPanel::feed>(*this);
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
  return {.show = Callback<void(const cia447::DisplayContent&)>::to<&CarPanel::show_text>(*this)};
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
  return {.drive = Callback<void(unsigned, cia447::Lamp)>::to<&CarPanel::drive_lamp>(*this)};
}
void CarPanel::drive_lamp(unsigned lamp, cia447::Lamp wanted) {
  output_.say("tariff-display", fmt::format("lamp {} {}", lamp, lamp_words(wanted)));
}

cia447::TaxiAlarmHardware CarPanel::alarm() {
  return {.alarm = Callback<void(bool, bool)>::to<&CarPanel::alarm_changed>(*this)};
}
void CarPanel::alarm_changed(bool silent, bool full) {
  output_.say("taxi-alarm", silent ? full ? "silent and full alarm" : "silent alarm"
                            : full ? "full alarm"
                                   : "no alarm");
}

void CarPanel::has_master(cia447::CarMaster& master, Node& /*node*/) {
  master.on_event(Callback<void(const cia447::CarEvent&)>::to<&CarPanel::car_event>(*this));
}
/// Once, while it stays so: a device for which there is no room asks again and again.
void CarPanel::car_event(const cia447::CarEvent& event) {
  const std::string text = car_event_words(event.kind, fmt::format("node {}", event.node));
  if (std::exchange(told_of_network_, text) != text) output_.say("ivn-gateway", text);
}

}  // namespace canvoy::tools
