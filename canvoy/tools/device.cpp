// canvoy device KIND... --bus BUS: one or several devices, with simulated hardware, on a bus.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
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
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/session.hpp"
#include "canvoy/tools/text.hpp"

namespace canvoy::tools {

namespace {

struct DeviceOptions {
  std::vector<std::string> kinds;
  std::vector<std::string> node_ids;
  std::string bus;
  std::string duration;
  unsigned heartbeat_ms = 1000;
  std::optional<unsigned> bit_rate;
  double state_of_charge = 20;
  bool no_manage = false;
};

constexpr unsigned bit_rate_default = 125'000;

/// The hardware of the devices of this process. A charger and a battery are plugged together;
/// alone, each has a partner that does what was agreed on the bus.
class Hardware {
 public:
  explicit Hardware(double state_of_charge)
      : plant_(BatteryPlant::lead_acid_48v(), state_of_charge) {}

  cia419::ChargerHardware charger() {
    has_charger_ = true;
    return plant_.stage.hardware();
  }
  cia418::BatteryHardware battery() { return plant_.battery.hardware(); }
  void partner_of(const cia418::Battery& battery) { battery_ = &battery; }

  void step(Time) {
    if (has_charger_) return plant_.step();
    const bool flows = battery_ != nullptr && battery_->charger_ready();
    plant_.battery.step(flows ? plant_.battery.requested_ampere() : 0, ChargingPlant::step_time);
  }
  Callback<void(Time)> on_step() { return Callback<void(Time)>::to<&Hardware::step>(*this); }

 private:
  ChargingPlant plant_;
  const cia418::Battery* battery_ = nullptr;
  bool has_charger_ = false;
};

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

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
  StateTeller(std::string who, Node& node) : who_(std::move(who)) {
    service_.state_entered = Callback<void(NmtState)>::to<&StateTeller::entered>(*this);
    service_.bus_state_changed = Callback<void(BusState)>::to<&StateTeller::bus_changed>(*this);
    node.attach(service_);
  }

 private:
  void entered(NmtState state) { say(fmt::format("{}: {}", who_, nmt_state_text(state))); }
  void bus_changed(BusState state) {
    say(fmt::format("{}: CAN controller {}", who_, bus_state_text(state)));
  }

  std::string who_;
  Service service_;
};

/// A device of either kind, with what watches it.
class HostedDevice {
 public:
  HostedDevice(const std::string& kind, NodeId id, const Port& port, Hardware& hardware,
               const DeviceOptions& options) {
    const std::string who = fmt::format("{} {}", kind, node_text(id));
    if (kind == "charger") {
      cia419::ChargerSettings settings;
      settings.manage_network = !options.no_manage;
      charger_ = std::make_unique<cia419::ChargerDevice<>>(port, id, hardware.charger(), settings);
      charger_->charger().on_event(
          Callback<void(cia419::Charger::Event)>::to<&HostedDevice::charger_said>(*this));
    } else {
      battery_ = std::make_unique<cia418::BatteryDevice<>>(port, id, hardware.battery());
      hardware.partner_of(battery_->battery());
    }
    heartbeat_ = std::make_unique<HeartbeatOption>(node(), options.heartbeat_ms);
    teller_ = std::make_unique<StateTeller>(who, node());
  }

  Node& node() { return charger_ ? charger_->node() : battery_->node(); }

 private:
  void charger_said(cia419::Charger::Event event) {
    const cia419::Charger& charger = charger_->charger();
    switch (event) {
      case cia419::Charger::Event::phase_changed:
        if (charger.battery() != 0)
          say(fmt::format("charger: linked to {}", node_text(charger.battery())));
        return;
      case cia419::Charger::Event::reason_changed:
        return say(fmt::format("charger: {}", stop_reason_text(charger.reason())));
      case cia419::Charger::Event::charge_began:
        return say("charger: the charge begins");
      case cia419::Charger::Event::charge_ended:
        return say(fmt::format("charger: the charge ends, {:.2f} Ah delivered",
                               charger.ampere_hours_total()));
    }
  }

