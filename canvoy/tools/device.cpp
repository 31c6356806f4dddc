// canvoy device KIND... --bus BUS: one or several devices, with simulated hardware, on a bus.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <chrono>
#include <csignal>
#include <deque>
#include <memory>
#include <optional>
#include <thread>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/bus_address.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/formats/sheet_device.hpp"
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/tools/bit_rate_search.hpp"
#include "canvoy/tools/bootloader.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/device_lift_car.hpp"
#include "canvoy/tools/device_lift_panel.hpp"
#include "canvoy/tools/device_lift_unit.hpp"
#include "canvoy/tools/device_output.hpp"
#include "canvoy/tools/device_store.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/lss_option.hpp"
#include "canvoy/tools/session.hpp"
#include "canvoy/tools/sheet_file.hpp"
#include "canvoy/tools/text.hpp"

namespace canvoy::tools {

namespace {

struct DeviceOptions {
  std::vector<std::string> kinds;
  std::vector<std::string> node_ids;
  std::vector<std::string> stores;
  std::string bus;
  std::string duration;
  std::optional<unsigned> heartbeat_ms;
  std::string bit_rate;
  double state_of_charge = 20;
  bool no_manage = false;
  bool json = false;
  std::optional<std::uint32_t> serial_number;
  LiftPanelOptions panel;
  LiftUnitOptions unit;
  std::string interface = {};  ///< of SocketCAN, of which LSS may set the bit rate
};

constexpr unsigned bit_rate_default = 125'000;

/// Of a simulated bus.
unsigned parse_bit_rate(const std::string& text) {
  if (text.empty()) return bit_rate_default;
  constexpr unsigned least = 10'000;
  constexpr unsigned most = 1'000'000;
  unsigned rate = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, rate);
  if (error == std::errc{} && stop == end && rate >= least && rate <= most) return rate;
  throw UsageError(fmt::format("--bit-rate: '{}' is none of a simulated bus: give {} to {} bit/s",
                               text, least, most));
}

/// The clock of this machine, in UTC.
std::optional<TimeOfDay> host_time() {
  return to_time_of_day(
      std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now()));
}

/// The hardware of the devices of this process. A charger and a battery are plugged together;
/// alone, each has a partner that does what was agreed on the bus.
class Hardware {
 public:
  Hardware(const DeviceOptions& options, Callback<Time()> clock)
      : plant_(BatteryPlant::lead_acid_48v(), options.state_of_charge / 100),
        car_(clock),
        units_(options.unit) {}

  cia419::ChargerHardware charger() {
    has_charger_ = true;
    cia419::ChargerHardware hardware = plant_.stage.hardware();
    hardware.time_of_day = {[](void*) { return host_time(); }, nullptr};
    return hardware;
  }
  cia418::BatteryHardware battery() { return plant_.battery.hardware(); }
  void partner_of(const cia418::Battery& battery) { battery_ = &battery; }
  LiftCar& car() { return car_; }
  LiftUnits& units() { return units_; }

  void step(Time now) {
    units_.step(now);
    if (has_charger_) return plant_.step();
    const bool flows = battery_ != nullptr && battery_->charger_ready();
    plant_.battery.step(flows ? plant_.battery.requested_ampere() : 0, ChargingPlant::step_time);
  }
  Callback<void(Time)> on_step() { return Callback<void(Time)>::to<&Hardware::step>(*this); }

 private:
  ChargingPlant plant_;
  LiftCar car_;
  LiftUnits units_;
  const cia418::Battery* battery_ = nullptr;
  bool has_charger_ = false;
};

/// The heartbeat period from the command line becomes the power-on value of 1017h.
class HeartbeatOption {
 public:
  HeartbeatOption(Node& node, unsigned period_ms) : node_(node), period_ms_(period_ms) {
    service_.reset = Callback<void(ResetScope)>::to<&HeartbeatOption::reset>(*this);
    node.attach(service_);
  }

 private:
  void reset(ResetScope) {
    std::uint8_t bytes[2];
    store(bytes, static_cast<std::uint16_t>(period_ms_));
    node_.dictionary().write(producer_heartbeat, 0, bytes, Source::application);
  }

