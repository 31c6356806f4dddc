#include "canvoy/tools/network/boot_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/toml_file.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/sheet/configuration_file.hpp"

namespace canvoy::tools {

namespace {

constexpr Duration longest = std::chrono::milliseconds(0xFFFF);
constexpr Duration longest_inhibit_time = std::chrono::milliseconds(6553);

constexpr std::array<std::string_view, 18> slave_words = {"mandatory",
                                                          "keep-alive",
                                                          "watch-only",
                                                          "name",
                                                          "device",
                                                          "vendor",
                                                          "product",
                                                          "revision",
                                                          "serial",
                                                          "heartbeat",
                                                          "guard",
                                                          "configuration",
                                                          "configuration-date",
                                                          "restore",
                                                          "program",
                                                          "program-id",
                                                          "program-date",
                                                          "update"};

std::uint32_t parse_number(std::string_view key, std::string_view text) {
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  const std::string_view digits = hexadecimal ? text.substr(2) : text;
  std::uint32_t number = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), number, hexadecimal ? 16 : 10);
  if (error != std::errc{} || end != digits.data() + digits.size()) {
    throw UsageError(fmt::format("{}={}: write a number of 32 bits, as 291 or 0x123", key, text));
  }
  return number;
}

/// In the range of 1016h and 1F81h.
Duration parse_period(std::string_view key, std::string_view text) {
  const auto period = parse_duration(text);
  if (!period || *period < 1ms || *period > longest) {
    throw UsageError(
        fmt::format("{}={}: write a time from 1ms to 65535ms, as 500ms or 1.5s", key, text));
  }
  return *period;
}

/// 102Ah is in units of 100 us.
Duration parse_inhibit_time(std::string_view text) {
  const Duration time = parse_period("inhibit", text);
  if (time > longest_inhibit_time) throw UsageError("inhibit: 102Ah holds 1ms to 6553ms");
  return time;
}

/// `200ms` or `200ms*5`.
void set_guarding(SlavePlan& slave, std::string_view text) {
  const std::size_t star = text.find('*');
  slave.guard_time = parse_period("guard", text.substr(0, star));
  if (star == std::string_view::npos) return;
  const std::uint32_t factor = parse_number("guard", text.substr(star + 1));
  if (factor < 1 || factor > 255) {
    throw UsageError(fmt::format("guard={}: the factor is 1 to 255, as 200ms*3", text));
  }
  slave.guard_factor = static_cast<std::uint8_t>(factor);
}

bool is_true(std::string_view key, std::string_view text) {
  if (text == "true" || text == "false") return text == "true";
  throw UsageError(fmt::format("{}={}: write {} alone, or true or false", key, text, key));
}

/// Reads a date in the form of 1F26h and 1F27h, or 1F53h and 1F54h.
SlavePlan::Date parse_date(std::string_view key, std::string_view text) {
  const auto date = text::parse_time_of_day(text);
  if (!date) {
    throw UsageError(
        fmt::format("{}={}: write a time after 1984, as 2026-11-21 12:00:00", key, text));
  }
  return {date->days, date->milliseconds};
}

/// A sub-index of 1011h, or `restore` alone for all parameters.
std::uint8_t parse_restore(std::string_view text) {
  if (text == "true") return 1;
  const std::uint32_t sub = parse_number("restore", text);
  if (sub < 1 || sub > 254) {
    throw UsageError(fmt::format("restore={}: a sub-index of 1011h, 1 to 254", text));
  }
  return static_cast<std::uint8_t>(sub);
}

struct NumberWord {
  std::string_view key;
  std::uint32_t SlavePlan::*field;
};
constexpr auto number_words = std::to_array<NumberWord>({
    {"device", &SlavePlan::device_type},
    {"vendor", &SlavePlan::vendor_id},
    {"product", &SlavePlan::product_code},
    {"revision", &SlavePlan::revision_number},
    {"serial", &SlavePlan::serial_number},
    {"program-id", &SlavePlan::program_id},
});

