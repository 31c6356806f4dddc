#include "canvoy/tools/device/bus/bus_press.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "canvoy/devices/cia407/by_code/code_only_unit.hpp"
#include "canvoy/devices/cia407/generic_io/generic_io_unit.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

using cia407::DeviceCode;

/// A number after the colon; one with a name is optional.
struct BusPressNumber {
  std::string_view name;  ///< empty: a single number
  std::uint32_t most = 0;
  std::uint32_t least = 0;
  std::span<const std::uint16_t> choice = {};  ///< empty: any in the range

  bool allows(std::uint32_t number) const {
    const bool is_chosen = choice.empty() || std::ranges::find(choice, number) != choice.end();
    return number >= least && number <= most && is_chosen;
  }
};
struct BusPressInfo {
  DeviceCode code;
  std::string_view name;
  std::string_view example;
  std::span<const BusPressNumber> numbers = {};

  /// The number selects one of several: `key5`, `open2`; otherwise it is an amount, or an error.
  bool is_numbered() const {
    const std::string_view each = example.substr(name.size(), 1);
    return !each.empty() && each != "=" && each != "@";
  }
};

constexpr std::uint32_t any_16 = 0xFFFF;
constexpr std::uint32_t any_32 = 0xFFFF'FFFF;
constexpr BusPressNumber of_key[] = {{"", 32, 1}};
constexpr BusPressNumber of_door[] = {{"", 12, 1}};
constexpr BusPressNumber of_slot[] = {{"", 2, 1}};
constexpr BusPressNumber people_numbers[] = {{"", 255, 1}};
constexpr BusPressNumber assignment[] = {{"driver", any_32},  {"line", any_16},
                                         {"route", any_16},   {"block", any_32},
                                         {"journey", any_16}, {"destination", any_32}};
constexpr BusPressNumber position_numbers[] = {
    {"stop", any_32}, {"zone", 255}, {"segment", any_16}, {"running", 255}};
constexpr BusPressNumber relayed[] = {{"index", 0x67FF, 0x6000}, {"sub", 254}, {"value", any_32}};
constexpr BusPressNumber of_output[] = {{"", any_16, 0, cia407::GenericIoUnit::errors}};
constexpr BusPressNumber of_supply[] = {{"", any_16, 0, cia407::power_errors}};

constexpr BusPressInfo presses[] = {
    {DeviceCode::main_on_board_computer, "place", "place=stop:17,zone:2,segment:1@2s",
     position_numbers},
    {DeviceCode::main_on_board_computer, "stop", "stop@2s"},
    {DeviceCode::main_on_board_computer, "block", "block@2s"},
    {DeviceCode::main_on_board_computer, "unblock", "unblock@2s"},
    {DeviceCode::identification, "log-in", "log-in=driver:1234,line:23@2s", assignment},
    {DeviceCode::identification, "log-out", "log-out@2s"},
    {DeviceCode::ticket_canceller, "ticket", "ticket@2s"},
    {DeviceCode::ticket_printer, "sell", "sell@2s"},
    {DeviceCode::ticket_printer, "no-paper", "no-paper@2s"},
    {DeviceCode::ticket_printer, "paper", "paper@2s"},
    {DeviceCode::train_bus_gateway, "from-train", "from-train=index:0x6109,value:17@2s", relayed},
    {DeviceCode::vehicle_gateway, "open", "open2@2s", of_door},
    {DeviceCode::vehicle_gateway, "close", "close2@2s", of_door},
    {DeviceCode::vehicle_gateway, "brake", "brake@2s"},
    {DeviceCode::vehicle_gateway, "release", "release@2s"},
    {DeviceCode::tachograph, "card", "card1@2s", of_slot},
    {DeviceCode::tachograph, "no-card", "no-card1@2s", of_slot},
    {DeviceCode::data_radio, "disconnect", "disconnect@2s"},
    {DeviceCode::data_radio, "connect", "connect@2s"},
    {DeviceCode::voice_radio, "disconnect", "disconnect@2s"},
    {DeviceCode::voice_radio, "connect", "connect@2s"},
    {DeviceCode::short_range_communication, "disconnect", "disconnect@2s"},
    {DeviceCode::short_range_communication, "connect", "connect@2s"},
    {DeviceCode::geographical_positioning, "no-signal", "no-signal@2s"},
    {DeviceCode::geographical_positioning, "signal", "signal@2s"},
    {DeviceCode::time_fixing, "no-signal", "no-signal@2s"},
    {DeviceCode::time_fixing, "signal", "signal@2s"},
    {DeviceCode::drivers_console_keyboard, "key", "key5@2s", of_key},
    {DeviceCode::drivers_console_keyboard, "reverse", "reverse@2s"},
    {DeviceCode::drivers_console_keyboard, "forward", "forward@2s"},
    {DeviceCode::passenger_counter, "in", "in=3@2s", people_numbers},
    {DeviceCode::passenger_counter, "out", "out=3@2s", people_numbers},
    {DeviceCode::passenger_counter, "open-door", "open-door@2s"},
    {DeviceCode::passenger_counter, "close-door", "close-door@2s"},
    {DeviceCode::passenger_counting_manager, "clear", "clear@2s"},
    {DeviceCode::generic_io, "input", "input5@2s", of_key},
    {DeviceCode::generic_io, "fail", "fail=0x2320@2s", of_output},
    {DeviceCode::generic_io, "mend", "mend=0x2320@2s", of_output},
    {DeviceCode::power_supply, "fail", "fail=0x3110@2s", of_supply},
    {DeviceCode::power_supply, "mend", "mend=0x3110@2s", of_supply},
};

