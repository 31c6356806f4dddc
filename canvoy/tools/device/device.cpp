// canvoy device KIND... BUS: one or several devices, with simulated hardware, on a bus.
#include <fmt/format.h>

#include <chrono>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/bus_address.hpp"
#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/profiles/cia417.hpp"
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/bit_rate_text.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/interruption.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/device/bit_rate_search.hpp"
#include "canvoy/tools/device/catalogue/device_catalogue.hpp"
#include "canvoy/tools/device/catalogue/operator_elements.hpp"
#include "canvoy/tools/device/device_hardware.hpp"
#include "canvoy/tools/device/device_options.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"
#include "canvoy/tools/device/hand/hand_lines.hpp"
#include "canvoy/tools/device/hand_list.hpp"
#include "canvoy/tools/device/hosted_device.hpp"
#include "canvoy/tools/device/seat/seat_hands.hpp"
#include "canvoy/tools/device/wired_hands.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

namespace {

constexpr unsigned bit_rate_default = 125'000;
constexpr std::string_view car_panel_name = "lift-car-panel";
constexpr unsigned car_panel_floors_max = 64;
constexpr unsigned floors_max = 254;
constexpr unsigned bus_doors_max = 12;  ///< for CiA 407

/// Bit rate of a simulated bus.
unsigned simulated_bit_rate(const std::string& text) {
  if (text.empty()) return bit_rate_default;
  constexpr unsigned least = 10'000;
  constexpr unsigned most = 1'000'000;
  const std::optional<std::uint32_t> rate = parse_bit_rate(text);
  if (rate && *rate >= least) return *rate;
  throw UsageError(fmt::format("--bit-rate: '{}' is none of a simulated bus: give {} to {} bit/s",
                               text, least, most));
}

/// The sheet of a device that is given as a file; null for a name of another kind.
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

void check_place(const DeviceOptions& options) {
  const auto check = [](const char* option, unsigned value, unsigned least, unsigned most) {
    if (value >= least && value <= most) return;
    throw UsageError(fmt::format("{}: {} to {}", option, least, most));
  };
  const bool is_car_panel = std::ranges::find(options.kinds, car_panel_name) != options.kinds.end();
  check("--lift", options.lift, 1, cia417::lift_count);
  const auto is_of_bus = [](const std::string& kind) {
    return kind.find("passenger-counter") != std::string::npos;
  };
  const bool has_bus_doors = std::ranges::any_of(options.kinds, is_of_bus);
  check("--door", options.door, 1, has_bus_doors ? bus_doors_max : cia417::door_count);
  check("--floors", options.floors, 2, is_car_panel ? car_panel_floors_max : floors_max);
  check("--floor", options.floor, 1, options.floors);
}

/// The device with this name, without a node-ID.
Wanted find_wanted(const std::string& name, bool stores) {
  Wanted wanted{.name = name, .kind = find_any_device_kind(name), .sheet = sheet_of(name)};
  if (wanted.sheet) return wanted;
  wanted.shared = parse_shared_node(name);
  if (!wanted.shared.empty()) return wanted;
  if (wanted.kind == nullptr) {
    throw UsageError(
        fmt::format("'{}' is no device of `canvoy device --list`, nor a file .eds, .dcf, .xdd, "
                    ".xdc or .xpd{}",
                    name, did_you_mean(name, all_device_names())));
  }
  const bool has_own_store = wanted.kind->car_unit != nullptr || wanted.kind->bus_unit != nullptr;
  if (stores && !has_own_store && wanted.kind->keeping_forms.empty()) {
    throw UsageError(fmt::format("a {} keeps nothing", name));
  }
  if (wanted.is_bootloader() && !stores) {
    throw UsageError("a bootloader wants --store FILE, as the place of its program");
  }
  return wanted;
}

NodeId wanted_node_id(const Wanted& wanted, const DeviceOptions& options, std::size_t position) {
  if (!options.node_ids.empty()) {
    const std::string& text = options.node_ids[position];
    if (text != "lss") return parse_node_id(text);
    if (wanted.answers_lss()) return node_id_unconfigured;
    throw UsageError(fmt::format("a {} gets no node-ID by LSS", wanted.name));
  }
  Environment environment;
  put_in_place(environment, options);
  const NodeId id = wanted.sheet                 ? wanted.sheet->node_id()
                    : !wanted.shared.car.empty() ? wanted.shared.car.front()->info.node_id
                    : !wanted.shared.bus.empty() ? wanted.shared.bus.front()->info.node_id
                                                 : wanted.kind->node_id(environment);
  if (id == 0) throw UsageError(fmt::format("{} gives no node-ID: say --node-id", wanted.name));
  return id;
}

std::vector<Wanted> wanted_devices(const DeviceOptions& options) {
  if (!options.node_ids.empty() && options.node_ids.size() != options.kinds.size()) {
    throw UsageError("give one --node-id for each device, or none");
  }
  if (!options.stores.empty() && options.stores.size() != options.kinds.size()) {
    throw UsageError("give one --store for each device, or none");
  }
  std::vector<Wanted> all;
  for (std::size_t i = 0; i < options.kinds.size(); ++i) {
    Wanted wanted = find_wanted(options.kinds[i], !options.stores.empty());
    wanted.id = wanted_node_id(wanted, options, i);
    if (!options.stores.empty()) wanted.store = options.stores[i];
    for (const Wanted& other : all) {
      if (!wanted.sheet && other.name == wanted.name) {
        throw UsageError(fmt::format("one {} at a time", wanted.name));
      }
      if (is_node_id(wanted.id) && other.id == wanted.id) {
        throw UsageError(fmt::format("{} is given twice", text::node_text(wanted.id)));
      }
    }
    all.push_back(std::move(wanted));
  }
  return all;
}

/// A line applies to the first device that has the hand.
void take_line(std::deque<HostedDevice>& devices, const std::string& order) {
  std::optional<UsageError> complaint;
  for (HostedDevice& device : devices) {
    try {
      return device.take(order);
    } catch (const UsageError& error) {
      if (!complaint) complaint = error;
    }
  }
  if (complaint) throw UsageError(*complaint);
}

/// Lines of standard input, if requested.
class HandInput {
 public:
  HandInput(const DeviceOptions& options, std::deque<HostedDevice>& devices)
      : is_wanted_(options.reads_lines), devices_(devices) {}

