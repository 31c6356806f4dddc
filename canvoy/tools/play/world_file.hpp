// Common parts of the network files of all worlds: duration, seed, faults, real buses and devices
// that are not played. A world adds tables of its own.
//
//     const WorldFile<PoliceRun> file = {.network = "police", .title = "A patrol of a police car:
//     CiA 447-3.", ...}; take_run(table, file, run);     // throws Failure with file and line
//     run_text(file, run);            // reads as the same
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/sim/fault.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/play/settings.hpp"
#include "canvoy/tools/player/player.hpp"

namespace canvoy::tools {

/// Common data of the run of each world, beside its network.
struct WorldRun {
  std::vector<RealBus> real{};
  std::vector<std::string> faults_of_file{};  ///< as read, until they are added
  std::vector<std::string> acts{};            ///< of the file and of people, see act.hpp

  bool has_real(BusIndex bus) const {
    return std::ranges::find(real, bus, &RealBus::bus) != real.end();
  }
};

/// A table of a file, or all tables of one name.
template <class Run>
struct FilePart {
  std::function<void(TomlTable&, Run&)> take;
  std::function<std::string(const Run&)> text;
  std::string keys;  ///< rows of a table in docs

  /// `[table]`
  FilePart(SettingTable<Run> table)  // NOLINT(google-explicit-constructor): it is one
      : take([table](TomlTable& file, Run& run) { take_settings(file, table, run); }),
        text([table](const Run& run) { return settings_text(table, run); }),
        keys(keys_text("[" + table.name + "]", table.settings)) {}
  FilePart(std::function<void(TomlTable&, Run&)> takes,
           std::function<std::string(const Run&)> writes, std::string rows)
      : take(std::move(takes)), text(std::move(writes)), keys(std::move(rows)) {}
};

/// Each `[[table]]`, with keys that may depend on the run so far; `items` has them, and `add` takes
/// one that was read.
template <class Run, class Item>
FilePart<Run> several(std::function<SettingTable<Item>(const Run&)> table,
                      std::function<std::vector<Item>(const Run&)> items,
                      std::function<void(const TomlTable&, Run&, Item)> add) {
  const SettingTable<Item> blank = table(Run{});
  return {[table, add = std::move(add)](TomlTable& file, Run& run) {
            const SettingTable<Item> rows = table(run);
            for (TomlTable& each : file.tables(rows.name)) {
              Item item{};
              take_settings(each, rows.settings, item);
              each.finish();
              if (rows.check) rows.check(each, item);
              add(each, run, std::move(item));
            }
          },
          [table, items = std::move(items)](const Run& run) {
            const SettingTable<Item> rows = table(run);
            std::string all;
            for (const Item& item : items(run)) all += settings_text(rows, item, true);
            return all;
          },
          keys_text("[[" + blank.name + "]]", blank.settings)};
}

template <class Run>
struct WorldFile {
  std::string_view network{};  ///< `taxi`
  std::string_view title{};    ///< title of a file; empty: none
  std::vector<Setting<Run>> head{};
  std::vector<FilePart<Run>> parts{};
};

/// All keys of its files, as a table in docs.
template <class Run>
std::string keys_text(const WorldFile<Run>& file) {
  std::string text =
      "| table | key | takes | |\n| --- | --- | --- | --- |\n" + keys_text("", file.head);
  for (const FilePart<Run>& part : file.parts) text += part.keys;
  return text;
}

/// `seed = 1`
template <class Run>
Setting<Run> seed_setting() {
  return {.key = "seed",
          .takes = "a whole number",
          .help = "of all that is left to chance",
          .take = [](TomlTable& table, Run& run) { table.take("seed", run.network.faults.seed); },
          .value = [](const Run& run) { return fmt::format("{}", run.network.faults.seed); }};
}

/// `faults = ["lost-node@20min"]`
template <class Run>
Setting<Run> faults_setting(std::string_view network) {
  return {.key = "faults",
          .takes = "a list of texts",
          .help = fmt::format("NAME@START or NAME@START+DURATION; canvoy run {} --help lists them",
                              network),
          .take = [](TomlTable& table, Run& run) { table.take("faults", run.faults_of_file); },
          .value =
              [](const Run& run) {
                std::vector<std::string> faults;
                faults.reserve(run.network.faults.faults.size());
                for (const auto& fault : run.network.faults.faults) {
                  faults.push_back(fmt::format("\"{}\"", fault_text(fault)));
                }
                return fmt::format("[{}]", fmt::join(faults, ", "));
              }};
}

/// `acts = ["visit:from=2:to=7@1min"]`
template <class Run>
Setting<Run> acts_setting() {
  return {
      .key = "acts",
      .takes = "a list of texts",
      .help = "what people did from outside, as the page writes it",
      .take = [](TomlTable& table, Run& run) { table.take("acts", run.acts); },
      .value = [](const Run& run) { return run.acts.empty() ? "" : detail::in_file(run.acts); }};
}

/// Duration, seed, faults and acts.
template <class Run>
std::vector<Setting<Run>> world_head(Setting<Run> length, std::string_view network) {
  return {std::move(length), seed_setting<Run>(), faults_setting<Run>(network),
          acts_setting<Run>()};
}

/// `real = "can0"` at a bus.
template <class Run>
Setting<Run> real_setting(BusIndex bus) {
  return {.key = "real",
          .takes = "a bus, as `\"can0\"`",
          .help = "a real bus is a part of it; all runs at the speed of the clock",
          .take = [bus](TomlTable& table, Run& run) { take_real_bus(table, bus, run.real); },
          .value =
              [bus](const Run& run) {
                const auto real = std::ranges::find(run.real, bus, &RealBus::bus);
                return real == run.real.end() ? "" : text_value(real->address);
              },
          .example = fmt::format("\"can{}\"", bus)};
}

/// `played = false` at a device of a network that has a list of real devices.
template <class Run>
Setting<Run> played(NodeId id, bool has_help = false) {
  return {.key = "played",
          .takes = "`true` or `false`",
          .help = has_help ? "false: a real one is on the bus" : "",
          .take =
              [id](TomlTable& table, Run& run) {
                bool is_played = true;
                table.take("played", is_played);
                if (!is_played) run.network.real.push_back(id);
              },
          .value =
              [id](const Run& run) {
                const auto& real = run.network.real;
                return fmt::format("{}", std::ranges::find(real, id) == real.end());
              }};
}

/// Checks that each device that is not played is on a real bus, and that there are then no faults.
/// `bus_of` gives the bus of a node, and `tables` its name in the file.
template <class Run>
void check_real(const TomlTable& file, const Run& run, BusIndex (*bus_of)(NodeId),
                std::initializer_list<std::string_view> tables) {
  for (const NodeId id : run.network.real) {
    const BusIndex bus = bus_of(id);
    if (run.has_real(bus)) continue;
    const std::string where =
        tables.size() == 1 ? "" : fmt::format(" in [{}]", tables.begin()[bus]);
    file.refuse(
        fmt::format("who is not played is on a real bus: write real = \"can{}\"{}", bus, where));
  }
  if (!run.network.real.empty() && !run.network.faults.faults.empty()) {
    file.refuse("faults", "only where all devices are played");
  }
}

/// Reads the whole table; faults are not added yet. Throws Failure with file and line.
template <class Run>
void take_run(TomlTable& file, const WorldFile<Run>& world, Run& run) {
  take_settings(file, world.head, run);
  for (const auto& each : world.parts) each.take(file, run);
  file.finish();
}

/// A file with the same meaning, with a comment for each value.
template <class Run>
std::string run_text(const WorldFile<Run>& world, const Run& run) {
  std::string text = world.title.empty() ? "" : fmt::format("# {}\n", world.title);
  text += fmt::format("network = \"{}\"\n", world.network) + settings_text(world.head, run);
  for (const auto& each : world.parts) text += each.text(run);
  return text;
}

}  // namespace canvoy::tools
