// canvoy run charger: plays the network of a battery and its charger in virtual time.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/sim/charging_network.hpp"
#include "canvoy/tools/charging_text.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/text.hpp"
#include "canvoy/tools/time_text.hpp"

namespace canvoy::tools {

namespace {

constexpr std::string_view log_interface = "sim0";
constexpr double terminal_speed = 60;
/// How often the live table is drawn, and how far the simulation goes between two looks at the
/// signals.
constexpr auto frame_period = std::chrono::milliseconds(100);
constexpr Duration step_time = 1min;

volatile std::sig_atomic_t interrupted = 0;

struct RunOptions {
  std::string duration = "8h";
  std::vector<std::string> faults;
  std::string log;
  std::uint64_t seed = 1;
  double speed = -1;  ///< below 0: as fits the output; 0: as fast as it goes
  double state_of_charge = 20;
  double ambience = 20;
  std::string begin = "2026-11-21 18:00:00";
  bool no_sdo_manager = false;
  bool json = false;
};

/// In the vehicle there is a CANopen manager; nobody else has this node-ID.
constexpr NodeId sdo_manager_id = 1;

ChargingOptions network_options(const RunOptions& options, Time end) {
  ChargingOptions network;
  const std::optional<TimeOfDay> begin = parse_time_of_day(options.begin);
  if (!begin || !begin->valid()) {
    throw UsageError(fmt::format("--begin: '{}' is no time after 1984: write 2026-11-21 18:00:00",
                                 options.begin));
  }
  network.begin = to_civil_time(*begin);
  network.manager_id = options.no_sdo_manager ? NodeId{0} : sdo_manager_id;
  network.faults.seed = options.seed;
  network.state_of_charge = options.state_of_charge / 100;
  network.ambience_celsius = options.ambience;
  for (const std::string& text : options.faults) {
    const FaultParse parsed = parse_fault(text);
    if (!parsed.fault) throw UsageError(parsed.error);
    if (parsed.fault->start >= end) {
      throw UsageError(
          fmt::format("fault '{}' begins after the end: run longer, with --for", text));
    }
    network.faults.faults.push_back(*parsed.fault);
  }
  return network;
}

/// The log of all frames. Its times count from zero, so that the same seed gives the same bytes.
class FrameLog {
 public:
  FrameLog(const std::string& path, ChargingNetwork& network)
      : writer_(value_or_throw(host::CandumpWriter::create(path))) {
    network.observe(
        {.context = this,
         .on_frame = [](void* self, Time now, ControllerId,
                        const Frame& frame) { static_cast<FrameLog*>(self)->write(now, frame); },
         .on_error = nullptr,
         .on_state = nullptr,
         .on_overrun = nullptr});
  }
  void check() const {
    if (failure_) throw Failure(*failure_);
  }
  void finish() {
    check();
    ok_or_throw(writer_.flush());
  }

 private:
  void write(Time now, const Frame& frame) {
    const host::Result<void> written = writer_.write(now, log_interface, frame);
    if (!written) failure_ = written.error().line();
  }

  host::CandumpWriter writer_;
  std::optional<std::string> failure_;
};

class ChargerRun {
 public:
  explicit ChargerRun(const RunOptions& options)
      : options_(options),
        end_(Time{} + parse_duration_argument(options.duration)),
        network_(network_options(options, end_)) {
    is_live_ = !options.json && isatty(STDOUT_FILENO) != 0;
    speed_ = options.speed >= 0 ? options.speed : is_live_ ? terminal_speed : 0;
    if (!options.log.empty()) log_.emplace(options.log, network_);
  }

  int run() {
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });
    if (is_live_) fmt::print("\x1b[2J");  // an empty screen
    const auto begun = std::chrono::steady_clock::now();
    while (network_.now() < end_ && interrupted == 0) {
      network_.run_until(std::min(end_, next_stop(begun)));
      if (log_) log_->check();
      tell_events();
      if (is_live_) draw();
    }
    if (log_) log_->finish();
    fmt::print("{}", options_.json ? summary_json(network_).dump() + "\n" : summary_text(network_));
    return network_.all_hold() ? exit_done : exit_failed;
  }

