#include "canvoy/tools/play/taxi_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/value_file.hpp"

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;
using taxi::money_unit;
using taxi::TaxiEvent;
using taxi::TaxiNetwork;
using taxi::Trip;

/// An interruption of the power of the meter.
struct Interruption {
  Time begin{};
  Time end{};
};
std::vector<Interruption> interruptions(const TaxiNetwork& network) {
  std::vector<Interruption> all;
  const auto is_of_meter = [](const auto& fault) {
    return has_node(fault.kind) && fault.place.node == taxi::taximeter_id;
  };
  for (const TaxiEvent& event : network.events()) {
    if (const auto* began = std::get_if<taxi::FaultBegan>(&event.what)) {
      if (is_of_meter(*began)) all.push_back({event.at, event.at});
    } else if (const auto* ended = std::get_if<taxi::FaultEnded>(&event.what)) {
      if (is_of_meter(*ended) && !all.empty()) all.back().end = event.at;
    }
  }
  return all;
}

std::size_t tariff_changes(const TaxiNetwork& network) {
  return static_cast<std::size_t>(std::ranges::count_if(network.trips(), &Trip::has_tariff_change));
}

std::string verdict(const Trip& trip) {
  if (!trip.is_read) return "not judged";
  const bool is_good =
      trip.distance_excess() <= 0 && trip.time_excess() <= 0 && trip.fare_excess() <= 0;
  return is_good ? "within" : "BEYOND";
}

struct Total {
  std::string_view name;
  std::uint32_t shift;
  std::uint32_t all;
  double unit;  ///< unit of the amount; 1: none
};
std::vector<Total> totals(TaxiNetwork& network) {
  const cia447::TaximeterRecord& record = network.meter().record();
  const cia447::TaxiTotals& shift = record.shift;
  const cia447::TaxiTotals& all = record.total;
  return {{"distance", shift.distance, all.distance, money_unit},
          {"distance_hired", shift.distance_hired, all.distance_hired, money_unit},
          {"hirings", shift.hirings, all.hirings, 1},
          {"fare", shift.fare, all.fare, money_unit},
          {"supplements", shift.supplements, all.supplements, money_unit},
          {"income", shift.income, all.income, money_unit}};
}

}  // namespace

std::string taxi_report_text(TaxiNetwork& network) {
  std::string text = fmt::format(
      "Taximeter: {} trips in {}, k = {} pulses\n\n"
      "{:>9} {:>11} {:>11} {:>8} {:>8} {:>9} {:>9} {:>8} {:>9} {:>21}  {}\n",
      network.trips().size(), text::duration_text(network.now() - Time{}),
      network.options().meter.k, "begin s", "true m", "metered m", "error m", "limit m", "true s",
      "metered s", "error s", "fare", "asked for", "limits");
  for (const Trip& trip : network.trips()) {
    text += fmt::format(
        "{:>9.1f} {:>11.1f} {:>11.0f} {:>8.1f} {:>8.1f} {:>9.1f} {:>9.0f} {:>8.1f} {:>9.2f} "
        "{:>10.2f}..{:>9.2f}  {}{}\n",
        in_seconds(trip.begin - Time{}), trip.metres, trip.metered_metres,
        trip.metered_metres - trip.metres, trip.distance_limit(), trip.seconds,
        trip.metered_seconds, trip.metered_seconds - trip.seconds, trip.metered_fare / money_unit,
        trip.fare_low / money_unit, trip.fare_high / money_unit, verdict(trip),
        trip.has_tariff_change ? ", tariff changed" : "");
  }
  text += fmt::format("\n{:<16} {:>14} {:>14}\n", "totals", "shift", "all time");
  for (const Total& total : totals(network)) {
    const int digits = total.unit > 1 ? 3 : 0;
    text += fmt::format("{:<16} {:>14.{}f} {:>14.{}f}\n", total.name, total.shift / total.unit,
                        digits, total.all / total.unit, digits);
  }
  text += fmt::format("\ntrips with a change of tariff: {}\ninterruptions of power: {}\n",
                      tariff_changes(network), interruptions(network).size());
  for (const Interruption& each : interruptions(network)) {
    text += fmt::format("  at {} for {}\n", text::duration_text(each.begin - Time{}),
                        text::duration_text(each.end - each.begin));
  }
  return text;
}

std::string taxi_report_json(TaxiNetwork& network) {
  Json trips = Json::array();
  for (const Trip& trip : network.trips()) {
    trips.push_back({{"begin", in_seconds(trip.begin - Time{})},
                     {"distance_m", trip.metres},
                     {"metered_distance_m", trip.metered_metres},
                     {"distance_limit_m", trip.distance_limit()},
                     {"duration_s", trip.seconds},
                     {"metered_duration_s", trip.metered_seconds},
                     {"duration_limit_s", trip.time_limit()},
                     {"fare", trip.metered_fare / money_unit},
                     {"fare_low", trip.fare_low / money_unit},
                     {"fare_high", trip.fare_high / money_unit},
                     {"paid", trip.paid / money_unit},
                     {"tariff_change", trip.has_tariff_change},
                     {"verdict", verdict(trip)}});
  }
  Json sums = Json::object();
  for (const Total& total : totals(network)) {
    sums[total.name] = {{"shift", total.shift / total.unit}, {"all", total.all / total.unit}};
  }
  Json cuts = Json::array();
  for (const Interruption& each : interruptions(network)) {
    cuts.push_back(
        {{"begin", in_seconds(each.begin - Time{})}, {"end", in_seconds(each.end - Time{})}});
  }
  const Json report = {{"k", network.options().meter.k},
                       {"trips", trips},
                       {"totals", sums},
                       {"interruptions", cuts}};
  return report.dump(2) + "\n";
}

void write_taxi_report(TaxiNetwork& network, const std::string& path) {
  const std::string report =
      path.ends_with(".json") ? taxi_report_json(network) : taxi_report_text(network);
  write_value_file(path, {reinterpret_cast<const std::uint8_t*>(report.data()), report.size()});
}

}  // namespace canvoy::tools
