// The settings of a network file, one row for each key: it reads the key, refuses invalid values,
// writes it with its comment, and describes it in docs/settings.md.
//
//     const std::vector<Setting<TaxiRun>> rows = {
//         setting<&TaxiRun::network, &TaxiOptions::bit_rate>("bit_rate", "bit/s", {50'000,
//         1'000'000}), setting<&TaxiRun::nmea>("nmea", "a recorded
//         drive").as_example("\"drive.nmea\"")};
//     take_settings(table, rows, run);
//     settings_text(rows, run);
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/toml_file.hpp"
#include "canvoy/tools/sheet/network_text.hpp"

namespace canvoy::tools {

/// A line `key = value  # help`. Without a value, an example is written as a comment: `# key =
/// example  # help`; without both, nothing. If there is an example, only the example has the help.
std::string setting_line(std::string_view key, std::string_view value, std::string_view help,
                         std::string_view example, bool is_help_of_example);

/// A key of a table with a value in an Owner.
template <class Owner>
struct Setting {
  std::string key;
  std::string takes;  ///< in words: `a number from 0 to 100`
  std::string help;
  /// Throws Failure with file and line.
  std::function<void(TomlTable&, Owner&)> take;
  /// The value in the form of a file; empty: not in the file.
  std::function<std::string(const Owner&)> value;
  std::string example{};

  /// Owners for which the example is shown; empty: all.
  std::function<bool(const Owner&)> has_example{};

