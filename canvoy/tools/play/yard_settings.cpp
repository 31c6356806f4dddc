#include "canvoy/tools/play/yard_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "canvoy/can/real_text.hpp"

namespace canvoy::tools {

namespace {

using charger::BatteryKind;
using charger::ChargerOptions;
using charger::YardOptions;

constexpr double whole_percent = 100;
/// Where the charger has no clock: what it would show at the start.
constexpr unsigned usual_begin_minute = 18 * 60;
constexpr unsigned day_minutes = 24 * 60;

struct GoalText {
  double percent = 0;
  unsigned minute = 0;  ///< of the day
};

std::from_chars_result read_figure(const char* first, const char* last, double& to) {
  return real_from_chars(first, last, to);
}

std::from_chars_result read_figure(const char* first, const char* last, unsigned& to) {
  return std::from_chars(first, last, to);
}

template <class Number>
bool take_figure(std::string_view& text, Number& to) {
  const auto [end, error] = read_figure(text.data(), text.data() + text.size(), to);
  if (error != std::errc() || end == text.data()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

/// `80@06:00`
std::optional<GoalText> parse_goal(std::string_view text) {
  unsigned hour = 0;
  unsigned minute = 0;
  GoalText goal;
  const auto take = [&text](char sign) {
    if (text.empty() || text.front() != sign) return false;
    text.remove_prefix(1);
    return true;
  };
  const bool is_read = take_figure(text, goal.percent) && take('@') && take_figure(text, hour) &&
                       take(':') && take_figure(text, minute) && text.empty();
  const bool is_right =
      is_read && goal.percent > 0 && goal.percent <= whole_percent && hour < 24 && minute < 60;
  if (!is_right) return std::nullopt;
  goal.minute = hour * 60 + minute;
  return goal;
}

std::optional<BatteryKind> parse_kind(std::string_view name) {
  const auto found = std::ranges::find(charger::battery_kind_names, name);
  if (found == std::end(charger::battery_kind_names)) return std::nullopt;
  return static_cast<BatteryKind>(found - std::begin(charger::battery_kind_names));
}

/// The first such time of the day after the start.
Time time_of(const GoalText& goal, const ChargerOptions& network) {
  unsigned begin = usual_begin_minute;
  if (network.begin) {
    const auto since = *network.begin - std::chrono::floor<std::chrono::days>(*network.begin);
    begin = static_cast<unsigned>(since / 1min);
  }
  const unsigned until = (goal.minute + day_minutes - begin) % day_minutes;
  return Time(std::chrono::minutes(until == 0 ? day_minutes : until));
}

std::vector<std::string> split_names(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t first = 0;
  while (first <= text.size()) {
    const std::size_t end = std::min(text.find(',', first), text.size());
    parts.push_back(text.substr(first, end - first));
    first = end + 1;
  }
  return parts;
}

std::string wrong_node_ids(const YardSettings& yard, const ChargerOptions& network) {
  if (!yard.one_bus) return "";
  const unsigned last_charger = network.charger_id + yard.chargers - 1;
  const unsigned last_battery = network.battery_id + yard.chargers - 1;
  const bool are_apart = last_charger < network.battery_id || last_battery < network.charger_id;
  const bool are_ids = last_charger <= node_id_max && last_battery <= node_id_max;
  if (are_apart && are_ids) return "";
  return fmt::format(
      "on one bus, {} chargers have node-IDs from {} on and their batteries from {} on: give them "
      "others, which do not meet",
      yard.chargers, network.charger_id, network.battery_id);
}

std::string wrong_vehicle(const YardSettings& yard) {
  for (const VehicleOfFile& vehicle : yard.vehicles) {
    if (vehicle.bay > yard.chargers) {
      return fmt::format("a vehicle has bay {}: there are bays 1 to {}", vehicle.bay,
                         yard.chargers);
    }
    const bool leaves = vehicle.leaves != Duration::zero();
    if (leaves && vehicle.leaves <= vehicle.arrives) {
      return "a vehicle leaves before it arrives";
    }
    if (vehicle.returns != Duration::zero() && (!leaves || vehicle.returns <= vehicle.leaves)) {
      return "a vehicle returns before it leaves";
    }
  }
  const bool is_counted_otherwise = yard.batteries != 0 && yard.batteries != yard.vehicles.size();
  if (yard.vehicles.empty() || !is_counted_otherwise) return "";
  return fmt::format("there are {} batteries and {} vehicles: leave batteries out", yard.batteries,
                     yard.vehicles.size());
}

std::string wrong_bay(const YardSettings& yard, bool has_real_bus) {
  if (has_real_bus && !yard.one_bus) {
    return "each bay has a bus of its own: write real in [[bay]], or one_bus = true";
  }
  std::vector<unsigned> named;
  for (const BayOfFile& bay : yard.bays) {
    if (bay.bay > yard.chargers) {
      return fmt::format("[[bay]] names bay {}: there are bays 1 to {}", bay.bay, yard.chargers);
    }
    if (std::ranges::find(named, bay.bay) != named.end()) {
      return fmt::format("[[bay]] names bay {} twice", bay.bay);
    }
    named.push_back(bay.bay);
    if (yard.one_bus && !bay.real.empty()) {
      return "all bays are on one bus: write real in [bus]";
    }
    const bool has_bus = yard.one_bus ? has_real_bus : !bay.real.empty();
    if (!bay.is_played() && !has_bus) {
      return fmt::format(
          "who is not played in bay {} is on a real bus: write real = \"can0\" in {}", bay.bay,
          yard.one_bus ? "[bus]" : "[[bay]]");
    }
  }
  return "";
}

/// A fault is made in a bay of which nothing is real.
std::string wrong_faults(const YardSettings& yard, const ChargerOptions& network) {
  for (const BayOfFile& bay : yard.bays) {
    const bool has_faults = std::ranges::any_of(
        network.faults.faults, [&](const auto& fault) { return fault.part == bay.bay; });
    if (bay.is_played() || !has_faults) continue;
    return fmt::format("bay {} has a fault: only where charger and battery are both played",
                       bay.bay);
  }
  return "";
}

}  // namespace

void add_yard_options(Verb& verb, YardChoice& choice) {
  verb.add({
      {"--chargers", choice.chargers,
       "a charging yard: 1 (default) to 16 bays with a charger each, and vehicles that come and go",
       between(1U, charger::yard_chargers_max)},
      {"--batteries", choice.batteries, "vehicles of the yard, 1 to 64 (default: one for each bay)",
       between(1U, charger::yard_batteries_max)},
      {"--battery", choice.battery,
       "lead-acid (default), lithium, or plain, which requests no current: the charger has a curve "
       "(IUoU) with equalising; of the first bay, the second ...: lithium,plain"},
      {"--one-bus", choice.one_bus, "all bays are on one bus (default: a bus for each bay)"},
      {"--goal", choice.goal, "for each battery, in % and by the clock: 80@06:00"},
      {"--supply", choice.supply, "what the mains connection bears, in kW (default: not judged)",
       between(0.0, 10'000.0)},
  });
}

YardSettings chosen_yard(const YardChoice& choice) {
  YardSettings yard;
  yard.chargers = choice.chargers;
  yard.batteries = choice.batteries;
  yard.one_bus = choice.one_bus;
  if (!choice.battery.empty()) yard.kinds = split_names(choice.battery);
  yard.goal = choice.goal;
  yard.supply_kilowatt = choice.supply;
  yard.is_given = choice.chargers > 1 || choice.batteries > 1 || choice.one_bus ||
                  !choice.battery.empty() || !choice.goal.empty() || choice.supply > 0;
  return yard;
}

SettingTable<YardSettings> yard_table() {
  constexpr unsigned most = charger::yard_chargers_max;
  return {
      "yard",
      "bays with a charger each, and vehicles that come and go",
      {setting<&YardSettings::chargers>("chargers", "a bay each", {{1, most}}),
       setting<&YardSettings::batteries>("batteries",
                                         "0: one for each charger, or for each [[vehicle]]",
                                         {{0, charger::yard_batteries_max}}),
       setting<&YardSettings::one_bus>("one_bus", "false: a bus for each bay"),
       {.key = "battery",
        .takes = R"(a list of `"lead-acid"`, `"lithium"` and `"plain"`)",
        .help = "of the first bay, the second ...; a plain one requests no current",
        .take = [](TomlTable& table, YardSettings& yard) { table.take("battery", yard.kinds); },
        .value =
            [](const YardSettings& yard) {
              return yard.kinds.empty() ? std::string() : detail::in_file(yard.kinds);
            },
        .example = R"(["lithium", "plain"])",
        .has_example = [](const YardSettings& yard) { return yard.kinds.empty(); }},
       setting<&YardSettings::goal>("goal", "of each battery, in % and by the clock")
           .as_example("\"80@06:00\""),
       setting<&YardSettings::change_time>("change", "from one vehicle at the cable to the next"),
       setting<&YardSettings::supply_kilowatt>(
           "supply_kw", "what the mains connection bears; 0: not judged", {{0, 10'000}})}};
}

SettingTable<VehicleOfFile> yard_vehicle_table() {
  constexpr SettingLimits<double> share{{0, whole_percent}};
  return {"vehicle",
          "",
          {setting<&VehicleOfFile::bay>("bay", "", {{1, charger::yard_chargers_max}}),
           setting<&VehicleOfFile::percent>("state_of_charge", "%, when it first comes", share),
           setting<&VehicleOfFile::arrives>("arrives", "from the start on; left out: at the start",
                                            {Duration::zero()}),
           setting<&VehicleOfFile::leaves>("leaves", "left out: it stays"),
           setting<&VehicleOfFile::returns>("returns", "left out: it stays away"),
           setting<&VehicleOfFile::used_percent>("used", "% of the capacity, while it is away",
                                                 share)}};
}

SettingTable<BayOfFile> yard_bay_table() {
  return {
      "bay",
      "",
      {setting<&BayOfFile::bay>("bay", "", {{1, charger::yard_chargers_max}}),
       setting<&BayOfFile::plays_charger>("charger_played", "false: a real one is on the bus"),
       setting<&BayOfFile::plays_battery>("battery_played",
                                          "false: the vehicles of the bay have a real one"),
       {.key = "real",
        .takes = "a bus, as `\"can0\"`",
        .help = "of a bay with a bus of its own; all runs at the speed of the clock",
        .take =
            [](TomlTable& table, BayOfFile& bay) {
              std::vector<RealBus> real;
              take_real_bus(table, 0, real);
              if (!real.empty()) bay.real = real.front().address;
            },
        .value = [](const BayOfFile& bay) { return bay.real.empty() ? "" : text_value(bay.real); },
        .example = "\"can0\""}}};
}

std::vector<RealBus> real_buses_of(const YardSettings& yard) {
  std::vector<RealBus> real;
  for (const BayOfFile& bay : yard.bays) {
    if (!bay.real.empty()) real.push_back({BusIndex{bay.bay - 1}, bay.real});
  }
  return real;
}

std::string wrong_of_yard(const YardSettings& yard, const ChargerOptions& network,
                          bool has_real_bus) {
  for (const std::string& kind : yard.kinds) {
    if (!parse_kind(kind)) {
      return fmt::format("there is no battery '{}': there are {}", kind,
                         fmt::join(charger::battery_kind_names, ", "));
    }
  }
  if (yard.kinds.size() > yard.chargers) {
    return fmt::format("there are {} kinds of batteries for {} bay{}: give each bay one, or fewer",
                       yard.kinds.size(), yard.chargers, yard.chargers == 1 ? "" : "s");
  }
  if (!yard.goal.empty() && !parse_goal(yard.goal)) {
    return fmt::format("'{}' is no goal: write 80@06:00, for 80 % at six o'clock", yard.goal);
  }
  if (!network.plays_charger || !network.plays_battery) {
    return "which bay has a real one? Write [[bay]] with charger_played or battery_played = false";
  }
  for (const std::string& wrong : {wrong_node_ids(yard, network), wrong_vehicle(yard),
                                   wrong_bay(yard, has_real_bus), wrong_faults(yard, network)}) {
    if (!wrong.empty()) return wrong;
  }
  return "";
}

YardOptions yard_of(const YardSettings& yard, const ChargerOptions& network) {
  YardOptions made;
  made.bay = network;
  made.chargers = yard.chargers;
  made.one_bus = yard.one_bus;
  made.change_time = yard.change_time;
  made.supply_watt = yard.supply_kilowatt * 1000;
  if (!yard.kinds.empty()) made.kinds.clear();
  for (const std::string& kind : yard.kinds) made.kinds.push_back(*parse_kind(kind));
  if (const auto goal = parse_goal(yard.goal)) {
    made.goal = charger::Goal{.state_of_charge = goal->percent / whole_percent,
                              .at = time_of(*goal, network)};
  }
  const auto or_never = [](Duration time) { return time == Duration::zero() ? never : Time(time); };
  for (const VehicleOfFile& vehicle : yard.vehicles) {
    made.vehicles.push_back({.bay = vehicle.bay,
                             .state_of_charge = vehicle.percent / whole_percent,
                             .arrives = Time(vehicle.arrives),
                             .leaves = or_never(vehicle.leaves),
                             .returns = or_never(vehicle.returns),
                             .used = vehicle.used_percent / whole_percent});
  }
  for (const BayOfFile& bay : yard.bays) {
    if (!bay.plays_charger) made.real_chargers.push_back(bay.bay);
    if (!bay.plays_battery) made.real_batteries.push_back(bay.bay);
  }
  made.batteries = yard.batteries == 0 ? yard.chargers : yard.batteries;
  if (made.vehicles.empty()) made.vehicles = charger::drawn_vehicles(made);
  made.batteries = static_cast<unsigned>(made.vehicles.size());
  return made;
}

}  // namespace canvoy::tools
