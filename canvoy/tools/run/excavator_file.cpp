#include "canvoy/tools/run/excavator_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/network_text.hpp"
#include "canvoy/tools/run/run.hpp"

namespace canvoy::tools {

void add_fault(ExcavatorRun& run, const std::string& text) {
  const excavator::ScheduledFault fault = excavator::scheduled(
      parse_run_fault(excavator::fault_grammar(), text, Time(run.network.length)));
  if (fault.node != 0 && !excavator::has_node(fault.kind)) {
    throw UsageError(fmt::format("fault '{}': it is not one of a node", text));
  }
  if (fault.axis != 0 && !excavator::has_axis(fault.kind)) {
    throw UsageError(fmt::format("fault '{}': it is not one of an axis", text));
  }
  const auto has_this = [&fault](const excavator::DevicePlace& place) {
    return place.id == fault.node;
  };
  if (fault.node != 0 && std::ranges::none_of(excavator::device_places, has_this)) {
    throw UsageError(fmt::format("fault '{}': there are nodes {} (host), {} (seat) and {} (valves)",
                                 text, excavator::host_id, excavator::seat_id,
                                 excavator::valves_id));
  }
  run.network.faults.faults.push_back(fault);
}

namespace {

void check_excavator(TomlTable& table, const ExcavatorRun& run) {
  if (run.network.real.empty()) return;
  if (run.real.empty()) table.refuse("who is not played is on a real bus: write real = \"can0\"");
  if (!run.network.faults.faults.empty()) {
    table.refuse("faults", "only where all devices are played");
  }
}

void take_excavator_device(TomlTable& table, NodeId id, ExcavatorRun& run) {
  excavator::ExcavatorOptions& network = run.network;
  bool is_played = true;
  table.take("played", is_played);
  if (!is_played) network.real.push_back(id);
  if (id == excavator::seat_id) table.take("sensing_period", network.sensing_period);
}

}  // namespace

ExcavatorRun read_excavator_run(TomlTable& table) {
  ExcavatorRun run;
  excavator::ExcavatorOptions& network = run.network;
  table.take("for", network.length);
  table.take("seed", network.faults.seed);
  std::vector<std::string> faults;
  table.take("faults", faults);
  TomlTable bus = table.table("bus");
  bus.take<std::uint32_t>("bit_rate", network.bit_rate, {125'000, 1'000'000});
  take_real_bus(bus, 0, run.real);
  bus.finish();
  TomlTable shift = table.table("shift");
  shift.take("work", network.shift.work);
  shift.take("rest", network.shift.rest);
  shift.finish();
  for (const excavator::DevicePlace& place : excavator::device_places) {
    TomlTable device = table.table(place.name);
    take_excavator_device(device, place.id, run);
    device.finish();
  }
  table.finish();
  try {
    for (const std::string& fault : faults) add_fault(run, fault);
  } catch (const Failure& failure) {
    table.refuse("faults", failure.what());
  }
  check_excavator(table, run);
  return run;
}

std::string excavator_run_text(const ExcavatorRun& run) {
  const excavator::ExcavatorOptions& network = run.network;
  std::vector<std::string> faults;
  faults.reserve(network.faults.faults.size());
  for (const excavator::ScheduledFault& fault : network.faults.faults) {
    faults.push_back(
        fmt::format("\"{}\"", fault_text(excavator::fault_grammar(), excavator::written(fault))));
  }
  std::string text = fmt::format(
      R"(# A shift of an excavator: CiA 852 and CiA 401.
network = "excavator"
for = "{}"  # virtual time
seed = {}  # of all that is left to chance
faults = [{}]  # NAME@START or NAME@START+DURATION; canvoy run excavator --help lists them

[bus]
bit_rate = {}  # bit/s
)",
      canvoy::written(network.length), network.faults.seed, fmt::join(faults, ", "),
      network.bit_rate);
  text += run.real.empty()
              ? "# real = \"can0\"  # a real bus is a part of it; all runs at the speed of the "
                "clock\n"
              : fmt::format("real = {}\n", text_value(run.real.front().address));
  text += fmt::format("\n[shift]\nwork = \"{}\"  # between two breaks\nrest = \"{}\"\n",
                      canvoy::written(network.shift.work), canvoy::written(network.shift.rest));
  for (const excavator::DevicePlace& place : excavator::device_places) {
    const bool is_played = std::ranges::find(network.real, place.id) == network.real.end();
    text +=
        fmt::format("\n[{}]\nplayed = {}{}\n", place.name, is_played,
                    place.id == excavator::host_id ? "  # false: a real one is on the bus" : "");
    if (place.id != excavator::seat_id) continue;
    text += network.sensing_period == Duration{}
                ? "# sensing_period = \"2ms\"  # without it, it is told of each movement\n"
                : fmt::format("sensing_period = \"{}\"\n", canvoy::written(network.sensing_period));
  }
  return text;
}

}  // namespace canvoy::tools