  static constexpr std::uint16_t producer_heartbeat = 0x1017;
  Node& node_;
  unsigned period_ms_;
  Service service_;
};

/// Says what its node does.
class StateTeller {
 public:
  StateTeller(const DeviceOutput& output, std::string who, Node& node)
      : output_(output), who_(std::move(who)) {
    service_.state_entered = Callback<void(NmtState)>::to<&StateTeller::entered>(*this);
    service_.bus_state_changed = Callback<void(BusState)>::to<&StateTeller::bus_changed>(*this);
    node.attach(service_);
  }

 private:
  void entered(NmtState state) { output_.say(who_, nmt_state_text(state)); }
  void bus_changed(BusState state) {
    output_.say(who_, fmt::format("CAN controller {}", bus_state_text(state)));
  }

  const DeviceOutput& output_;
  std::string who_;
  Service service_;
};

bool is_lift_unit(const std::string& kind) {
  return lift_unit_node_id(kind, 1) != 0;
}
bool has_lss(const std::string& kind) {
  return kind != "bootloader" && kind != lift_controller_kind;
}

struct Wanted {
  std::string kind;
  NodeId id;
  std::string store;                                     ///< file; empty: nothing is kept
  std::shared_ptr<const formats::DataSheet> sheet = {};  ///< of a device that a file describes
};

/// The sheet of a device that is named by a file; null where the name is of another kind.
std::shared_ptr<const formats::DataSheet> sheet_of(const std::string& kind) {
  constexpr std::string_view endings[] = {".eds", ".dcf", ".xdd", ".xdc", ".xpd"};
  const bool is_file = std::ranges::any_of(endings, [&kind](std::string_view ending) {
    return kind.size() > ending.size() &&
           formats::same_letters(std::string_view(kind).substr(kind.size() - ending.size()),
                                 ending);
  });
  if (!is_file) return nullptr;
  formats::Findings findings;
  return std::make_shared<formats::DataSheet>(read_sheet_file(kind, findings));
}

/// The node-ID that a DCF gives, or 0.
NodeId node_id_in(const formats::DataSheet& sheet) {
  const auto id = formats::sheet_number(sheet.text("DeviceComissioning", "NodeID"));
  const bool is_id = id && id->number >= 1 && id->number <= 127;
  return is_id ? static_cast<NodeId>(id->number) : NodeId{0};
}

// Those who keep their parameters have the objects for it.
constexpr auto storing_charger = describe(cia419::full_charger, cia301::storage(storage_groups));
constexpr auto storing_charger_layout = lay_out_device<storing_charger>();
constexpr auto storing_battery = describe(cia418::full_battery, cia301::storage(storage_groups));
constexpr auto storing_battery_layout = lay_out_device<storing_battery>();

/// A device of either kind, with what watches it.
class HostedDevice {
 public:
  HostedDevice(const Wanted& wanted, const Port& port, Hardware& hardware,
               const DeviceOptions& options, const DeviceOutput& output)
      : output_(output),
        who_(is_node_id(wanted.id) ? fmt::format("{} {}", wanted.kind, node_text(wanted.id))
                                   : wanted.kind) {
    const bool is_bootloader = wanted.kind == "bootloader";
    const bool stores = !wanted.store.empty() && !is_bootloader;
    if (wanted.sheet) {
      hold_sheet(wanted, port, stores);
    } else if (is_bootloader) {
      const auto device = std::make_shared<Bootloader>(
          port, wanted.id, wanted.store,
          [this](const std::string& text) { output_.say("bootloader", text); });
      device_ = device;
      node_ = &device->node();
      indicators_ = {device, &device->indicators()};
    } else if (lift_node_id(wanted.kind) != 0) {
      hold_lift_device(make_lift_device(wanted.kind, wanted.id, port, hardware.car(), stores));
    } else if (is_lift_unit(wanted.kind)) {
      hold_lift_device(hardware.units().make(wanted.kind, wanted.id, port));
    } else if (is_lift_panel(wanted.kind)) {
      hold_panel(wanted, port, options);
    } else if (wanted.kind == "charger") {
      stores ? hold_charger<storing_charger_layout>(wanted.id, port, hardware, options)
             : hold_charger<cia419::full_charger_layout>(wanted.id, port, hardware, options);
    } else {
      stores ? hold_battery<storing_battery_layout>(wanted.id, port, hardware)
             : hold_battery<cia418::full_battery_layout>(wanted.id, port, hardware);
    }
    if (stores) store_ = std::make_unique<DeviceStore>(wanted.store, node());
    if (options.heartbeat_ms) {
      heartbeat_ = std::make_unique<HeartbeatOption>(node(), *options.heartbeat_ms);
    }
    if (has_lss(wanted.kind)) add_lss(options);
    teller_ = std::make_unique<StateTeller>(output_, who_, node());
    lights_ = std::make_unique<LightsTeller>(output_, who_, *indicators_);
  }