 private:
  /// Up to which virtual time to run now; with a speed, it waits until the wall clock wants the
  /// next picture.
  Time next_stop(std::chrono::steady_clock::time_point begun) {
    if (speed_ == 0) return network_.now() + step_time;
    std::this_thread::sleep_until(begun + frame_period * ++frames_);
    const std::chrono::duration<double, std::micro> passed = frame_period * frames_ * speed_;
    return Time(Duration(static_cast<Duration::rep>(passed.count())));
  }

  void tell_events() {
    const auto events = network_.events();
    if (!is_live_) {
      for (; told_ < events.size(); ++told_) {
        if (options_.json) {
          fmt::print("{}\n", event_json(events[told_]).dump());
        } else {
          fmt::print("{:>20}  {}\n", duration_text(events[told_].at - Time{}),
                     event_text(events[told_], network_.options()));
        }
      }
    }
    if (options_.json) fmt::print("{}\n", snapshot_json(network_.snapshot()).dump());
    std::fflush(stdout);
  }

  /// Over the last picture: cursor home, clear to the end of each line and of the screen.
  void draw() {
    std::string picture = table_text(network_, speed_);
    for (std::size_t at = 0; (at = picture.find('\n', at)) != std::string::npos; at += 4) {
      picture.replace(at, 1, "\x1b[K\n");
    }
    fmt::print("\x1b[H{}\x1b[J", picture);
    std::fflush(stdout);
  }

  RunOptions options_;
  Time end_;
  ChargingNetwork network_;
  std::optional<FrameLog> log_;
  double speed_ = 0;
  bool is_live_ = false;
  std::int64_t frames_ = 0;
  std::size_t told_ = 0;
};

std::string fault_help() {
  std::string text = "NAME@START or NAME@START+DURATION, any number of:\n";
  for (const FaultName& fault : fault_names()) {
    text += fmt::format("  {}: {}\n", fault.name, fault.description);
  }
  return text;
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("run", "Play a built-in network in virtual time");
  command->require_subcommand(1);
  const auto options = std::make_shared<RunOptions>();
  CLI::App* charger =
      command->add_subcommand("charger", "A CiA 419 charger charges a CiA 418 battery");
  charger->add_option("--for", options->duration, "virtual time: 30s, 10min, 8h (default)");
  charger->add_option("--seed", options->seed, "of all that is left to chance (default 1)")
      ->check(CLI::NonNegativeNumber);
  charger->add_option("--fault", options->faults, fault_help())->allow_extra_args(false);
  charger
      ->add_option(
          "--speed", options->speed,
          "times faster than the clock; 0: as fast as it goes (default: 60 on a terminal, else 0)")
      ->check(CLI::Range(0.0, 1e6));
  charger
      ->add_option("--state-of-charge", options->state_of_charge,
                   "of the battery at the start, in % (default 20)")
      ->check(CLI::Range(0.0, 100.0));
  charger->add_option("--ambience", options->ambience, "temperature, in °C (default 20)")
      ->check(CLI::Range(-40.0, 85.0));
  charger->add_option("--begin", options->begin,
                      "date and time of the charger's clock at the start (default 2026-11-21 "
                      "18:00:00); it tells them each minute (TIME)");
  charger->add_flag("--no-sdo-manager", options->no_sdo_manager,
                    "no CANopen manager gives the charger its SDO connection to the battery: it "
                    "takes the default channel");
  charger->add_option("--log", options->log, "write all frames as a candump log");
  charger->add_flag("--json", options->json, "events and values, one JSON object a line");
  charger->callback(
      [options, &action] { action = [options] { return ChargerRun(*options).run(); }; });
}

}  // namespace canvoy::tools
