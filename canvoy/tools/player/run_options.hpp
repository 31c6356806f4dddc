// Common options of the networks of `canvoy run`.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/sim/fault.hpp"
#include "canvoy/tools/cli/toml_file.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/player/player.hpp"

namespace canvoy::tools {

/// Options of the command line take precedence over the file.
struct RunOptions {
  std::optional<std::string> duration;
  std::vector<std::string> faults;  ///< in addition to those of the file
  std::vector<std::string> acts;    ///< in addition to those of the file, see act.hpp
  std::string log;
  std::optional<std::uint64_t> seed;
  std::string link;   ///< link from a page, with its seed, faults and acts
  double speed = -1;  ///< see PlayOptions
  bool require_decided = false;
  bool json = false;
  bool print = false;                 ///< print the network as a file instead of running it
  std::optional<std::string> web;     ///< port of a page; empty: a free one
  std::string allow_write;            ///< what viewers of the page may write
  std::string allow_record;           ///< folder for logs of viewers; empty: none
  std::optional<std::string> report;  ///< file for the report, instead of showing the run
  std::string taxi_report;            ///< for the taxi of a network file, see `run taxi`
  std::string taxi_receipts;          ///< for the taxi of a network file, see `run taxi`
  std::string command;                ///< the command line, without seed and options of the page

  /// True if the run is shown step by step instead of played to its end.
  bool is_watched() const { return web || report; }
};

/// `fault_help` lists the kinds of faults. For `canvoy report`, only options that select the run
/// and the file.
void add_run_options(Verb& command, RunOptions& options, const std::string& fault_help);
/// All of the command line except the real buses. `duration` is that of the network.
PlayOptions play_options(const RunOptions& options, Duration duration);

/// Throws UsageError for an invalid fault of the world, or one that begins after the end of the
/// run.
AnyFault parse_run_fault(const FaultGrammar& grammar, const std::string& text, Time end);

/// Reads the keys of a network file that give the real part of `bus`: `real = "can0"`.
void take_real_bus(TomlTable& table, BusIndex bus, std::vector<RealBus>& real);

}  // namespace canvoy::tools