  Node& node() { return *node_; }
  /// To be called often.
  void step(Time now) {
    if (panel_) panel_->step(now);
    lights_->look();
  }
  void start(Time now) {
    node_->start(now);
    say_what_was_kept();
  }
  void say_what_was_kept() const {
    const std::string complaint = store_ ? store_->complaint() : "";
    if (!complaint.empty()) fmt::print(stderr, "canvoy: {}\n", complaint);
  }

 private:
  template <const auto& layout>
  void hold_charger(NodeId id, const Port& port, Hardware& hardware, const DeviceOptions& options) {
    cia419::ChargerSettings settings;
    settings.manage_network = !options.no_manage;
    const auto device = std::make_shared<cia419::ChargerDevice<layout, LssSlave::routes>>(
        port, id, hardware.charger(), settings);
    device_ = device;
    node_ = &device->node();
    indicators_ = std::make_shared<Indicators>(*node_, &device->emergency_producer());
    charger_ = &device->charger();
    charger_->on_event(
        Callback<void(cia419::Charger::Event)>::to<&HostedDevice::charger_said>(*this));
  }
  template <const auto& layout>
  void hold_battery(NodeId id, const Port& port, Hardware& hardware) {
    const auto device = std::make_shared<cia418::BatteryDevice<layout, LssSlave::routes>>(
        port, id, hardware.battery());
    device_ = device;
    node_ = &device->node();
    indicators_ = std::make_shared<Indicators>(*node_, &device->emergency_producer());
    hardware.partner_of(device->battery());
  }

  void hold_lift_device(const LiftDevice& made) {
    device_ = made.device;
    node_ = made.node;
    indicators_ = std::make_shared<Indicators>(*node_, made.emergencies);
  }

  void hold_panel(const Wanted& wanted, const Port& port, const DeviceOptions& options) {
    panel_ = std::make_shared<LiftPanel>(wanted.kind, port, wanted.id, options.panel, output_);
    device_ = panel_;
    node_ = &panel_->node();
    indicators_ = std::make_shared<Indicators>(*node_, &panel_->emergency_producer());
  }

  void hold_sheet(const Wanted& wanted, const Port& port, bool stores) {
    const formats::SheetDevice::Options device_options = {.further_routes = LssSlave::routes,
                                                          .stores_in_memory = !stores};
    const auto device =
        std::make_shared<formats::SheetDevice>(*wanted.sheet, port, wanted.id, device_options);
    device_ = device;
    node_ = &device->node();
    indicators_ = std::make_shared<Indicators>(*node_, &device->emergency_producer());
    for (const formats::Finding& finding : device->left_out()) {
      fmt::print(stderr, "canvoy: {}: it is left out\n", finding_text(wanted.kind, finding));
    }
    say_values_only(wanted.kind, *device);
  }

  static void say_values_only(const std::string& kind, const formats::SheetDevice& device) {
    std::vector<std::string> places;
    for (const auto& range : device.without_behaviour()) {
      places.push_back(range.first == range.last
                           ? fmt::format("{:04X}h", range.first)
                           : fmt::format("{:04X}h to {:04X}h", range.first, range.last));
    }
    if (places.empty()) return;
    fmt::print(stderr, "canvoy: {}: these are values here, and do nothing: {}\n", kind,
               fmt::join(places, ", "));
  }

