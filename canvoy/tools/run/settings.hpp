// The settings of a network file, a row for each key: it reads the key, refuses what it does not
// take, writes it with its comment, and says in docs/settings.md what it takes.
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

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/network_text.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// `key = value  # help`, and its end. Without a value an example is a comment: `# key = example  #
/// help`; without either, nothing. What has an example has its help beside that alone.
std::string setting_line(std::string_view key, std::string_view value, std::string_view help,
                         std::string_view example, bool is_help_of_example);

/// A key of a table, whose value is in an Owner.
template <class Owner>
struct Setting {
  std::string key;
  std::string takes;  ///< in words: `a number from 0 to 100`
  std::string help;
  /// Throws Failure with file and line.
  std::function<void(TomlTable&, Owner&)> take;
  /// As a file has it; empty: the file has none.
  std::function<std::string(const Owner&)> value;
  std::string example{};

  /// Of which owners the example is shown; empty: of all.
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

/// `[name]  # help`, and the keys in it; without a name: those in front of the first table.
template <class Owner>
struct SettingTable {
  std::string name;
  std::string help;
  std::vector<Setting<Owner>> settings;
  /// What no key alone says: throws Failure with file and line.
  std::function<void(const TomlTable&, Owner&)> check{};
};

/// What may stand behind a key, both ends included; of a time, as of a number.
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
std::string value_text(const std::string& value);  ///< empty for an empty one
std::string value_text(Duration value);            ///< empty for 0
std::string value_text(Time value);
std::string value_text(CivilTime value);
/// As a file has it, also where it is empty.
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

/// What a key takes, in words.
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

/// Of the member that the path leads to: of the owner, of that member, and so on.
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

/// What a file has in place of a member: a text, a number, or a list of them, and how one follows
/// from the other. `read` throws Failure for what is none; `write` gives nothing where a file says
/// nothing.
template <class Owner, class InFile>
struct Mapped {
  std::string key;
  std::string takes;
  std::function<void(Owner&, const InFile&)> read;
  std::function<std::optional<InFile>(const Owner&)> write;
  bool is_needed = false;    ///< without it, what was read is an empty text
  Range<double> range = {};  ///< of numbers
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
/// All of `[name]`, and nothing else may be there.
template <class Owner>
void take_settings(TomlTable& file, const SettingTable<Owner>& table, Owner& owner) {
  TomlTable own = file.table(table.name);
  take_settings(own, table.settings, owner);
  own.finish();
  if (table.check) table.check(own, owner);
}

/// `| [table] | key | takes | help |`, a row for each.
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
/// With an empty line in front. In `brackets`: `[[` of one of several.
template <class Owner>
std::string settings_text(const SettingTable<Owner>& table, const Owner& owner,
                          bool is_one_of_several = false) {
  return fmt::format("\n{0}[{1}]{2}{3}{4}\n", is_one_of_several ? "[" : "", table.name,
                     is_one_of_several ? "]" : "", table.help.empty() ? "" : "  # ", table.help) +
         settings_text(table.settings, owner);
}

}  // namespace canvoy::tools
