// The built-in networks: one row for each, used by `run`, `report`, network files, data sheets and
// fuzzing. What they have in common is here; a world defines the rest in a class of its own:
//
//     struct PoliceWorld {
//       using Run = PoliceRun;  // its network, as options, and what it has beside that
//       using Kind = police::FaultKind;
//       struct Choice {};  // of the command line, beside what all have
//
//       static WorldInfo info();
//       static WorldFile<Run> file(const std::string& folder);
//       static void check(const TomlTable& file, const std::string& folder, Run& run);
//       static Duration& length(Run& run);
//       static std::unique_ptr<PlayedNetwork> make(const Run& run, const Choice& choice);
//       ...
//     };
#pragma once

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/tools/play/play_world.hpp"
#include "canvoy/tools/play/world_file.hpp"
#include "canvoy/tools/player/run_options.hpp"
#include "canvoy/tools/sheet/world_nodes.hpp"

namespace canvoy::tools {

/// Texts about a world.
struct WorldInfo {
  std::string about{};  ///< of its verb
  std::string examples{};
  std::string page{};  ///< name on the page
  double terminal_speed = 60;
  FramePrinterOptions decoding{};
};

/// A network from a file, to be played by the caller.
struct HeardWorld {
  std::unique_ptr<PlayedNetwork> network;
  std::vector<std::uint32_t> bit_rates;  ///< of its buses, in bit/s
};

/// A row of the table.
struct WorldEntry {
  std::string_view name;  ///< `taxi`, in files and on the command line
  void (*add_verb)(Verb& run);
  /// Plays a file, and returns the exit status. Paths in it are relative to `folder`.
  int (*play)(TomlTable& file, const std::string& folder, const RunOptions& options);
  /// Makes the network of a file, with its faults.
  HeardWorld (*make)(TomlTable& file, const std::string& folder);
  /// Writes a file again with the same meaning.
  std::string (*rewrite)(TomlTable& file, const std::string& folder);
  /// The nodes with their data sheets, if files do not contain them; null: they do.
  std::vector<DescribedNode> (*describe)(TomlTable& file, const std::string& folder);
  /// The keys, as a page of docs.
  std::string (*keys)();
};
std::span<const WorldEntry> worlds();
/// Text of the names: `charger, lift and taxi`.
std::string world_names(std::string_view last_comma = " and ");

/// Plays a network file, and returns the exit status. Throws Failure.
int run_network_file(const std::string& path, const RunOptions& options);

/// Names of the built-in networks.
std::vector<std::string> built_in_networks();
/// Adds all of the built-in networks.
void add_networks(Verb& run);

/// Reads a fault that begins before the end of the run. Throws UsageError.
template <class Kind>
ScheduledFault<Kind> parse_run_fault(const std::string& text, Duration length) {
  const Time end = length > Duration::zero() ? Time(length) : never;
  return fault_as<Kind>(parse_run_fault(fault_grammar<Kind>(), text, end));
}

/// Adds a fault such as `lost-node:node=2@20min+30s`. Throws UsageError.
template <class World>
void add_fault(typename World::Run& run, const std::string& text) {
  const auto fault = parse_run_fault<typename World::Kind>(text, World::length(run));
  constexpr bool is_of_run = requires { World::check_fault_node(run, fault.node); };
  if constexpr (is_of_run || requires { World::check_fault_node(fault.node); }) {
    if (fault.node != 0 && !has_node(fault.kind)) {
      throw UsageError(fmt::format("fault '{}': it is not one of a node", text));
    }
    if (fault.spot != 0 && !has_spot(fault.kind)) {
      throw UsageError(fmt::format("fault '{}': it is not one of an axis", text));
    }
    std::string wrong;
    if (fault.node == 0) {
    } else if constexpr (is_of_run) {
      wrong = World::check_fault_node(run, fault.node);
    } else {
      wrong = World::check_fault_node(fault.node);
    }
    if (!wrong.empty()) throw UsageError(fmt::format("fault '{}': {}", text, wrong));
  }
  run.network.faults.faults.push_back(fault);
}

/// Reads the whole table. Throws Failure with file and line.
template <class World>
typename World::Run read_run(TomlTable& file, const std::string& folder) {
  typename World::Run run = World::run_of_file();
  take_run(file, World::file(folder), run);
  try {
    for (const std::string& fault : run.faults_of_file) add_fault<World>(run, fault);
  } catch (const Failure& failure) {
    file.refuse("faults", failure.what());
  }
  try {
    static_cast<void>(parse_acts(run.acts));
  } catch (const Failure& failure) {
    file.refuse("acts", failure.what());
  }
  World::check(file, folder, run);
  return run;
}
/// A file with the same meaning, with a comment for each value.
template <class World>
std::string run_text(const typename World::Run& run) {
  return run_text(World::file(""), run);
}

/// For a world with nodes 1 to `most`: the error of a node-ID.
inline std::string check_node_up_to(std::size_t most, NodeId id) {
  return id <= most ? "" : fmt::format("there are nodes 1 to {}", most);
}

namespace detail {

template <class World>
void set_seed(typename World::Run& run, std::uint64_t seed) {
  if constexpr (requires { World::set_seed(run, seed); }) {
    World::set_seed(run, seed);
  } else {
    run.network.faults.seed = seed;
  }
}

/// Some worlds have another page for some runs.
template <class World>
WorldInfo info_of(const typename World::Run& run) {
  if constexpr (requires { World::info(run); }) {
    return World::info(run);
  } else {
    return World::info();
  }
}

template <class World>
void check_run(const typename World::Run& run) {
  if constexpr (requires { World::check_run(run); }) World::check_run(run);
}

/// The run with the seed of the plan, and its faults and acts in addition to those of the run.
template <class World>
typename World::Run planned(typename World::Run run, const WorldPlan& plan) {
  if (plan.seed != run.network.faults.seed) set_seed<World>(run, plan.seed);
  for (const std::string& fault : plan.faults) add_fault<World>(run, fault);
  run.acts.insert(run.acts.end(), plan.acts.begin(), plan.acts.end());
  check_run<World>(run);
  return run;
}

}  // namespace detail

/// Options of the command line take precedence over the run.
template <class World>
PlayOptions apply(const RunOptions& options, typename World::Run& run) {
  PlayOptions play_as = play_options(options, World::length(run));
  World::length(run) = play_as.duration;
  if (options.seed) detail::set_seed<World>(run, *options.seed);
  for (const std::string& fault : options.faults) add_fault<World>(run, fault);
  detail::check_run<World>(run);
  run.acts.insert(run.acts.end(), options.acts.begin(), options.acts.end());
  play_as.acts = parse_acts(run.acts);
  play_as.real = run.real;
  play_as.terminal_speed = World::info().terminal_speed;
  return play_as;
}

/// Returns the exit status. Throws Failure.
template <class World>
int play_run(typename World::Run run, const RunOptions& options,
             const typename World::Choice& choice = {}) {
  PlayOptions play_as = apply<World>(options, run);
  if constexpr (requires { World::play(run, play_as, options, choice); }) {
    if (const std::optional<int> status = World::play(run, play_as, options, choice))
      return *status;
  }
  const WorldInfo info = detail::info_of<World>(run);
  return play_world({.kind = info.page,
                     .grammar = fault_grammar<typename World::Kind>(),
                     .make =
                         [run, choice](const WorldPlan& plan) {
                           return World::make(detail::planned<World>(run, plan), choice);
                         },
                     .file =
                         [run](const WorldPlan& plan) {
                           return run_text<World>(detail::planned<World>(run, plan));
                         },
                     .plan = {.seed = run.network.faults.seed},
                     .decoding = info.decoding},
                    play_as, options);
}

template <class World>
void add_world_verb(Verb& run) {
  struct Command {
    RunOptions run;
    typename World::Choice choice;
  };
  const WorldInfo info = World::info();
  Verb& verb = run.add_verb(std::string(World::name), info.about);
  const auto command = std::make_shared<Command>();
  add_run_options(verb, command->run, fault_help(fault_grammar<typename World::Kind>()));
  if constexpr (requires { World::add_options(verb, command->choice); })
    World::add_options(verb, command->choice);
  verb.add_examples(info.examples);
  verb.runs([at = &verb, command, parent = &run] {
    if (parent->count("--report") + parent->count("--receipts") != 0) {
      throw UsageError("--report and --receipts are of canvoy run taxi, or of a file of a taxi");
    }
    if constexpr (requires { World::run_chosen(verb, command->run, command->choice); }) {
      return World::run_chosen(*at, command->run, command->choice);
    } else {
      static_cast<void>(at);
      return play_run<World>(World::chosen(command->choice), command->run, command->choice);
    }
  });
}

template <class World>
constexpr auto describer() -> std::vector<DescribedNode> (*)(TomlTable&, const std::string&) {
  if constexpr (requires(const typename World::Run& run) { World::describe(run); }) {
    return [](TomlTable& file, const std::string& folder) {
      return World::describe(read_run<World>(file, folder));
    };
  } else {
    return nullptr;
  }
}

template <class World>
HeardWorld heard_world(TomlTable& file, const std::string& folder) {
  const typename World::Run run = read_run<World>(file, folder);
  HeardWorld made{.network = World::make(run, {}).network, .bit_rates = {}};
  if constexpr (requires { run.network.buses; }) {
    for (const auto& bus : run.network.buses) made.bit_rates.push_back(bus.bit_rate);
  } else {
    made.bit_rates.assign(made.network->bus_names().size(), run.network.bit_rate);
  }
  return made;
}

/// Options of the command line beside a network file.
template <class World>
typename World::Choice choice_beside_file(const RunOptions& options) {
  if constexpr (requires { World::choice_beside_file(options); }) {
    return World::choice_beside_file(options);
  } else {
    const bool is_of_taxi = !options.taxi_report.empty() || !options.taxi_receipts.empty();
    if (is_of_taxi) throw UsageError("--report and --receipts are of a taxi: this is none");
    return {};
  }
}

template <class World>
constexpr WorldEntry world_entry() {
  return {.name = World::name,
          .add_verb = add_world_verb<World>,
          .play =
              [](TomlTable& file, const std::string& folder, const RunOptions& options) {
                return play_run<World>(read_run<World>(file, folder), options,
                                       choice_beside_file<World>(options));
              },
          .make = heard_world<World>,
          .rewrite =
              [](TomlTable& file, const std::string& folder) {
                return run_text<World>(read_run<World>(file, folder));
              },
          .describe = describer<World>(),
          .keys = [] { return keys_text(World::file("")); }};
}

/// A played network of `canvoy/sim` on this many buses: `sim0` and so on.
template <class Network, unsigned buses = 1>
class Played : public PlayedNetwork {
 public:
  template <class Options>
  explicit Played(const Options& options) : network_(options) {}

  World& world() override { return network_.world(); }
  void run_until(Time until) override { network_.run_until(until); }
  std::vector<std::string> bus_names() const override {
    std::vector<std::string> names;
    for (unsigned bus = 0; bus < buses; ++bus) names.push_back(fmt::format("sim{}", bus));
    return names;
  }
  std::size_t event_count() const override { return network_.events().size(); }
  ReportedEvent event(std::size_t number) const override {
    return Text::event(network_.events()[number], network_);
  }
  std::string picture(double speed) override { return Text::picture(network_, speed); }
  nlohmann::ordered_json snapshot() override { return Text::snapshot(network_); }
  std::string summary_text() override {
    return Text::summary_text(network_) + faults_left_text(Text::summary(network_));
  }
  nlohmann::ordered_json summary_json() override { return Text::summary(network_); }
  bool all_hold() const override { return network_.all_hold(); }
  std::vector<Judged> judged() const override {
    std::vector<Judged> all;
    for (const auto& each : network_.invariants()) all.push_back(tools::judged(each));
    return all;
  }
  Network& network() { return network_; }

 protected:
  using Text = WorldText<Network>;
  Network network_;
};

}  // namespace canvoy::tools