  void add_lss(const DeviceOptions& options) {
    LssOption::Settings settings;
    settings.serial_number = options.serial_number;
    settings.interface = options.interface;
    settings.indicators = indicators_.get();
    if (store_) {
      settings.flash = &store_->flash();
      settings.place = store_->lss_place();
    }
    lss_ = std::make_unique<LssOption>(output_, who_, node(), settings);
  }

  void charger_said(cia419::Charger::Event event) {
    const cia419::Charger& charger = *charger_;
    switch (event) {
      case cia419::Charger::Event::phase_changed:
        if (charger.battery() == 0) return;
        return output_.say("charger", fmt::format("linked to {}", node_text(charger.battery())));
      case cia419::Charger::Event::reason_changed:
        return output_.say("charger", stop_reason_text(charger.reason()));
      case cia419::Charger::Event::charge_began:
        return output_.say("charger", "the charge begins");
      case cia419::Charger::Event::charge_ended:
        return output_.say("charger", fmt::format("the charge ends, {:.2f} Ah delivered",
                                                  charger.ampere_hours_total()));
    }
  }

  const DeviceOutput& output_;
  std::string who_;
  std::shared_ptr<void> device_;
  Node* node_ = nullptr;
  cia419::Charger* charger_ = nullptr;
  std::shared_ptr<LiftPanel> panel_;
  std::unique_ptr<DeviceStore> store_;
  std::unique_ptr<HeartbeatOption> heartbeat_;
  std::unique_ptr<LssOption> lss_;
  std::unique_ptr<StateTeller> teller_;
  std::shared_ptr<Indicators> indicators_;
  std::unique_ptr<LightsTeller> lights_;
};

std::vector<Wanted> wanted_devices(const DeviceOptions& options) {
  if (!options.node_ids.empty() && options.node_ids.size() != options.kinds.size()) {
    throw UsageError("give one --node-id for each device, or none");
  }
  if (!options.stores.empty() && options.stores.size() != options.kinds.size()) {
    throw UsageError("give one --store for each device, or none");
  }
  std::vector<Wanted> wanted;
  for (std::size_t i = 0; i < options.kinds.size(); ++i) {
    const std::string& kind = options.kinds[i];
    const std::shared_ptr<const formats::DataSheet> sheet = sheet_of(kind);
    const NodeId of_unit = lift_unit_node_id(kind, options.unit.door);
    const NodeId of_lift = of_unit != 0 ? of_unit : lift_node_id(kind);
    const bool is_panel = is_lift_panel(kind);
    const bool is_known = kind == "charger" || kind == "battery" || kind == "bootloader";
    if (!sheet && !is_known && !is_panel && of_lift == 0) {
      throw UsageError(
          fmt::format("'{}' is no device: charger, battery, lift-controller, lift-drive, "
                      "lift-position, lift-door, lift-light-barrier, lift-load, "
                      "lift-landing-panel, lift-car-panel, bootloader, "
                      "or a file .eds, .dcf, .xdd, .xdc or .xpd",
                      kind));
    }
    if (is_panel && !options.stores.empty()) throw UsageError("a lift panel keeps nothing");
    if (of_unit != 0 && !options.stores.empty()) {
      throw UsageError(fmt::format("a {} keeps nothing", kind));
    }
    if (kind == "bootloader" && options.stores.empty()) {
      throw UsageError("a bootloader wants --store FILE, as the place of its program");
    }
    const NodeId by_default = sheet               ? node_id_in(*sheet)
                              : of_lift != 0      ? of_lift
                              : kind == "charger" ? 5
                              : kind == "battery" ? 10
                              : is_panel          ? node_id_of_panel(kind)
                                                  : 20;
    if (options.node_ids.empty() && by_default == 0) {
      throw UsageError(fmt::format("{} gives no node-ID: say --node-id", kind));
    }
    const bool by_lss = !options.node_ids.empty() && options.node_ids[i] == "lss";
    if (by_lss && !has_lss(kind)) {
      throw UsageError(fmt::format("a {} gets no node-ID by LSS", kind));
    }
    const NodeId id = options.node_ids.empty() ? by_default
                      : by_lss                 ? node_id_unconfigured
                                               : parse_node_id(options.node_ids[i]);
    for (const Wanted& other : wanted) {
      if (!sheet && other.kind == kind) throw UsageError(fmt::format("one {} at a time", kind));
      if (by_lss) continue;
      if (other.id == id) throw UsageError(fmt::format("{} is given twice", node_text(id)));
    }
    wanted.push_back({kind, id, options.stores.empty() ? "" : options.stores[i], sheet});
  }
  return wanted;
}

