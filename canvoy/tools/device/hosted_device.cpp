#include "canvoy/tools/device/hosted_device.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/catalogue/bootloader.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

LssOption::LssOption(const DeviceOutput& output, std::string who, Node& node,
                     const Settings& settings)
    : output_(output),
      who_(std::move(who)),
      node_(node),
      identity_(node, {.serial_number = settings.serial_number}),
      indicators_(settings.indicators),
      // In braces, since these are evaluated in order.
      slave_{node, hooks(settings),
             bit_timing_ ? bit_timing_->present() : std::uint8_t{lss_bit_timing::unknown}} {
  if (store_) store_->on_stored(LssStore::Stored::to<&LssSlave::stored>(slave_));
  service_.reset = callback<&LssOption::reset>(*this);
  node.attach(service_);
}

/// Makes the requested functions for the slave.
LssSlaveHooks LssOption::hooks(const Settings& settings) {
  LssSlaveHooks hooks;
  hooks.state_entered = callback<&LssOption::entered>(*this);
  if (settings.flash != nullptr) {
    hooks.store = store_.emplace(node_, *settings.flash, settings.place).hook();
  }
  if (settings.interface.empty()) return hooks;
  InterfaceBitTiming& timing = bit_timing_.emplace(
      settings.interface, [this](const std::string& line) { output_.say(who_, line); });
  const std::uint8_t stored = store_ ? store_->bit_timing() : lss_bit_timing::unknown;
  if (settings.takes_stored_bit_rate && lss_bit_timing::bit_rate(stored) != 0) {
    timing.switch_to(stored);
  }
  hooks.configure_bit_timing = callback<&InterfaceBitTiming::configure>(timing);
  hooks.activate_bit_timing = switch_.emplace(node_, callback<&LssOption::switch_to>(*this)).hook();
  return hooks;
}

void LssOption::reset(ResetScope) {
  told_ = node_.id();
  if (!is_node_id(node_.id())) output_.say(who_, "waits for a node-ID by LSS");
}

void LssOption::entered(LssState state) {
  if (indicators_ != nullptr) indicators_->lss_state_entered(state);
  if (state == LssState::configuration) return output_.say(who_, "LSS configuration");
  if (std::exchange(told_, node_.pending_id()) == node_.pending_id()) return;
  if (!is_node_id(node_.pending_id())) {
    return output_.say(who_, "has no node-ID from the next reset on");
  }
  output_.say(who_, fmt::format("{} {}", is_node_id(node_.id()) ? "at the next reset it is" : "is",
                                text::node_text(node_.pending_id())));
}

/// Sets the heartbeat period of the command line as power-on value of 1017h.
class HostedDevice::HeartbeatOption {
 public:
  HeartbeatOption(Node& node, unsigned period_ms) : node_(node), period_ms_(period_ms) {
    service_.reset = callback<&HeartbeatOption::reset>(*this);
    node.attach(service_);
  }

 private:
  void reset(ResetScope) {
    std::uint8_t bytes[2];
    store(bytes, static_cast<std::uint16_t>(period_ms_));
    node_.dictionary().write(object_index::heartbeat_producer, 0, bytes, Source::application);
  }

  Node& node_;
  unsigned period_ms_;
  Service service_;
};

/// Reports the state of its node.
class HostedDevice::StateTeller {
 public:
  StateTeller(const DeviceOutput& output, std::string who, Node& node)
      : output_(output), who_(std::move(who)) {
    service_.state_entered = callback<&StateTeller::entered>(*this);
    service_.bus_state_changed = callback<&StateTeller::bus_changed>(*this);
    node.attach(service_);
  }

 private:
  void entered(NmtState state) { output_.say(who_, text::nmt_state_text(state)); }
  void bus_changed(BusState state) {
    output_.say(who_, fmt::format("CAN controller {}", text::bus_state_text(state)));
  }

  const DeviceOutput& output_;
  std::string who_;
  Service service_;
};

