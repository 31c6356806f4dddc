#include "canvoy/tools/run/excavator_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/network_text.hpp"
#include "canvoy/tools/run/run.hpp"
#include "canvoy/tools/run/shift_file.hpp"

namespace canvoy::tools {

void choose_shift(ExcavatorRun& run, const std::string& path) {
  run.network.shift.recorded = read_shift(path);
  run.shift = path;
}

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

bool has_real_bus(const ExcavatorRun& run, BusIndex bus) {
  return std::ranges::find(run.real, bus, &RealBus::bus) != run.real.end();
}

void check_excavator(TomlTable& table, const ExcavatorRun& run) {
  if (run.network.real.empty()) return;
  for (const NodeId id : run.network.real) {
    const bool is_behind = id == excavator::armrest_id;
    if (has_real_bus(run, is_behind ? 1 : 0)) continue;
    table.refuse(fmt::format("who is not played is on a real bus: write real = \"can{}\" in [{}]",
                             is_behind ? 1 : 0, is_behind ? "embedded" : "bus"));
  }
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

ExcavatorRun read_excavator_run(TomlTable& table, const std::string& folder) {
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
  TomlTable embedded = table.table("embedded");
  take_real_bus(embedded, 1, run.real);
  embedded.finish();
  TomlTable shift = table.table("shift");
  shift.take("work", network.shift.work);
  shift.take("rest", network.shift.rest);
  std::string recorded;
  shift.take("recorded", recorded);
  shift.finish();
  if (!recorded.empty()) choose_shift(run, (std::filesystem::path(folder) / recorded).string());
  for (const excavator::DevicePlace& place : excavator::device_places) {
    TomlTable device = table.table(place.name);
    take_excavator_device(device, place.id, run);
    device.finish();
  }
  TomlTable armrest = table.table(excavator::armrest_place.name);
  take_excavator_device(armrest, excavator::armrest_id, run);
  armrest.finish();
  // A real seat has its own bus behind it, or none.
  const bool has_real_seat =
      std::ranges::find(network.real, excavator::seat_id) != network.real.end();
  network.has_armrest = !has_real_seat || has_real_bus(run, 1);
  table.finish();
  try {
    for (const std::string& fault : faults) add_fault(run, fault);
  } catch (const Failure& failure) {
    table.refuse("faults", failure.what());
  }
  check_excavator(table, run);
  return run;
}

namespace {

std::string real_bus_text(const ExcavatorRun& run, BusIndex bus) {
  const auto real = std::ranges::find(run.real, bus, &RealBus::bus);
  if (real != run.real.end()) return fmt::format("real = {}\n", text_value(real->address));
  return fmt::format(
      "# real = \"can{}\"  # a real bus is a part of it; all runs at the speed of the clock\n",
      bus);
}

/// `[seat]` and what is said of it.
std::string excavator_device_text(const ExcavatorRun& run, const excavator::DevicePlace& place) {
  const auto& real = run.network.real;
  const bool is_played = std::ranges::find(real, place.id) == real.end();
  return fmt::format("\n[{}]\nplayed = {}{}\n", place.name, is_played,
                     place.id == excavator::host_id ? "  # false: a real one is on the bus" : "");
}

}  // namespace

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
  text += real_bus_text(run, 0);
  text += "\n[embedded]  # the bus behind the seat: network 2\n" + real_bus_text(run, 1);
  text += fmt::format("\n[shift]\nwork = \"{}\"  # between two breaks\nrest = \"{}\"\n",
                      canvoy::written(network.shift.work), canvoy::written(network.shift.rest));
  text += run.shift.empty()
              ? "# recorded = \"shift.csv\"  # played again in place of that\n"
              : fmt::format("recorded = {}\n",
                            text_value(std::filesystem::absolute(run.shift).string()));
  for (const excavator::DevicePlace& place : excavator::device_places) {
    text += excavator_device_text(run, place);
    if (place.id != excavator::seat_id) continue;
    text += network.sensing_period == Duration{}
                ? "# sensing_period = \"2ms\"  # without it, it is told of each movement\n"
                : fmt::format("sensing_period = \"{}\"\n", canvoy::written(network.sensing_period));
  }
  text += excavator_device_text(run, excavator::armrest_place);
  return text;
}

}  // namespace canvoy::tools
