// What the networks of `canvoy run` have in common on the command line, and one function for each.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/sim/fault.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/run/player.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// What is given on the command line goes before what a file says.
struct RunOptions {
  std::optional<std::string> duration;
  std::vector<std::string> faults;  ///< beside those of the file
  std::string log;
  std::optional<std::uint64_t> seed;
  std::string link;   ///< of a page: its seed and faults, which are taken over
  double speed = -1;  ///< as PlayOptions have it
  bool require_decided = false;
  bool json = false;
  bool print = false;                 ///< the network as a file, in place of a run
  std::optional<std::string> web;     ///< a page of it: the port, empty: a free one
  std::string allow_write;            ///< what people at the page may write
  std::string allow_record;           ///< the folder for logs that they begin; empty: none
  std::optional<std::string> report;  ///< the file that it is written into, in place of being shown
  std::string command;                ///< the command line, but for seed and what the page takes

  /// By who wants it as it is made at each look, and not from its start to its end.
  bool is_watched() const { return web || report; }
};

/// `fault_help` lists the kinds of faults. Of `canvoy report` those alone that say which run it is,
/// and where it is written.
void add_run_options(Verb& command, RunOptions& options, const std::string& fault_help);
/// All of the command line but the real buses. `duration` is that of the network.
PlayOptions play_options(const RunOptions& options, Duration duration);

/// Throws UsageError for what is no fault of the world, or begins when the run is over.
AnyFault parse_run_fault(const FaultGrammar& grammar, const std::string& text, Time end);

/// The keys of a network file that say which real bus is a part of `bus`: `real = "can0"`.
void take_real_bus(TomlTable& table, BusIndex bus, std::vector<RealBus>& real);

/// Plays what a network file describes, and returns the exit status. Throws Failure.
int run_network_file(const std::string& path, const RunOptions& options);

/// Their names.
std::vector<std::string> built_in_networks();
/// Adds all of the built-in networks.
void add_networks(Verb& run);

}  // namespace canvoy::tools