  void step(Time now) {
    if (!begin_) begin_ = now;
    if (!is_wanted_) return;
    lines_.read([this](const std::string& order) { take_line(devices_, order); }, now - *begin_);
  }
  int status() const { return lines_.has_failed() ? exit_failed : exit_done; }

 private:
  bool is_wanted_;
  std::deque<HostedDevice>& devices_;
  HandLines lines_;
  std::optional<Time> begin_;
};

Time end_of(const DeviceOptions& options, Time now) {
  return options.duration.empty() ? never : now + parse_duration_argument(options.duration);
}

/// Serves hands as soon as they move.
class HandsWatch {
 public:
  HandsWatch(host::EventLoop& loop, OperatorPanel& panel) : loop_(loop), panel_(panel) {
    value_or_throw(loop.watch(panel.hands_descriptor(), {.readable = true},
                              host::EventLoop::Ready::to<&HandsWatch::ready>(*this)));
  }
  HandsWatch(const HandsWatch&) = delete;
  HandsWatch& operator=(const HandsWatch&) = delete;

 private:
  void ready(host::Readiness /*how*/) { panel_.serve_hands(loop_.now()); }

  host::EventLoop& loop_;
  OperatorPanel& panel_;
};

/// Runs on a real bus, driven by the event loop.
int run_on_host(const DeviceOptions& options, const std::vector<Wanted>& wanted,
                const DeviceOutput& output) {
  const auto loop = value_or_throw(host::EventLoop::create());
  const auto bus = value_or_throw(host::open_bus(*loop, options.bus));
  auto clock = [&loop] { return loop->now(); };
  DeviceHardware hardware(options, Callback<Time()>::of(clock), output);
  std::deque<host::Attachment> attachments;
  std::deque<HostedDevice> devices;
  std::optional<EmbeddedNetwork> embedded;
  std::string trouble;
  bus->on_trouble([&](const host::Error& error) {
    if (trouble.empty()) print_message(fmt::format("canvoy: {}", error.line()));
    trouble = error.line();
  });
  for (const Wanted& device : wanted) {
    host::Attachment& attachment = attachments.emplace_back(*loop, *bus);
    HostedDevice& hosted =
        devices.emplace_back(device, attachment.port(), hardware, options, output);
    if (device.is_operator() && !options.embedded.bus.empty()) {
      embedded.emplace(*loop, hosted.node(), options.embedded);
      attachment.attach(embedded->access());
    } else {
      attachment.attach(hosted.node());
    }
  }
  std::optional<HandsWatch> hands;
  for (HostedDevice& device : devices) {
    if (OperatorPanel* panel = device.panel_with_hands()) hands.emplace(*loop, *panel);
  }
  Time next_step = loop->now();
  host::Task plant{
      .deadline = Callback<Time()>([](void* at) { return *static_cast<Time*>(at); }, &next_step),
      .advance = {}};
  HandInput lines(options, devices);
  auto step = [&](Time now) {
    lines.step(now);
    hardware.step(now);
    for (HostedDevice& device : devices) device.step(now);
    next_step = now + ChargingPlant::step_time;
  };
  plant.advance = Callback<void(Time)>::of(step);
  loop->add(plant);
  ok_or_throw(loop->stop_on_signals());
  for (HostedDevice& device : devices) device.start(loop->now());
  loop->run_until(end_of(options, loop->now()));
  // The attachments are destroyed before the nodes that they serve.
  attachments.clear();
  return lines.status();
}

/// Runs on a simulated bus of this process, at the speed of the clock.
int run_simulated(const DeviceOptions& options, const std::vector<Wanted>& wanted,
                  const DeviceOutput& output) {
  World world;
  const BusIndex bus = world.add_bus({.bit_rate = simulated_bit_rate(options.bit_rate)});
  DeviceHardware hardware(options, callback<&World::now>(world), output);
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
  heed_interruption();
  HandInput lines(options, devices);
  const Time end = end_of(options, Time{});
  const auto begun = std::chrono::steady_clock::now();
  while (!is_interrupted() && world.now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const auto passed =
        std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - begun);
    world.run_until(std::min(end, Time(passed)));
    lines.step(world.now());
    for (HostedDevice& device : devices) device.step(world.now());
    for (const SlotIndex slot : slots) world.touched(slot);
  }
  return lines.status();
}

