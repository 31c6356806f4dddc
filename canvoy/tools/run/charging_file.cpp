#include "canvoy/tools/run/charging_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/network_text.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

constexpr double percent = 100;
/// In the vehicle there is a CANopen manager; nobody else has this node-ID.
constexpr NodeId manager_id = 1;

constexpr Range<NodeId> node_ids{1, 127};

void check(TomlTable& table, const ChargingRun& run) {
  const charging::ChargingOptions& network = run.network;
  if (network.charger_id == network.battery_id || network.charger_id == network.manager_id ||
      network.battery_id == network.manager_id) {
    table.refuse("two nodes have one node-ID");
  }
  if (network.plays_charger && network.plays_battery) return;
  if (run.real.empty()) table.refuse("who is not played is on a real bus: write real = \"can0\"");
  if (!network.faults.faults.empty()) {
    table.refuse("faults", "only where charger and battery are both played");
  }
}

}  // namespace

ChargingRun default_charging_run() {
  ChargingRun run;
  run.network.manager_id = manager_id;
  using namespace std::chrono;  // NOLINT(google-build-using-namespace): units and calendar
  run.network.begin = sys_days{2026y / 11 / 21} + 18h;
  return run;
}

void add_fault(ChargingRun& run, const std::string& text) {
  run.network.faults.faults.push_back(
      charging::scheduled(parse_run_fault(charging::fault_grammar(), text, Time(run.duration))));
}

ChargingRun read_charging_run(TomlTable& table) {
  ChargingRun run = default_charging_run();
  charging::ChargingOptions& network = run.network;
  table.take("for", run.duration);
  table.take("seed", network.faults.seed);
  std::vector<std::string> faults;
  table.take("faults", faults);
  TomlTable bus = table.table("bus");
  bus.take<std::uint32_t>("bit_rate", network.bit_rate, {10'000, 1'000'000});
  take_real_bus(bus, 0, run.real);
  TomlTable charger = table.table("charger");
  charger.take("id", network.charger_id, node_ids);
  charger.take("played", network.plays_charger);
  network.begin.reset();
  CivilTime begin{};
  charger.take("begin", begin);
  if (charger.has("begin")) network.begin = begin;
  TomlTable battery = table.table("battery");
  battery.take("id", network.battery_id, node_ids);
  battery.take("played", network.plays_battery);
  double state_of_charge = network.state_of_charge * percent;
  battery.take("state_of_charge", state_of_charge, {0, percent});
  network.state_of_charge = state_of_charge / percent;
  battery.take("ambience", network.ambience_celsius, {-40, 85});
  TomlTable manager = table.table("manager");
  manager.take<NodeId>("id", network.manager_id, {0, node_ids.most});
  for (const TomlTable* each : {&table, &bus, &charger, &battery, &manager}) each->finish();
  try {
    for (const std::string& fault : faults) add_fault(run, fault);
  } catch (const Failure& failure) {
    table.refuse("faults", failure.what());
  }
  check(table, run);
  return run;
}

std::string charging_run_text(const ChargingRun& run) {
  const charging::ChargingOptions& network = run.network;
  std::vector<std::string> faults;
  faults.reserve(network.faults.faults.size());
  for (const charging::ScheduledFault& fault : network.faults.faults) {
    faults.push_back(
        fmt::format("\"{}\"", fault_text(charging::fault_grammar(), charging::written(fault))));
  }
  std::string text = fmt::format(
      R"(# A CiA 419 charger charges a CiA 418 battery.
network = "charger"
for = "{}"  # virtual time
seed = {}  # of all that is left to chance
faults = [{}]  # NAME@START or NAME@START+DURATION; canvoy run charger --help lists them

[bus]
bit_rate = {}  # bit/s
)",
      canvoy::written(run.duration), network.faults.seed, fmt::join(faults, ", "),
      network.bit_rate);
  text +=
      run.real.empty()
          ? "# real = \"can0\"  # a real bus is a part of it; all runs at the speed of the clock\n"
          : fmt::format("real = {}\n", text_value(run.real.front().address));
  text += fmt::format(R"(
[charger]
id = {}
played = {}  # false: a real one is on the bus
)",
                      network.charger_id, network.plays_charger);
  if (network.begin) {
    text += fmt::format("begin = {}  # what its clock shows at the start\n",
                        date_value(*network.begin));
  }
  text += fmt::format(R"(
[battery]
id = {}
played = {}
state_of_charge = {}  # %
ambience = {}  # degrees Celsius

[manager]
id = {}  # gives the charger its SDO connection to the battery; 0: there is none
)",
                      network.battery_id, network.plays_battery, network.state_of_charge * percent,
                      network.ambience_celsius, network.manager_id);
  return text;
}

}  // namespace canvoy::tools