  Setting as_example(std::string text) && {
    example = std::move(text);
    return std::move(*this);
  }
  std::string line(const Owner& owner) const {
    const bool shows = !has_example || has_example(owner);
    return setting_line(key, value(owner), help, shows ? std::string_view(example) : "",
                        !example.empty());
  }
};

/// A table `[name]  # help` with its keys; without a name: the keys before the first table.
template <class Owner>
struct SettingTable {
  std::string name;
  std::string help;
  std::vector<Setting<Owner>> settings;
  /// Checks beyond single keys: throws Failure with file and line.
  std::function<void(const TomlTable&, Owner&)> check{};
};

/// Accepted range of a key, inclusive; for a time, as for a number.
template <class Value>
struct SettingLimits {};
template <class Value>
  requires std::floating_point<Value> ||
           (std::unsigned_integral<Value> && !std::same_as<Value, bool>)
struct SettingLimits<Value> : Range<Value> {};
template <>
struct SettingLimits<Duration> {
  Duration least = Duration{1};
  Duration most = Duration::max();
};
template <>
struct SettingLimits<Time> : SettingLimits<Duration> {};

namespace detail {

template <class Class, class Value>
Class owner_of(Value Class::*);
template <class Class, class Value>
Value value_of(Value Class::*);
template <auto first, auto...>
struct FirstOf {
  using Owner = decltype(owner_of(first));
};
template <auto... path>
struct LastOf;
template <auto last>
struct LastOf<last> {
  using Value = decltype(value_of(last));
};
template <auto first, auto... rest>
struct LastOf<first, rest...> : LastOf<rest...> {};

void take_time(TomlTable& table, std::string_view key, Duration& to,
               SettingLimits<Duration> limits);

template <class Value>
void take_value(TomlTable& table, const std::string& key, Value& to,
                const SettingLimits<Value>& limits) {
  if constexpr (std::same_as<Value, Duration>) {
    take_time(table, key, to, limits);
  } else if constexpr (std::same_as<Value, Time>) {
    Duration time = to - Time{};
    take_time(table, key, time, limits);
    to = Time{} + time;
  } else if constexpr (std::derived_from<SettingLimits<Value>, Range<Value>>) {
    table.take(key, to, Range<Value>(limits));
  } else if constexpr (requires { to.reset(); }) {
    typename Value::value_type value{};
    table.take(key, value);
    to = table.has(key) ? Value(value) : Value();
  } else {
    table.take(key, to);
  }
}

std::string value_text(bool value);
std::string value_text(double value);
std::string value_text(const std::string& value);  ///< empty for an empty text
std::string value_text(Duration value);            ///< empty for 0
std::string value_text(Time value);
std::string value_text(CivilTime value);
/// The value in the form of a file, also if it is empty.
std::string in_file(double value);
std::string in_file(const std::string& value);
std::string in_file(const std::vector<double>& value);
std::string in_file(const std::vector<std::string>& value);
template <std::unsigned_integral Number>
std::string value_text(Number value) {
  return fmt::format("{}", value);
}
template <class Value>
std::string value_text(const std::optional<Value>& value) {
  return value ? value_text(*value) : std::string();
}

template <class Number>
std::string range_words(std::string_view what, const Range<Number>& range) {
  const bool is_open = range.most == Range<Number>{}.most && range.least == Range<Number>{}.least;
  return is_open ? std::string(what)
                 : fmt::format("{} from {} to {}", what, range.least, range.most);
}
std::string range_words(const SettingLimits<Duration>& limits);

/// Accepted values of a key, in words.
template <class Value>
std::string words_of(const SettingLimits<Value>& limits) {
  if constexpr (std::same_as<Value, bool>)
    return "`true` or `false`";
  else if constexpr (std::floating_point<Value>)
    return range_words<Value>("a number", limits);
  else if constexpr (std::unsigned_integral<Value>)
    return range_words<Value>("a whole number", limits);
  else if constexpr (std::same_as<Value, Duration> || std::same_as<Value, Time>)
    return range_words(limits);
  else if constexpr (std::same_as<Value, std::string>)
    return "a text";
  else
    return "a date and time, as `2026-11-21T18:00:00`";
}

}  // namespace detail

/// A setting for the member at the path: a member of the owner, a member of that, and so on.
template <auto... path>
Setting<typename detail::FirstOf<path...>::Owner> setting(
    std::string key, std::string help = {},
    SettingLimits<typename detail::LastOf<path...>::Value> limits = {}) {
  using Owner = typename detail::FirstOf<path...>::Owner;
  return {.key = key,
          .takes = detail::words_of(limits),
          .help = std::move(help),
          .take = [key, limits](
                      TomlTable& table,
                      Owner& owner) { detail::take_value(table, key, (owner.*....*path), limits); },
          .value = [](const Owner& owner) { return detail::value_text((owner.*....*path)); }};
}

/// The form of a member in a file: a text, a number, or a list of them, with conversions. `read`
/// throws Failure for an invalid value; `write` returns nothing if the file omits it.
template <class Owner, class InFile>
struct Mapped {
  std::string key;
  std::string takes;
  std::function<void(Owner&, const InFile&)> read;
  std::function<std::optional<InFile>(const Owner&)> write;
  bool is_needed = false;    ///< without it, a missing value reads as an empty text
  Range<double> range = {};  ///< for numbers
};
template <class Owner, class InFile>
Setting<Owner> mapped(Mapped<Owner, InFile> row, std::string help = {}) {
  return {.key = row.key,
          .takes = row.takes,
          .help = std::move(help),
          .take =
              [row](TomlTable& table, Owner& owner) {
                InFile value{};
                if constexpr (requires { table.take(row.key, value, row.range); }) {
                  table.take(row.key, value, row.range);
                } else {
                  table.take(row.key, value);
                }
                if (!table.has(row.key) && !row.is_needed) return;
                try {
                  row.read(owner, value);
                } catch (const Failure& wrong) {
                  table.refuse(row.key, wrong.what());
                }
              },
          .value =
              [write = row.write](const Owner& owner) {
                const std::optional<InFile> value = write(owner);
                return value ? detail::in_file(*value) : std::string();
              }};
}

template <class Owner>
void take_settings(TomlTable& table, const std::vector<Setting<Owner>>& settings, Owner& owner) {
  for (const Setting<Owner>& each : settings) each.take(table, owner);
}
/// Reads all of `[name]`; refuses other keys.
template <class Owner>
void take_settings(TomlTable& file, const SettingTable<Owner>& table, Owner& owner) {
  TomlTable own = file.table(table.name);
  take_settings(own, table.settings, owner);
  own.finish();
  if (table.check) table.check(own, owner);
}

/// Rows `| [table] | key | takes | help |`.
template <class Owner>
std::string keys_text(std::string_view table, const std::vector<Setting<Owner>>& settings) {
  std::string text;
  for (const Setting<Owner>& each : settings) {
    text +=
        fmt::format("| {} | `{}` | {} | {} |\n", table.empty() ? "" : fmt::format("`{}`", table),
                    each.key, each.takes, each.help);
  }
  return text;
}

template <class Owner>
std::string settings_text(const std::vector<Setting<Owner>>& settings, const Owner& owner) {
  std::string text;
  for (const Setting<Owner>& each : settings) {
    text += each.line(owner);
  }
  return text;
}
/// Writes a table after an empty line. `brackets`: `[[` for one of several.
template <class Owner>
std::string settings_text(const SettingTable<Owner>& table, const Owner& owner,
                          bool is_one_of_several = false) {
  return fmt::format("\n{0}[{1}]{2}{3}{4}\n", is_one_of_several ? "[" : "", table.name,
                     is_one_of_several ? "]" : "", table.help.empty() ? "" : "  # ", table.help) +
         settings_text(table.settings, owner);
}

}  // namespace canvoy::tools