/// The hands of all devices with tables of hands; for those of a bus, see BusPress.
class WantedHands {
 public:
  WantedHands(const std::vector<Wanted>& wanted, const DeviceOptions& options) {
    Environment environment;
    put_in_place(environment, options);
    for (const Wanted& device : wanted) {
      const std::vector<const cia447::CarUnit*> units = device.car_units();
      for (const HandTable& table : hand_tables(units)) tables_.push_back(table);
      if (!units.empty()) continue;
      hands_.push_back(device.is_operator()
                           ? seat_hands(parse_operator_elements(options.operator_panel.elements))
                           : wired_hands(device.name, environment));
      tables_.push_back({device.name, hands_.back()});
    }
  }
  std::span<const HandTable> tables() const { return tables_; }

 private:
  std::deque<std::vector<DeviceHand>> hands_;
  std::vector<HandTable> tables_;
};

void check_operator(const DeviceOptions& options, bool is_there, const DeviceOutput& output) {
  const auto check_owner = [is_there](const char* option, bool is_given) {
    if (!is_given || is_there) return;
    throw UsageError(fmt::format("{} is of an operator: there is none here", option));
  };
  check_owner("--move", !options.operator_panel.moves.empty());
  check_owner("--elements", !options.operator_panel.elements.empty());
  check_owner("--joystick", !options.operator_panel.hands.empty());
  check_owner("--program-store", !options.operator_panel.program_store.empty());
  check_owner("--embedded", !options.embedded.bus.empty());
  check_embedded(options.embedded, options.bus);
  if (!is_there) return;
  Environment environment;
  put_in_place(environment, options);
  const OperatorPanel panel(options.operator_panel, environment, output);
}