  std::unique_ptr<cia419::ChargerDevice<>> charger_;
  std::unique_ptr<cia418::BatteryDevice<>> battery_;
  std::unique_ptr<HeartbeatOption> heartbeat_;
  std::unique_ptr<StateTeller> teller_;
};

struct Wanted {
  std::string kind;
  NodeId id;
};

std::vector<Wanted> wanted_devices(const DeviceOptions& options) {
  if (!options.node_ids.empty() && options.node_ids.size() != options.kinds.size()) {
    throw UsageError("give one --node-id for each device, or none");
  }
  std::vector<Wanted> wanted;
  for (std::size_t i = 0; i < options.kinds.size(); ++i) {
    const std::string& kind = options.kinds[i];
    if (kind != "charger" && kind != "battery") {
      throw UsageError(fmt::format("'{}' is no device: charger or battery", kind));
    }
    const NodeId by_default = kind == "charger" ? 5 : 10;
    const NodeId id = options.node_ids.empty() ? by_default : parse_node_id(options.node_ids[i]);
    for (const Wanted& other : wanted) {
      if (other.kind == kind) throw UsageError(fmt::format("one {} at a time", kind));
      if (other.id == id) throw UsageError(fmt::format("{} is given twice", node_text(id)));
    }
    wanted.push_back({kind, id});
  }
  return wanted;
}

Time end_of(const DeviceOptions& options, Time now) {
  return options.duration.empty() ? never : now + parse_duration_argument(options.duration);
}

/// On a real bus, driven by the event loop.
int run_on_host(const DeviceOptions& options, const std::vector<Wanted>& wanted) {
  const auto loop = value_or_throw(host::EventLoop::create());
  const auto bus = value_or_throw(host::open_bus(*loop, options.bus));
  Hardware hardware(options.state_of_charge / 100);
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
        devices.emplace_back(device.kind, device.id, attachment.port(), hardware, options);
    attachment.serve(hosted.node());
  }
  Time next_step = loop->now();
  host::Task plant{
      .deadline = Callback<Time()>([](void* at) { return *static_cast<Time*>(at); }, &next_step),
      .advance = {}};
  auto step = [&](Time now) {
    hardware.step(now);
    next_step = now + ChargingPlant::step_time;
  };
  plant.advance = Callback<void(Time)>::of(step);
  loop->add(plant);
  ok_or_throw(loop->stop_on_signals());
  for (HostedDevice& device : devices) device.node().start(loop->now());
  loop->run_until(end_of(options, loop->now()));
  // The attachments go before the nodes that they serve.
  attachments.clear();
  return exit_done;
}

volatile std::sig_atomic_t interrupted = 0;

/// On a simulated bus of this process, at the pace of the clock.
int run_simulated(const DeviceOptions& options, const std::vector<Wanted>& wanted) {
  World world;
  const BusIndex bus = world.add_bus({.bit_rate = options.bit_rate.value_or(bit_rate_default)});
  Hardware hardware(options.state_of_charge / 100);
  std::deque<HostedDevice> devices;
  for (const Wanted& device : wanted) {
    const SlotIndex slot = world.add_slot(bus);
    HostedDevice& hosted =
        devices.emplace_back(device.kind, device.id, world.port(slot), hardware, options);
    world.occupy(slot, hosted.node());
    world.start(slot);
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
  if (address.kind == host::BusKind::simulated) return run_simulated(options, wanted);
  if (options.bit_rate) {
    throw UsageError("--bit-rate is for --bus sim; that of a CAN interface is set with ip link");
  }
  return run_on_host(options, wanted);
}

}  // namespace

void add_device(CLI::App& app, Action& action) {
  const auto options = std::make_shared<DeviceOptions>();
  CLI::App* command = app.add_subcommand("device", "Put a device with simulated hardware on a bus");
  command->add_option("kind", options->kinds, "charger, battery, or both")->required();
  command->add_option("--bus", options->bus, "can0, vcan0, udp:239.74.163.2:43113, or sim")
      ->required();
  command
      ->add_option("--node-id", options->node_ids,
                   "10 or 0x0A, one for each device (default: charger 5, battery 10)")
      ->allow_extra_args(false);
  command->add_option("--heartbeat", options->heartbeat_ms, "period in ms (default 1000)")
      ->check(CLI::Range(0U, 65'535U));
  command
      ->add_option("--bit-rate", options->bit_rate,
                   "of a simulated bus, in bit/s (default 125000); that of a CAN interface is set "
                   "with ip link")
      ->check(CLI::Range(10'000U, 1'000'000U));
  command
      ->add_option("--state-of-charge", options->state_of_charge,
                   "of the battery at the start, in % (default 20)")
      ->check(CLI::Range(0.0, 100.0));
  command->add_option("--for", options->duration, "end after this time: 30s, 10min, 8h");
  command->add_flag("--no-manage", options->no_manage,
                    "the charger leaves it to another NMT master to start the network");
  command->callback([options, &action] { action = [options] { return run_devices(*options); }; });
}

}  // namespace canvoy::tools