HostedDevice::HostedDevice(const Wanted& wanted, const Port& port, DeviceHardware& hardware,
                           const DeviceOptions& options, const DeviceOutput& output)
    : output_(output),
      who_(is_node_id(wanted.id) ? fmt::format("{} {}", wanted.name, text::node_text(wanted.id))
                                 : wanted.name) {
  const bool is_bus = !wanted.bus_units().empty();
  const bool has_own_store = wanted.is_bootloader() || is_bus || !wanted.car_units().empty();
  const bool stores = !wanted.store.empty() && !has_own_store;
  if (wanted.sheet) {
    hold_sheet(wanted, port, stores);
  } else if (wanted.is_bootloader()) {
    hold_bootloader(wanted, port);
  } else if (is_bus) {
    hold_bus_device(wanted, port, hardware, options);
  } else {
    hold_device(wanted, port, hardware, options);
  }
  if (stores) store_ = std::make_unique<DeviceStore>(wanted.store, node());
  if (options.heartbeat_ms) {
    heartbeat_ = std::make_unique<HeartbeatOption>(node(), *options.heartbeat_ms);
  }
  if (wanted.answers_lss()) add_lss(options);
  teller_ = std::make_unique<StateTeller>(output_, who_, node());
  lights_ = std::make_unique<LightsTeller>(output_, who_, *indicators_);
}

HostedDevice::~HostedDevice() {
  if (car_panel_) car_panel_->end();
  if (bus_panel_) bus_panel_->end();
}

void HostedDevice::step(Time now) {
  if (wires_) wires_->step(node(), now);
  if (car_panel_) car_panel_->step(node(), now);
  if (bus_panel_) bus_panel_->step(node(), now);
  if (operator_panel_) operator_panel_->step(node(), now);
  lights_->look();
}

void HostedDevice::take(const std::string& order) {
  if (car_panel_) return car_panel_->take(order);
  if (bus_panel_) return bus_panel_->take(order);
  if (operator_panel_) return operator_panel_->take(order);
  if (wires_) return wires_->take(order);
  throw UsageError(fmt::format("'{}': there are no hands here", order));
}

OperatorPanel* HostedDevice::panel_with_hands() const {
  const bool has_hands = operator_panel_ && operator_panel_->hands_descriptor() >= 0;
  return has_hands ? operator_panel_.get() : nullptr;
}

void HostedDevice::start(Time now) {
  node_->start(now);
  say_what_was_kept();
}

void HostedDevice::say_what_was_kept() const {
  const std::string complaint = store_ ? store_->complaint() : "";
  if (!complaint.empty()) print_message(fmt::format("canvoy: {}", complaint));
}

/// The part of the command line that concerns this device, not others beside it.
template <class Panel>
void HostedDevice::take_options(const DeviceOptions& options, Panel& panel) {
  for (const std::string& order : orders_of(options)) {
    if (panel.has(order)) panel.take(order);
  }
}

void HostedDevice::hold_device(const Wanted& wanted, const Port& port, DeviceHardware& hardware,
                               const DeviceOptions& options) {
  put_in_place(environment_, options);
  const std::vector<const cia447::CarUnit*> car_units = wanted.car_units();
  environment_.keeps_parameters = !wanted.store.empty() && car_units.empty();
  if (car_units.empty()) {
    hardware.join(environment_);
    environment_.watch(callback<&HostedDevice::is_charger>(*this));
  } else {
    hardware.road_car().join(environment_);
  }
  if (wanted.is_operator()) {
    operator_panel_ =
        std::make_unique<OperatorPanel>(options.operator_panel, environment_, output_);
    take_options(options, *operator_panel_);
  } else if (car_units.empty()) {
    wires_ = std::make_unique<DeviceWires>(wanted.name, hardware, environment_, output_);
    take_options(options, *wires_);
  } else {
    if (!wanted.store.empty()) {
      car_store_ = std::make_unique<CarStore>(wanted.store);
      car_store_->join(environment_);
    }
    car_panel_ =
        std::make_unique<CarPanel>(car_units, options.car_panel, hardware.road_car(), environment_,
                                   output_, car_store_ ? &car_store_->flash() : nullptr);
    take_options(options, *car_panel_);
  }
  if (wanted.shared.empty()) {
    hold(std::make_shared<CatalogueDevice>(*wanted.kind, port, wanted.id, environment_));
    if (operator_panel_ && operator_panel_->program_store() != nullptr) {
      operator_panel_->program_store()->on_under_way(
          [this](bool is) { indicators_->program_under_way(is); });
    }
  } else {
    hold(std::make_shared<cia447::CarDevice>(wanted.shared.car, port, wanted.id, environment_));
  }
  cia447::IvnGatewayUnit* const gateway = car_panel_ ? car_panel_->gateway() : nullptr;
  if (gateway != nullptr && car_store_) gateway->seats().keep_in(car_store_->seats());
}