/// Sets its files. False for another key.
bool set_content(SlavePlan& slave, std::string_view key, std::string_view value,
                 const std::filesystem::path& folder) {
  if (key == "configuration") {
    slave.concise_dcf =
        formats::concise_dcf_of(read_configuration((folder / value).string(), slave.id).entries);
  } else if (key == "configuration-date") {
    slave.configuration_date = parse_date(key, value);
  } else if (key == "restore") {
    slave.restored_sub = parse_restore(value);
  } else if (key == "program") {
    slave.program = read_value_file((folder / value).string());
    if (slave.program.empty()) throw Failure(fmt::format("{}: it is empty, and no program", value));
  } else if (key == "program-date") {
    slave.program_date = parse_date(key, value);
  } else if (key == "update") {
    slave.may_be_updated = is_true(key, value);
  } else {
    return false;
  }
  return true;
}

/// File names are relative to `folder`.
void set(SlavePlan& slave, std::string_view key, std::string_view value,
         const std::filesystem::path& folder) {
  if (set_content(slave, key, value, folder)) return;
  const auto* word = std::ranges::find(number_words, key, &NumberWord::key);
  if (word != number_words.end()) {
    slave.*word->field = parse_number(key, value);
  } else if (key == "name") {
    slave.name = value;
  } else if (key == "heartbeat") {
    slave.heartbeat = parse_period(key, value);
  } else if (key == "guard") {
    set_guarding(slave, value);
  } else if (key == "mandatory") {
    slave.is_mandatory = is_true(key, value);
  } else if (key == "keep-alive") {
    slave.is_kept_alive = is_true(key, value);
  } else if (key == "watch-only") {
    slave.is_only_watched = is_true(key, value);
  } else {
    throw UsageError(fmt::format("'{}' is not known of a slave; there are {}{}", key,
                                 fmt::join(slave_words, ", "),
                                 did_you_mean(key, {slave_words.begin(), slave_words.end()})));
  }
}

void add(BootPlan& plan, const SlavePlan& slave) {
  if (std::ranges::find(plan.slaves, slave.id, &SlavePlan::id) != plan.slaves.end()) {
    throw UsageError(fmt::format("{} is given twice", text::node_text(slave.id)));
  }
  plan.slaves.push_back(slave);
}

void set_master(BootPlan& plan, std::string_view key, std::string_view value) {
  if (key == "node") {
    plan.master = parse_node_id(value);
  } else if (key == "boot-time") {
    plan.boot_time = parse_duration_argument(value);
  } else if (key == "inhibit") {
    plan.inhibit_time = parse_inhibit_time(value);
  } else if (key == "start") {
    plan.start = parse_start(value);
  } else if (key == "reset") {
    plan.resets = is_true(key, value);
  } else {
    throw UsageError(fmt::format(
        "'{}' is not known of the master; there are node, boot-time, inhibit, start, reset", key));
  }
}

/// A value of the file in the notation of the command line.
std::string text_of(std::string_view key, const toml::node& value) {
  if (const auto text = value.value_exact<std::string>()) return *text;
  if (const auto number = value.value_exact<std::int64_t>()) return fmt::format("{}", *number);
  if (const auto truth = value.value_exact<bool>()) return *truth ? "true" : "false";
  if (const auto moment = value.value_exact<toml::date_time>()) {
    const toml::date& date = moment->date;
    const toml::time& time = moment->time;
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}.{:03}", date.year, date.month, date.day,
                       time.hour, time.minute, time.second, time.nanosecond / 1'000'000);
  }
  throw UsageError(fmt::format("{}: write a number, a text in quotes, true or false", key));
}

/// Calls `take` for each entry of a table; errors give its line.
template <class Take>
void each(const std::string& path, const toml::table& table, Take take) {
  for (const auto& [key, value] : table) {
    try {
      take(key.str(), text_of(key.str(), value));
    } catch (const Failure& failure) {
      throw Failure(fmt::format("{} line {}: {}", path, value.source().begin.line, failure.what()));
    }
  }
}

