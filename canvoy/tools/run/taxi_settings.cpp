#include "canvoy/tools/run/taxi_settings.hpp"

#include <algorithm>
#include <bitset>
#include <charconv>
#include <cmath>
#include <optional>

#include "canvoy/sim/duration_text.hpp"

namespace canvoy::tools {

namespace {

using cia447::TariffHours;
using cia447::TariffLevel;
using taxi::ShiftOptions;
using taxi::TaxiOptions;

constexpr double thousandths = 1000;  ///< of the currency unit, as a taximeter has amounts
constexpr std::uint32_t coin = 10;    ///< in thousandths: the smallest one
constexpr double amount_max = 100'000;
constexpr std::size_t levels_max = 20;
constexpr std::size_t hours_max = 50;
constexpr unsigned minutes_of_hour = 60;
constexpr unsigned minutes_of_day = 24 * minutes_of_hour;

struct Days {
  std::string_view name;
  std::uint8_t bits;
};
constexpr Days days_names[] = {{"weekdays", cia447::on_mondays_to_fridays},
                               {"saturdays", cia447::on_saturdays},
                               {"sundays", cia447::on_sundays},
                               {"holidays", cia447::on_holidays}};

/// Whole ones of so many thousandths; the words tell what is wrong where it is not.
std::uint32_t whole_amount(double wanted, std::uint32_t unit, std::string_view otherwise) {
  const double counted = std::round(wanted * thousandths / unit);
  if (std::abs(counted - wanted * thousandths / unit) > 1e-6) {
    throw UsageError(fmt::format("{} {}", wanted, otherwise));
  }
  return static_cast<std::uint32_t>(counted) * unit;
}

/// A price: in a file of the currency, here of thousandths of it. It takes from `least` on.
template <auto member>
Setting<TariffLevel> amount(std::string key, double least, std::uint32_t unit,
                            std::string_view otherwise, std::string help) {
  return mapped<TariffLevel, double>(
      {.key = std::move(key),
       .takes = fmt::format("a number from {} to {}", least, amount_max),
       .read = [unit, otherwise](
                   TariffLevel& level,
                   double wanted) { level.*member = whole_amount(wanted, unit, otherwise); },
       .write = [](const TariffLevel& level) { return level.*member / thousandths; },
       .range = {least, amount_max}},
      std::move(help));
}
/// Of a distance or a time unit: fares have what whole steps make of it.
template <auto member>
Setting<TariffLevel> rate(std::string key) {
  return amount<member>(std::move(key), 0, 1, "is no whole number of thousandths", {});
}
/// What is shown, printed and paid as it is.
template <auto member>
Setting<TariffLevel> payable(std::string key, double least = 0, std::string help = {}) {
  return amount<member>(std::move(key), least, coin,
                        "is no whole number of cents, of which nobody can pay a part: take a "
                        "multiple of 0.01",
                        std::move(help));
}

std::string level_name(const TariffLevel& level) {
  std::string name;
  for (const char character : level.name) {
    if (character != 0) name += character;
  }
  return name;
}

std::array<char, 2> name_of_level(const std::string& name) {
  const bool is_name = !name.empty() && name.size() <= 2 &&
                       std::ranges::all_of(name, [](char one) { return one > ' ' && one < 0x7F; });
  if (!is_name) {
    throw UsageError(
        fmt::format("{} is no name of one or two characters of ASCII", text_value(name)));
  }
  return {name[0], name.size() == 2 ? name[1] : '\0'};
}

/// `22:00`, up to `24:00`.
std::optional<std::uint16_t> minutes_of(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || text.size() - colon != 3) return std::nullopt;
  unsigned hour = 0;
  unsigned minute = 0;
  const auto is_number = [](std::string_view part, unsigned& number) {
    const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    return error == std::errc{} && stop == part.data() + part.size();
  };
  const bool is_time = is_number(text.substr(0, colon), hour) &&
                       is_number(text.substr(colon + 1), minute) && hour <= 24 &&
                       minute < minutes_of_hour;
  const unsigned minutes = hour * minutes_of_hour + minute;
  if (!is_time || minutes > minutes_of_day) return std::nullopt;
  return static_cast<std::uint16_t>(minutes);
}
/// `from = "22:00"`
template <auto member>
Setting<TariffHours> time_of_day(std::string key) {
  return mapped<TariffHours, std::string>(
      {.key = std::move(key),
       .takes = "a time of day, as `\"22:00\"`",
       .read =
           [](TariffHours& hours, const std::string& text) {
             const auto minutes = minutes_of(text);
             if (!minutes)
               throw UsageError(fmt::format("{} is no time as \"22:00\"", text_value(text)));
             hours.*member = *minutes;
           },
       .write =
           [](const TariffHours& hours) {
             return fmt::format("{}:{:02}", hours.*member / minutes_of_hour,
                                hours.*member % minutes_of_hour);
           }});
}

Setting<TariffHours> days_setting() {
  using Texts = std::vector<std::string>;
  return mapped<TariffHours, Texts>(
      {.key = "days",
       .takes = "a list of `weekdays`, `saturdays`, `sundays`, `holidays`",
       .read =
           [](TariffHours& hours, const Texts& days) {
             hours.days = 0;
             for (const std::string& day : days) {
               const auto* const found = std::ranges::find(days_names, day, &Days::name);
               if (found == std::end(days_names)) {
                 throw UsageError(fmt::format(
                     "{} is none of weekdays, saturdays, sundays, holidays", text_value(day)));
               }
               hours.days = static_cast<std::uint8_t>(hours.days | found->bits);
             }
           },
       .write =
           [](const TariffHours& hours) {
             Texts days;
             for (const Days& each : days_names) {
               if ((hours.days & each.bits) == each.bits) days.emplace_back(each.name);
             }
             return days;
           }});
}

/// The levels that hours may name: of the file, or of the example.
std::vector<TariffLevel> levels_of(const TaxiRun& run) {
  const auto& levels = run.network.meter.tariff.levels;
  return run.tariff->levels.empty() ? std::vector<TariffLevel>(levels.begin(), levels.end())
                                    : run.tariff->levels;
}

Setting<TariffHours> level_of_hours(const std::vector<TariffLevel>& levels) {
  return mapped<TariffHours, std::string>(
      {.key = "level",
       .takes = "the name of a level",
       .read =
           [levels](TariffHours& hours, const std::string& name) {
             const auto level = std::ranges::find(levels, name_of_level(name), &TariffLevel::name);
             if (level == levels.end()) throw UsageError("there is no such level of the tariff");
             hours.level = static_cast<std::uint8_t>(level - levels.begin());
           },
       .write = [levels](const TariffHours& hours) { return level_name(levels[hours.level]); },
       .is_needed = true});
}

FilePart<TaxiRun> tariff_levels() {
  return several<TaxiRun, TariffLevel>(
      [](const TaxiRun&) {
        const auto name = mapped<TariffLevel, std::string>(
            {.key = "level",
             .takes = "one or two characters of ASCII",
             .read = [](TariffLevel& level,
                        const std::string& name) { level.name = name_of_level(name); },
             .write = [](const TariffLevel& level) { return level_name(level); },
             .is_needed = true});
        return SettingTable<TariffLevel>{
            "tariff",
            "",
            {name, payable<&TariffLevel::initial_fare>("initial_fare"),
             payable<&TariffLevel::minimum_fare>("minimum_fare"),
             rate<&TariffLevel::distance_rate>("per_km"), rate<&TariffLevel::time_rate>("per_hour"),
             payable<&TariffLevel::increment>("step", 0.01, "by which the fare grows")}};
      },
      [](const TaxiRun& run) {
        const auto& levels = run.network.meter.tariff.levels;
        return std::vector<TariffLevel>(levels.begin(), levels.end());
      },
      [](const TomlTable& table, TaxiRun& run, TariffLevel level) {
        std::vector<TariffLevel>& levels = run.tariff->levels;
        if (std::ranges::find(levels, level.name, &TariffLevel::name) != levels.end()) {
          table.refuse("level", "there is one of this name already");
        }
        if (levels.size() == levels_max)
          table.refuse(fmt::format("there are more than {} levels", levels_max));
        if (level.increment == 0) level.increment = coin;
        levels.push_back(level);
      });
}

FilePart<TaxiRun> tariff_hours() {
  return several<TaxiRun, TariffHours>(
      [](const TaxiRun& run) {
        return SettingTable<TariffHours>{
            "tariff_hours",
            "the first that fit hold; else the first level",
            {level_of_hours(levels_of(run)), days_setting(),
             time_of_day<&TariffHours::from>("from"), time_of_day<&TariffHours::to>("to")}};
      },
      [](const TaxiRun& run) {
        const auto& hours = run.network.meter.tariff.hours;
        return std::vector<TariffHours>(hours.begin(), hours.end());
      },
      [](const TomlTable& table, TaxiRun& run, TariffHours hours) {
        if (run.tariff->levels.empty())
          table.refuse("level", "there is no such level of the tariff");
        if (run.tariff->hours.size() == hours_max) {
          table.refuse(fmt::format("there are more than {} of them", hours_max));
        }
        run.tariff->hours.push_back(hours);
      });
}

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
  return {"shift",
          "",
          {setting<taxi_network, shift, &ShiftOptions::begin>("sign_on_after", "", {{1s, 24h}}),
           setting<taxi_network, shift, &ShiftOptions::waiting_max>(
               "waiting_max", "for somebody to call", {1s, 24h}),
           setting<taxi_network, shift, &ShiftOptions::boarding_max>("boarding_max", "", {1s, 1h}),
           setting<taxi_network, shift, &ShiftOptions::paying_max>("paying_max", "", {1s, 1h}),
           setting<taxi_network, shift, &ShiftOptions::trip_min_metres>("trip_min_m", "",
                                                                        {{10, way_max}}),
           setting<taxi_network, shift, &ShiftOptions::trip_max_metres>("trip_max_m", "",
                                                                        {{10, way_max}})},
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

}  // namespace

void add_taxi_settings(std::vector<FilePart<TaxiRun>>& parts) {
  parts.emplace_back(shift_table());
  parts.emplace_back(car_network_table());
  parts.push_back(tariff_levels());
  parts.push_back(tariff_hours());
}

}  // namespace canvoy::tools