bool is_of(const BusPressInfo& info, std::span<const cia407::BusUnit* const> units) {
  return std::ranges::any_of(units, [&](const cia407::BusUnit* unit) {
    return unit->provides->code == code_of(info.code);
  });
}

std::string_view name_of_press(std::string_view text) {
  return text.substr(0, text.find_first_of(":=@0123456789"));
}

const BusPressInfo* find_press(std::span<const cia407::BusUnit* const> units,
                               std::string_view name) {
  for (const BusPressInfo& info : presses) {
    if (info.name == name && is_of(info, units)) return &info;
  }
  return nullptr;
}

std::optional<std::uint32_t> number_in(std::string_view text) {
  const bool is_hex = text.starts_with("0x");
  if (is_hex) text.remove_prefix(2);
  std::uint32_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, is_hex ? 16 : 10);
  return error == std::errc{} && stop == end && !text.empty() ? std::optional(number)
                                                              : std::nullopt;
}

[[noreturn]] void refuse_press(std::span<const cia407::BusUnit* const> units,
                               std::string_view text) {
  std::string examples;
  for (const BusPressInfo& info : presses) {
    if (!is_of(info, units)) continue;
    examples += fmt::format("{}{}", examples.empty() ? "" : ", ", info.example);
  }
  throw UsageError(fmt::format("--press: '{}' is nothing that happens here with a time: {}", text,
                               examples.empty() ? "there is nothing" : "write " + examples));
}

/// Reads `17` or `driver:1234`, also `driver=1234`.
bool take_number(BusPress& press, const BusPressInfo& info, std::string_view text) {
  const std::size_t colon = text.find_first_of(":=");
  const std::string_view name = colon == std::string_view::npos ? "" : text.substr(0, colon);
  const auto number = number_in(colon == std::string_view::npos ? text : text.substr(colon + 1));
  const auto place = std::ranges::find(info.numbers, name, &BusPressNumber::name);
  if (!number || place == info.numbers.end() || !place->allows(*number)) return false;
  return press.numbers.emplace(name, *number).second;
}

}  // namespace

bool has_bus_press(std::span<const cia407::BusUnit* const> units, std::string_view text) {
  return find_press(units, name_of_press(text)) != nullptr;
}

BusPress parse_bus_press(std::span<const cia407::BusUnit* const> units, std::string_view text) {
  const std::size_t at = text.rfind('@');
  const BusPressInfo* const info = find_press(units, name_of_press(text));
  if (info == nullptr || at == std::string_view::npos) refuse_press(units, text);
  BusPress press{.what = info->name};
  std::string_view rest = text.substr(info->name.size(), at - info->name.size());
  // `in=3`, `open2`, `log-in=driver:1234,line:23`; also `in:3`, `log-in:driver=1234:line=23`.
  const char comma = rest.starts_with(':') ? ':' : ',';
  if (rest.starts_with(':') || rest.starts_with('=')) rest.remove_prefix(1);
  while (!rest.empty()) {
    const std::string_view number = rest.substr(0, rest.find(comma));
    if (!take_number(press, *info, number)) refuse_press(units, text);
    rest.remove_prefix(std::min(number.size() + 1, rest.size()));
  }
  const bool wants_number = !info->numbers.empty() && info->numbers.front().name.empty();
  if (wants_number && !press.number()) refuse_press(units, text);
  press.at = parse_moment_argument(text.substr(at + 1));
  return press;
}

std::vector<DeviceHand> bus_press_hands(const cia407::BusUnit& unit) {
  std::vector<DeviceHand> hands;
  const cia407::BusUnit* const units[] = {&unit};
  for (const BusPressInfo& info : presses) {
    if (!is_of(info, units)) continue;
    DeviceHand& hand = hands.emplace_back(DeviceHand{.name = std::string(info.name)});
    if (info.numbers.empty()) continue;
    const BusPressNumber& first = info.numbers.front();
    if (!first.name.empty()) {
      hand.form = HandForm::text;
      const std::string_view example = info.example.substr(info.name.size() + 1);
      hand.example = example.substr(0, example.find('@'));
    } else if (!first.choice.empty()) {
      hand.form = HandForm::word;
      for (const std::uint16_t code : first.choice) {
        hand.words.push_back({fmt::format("{:#06x}", code), code});
      }
    } else if (info.is_numbered()) {
      hand.count = first.most;
    } else {
      hand.form = HandForm::number;
      hand.least = first.least;
      hand.most = first.most;
    }
  }
  return hands;
}

}  // namespace canvoy::tools