/// A device without the button or hand is not put on the bus.
void check_presses(const std::vector<Wanted>& wanted, const DeviceOptions& options,
                   const DeviceOutput& output) {
  std::vector<const cia407::BusUnit*> bus_units;
  bool has_car = false;
  for (const Wanted& device : wanted) {
    for (const cia407::BusUnit* unit : device.bus_units()) bus_units.push_back(unit);
    has_car |= !device.car_units().empty();
  }
  check_operator(options, std::ranges::any_of(wanted, &Wanted::is_operator), output);
  if (has_car) check_car_panel(options.car_panel);
  const WantedHands hands(wanted, options);
  if (bus_units.empty()) {
    return check_hand_options(hands.tables(), options.presses, options.sets);
  }
  std::vector<std::string> of_bus;
  for (const std::string& order : orders_of(options)) {
    if (has_hand(hands.tables(), order)) {
      parse_hand_order(hands.tables(), order);
    } else {
      of_bus.push_back(order);
    }
  }
  check_bus_options(bus_units, options.bus_panel, of_bus);
}

/// The bus follows the devices.
void take_bus(DeviceOptions& options) {
  for (const std::string& word : options.kinds) {
    if (word.find('@') == std::string::npos || std::filesystem::exists(word)) continue;
    throw UsageError(fmt::format(
        "'{}' is no device: write --press or --set for each order, or hire@2s,stop@9s in one",
        word));
  }
  const std::string& last = options.kinds.back();
  const bool is_device = find_any_device_kind(last) != nullptr ||
                         !parse_shared_node(last).empty() || sheet_of(last) != nullptr;
  if (is_device || options.kinds.size() < 2) {
    throw UsageError(
        fmt::format("the bus is missing: canvoy device {} can0", is_device ? last : "charger"));
  }
  options.bus = last;
  options.kinds.pop_back();
}

/// In ms, as in 1017h; 0 switches it off.
std::optional<unsigned> heartbeat_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  if (text == "0") return 0;
  constexpr Duration longest = 65535ms;
  const Duration period = parse_duration_argument(text);
  if (period <= longest && period % Duration(1ms) == Duration{}) {
    return static_cast<unsigned>(period / Duration(1ms));
  }
  throw UsageError(fmt::format("--heartbeat: '{}' is none: give 1ms to 65535ms, or 0", text));
}

int run_devices(DeviceOptions options) {
  if (options.list) {
    print_device_list(options.json);
    return exit_done;
  }
  if (options.lists_hands) {
    print_hand_list(options.kinds, options.json);
    return exit_done;
  }
  if (options.kinds.empty()) {
    throw UsageError("device is required: one of `canvoy device --list`, or a data sheet");
  }
  take_bus(options);
  options.presses = separate_orders(options.presses);
  options.sets = separate_orders(options.sets);
  options.heartbeat_ms = heartbeat_of(options.heartbeat);
  check_place(options);
  const DeviceOutput output(options.json);
  const std::vector<Wanted> wanted = wanted_devices(options);
  const host::BusAddress address = any_bus(options.bus);
  end_of(options, Time{});
  check_presses(wanted, options, output);
  if (address.kind == host::BusType::simulated) return run_simulated(options, wanted, output);
  if (options.bit_rate == "auto" && address.kind == host::BusType::socketcan) {
    const auto flicker = [&](bool under_way) {
      const Indication light = under_way ? Indication::flickering : Indication::off;
      for (const Wanted& device : wanted) output.lights(device.name, light, light);
    };
    output.say(address.interface,
               fmt::format("{} bit/s", search_bit_rate(address.interface, flicker)));
  } else if (!options.bit_rate.empty()) {
    throw UsageError(
        "--bit-rate is for the bus sim; that of a CAN interface is set with ip link, or is auto");
  }
  DeviceOptions on_host = options;
  if (address.kind == host::BusType::socketcan) on_host.interface = address.interface;
  return run_on_host(on_host, wanted, output);
}

void add_lift_options(Verb& command, DeviceOptions& options) {
  command.add({
      {"--lift", options.lift, "of a lift panel: 1 to 8 (default 1)"},
      {"--floor", options.floor, "where a landing panel hangs (default 1)"},
      {"--floors", options.floors, "of the building of a lift panel or controller (default 10)"},
      {"--door", options.door, "of a lift door, and of a light barrier: 1 to 4 (default 1)"},
  });
}

