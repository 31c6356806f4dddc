#include "canvoy/tools/run/police_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/network_text.hpp"
#include "canvoy/tools/run/run.hpp"

namespace canvoy::tools {

void add_fault(PoliceRun& run, const std::string& text) {
  const police::ScheduledFault fault =
      police::scheduled(parse_run_fault(police::fault_grammar(), text, Time(run.network.length)));
  if (fault.node != 0 && !police::has_node(fault.kind)) {
    throw UsageError(fmt::format("fault '{}': it is not one of a node", text));
  }
  if (fault.node > police::device_names.size()) {
    throw UsageError(
        fmt::format("fault '{}': there are nodes 1 to {}", text, police::device_names.size()));
  }
  run.network.faults.faults.push_back(fault);
}

namespace {

void check_police(TomlTable& table, const PoliceRun& run) {
  if (run.network.real.empty()) return;
  if (run.real.empty()) table.refuse("who is not played is on a real bus: write real = \"can0\"");
  if (!run.network.faults.faults.empty()) {
    table.refuse("faults", "only where all devices are played");
  }
}

void take_police_device(TomlTable& table, NodeId id, PoliceRun& run) {
  police::PoliceOptions& network = run.network;
  bool is_played = true;
  table.take("played", is_played);
  if (!is_played) network.real.push_back(id);
  if (id != police::power_supply_id) return;
  table.take("radio_after_run", network.supply.radio_after_run);
  table.take("periphery_after_run", network.supply.periphery_after_run);
}

}  // namespace

PoliceRun read_police_run(TomlTable& table) {
  PoliceRun run;
  police::PoliceOptions& network = run.network;
  table.take("for", network.length);
  table.take("seed", network.faults.seed);
  std::vector<std::string> faults;
  table.take("faults", faults);
  TomlTable bus = table.table("bus");
  bus.take<std::uint32_t>("bit_rate", network.bit_rate, {50'000, 1'000'000});
  take_real_bus(bus, 0, run.real);
  bus.finish();
  for (std::size_t i = 0; i < police::device_names.size(); ++i) {
    TomlTable device = table.table(police::device_names[i]);
    take_police_device(device, static_cast<NodeId>(i + 1), run);
    device.finish();
  }
  table.finish();
  try {
    for (const std::string& fault : faults) add_fault(run, fault);
  } catch (const Failure& failure) {
    table.refuse("faults", failure.what());
  }
  check_police(table, run);
  return run;
}

std::string police_run_text(const PoliceRun& run) {
  const police::PoliceOptions& network = run.network;
  std::vector<std::string> faults;
  faults.reserve(network.faults.faults.size());
  for (const police::ScheduledFault& fault : network.faults.faults) {
    faults.push_back(
        fmt::format("\"{}\"", fault_text(police::fault_grammar(), police::written(fault))));
  }
  std::string text = fmt::format(
      R"(# A patrol of a police car: CiA 447-3.
network = "police"
for = "{}"  # virtual time; the patrol ends an hour before
seed = {}  # of all that is left to chance
faults = [{}]  # NAME@START or NAME@START+DURATION; canvoy run police --help lists them

[bus]
bit_rate = {}  # bit/s
)",
      canvoy::written(network.length), network.faults.seed, fmt::join(faults, ", "),
      network.bit_rate);
  text += run.real.empty()
              ? "# real = \"can0\"  # a real bus is a part of it; all runs at the speed of the "
                "clock\n"
              : fmt::format("real = {}\n", text_value(run.real.front().address));
  for (std::size_t i = 0; i < police::device_names.size(); ++i) {
    const auto id = static_cast<NodeId>(i + 1);
    const bool is_played = std::ranges::find(network.real, id) == network.real.end();
    text += fmt::format("\n[{}]\nplayed = {}{}\n", police::device_names[i], is_played,
                        i == 0 ? "  # false: a real one is on the bus" : "");
    if (id != police::power_supply_id) continue;
    text += fmt::format(
        "radio_after_run = \"{}\"  # of the power when the ignition is off\n"
        "periphery_after_run = \"{}\"\n",
        canvoy::written(network.supply.radio_after_run),
        canvoy::written(network.supply.periphery_after_run));
  }
  return text;
}

}  // namespace canvoy::tools