SlavePlan read_slave(const std::string& path, const toml::table& table) {
  SlavePlan slave;
  // Its configuration may depend on its node-ID.
  each(path, table, [&](std::string_view key, const std::string& value) {
    if (key == "node") slave.id = parse_node_id(value);
  });
  if (slave.id == 0) {
    throw Failure(fmt::format("{} line {}: a slave without node = 1 to 127", path,
                              table.source().begin.line));
  }
  each(path, table, [&](std::string_view key, const std::string& value) {
    if (key != "node") set(slave, key, value, std::filesystem::path(path).parent_path());
  });
  return slave;
}

void read_slaves(BootPlan& plan, const std::string& path, const toml::node& value) {
  const toml::array* array = value.as_array();
  if (array == nullptr || !array->is_array_of_tables()) {
    throw Failure(
        fmt::format("{} line {}: write slaves as [[slave]]", path, value.source().begin.line));
  }
  for (const toml::node& slave : *array) {
    try {
      add(plan, read_slave(path, *slave.as_table()));
    } catch (const UsageError& error) {
      throw Failure(fmt::format("{} line {}: {}", path, slave.source().begin.line, error.what()));
    }
  }
}

}  // namespace

std::uint32_t SlavePlan::assignment() const {
  const auto guard_ms = static_cast<std::uint32_t>(guard_time / 1ms);
  return 0x01U | (is_only_watched ? 0U : 0x04U) | (is_mandatory ? 0x08U : 0U) |
         (is_kept_alive ? 0x10U : 0U) | (has_checked_program() ? 0x20U : 0U) |
         (may_be_updated ? 0x40U : 0U) | (restored_sub != 0 ? 0x80U : 0U) |
         std::uint32_t{guard_factor} << 8 | guard_ms << 16;
}

std::uint32_t BootPlan::startup() const {
  return 0x01U | (start == Start::all ? 0x02U : 0U) | (start == Start::none ? 0x08U : 0U);
}

void add_slave(BootPlan& plan, std::string_view text) {
  const std::size_t colon = text.find(':');
  SlavePlan slave;
  slave.id = parse_node_id(text.substr(0, colon));
  std::string_view rest = colon == std::string_view::npos ? "" : text.substr(colon + 1);
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    const std::string_view word = rest.substr(0, comma);
    const std::size_t sign = word.find('=');
    set(slave, word.substr(0, sign),
        sign == std::string_view::npos ? "true" : word.substr(sign + 1), {});
    rest = comma == std::string_view::npos ? "" : rest.substr(comma + 1);
  }
  add(plan, slave);
}

BootPlan::Start parse_start(std::string_view text) {
  if (text == "each") return BootPlan::Start::each;
  if (text == "all") return BootPlan::Start::all;
  if (text == "none") return BootPlan::Start::none;
  throw UsageError(fmt::format("start={}: each, all or none", text));
}

BootPlan read_boot_plan(const std::string& path) {
  const toml::table file = parse_toml_file(path);
  BootPlan plan;
  for (const auto& [key, value] : file) {
    const toml::table* table = value.as_table();
    if (key == "master" && table != nullptr) {
      each(path, *table,
           [&](std::string_view word, const std::string& text) { set_master(plan, word, text); });
    } else if (key == "slave") {
      read_slaves(plan, path, value);
    } else {
      throw Failure(fmt::format("{} line {}: '{}' is not known; there are [master] and [[slave]]",
                                path, value.source().begin.line, key.str()));
    }
  }
  return plan;
}

void check(const BootPlan& plan) {
  if (plan.slaves.empty()) {
    throw UsageError("no slave is named: give --node 5 or --config FILE");
  }
  for (const SlavePlan& slave : plan.slaves) {
    if (slave.id == plan.master) {
      throw UsageError(fmt::format("{} is the master itself; give another one with --node-id",
                                   text::node_text(slave.id)));
    }
  }
}

}  // namespace canvoy::tools