void add_hand_options(Verb& command, DeviceOptions& options) {
  command.add({
      {"--hands", options.lists_hands,
       "say what can be pressed and set of these devices, or of all: a line for each, with the "
       "values, the object that it changes and the clause"},
      {"--press", options.presses,
       "a button or key, and when: up@2s, 7@2s, hire@2s, input5@2s; it is released after 300 ms; "
       "several in one: hire@2s,stop@9s",
       one_each},
      {"--set", options.sets,
       "what a device senses, or what breaks, and when: paper=no@2s, input5=on@3s, load=300@10s; "
       "several in one: paper=no@2s,paper=yes@5s",
       one_each},
      {"--stdin", options.reads_lines,
       "take presses and sets from stdin as well, a line each: hire, paper=no; with a time "
       "that counts from the start, hire@10s; status 1 if one failed"},
  });
}

}  // namespace

void add_device(Verb& app) {
  const auto options = std::make_shared<DeviceOptions>();
  Verb& command = app.add_verb("device", "Put a device with simulated hardware on a bus");
  command.add({
      {"device", options->kinds,
       "one of --list, several of CiA 447 or CiA 407 on one node (taximeter+printer), or a "
       "data sheet (FILE.eds); or several; and behind them the BUS: can0, "
       "udp:239.74.163.2:43113, tcp:HOST:PORT/can0 of a socketcand, or sim"},
      {"--list", options->list, "say which devices there are"},
      {"--node-id", options->node_ids,
       "10 or 0x0A, one for each device (default: as --list says, and by --door); lss: "
       "it waits for one by LSS",
       one_each},
      {"--serial-number", options->serial_number,
       "of the identity, 1018h:04h: with it LSS tells equal devices apart"},
      {"--store", options->stores,
       "file in which the device keeps its parameters (1010h, 1011h), one for each "
       "device; it is made where there is none. A node-ID that LSS has stored there goes "
       "before --node-id",
       one_each},
      {"--heartbeat", options->heartbeat,
       "its period: 500ms, up to 65535ms; 0: none (default: as stored, else 1s)"},
      {"--bit-rate", options->bit_rate,
       "of a simulated bus: 250k, 250000 (default 125k); that of a CAN interface is set "
       "with ip link, or auto: the device listens until it knows it (needs root)"},
      {"--state-of-charge", options->state_of_charge,
       "of the battery at the start, in % (default 20)", between(0.0, 100.0)},
  });
  command.begin_group("Hands");
  add_hand_options(command, *options);
  command.begin_group("Lifts (CiA 417)");
  add_lift_options(command, *options);
  add_lift_unit_options(command, options->unit);
  command.begin_group("Cars (CiA 447)");
  add_device_car_options(command, options->car);
  add_car_panel_options(command, options->car_panel);
  command.begin_group("Passenger information (CiA 407)");
  add_bus_panel_options(command, options->bus_panel);
  command.begin_group("Operator environments (CiA 852, CiA 401)");
  add_operator_panel_options(command, options->operator_panel);
  add_embedded_options(command, options->embedded);
  command.begin_group("Run");
  command.add({
      {"--for", options->duration, "end after this time: 30s, 10min, 8h"},
      {"--json", options->json, "one JSON object a line"},
      {"--no-manage", options->no_manage,
       "a charger, lift controller, IVN gateway or on-board computer leaves it to another NMT "
       "master to start the network"},
  });
  command.add_examples(
      "  canvoy device battery can0\n"
      "  canvoy device charger battery sim --for 1s --json\n"
      "  canvoy device battery can0 --node-id 0Ah --heartbeat 500ms --state-of-charge 80\n"
      "  canvoy device taximeter+printer can0 --node-id lss\n"
      "  canvoy device printer can0 --set paper=no@10s --set paper=yes@20s\n"
      "  canvoy device pump.eds can0 --node-id 9\n"
      "  canvoy device --list");
  command.runs([options] { return run_devices(*options); });
}

}  // namespace canvoy::tools