void HostedDevice::hold_bus_device(const Wanted& wanted, const Port& port,
                                   const DeviceHardware& hardware, const DeviceOptions& options) {
  put_in_place(environment_, options);
  if (!wanted.store.empty()) bus_store_ = std::make_unique<BusStore>(wanted.store);
  const std::vector<const cia407::BusUnit*> units = wanted.bus_units();
  const BusPanel::Place place = {hardware.road_car(), hardware.clock(), output_, bus_store_.get()};
  bus_panel_ =
      std::make_unique<BusPanel>(units, orders_of(options), options.bus_panel, environment_, place);
  hold(std::make_shared<cia407::BusDevice>(units, port, wanted.id, environment_));
}

template <class Device>
void HostedDevice::hold(const std::shared_ptr<Device>& device) {
  device_ = device;
  node_ = &device->node();
  indicators_ = std::make_shared<Indicators>(*node_, &device->emergency_producer());
}

void HostedDevice::is_charger(cia419::Charger& charger, Node& /*node*/) {
  charger_ = &charger;
  charger.on_event(callback<&HostedDevice::charger_said>(*this));
}

void HostedDevice::hold_bootloader(const Wanted& wanted, const Port& port) {
  const auto device = std::make_shared<Bootloader>(
      port, wanted.id, wanted.store,
      [this](const std::string& text) { output_.say("bootloader", text); });
  device_ = device;
  node_ = &device->node();
  indicators_ = {device, &device->indicators()};
}

void HostedDevice::hold_sheet(const Wanted& wanted, const Port& port, bool stores) {
  const formats::SheetDevice::Options device_options = {.further_routes = LssSlave::routes,
                                                        .stores_in_memory = !stores};
  const auto device =
      std::make_shared<formats::SheetDevice>(*wanted.sheet, port, wanted.id, device_options);
  hold(device);
  for (const formats::Finding& finding : device->left_out()) {
    print_message(fmt::format("canvoy: {}: it is left out", finding_text(wanted.name, finding)));
  }
  say_values_only(wanted.name, *device);
}

void HostedDevice::say_values_only(const std::string& kind, const formats::SheetDevice& device) {
  std::vector<std::string> places;
  for (const auto& range : device.without_behaviour()) {
    places.push_back(range.first == range.last
                         ? fmt::format("{:04X}h", range.first)
                         : fmt::format("{:04X}h to {:04X}h", range.first, range.last));
  }
  if (places.empty()) return;
  print_message(fmt::format("canvoy: {}: these are values here, and do nothing: {}", kind,
                            fmt::join(places, ", ")));
}

void HostedDevice::add_lss(const DeviceOptions& options) {
  LssOption::Settings settings;
  settings.serial_number = options.serial_number;
  settings.interface = options.interface;
  settings.indicators = indicators_.get();
  settings.takes_stored_bit_rate = options.bit_rate.empty();
  if (store_) {
    settings.flash = &store_->flash();
    settings.place = store_->lss_place();
  } else if (car_store_) {
    settings.flash = &car_store_->flash();
    settings.place = car_store_->lss_place();
  } else if (bus_store_) {
    settings.flash = &bus_store_->flash();
    settings.place = bus_store_->lss_place();
  }
  lss_ = std::make_unique<LssOption>(output_, who_, node(), settings);
}

void HostedDevice::charger_said(cia419::Charger::Event event) {
  const cia419::Charger& charger = *charger_;
  switch (event) {
    case cia419::Charger::Event::phase_changed:
      if (charger.battery() == 0) return;
      return output_.say("charger",
                         fmt::format("linked to {}", text::node_text(charger.battery())));
    case cia419::Charger::Event::reason_changed:
      return output_.say("charger", text::stop_reason_text(charger.reason()));
    case cia419::Charger::Event::charge_began:
      return output_.say("charger", "the charge begins");
    case cia419::Charger::Event::charge_ended:
      return output_.say("charger", fmt::format("the charge ends, {:.2f} Ah delivered",
                                                charger.ampere_hours_total()));
  }
}

}  // namespace canvoy::tools