Time end_of(const DeviceOptions& options, Time now) {
  return options.duration.empty() ? never : now + parse_duration_argument(options.duration);
}

/// On a real bus, driven by the event loop.
int run_on_host(const DeviceOptions& options, const std::vector<Wanted>& wanted,
                const DeviceOutput& output) {
  const auto loop = value_or_throw(host::EventLoop::create());
  const auto bus = value_or_throw(host::open_bus(*loop, options.bus));
  auto clock = [&loop] { return loop->now(); };
  Hardware hardware(options, Callback<Time()>::of(clock));
  std::deque<host::Attachment> attachments;
  std::deque<HostedDevice> devices;
  std::string trouble;
  bus->on_trouble([&](const host::Error& error) {
    if (trouble.empty()) fmt::print(stderr, "canvoy: {}\n", error.line());
    trouble = error.line();
  });
  for (const Wanted& device : wanted) {
    host::Attachment& attachment = attachments.emplace_back(*loop, *bus);
    HostedDevice& hosted =
        devices.emplace_back(device, attachment.port(), hardware, options, output);
    attachment.serve(hosted.node());
  }
  Time next_step = loop->now();
  host::Task plant{
      .deadline = Callback<Time()>([](void* at) { return *static_cast<Time*>(at); }, &next_step),
      .advance = {}};
  auto step = [&](Time now) {
    hardware.step(now);
    for (HostedDevice& device : devices) device.step(now);
    next_step = now + ChargingPlant::step_time;
  };
  plant.advance = Callback<void(Time)>::of(step);
  loop->add(plant);
  ok_or_throw(loop->stop_on_signals());
  for (HostedDevice& device : devices) device.start(loop->now());
  loop->run_until(end_of(options, loop->now()));
  // The attachments go before the nodes that they serve.
  attachments.clear();
  return exit_done;
}

volatile std::sig_atomic_t interrupted = 0;

/// On a simulated bus of this process, at the pace of the clock.
int run_simulated(const DeviceOptions& options, const std::vector<Wanted>& wanted,
                  const DeviceOutput& output) {
  World world;
  const BusIndex bus = world.add_bus({.bit_rate = parse_bit_rate(options.bit_rate)});
  Hardware hardware(options, Callback<Time()>::to<&World::now>(world));
  std::deque<HostedDevice> devices;
  std::vector<SlotIndex> slots;
  for (const Wanted& device : wanted) {
    const SlotIndex slot = world.add_slot(bus);
    HostedDevice& hosted =
        devices.emplace_back(device, world.port(slot), hardware, options, output);
    world.occupy(slot, hosted.node());
    slots.push_back(slot);
    world.start(slot);
    hosted.say_what_was_kept();
  }
  world.add_plant(hardware.on_step(), ChargingPlant::step_time);
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  const Time end = end_of(options, Time{});
  const auto begun = std::chrono::steady_clock::now();
  while (interrupted == 0 && world.now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const auto passed =
        std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - begun);
    world.run_until(std::min(end, Time(passed)));
    for (HostedDevice& device : devices) device.step(world.now());
    for (const SlotIndex slot : slots) world.touched(slot);
  }
  return exit_done;
}

