#include "canvoy/tools/run/taxi_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/drive_file.hpp"
#include "canvoy/tools/run/network_text.hpp"
#include "canvoy/tools/run/run.hpp"

namespace canvoy::tools {

namespace {

void check(TomlTable& table, const TaxiRun& run) {
  if (run.network.real.empty()) return;
  if (run.real.empty()) table.refuse("who is not played is on a real bus: write real = \"can0\"");
  if (!run.network.faults.faults.empty()) {
    table.refuse("faults", "only where all devices are played");
  }
}

}  // namespace

void add_fault(TaxiRun& run, const std::string& text) {
  const taxi::ScheduledFault fault =
      taxi::scheduled(parse_run_fault(taxi::fault_grammar(), text, Time(run.network.length)));
  if (fault.node != 0 && !taxi::has_node(fault.kind)) {
    throw UsageError(fmt::format("fault '{}': it is not one of a node", text));
  }
  if (fault.node > taxi::device_names.size()) {
    throw UsageError(
        fmt::format("fault '{}': there are nodes 1 to {}", text, taxi::device_names.size()));
  }
  run.network.faults.faults.push_back(fault);
}

namespace {

void take_device(TomlTable& table, NodeId id, TaxiRun& run) {
  taxi::TaxiOptions& network = run.network;
  bool is_played = true;
  table.take("played", is_played);
  if (!is_played) network.real.push_back(id);
  if (id == cia447::gateway_node_id) {
    table.take<unsigned>("pulses_per_rotation", network.car.pulses_per_rotation, {21, 253});
    table.take("wheel_circumference", network.car.wheel_circumference_m, {0.5, 5});
  } else if (id == taxi::taximeter_id) {
    table.take<std::uint32_t>("k", network.meter.k, {1, 10'000'000});
  }
}

}  // namespace

TaxiRun read_taxi_run(TomlTable& table, const std::string& folder) {
  TaxiRun run;
  taxi::TaxiOptions& network = run.network;
  table.take("for", network.length);
  table.take("seed", network.faults.seed);
  std::vector<std::string> faults;
  table.take("faults", faults);
  table.take("begin", network.begin);
  table.take("nmea", run.nmea);
  TomlTable bus = table.table("bus");
  bus.take<std::uint32_t>("bit_rate", network.bit_rate, {50'000, 1'000'000});
  take_real_bus(bus, 0, run.real);
  bus.finish();
  for (std::size_t i = 0; i < taxi::device_names.size(); ++i) {
    TomlTable device = table.table(taxi::device_names[i]);
    take_device(device, static_cast<NodeId>(i + 1), run);
    device.finish();
  }
  take_shift(table, network.shift);
  take_car_network(table, network.car_network);
  run.tariff = take_tariff(table);
  if (run.tariff) network.tariff_of_town = network.meter.tariff = run.tariff->tariff();
  table.finish();
  try {
    for (const std::string& fault : faults) add_fault(run, fault);
  } catch (const Failure& failure) {
    table.refuse("faults", failure.what());
  }
  check(table, run);
  if (!run.nmea.empty()) {
    network.record = read_drive_file((std::filesystem::path(folder) / run.nmea).string());
  }
  return run;
}

namespace {

std::string nmea_text(const TaxiRun& run) {
  if (run.nmea.empty()) return "# nmea = \"drive.nmea\"  # a recorded drive is what the car does\n";
  return fmt::format("nmea = {}\n", text_value(run.nmea));
}

}  // namespace

std::string taxi_run_text(const TaxiRun& run) {
  const taxi::TaxiOptions& network = run.network;
  std::vector<std::string> faults;
  faults.reserve(network.faults.faults.size());
  for (const taxi::ScheduledFault& fault : network.faults.faults) {
    faults.push_back(
        fmt::format("\"{}\"", fault_text(taxi::fault_grammar(), taxi::written(fault))));
  }
  std::string text = fmt::format(
      R"(# A shift of a taxi: CiA 447-3.
network = "taxi"
for = "{}"  # virtual time; the shift ends an hour before
seed = {}  # of all that is left to chance
faults = [{}]  # NAME@START or NAME@START+DURATION; canvoy run taxi --help lists them
begin = {}  # what clocks show at the start
{}
[bus]
bit_rate = {}  # bit/s
)",
      canvoy::written(network.length), network.faults.seed, fmt::join(faults, ", "),
      date_value(network.begin), nmea_text(run), network.bit_rate);
  text += run.real.empty()
              ? "# real = \"can0\"  # a real bus is a part of it; all runs at the speed of the "
                "clock\n"
              : fmt::format("real = {}\n", text_value(run.real.front().address));
  for (std::size_t i = 0; i < taxi::device_names.size(); ++i) {
    const auto id = static_cast<NodeId>(i + 1);
    const bool is_played = std::ranges::find(network.real, id) == network.real.end();
    text += fmt::format("\n[{}]\nplayed = {}{}\n", taxi::device_names[i], is_played,
                        i == 0 ? "  # false: a real one is on the bus" : "");
    if (id == cia447::gateway_node_id) {
      text += fmt::format("pulses_per_rotation = {}  # of a wheel\nwheel_circumference = {}  # m\n",
                          network.car.pulses_per_rotation, network.car.wheel_circumference_m);
    } else if (id == taxi::taximeter_id) {
      text += fmt::format("k = {}  # pulses for a kilometre\n", network.meter.k);
    }
  }
  return text + shift_text(network.shift) + car_network_text(network.car_network) +
         tariff_text(network.meter.tariff);
}

}  // namespace canvoy::tools
