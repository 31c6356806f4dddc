// A simulated network that viewers watch, play with and break. What they do is part of the plan,
// with its time: a fault is added, and the run is played again from its start to the present.
// Equal plans always give equal runs, frame by frame.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/sim/fault.hpp"
#include "canvoy/tools/page/live_network.hpp"
#include "canvoy/tools/page/playback.hpp"
#include "canvoy/tools/page/trend.hpp"
#include "canvoy/tools/page/worst_times.hpp"
#include "canvoy/tools/player/actor.hpp"
#include "canvoy/tools/player/player.hpp"
#include "canvoy/tools/player/real_buses.hpp"
#include "canvoy/tools/watch/log_writer.hpp"

namespace canvoy::tools {

/// Input of a played world, beside the options of its command.
struct WorldPlan {
  std::uint64_t seed = 1;
  std::vector<std::string> faults{};  ///< beside those of the command
  std::vector<std::string> acts{};    ///< beside those of the command, see act.hpp
};

/// A played network, and its additions for a page.
struct MadeWorld {
  std::unique_ptr<PlayedNetwork> network;
  /// The constant surroundings, for drawing.
  std::shared_ptr<const nlohmann::ordered_json> scenery{};  ///< null: none
};

struct LiveWorldOptions {
  std::string kind{};     ///< `lift`
  std::string command{};  ///< `canvoy run lift --lifts 4`, without seed and faults
  FaultGrammar grammar{};
  /// Throws Failure if the plan is not valid.
  std::function<MadeWorld(const WorldPlan&)> make{};
  /// Writes the world as a file for `canvoy run FILE`.
  std::function<std::string(const WorldPlan&)> file{};
  WorldPlan plan{};
  FramePrinterOptions decoding{};  ///< profiles of the nodes
  double speed = 10;
};

class LiveWorld : public LiveNetwork {
 public:
  /// `loop` serves the real buses that are part of the network.
  LiveWorld(LiveWorldOptions options, const PlayOptions& play, WritePermission permission,
            host::EventLoop& loop);
  ~LiveWorld() override;

  Json description() override;
  void begin_log() override;
  void advance(Time clock) override;
  Json state() override;
  std::string run_file() const override { return options_.file(options_.plan); }
  void act(std::string_view what, const Json& arguments, const Done& done) override;
  int finish() override;

 protected:
  void request(const BusRequest& request, const SdoRequests::Done& done) override;

 private:
  struct Tap;

  PlayedNetwork& network() { return *made_.network; }
  World& world() { return network().world(); }
  Time now() { return world().now(); }
  bool has_real() const { return !play_.real.empty(); }
  void build();
  void begin_again(const WorldPlan& plan, Time up_to);
  void run_until(Time until);
  void run_beside_real_buses();
  void take_events();
  std::vector<Act> acts_of(const WorldPlan& plan) const;
  void act_now(Act act, const SdoRequests::Done& done);
  void add_fault(const Json& arguments);
  void visit(const Json& arguments);
  void restart(const Json& arguments);
  void check_can_replay() const;
  void look_back();
  const Json& summary();
  Json play_json();
  Json plan_json() const;

  LiveWorldOptions options_;
  PlayOptions play_;
  host::EventLoop& loop_;
  Playback playback_;
  MadeWorld made_;
  std::vector<std::string> buses_;
  std::vector<std::unique_ptr<Tap>> taps_;
  std::unique_ptr<RealBuses> real_;
  host::EventLoop::Id real_timer_ = 0;
  std::unique_ptr<Actor> actor_;
  std::size_t told_ = 0;  ///< number of events reported
  std::optional<LogWriter> log_;
  std::optional<std::string> log_failure_;
  std::unique_ptr<Json> summary_;  ///< as of `judged_at_`
  Time judged_at_ = never;
  Trend trend_;
  WorstTimes worst_times_;
  Time next_look_{};  ///< for the worst times
};

}  // namespace canvoy::tools
