#include "canvoy/tools/run/taxi_settings_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bitset>
#include <charconv>
#include <cmath>
#include <optional>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/run/network_text.hpp"

namespace canvoy::tools {

namespace {

using cia447::TariffHours;
using cia447::TariffLevel;

constexpr double thousandths = 1000;  ///< of the currency unit, as a taximeter has amounts
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

void take_between(TomlTable& table, std::string_view key, Duration& to, Duration least,
                  Duration most) {
  table.take(key, to);
  if (to >= least && to <= most) return;
  table.refuse(key, fmt::format("{} is not from {} to {}", canvoy::written(to),
                                canvoy::written(least), canvoy::written(most)));
}

void take_amount(TomlTable& table, std::string_view key, std::uint32_t& to) {
  double amount = to / thousandths;
  table.take(key, amount, {0, amount_max});
  const double counted = std::round(amount * thousandths);
  if (std::abs(counted - amount * thousandths) > 1e-6) {
    table.refuse(key, fmt::format("{} is no whole number of thousandths", amount));
  }
  to = static_cast<std::uint32_t>(counted);
}

std::string level_name(const TariffLevel& level) {
  std::string name;
  for (const char character : level.name) {
    if (character != 0) name += character;
  }
  return name;
}

std::array<char, 2> take_name(TomlTable& table, std::string_view key) {
  std::string name;
  table.take(key, name);
  const bool is_name = !name.empty() && name.size() <= 2 &&
                       std::ranges::all_of(name, [](char one) { return one > ' ' && one < 0x7F; });
  if (!is_name)
    table.refuse(key,
                 fmt::format("{} is no name of one or two characters of ASCII", text_value(name)));
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
void take_time(TomlTable& table, std::string_view key, std::uint16_t& to) {
  std::string text = fmt::format("{}:{:02}", to / minutes_of_hour, to % minutes_of_hour);
  table.take(key, text);
  const auto minutes = minutes_of(text);
  if (!minutes) table.refuse(key, fmt::format("{} is no time as \"22:00\"", text_value(text)));
  to = *minutes;
}
std::string time_value(unsigned minutes) {
  return fmt::format("\"{}:{:02}\"", minutes / minutes_of_hour, minutes % minutes_of_hour);
}

TariffLevel take_level(TomlTable& table) {
  TariffLevel level;
  level.name = take_name(table, "level");
  take_amount(table, "initial_fare", level.initial_fare);
  take_amount(table, "minimum_fare", level.minimum_fare);
  take_amount(table, "per_km", level.distance_rate);
  take_amount(table, "per_hour", level.time_rate);
  take_amount(table, "step", level.increment);
  table.finish();
  return level;
}

TariffHours take_hours(TomlTable& table, const std::vector<TariffLevel>& levels) {
  TariffHours hours;
  const std::array<char, 2> name = take_name(table, "level");
  const auto level = std::ranges::find(levels, name, &TariffLevel::name);
  if (level == levels.end()) table.refuse("level", "there is no such level of the tariff");
  hours.level = static_cast<std::uint8_t>(level - levels.begin());
  take_time(table, "from", hours.from);
  take_time(table, "to", hours.to);
  std::vector<std::string> days;
  table.take("days", days);
  if (table.has("days")) hours.days = 0;
  for (const std::string& day : days) {
    const auto* const found = std::ranges::find(days_names, day, &Days::name);
    if (found == std::end(days_names)) {
      table.refuse("days", fmt::format("{} is none of weekdays, saturdays, sundays, holidays",
                                       text_value(day)));
    }
    hours.days = static_cast<std::uint8_t>(hours.days | found->bits);
  }
  table.finish();
  return hours;
}

}  // namespace

void take_shift(TomlTable& file, taxi::ShiftOptions& shift) {
  TomlTable table = file.table("shift");
  Duration begin = shift.begin - Time{};
  take_between(table, "sign_on_after", begin, 1s, 24h);
  shift.begin = Time{} + begin;
  take_between(table, "waiting_max", shift.waiting_max, 1s, 24h);
  take_between(table, "boarding_max", shift.boarding_max, 1s, 1h);
  take_between(table, "paying_max", shift.paying_max, 1s, 1h);
  constexpr double way_max = 200'000;
  table.take("trip_min_m", shift.trip_min_metres, {10, way_max});
  table.take("trip_max_m", shift.trip_max_metres, {10, way_max});
  if (shift.trip_max_metres < shift.trip_min_metres) {
    table.refuse("trip_max_m", fmt::format("{} is less than trip_min_m", shift.trip_max_metres));
  }
  table.finish();
}

void take_car_network(TomlTable& file, taxi::CarNetworkOptions& network) {
  TomlTable table = file.table("car_network");
  take_between(table, "heartbeat", network.nodes.heartbeat, 50ms, 5s);
  if (network.nodes.heartbeat % 1ms != Duration{}) {
    table.refuse("heartbeat", "it is in whole milliseconds");
  }
  take_between(table, "lost_after", network.nodes.time_out, 1500ms, 10s);
  if (network.nodes.time_out <= network.nodes.heartbeat) {
    table.refuse("lost_after", "it is to be longer than from one heartbeat to the next");
  }
  take_between(table, "scan_period", network.master.scan_period, 100ms, 5s);
  take_between(table, "objection_time", network.master.objection_time, 100ms, 5s);
  take_between(table, "sleep_preparation", network.sleep.preparation, 100ms, 5s);
  take_between(table, "wake_up_repetition", network.sleep.repetition, 100ms, 2s);
  cia447::PdoOffsets& offsets = network.nodes.pdo_offsets;
  std::vector<double> wanted(offsets.begin(), offsets.end());
  table.take("pdo_offsets", wanted, {0, cia447::pdos_per_node - 1});
  std::bitset<cia447::pdos_per_node> taken;
  for (const double offset : wanted) taken.set(static_cast<std::size_t>(offset));
  const bool are_whole =
      std::ranges::all_of(wanted, [](double offset) { return offset == std::floor(offset); });
  if (wanted.size() != offsets.size() || taken.count() != offsets.size() || !are_whole) {
    table.refuse("pdo_offsets", fmt::format("it takes {} whole numbers from 0 to {}, each another",
                                            offsets.size(), cia447::pdos_per_node - 1));
  }
  std::ranges::transform(wanted, offsets.begin(),
                         [](double offset) { return static_cast<std::uint8_t>(offset); });
  table.finish();
}

std::shared_ptr<const TariffParts> take_tariff(TomlTable& file) {
  auto parts = std::make_shared<TariffParts>();
  for (TomlTable& table : file.tables("tariff")) {
    const TariffLevel level = take_level(table);
    if (std::ranges::find(parts->levels, level.name, &TariffLevel::name) != parts->levels.end()) {
      table.refuse("level", "there is one of this name already");
    }
    if (parts->levels.size() == levels_max) {
      table.refuse(fmt::format("there are more than {} levels", levels_max));
    }
    parts->levels.push_back(level);
  }
  for (TomlTable& table : file.tables("tariff_hours")) {
    if (parts->hours.size() == hours_max) {
      table.refuse(fmt::format("there are more than {} of them", hours_max));
    }
    parts->hours.push_back(take_hours(table, parts->levels));
  }
  return parts->levels.empty() ? nullptr : parts;
}

std::string shift_text(const taxi::ShiftOptions& shift) {
  return fmt::format(
      "\n[shift]\nsign_on_after = \"{}\"\nwaiting_max = \"{}\"  # for somebody to call\n"
      "boarding_max = \"{}\"\npaying_max = \"{}\"\n"
      "trip_min_m = {}\ntrip_max_m = {}\n",
      canvoy::written(shift.begin - Time{}), canvoy::written(shift.waiting_max),
      canvoy::written(shift.boarding_max), canvoy::written(shift.paying_max), shift.trip_min_metres,
      shift.trip_max_metres);
}

std::string car_network_text(const taxi::CarNetworkOptions& network) {
  return fmt::format(
      "\n[car_network]  # what is assumed where CiA 447-1 and -4 are not public\n"
      "heartbeat = \"{}\"  # from one to the next, of all nodes\n"
      "lost_after = \"{}\"  # without a heartbeat\n"
      "scan_period = \"{}\"  # of the gateway, for devices without a node-ID\n"
      "objection_time = \"{}\"  # before sleep\nsleep_preparation = \"{}\"\n"
      "wake_up_repetition = \"{}\"\n"
      "pdo_offsets = [{}]  # of the pre-defined PDOs in the 32 CAN-IDs of a node\n",
      canvoy::written(network.nodes.heartbeat), canvoy::written(network.nodes.time_out),
      canvoy::written(network.master.scan_period), canvoy::written(network.master.objection_time),
      canvoy::written(network.sleep.preparation), canvoy::written(network.sleep.repetition),
      fmt::join(network.nodes.pdo_offsets, ", "));
}

std::string tariff_text(const cia447::Tariff& tariff) {
  std::string text;
  for (const TariffLevel& level : tariff.levels) {
    text += fmt::format(
        "\n[[tariff]]\nlevel = {}\ninitial_fare = {}\nminimum_fare = {}\nper_km = {}\n"
        "per_hour = {}\nstep = {}  # by which the fare grows\n",
        text_value(level_name(level)), level.initial_fare / thousandths,
        level.minimum_fare / thousandths, level.distance_rate / thousandths,
        level.time_rate / thousandths, level.increment / thousandths);
  }
  for (const TariffHours& hours : tariff.hours) {
    std::vector<std::string> days;
    for (const Days& each : days_names) {
      if ((hours.days & each.bits) == each.bits) days.push_back(text_value(each.name));
    }
    text += fmt::format(
        "\n[[tariff_hours]]  # the first that fit hold; else the first level\n"
        "level = {}\ndays = [{}]\nfrom = {}\nto = {}\n",
        text_value(level_name(tariff.levels[hours.level])), fmt::join(days, ", "),
        time_value(hours.from), time_value(hours.to));
  }
  return text;
}

}  // namespace canvoy::tools
