#include "canvoy/tools/play/taxi_settings.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "canvoy/sim/duration_text.hpp"

namespace canvoy::tools {

namespace {

using taxi::ShiftOptions;
using taxi::TaxiOptions;

Setting<TaxiRun> pdo_offsets() {
  using Numbers = std::vector<double>;
  return mapped<TaxiRun, Numbers>(
      {.key = "pdo_offsets",
       .takes = "30 whole numbers from 0 to 31",
       .read =
           [](TaxiRun& run, const Numbers& wanted) {
             cia447::PdoOffsets& offsets = run.network.car_network.nodes.pdo_offsets;
             std::bitset<cia447::pdos_per_node> taken;
             for (const double offset : wanted) taken.set(static_cast<std::size_t>(offset));
             const bool are_whole = std::ranges::all_of(
                 wanted, [](double offset) { return offset == std::floor(offset); });
             if (wanted.size() != offsets.size() || taken.count() != offsets.size() || !are_whole) {
               throw UsageError(fmt::format("it takes {} whole numbers from 0 to {}, each another",
                                            offsets.size(), cia447::pdos_per_node - 1));
             }
             std::ranges::transform(wanted, offsets.begin(), [](double offset) {
               return static_cast<std::uint8_t>(offset);
             });
           },
       .write =
           [](const TaxiRun& run) {
             const cia447::PdoOffsets& offsets = run.network.car_network.nodes.pdo_offsets;
             return Numbers(offsets.begin(), offsets.end());
           },
       .range = {0, cia447::pdos_per_node - 1}},
      "of the pre-defined PDOs in the 32 CAN-IDs of a node");
}

constexpr auto taxi_network = &TaxiRun::network;

SettingTable<TaxiRun> shift_table() {
  constexpr auto shift = &TaxiOptions::shift;
  constexpr double way_max = 200'000;
  return {
      "shift",
      "",
      {setting<taxi_network, shift, &ShiftOptions::begin>("sign_on_after", "", {{1s, 24h}}),
       setting<taxi_network, shift, &ShiftOptions::waiting_max>("waiting_max",
                                                                "for somebody to call", {1s, 24h}),
       setting<taxi_network, shift, &ShiftOptions::boarding_max>("boarding_max", "", {1s, 1h}),
       setting<taxi_network, shift, &ShiftOptions::paying_max>("paying_max", "", {1s, 1h}),
       setting<taxi_network, shift, &ShiftOptions::trip_min_metres>("trip_min_m", "",
                                                                    {{10, way_max}}),
       setting<taxi_network, shift, &ShiftOptions::trip_max_metres>("trip_max_m", "",
                                                                    {{10, way_max}}),
       setting<taxi_network, shift, &ShiftOptions::card_share>(
           "card_share", "of the trips that are paid by card, else in cash", {{0, 1}}),
       setting<taxi_network, shift, &ShiftOptions::no_show_share>(
           "no_show_share", "of those who have called and are not there", {{0, 1}}),
       setting<taxi_network, shift, &ShiftOptions::mistake_share>(
           "mistake_share", "of the trips in which a wrong supplement is pressed first", {{0, 1}}),
       setting<taxi_network, shift, &ShiftOptions::break_after>("break_after", "of work",
                                                                {1min, 24h}),
       setting<taxi_network, shift, &ShiftOptions::break_lasts>(
           "break_lasts", "with the meter in standby", {1min, 4h}),
       setting<taxi_network, shift, &ShiftOptions::calibration_metres>(
           "calibration_m", "a drive before the shift; 0: none", {{0, 10'000}})},
      [](const TomlTable& table, TaxiRun& run) {
        const ShiftOptions& shift = run.network.shift;
        if (shift.trip_max_metres >= shift.trip_min_metres) return;
        table.refuse("trip_max_m",
                     fmt::format("{} is less than trip_min_m", shift.trip_max_metres));
      }};
}

SettingTable<TaxiRun> car_network_table() {
  constexpr auto car = &TaxiOptions::car_network;
  constexpr auto nodes = &taxi::CarNetworkOptions::nodes;
  constexpr auto master = &taxi::CarNetworkOptions::master;
  constexpr auto sleep = &taxi::CarNetworkOptions::sleep;
  using Nodes = cia447::CarNetworkSettings;
  using Master = cia447::CarMasterSettings;
  using Sleep = cia447::CarSleepSettings;
  return {
      "car_network",
      "what is assumed where CiA 447-1 and -4 are not public",
      {setting<taxi_network, car, nodes, &Nodes::heartbeat>(
           "heartbeat", "from one to the next, of all nodes", {50ms, 5s}),
       setting<taxi_network, car, nodes, &Nodes::time_out>("lost_after", "without a heartbeat",
                                                           {1500ms, 10s}),
       setting<taxi_network, car, master, &Master::scan_period>(
           "scan_period", "of the gateway, for devices without a node-ID", {100ms, 5s}),
       setting<taxi_network, car, master, &Master::objection_time>("objection_time", "before sleep",
                                                                   {100ms, 5s}),
       setting<taxi_network, car, sleep, &Sleep::preparation>("sleep_preparation", "", {100ms, 5s}),
       setting<taxi_network, car, sleep, &Sleep::repetition>("wake_up_repetition", "", {100ms, 2s}),
       pdo_offsets()},
      [](const TomlTable& table, TaxiRun& run) {
        const Nodes& wanted = run.network.car_network.nodes;
        if (wanted.heartbeat % 1ms != Duration{})
          table.refuse("heartbeat", "it is in whole milliseconds");
        if (wanted.time_out > wanted.heartbeat) return;
        table.refuse("lost_after", "it is to be longer than from one heartbeat to the next");
      }};
}

struct TaxiZone {
  std::string_view name;
  cia447::TimeZone zone;
};
/// By the present rules.
constexpr TaxiZone taxi_zones[] = {
    {"UTC", {}},
    {"Europe/London", {.name = "GMT", .summer = cia447::european_summer}},
    {"Europe/Berlin", {.name = "CET", .offset_minutes = 60, .summer = cia447::european_summer}},
    {"Europe/Athens", {.name = "EET", .offset_minutes = 120, .summer = cia447::european_summer}},
    {"America/New_York",
     {.name = "EST", .offset_minutes = -300, .summer = cia447::american_summer}},
    {"America/Chicago", {.name = "CST", .offset_minutes = -360, .summer = cia447::american_summer}},
    {"America/Los_Angeles",
     {.name = "PST", .offset_minutes = -480, .summer = cia447::american_summer}},
    {"Asia/Tokyo", {.name = "JST", .offset_minutes = 540}}};

std::string taxi_zone_names() {
  std::string names;
  for (const TaxiZone& each : taxi_zones) {
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", each.name);
  }
  return names;
}

}  // namespace

Setting<TaxiRun> time_zone_setting() {
  return mapped<TaxiRun, std::string>(
      {.key = "time_zone",
       .takes = "one of " + taxi_zone_names(),
       .read =
           [](TaxiRun& run, const std::string& name) {
             const auto* const found = std::ranges::find(taxi_zones, name, &TaxiZone::name);
             if (found == std::end(taxi_zones)) {
               throw UsageError(
                   fmt::format("{} is none of {}", text_value(name), taxi_zone_names()));
             }
             run.network.zone = found->zone;
           },
       .write =
           [](const TaxiRun& run) {
             const auto* const found = std::ranges::find_if(
                 taxi_zones,
                 [&run](const TaxiZone& each) { return each.zone.name == run.network.zone.name; });
             return found == std::end(taxi_zones) ? std::string() : std::string(found->name);
           }},
      "of its clocks, with summer time");
}
void add_taxi_settings(std::vector<FilePart<TaxiRun>>& parts) {
  parts.emplace_back(shift_table());
  parts.emplace_back(car_network_table());
}

}  // namespace canvoy::tools