int run_devices(const DeviceOptions& options) {
  const std::vector<Wanted> wanted = wanted_devices(options);
  const host::BusAddress address = [&] {
    host::Result<host::BusAddress> parsed = host::parse_bus_address(options.bus);
    if (!parsed) throw UsageError(parsed.error().line());
    return *std::move(parsed);
  }();
  end_of(options, Time{});
  for (const Wanted& device : wanted) {
    if (is_lift_panel(device.kind)) check_lift_panel(device.kind, options.panel);
  }
  const DeviceOutput output(options.json);
  if (address.kind == host::BusKind::simulated) return run_simulated(options, wanted, output);
  if (options.bit_rate == "auto" && address.kind == host::BusKind::socketcan) {
    const auto flicker = [&](bool under_way) {
      const Indication light = under_way ? Indication::flickering : Indication::off;
      for (const Wanted& device : wanted) output.lights(device.kind, light, light);
    };
    output.say(address.interface,
               fmt::format("{} bit/s", search_bit_rate(address.interface, flicker)));
  } else if (!options.bit_rate.empty()) {
    throw UsageError(
        "--bit-rate is for --bus sim; that of a CAN interface is set with ip link, or is auto");
  }
  DeviceOptions on_host = options;
  if (address.kind == host::BusKind::socketcan) on_host.interface = address.interface;
  return run_on_host(on_host, wanted, output);
}

void add_lift_panel_options(CLI::App& command, LiftPanelOptions& options) {
  command.add_option("--lift", options.lift, "of a lift panel: 1 to 8 (default 1)");
  command.add_option("--floor", options.floor, "where a landing panel hangs (default 1)");
  command.add_option("--floors", options.floors,
                     "of the building of a lift panel or controller (default 10)");
  command
      .add_option("--press", options.presses,
                  "a button of a lift panel and when: up@2s, down@2s; in a car 7@2s, open@2s, "
                  "close@2s")
      ->allow_extra_args(false);
}

}  // namespace

void add_device(CLI::App& app, Action& action) {
  const auto options = std::make_shared<DeviceOptions>();
  CLI::App* command = app.add_subcommand("device", "Put a device with simulated hardware on a bus");
  command
      ->add_option(
          "kind", options->kinds,
          "charger, battery, lift-controller, lift-drive, lift-position, lift-door, "
          "lift-light-barrier, lift-load, lift-landing-panel, lift-car-panel, bootloader, a data "
          "sheet (FILE.eds), or several")
      ->required();
  command->add_option("--bus", options->bus, "can0, vcan0, udp:239.74.163.2:43113, or sim")
      ->required();
  command
      ->add_option(
          "--node-id", options->node_ids,
          "10 or 0x0A, one for each device (default: charger 5, battery 10, lift-controller 1, "
          "lift-drive 2, lift-position 4, lift-door 6 to 8 and 12, lift-light-barrier 9, "
          "lift-load 13, lift-car-panel 16, lift-landing-panel 21, bootloader 20); lss: it waits "
          "for one by LSS")
      ->allow_extra_args(false);
  command->add_option("--serial-number", options->serial_number,
                      "of the identity, 1018h:04h: with it LSS tells equal devices apart");
  command
      ->add_option(
          "--store", options->stores,
          "file in which the device keeps its parameters (1010h, 1011h), one for each "
          "device; it is made where there is none. A node-ID that LSS has stored there goes "
          "before --node-id")
      ->allow_extra_args(false);
  command
      ->add_option("--heartbeat", options->heartbeat_ms,
                   "period in ms (default: as stored, else 1000)")
      ->check(CLI::Range(0U, 65'535U));
  command->add_option(
      "--bit-rate", options->bit_rate,
      "of a simulated bus, in bit/s (default 125000); that of a CAN interface is set "
      "with ip link, or auto: the device listens until it knows it (needs root)");
  command
      ->add_option("--state-of-charge", options->state_of_charge,
                   "of the battery at the start, in % (default 20)")
      ->check(CLI::Range(0.0, 100.0));
  add_lift_panel_options(*command, options->panel);
  add_lift_unit_options(*command, options->unit);
  command->add_option("--for", options->duration, "end after this time: 30s, 10min, 8h");
  command->add_flag("--json", options->json, "one JSON object a line");
  command->add_flag("--no-manage", options->no_manage,
                    "the charger leaves it to another NMT master to start the network");
  command->callback([options, &action] {
    options->unit.floors = options->panel.floors;
    action = [options] { return run_devices(*options); };
  });
}

}  // namespace canvoy::tools
