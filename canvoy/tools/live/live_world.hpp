// A simulated network that people look at, play with and break. What they do is kept with its time:
// a fault is put into the plan, and the run played from its start up to now once more, at once; so
// the same plan always is the same run, frame by frame.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/sim/fault.hpp"
#include "canvoy/tools/live/live_network.hpp"
#include "canvoy/tools/live/playback.hpp"
#include "canvoy/tools/run/player.hpp"
#include "canvoy/tools/run/real_buses.hpp"

namespace canvoy::tools {

/// What a world is played from, beside what its command says.
struct WorldPlan {
  std::uint64_t seed = 1;
  std::vector<std::string> faults{};  ///< beside those of the command
};

/// A network as it is played, and what a page wants of it beside that.
struct MadeWorld {
  std::unique_ptr<PlayedNetwork> network;
  /// What does not change of the place that it is in, for who draws it.
  std::shared_ptr<const nlohmann::ordered_json> scenery{};  ///< null: there is nothing
  /// Somebody comes now, and wants to go from one floor to another; false: there is no way. Empty:
  /// nobody comes.
  std::function<bool(unsigned from, unsigned to)> visit{};
};

struct LiveWorldOptions {
  std::string kind{};     ///< `lift`
  std::string command{};  ///< `canvoy run lift --lifts 4`, without seed and faults
  FaultGrammar grammar{};
  /// Throws Failure where the plan makes no sense.
  std::function<MadeWorld(const WorldPlan&)> make{};
  /// The same as a file that `canvoy run FILE` plays.
  std::function<std::string(const WorldPlan&)> file{};
  WorldPlan plan{};
  FramePrinterOptions decoding{};  ///< which profiles the nodes have
  double speed = 10;
};

class LiveWorld : public LiveNetwork {
 public:
  /// `loop` serves the real buses that are parts of the network.
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
  void request(const BusRequest& request, const SdoDesk::Done& done) override;

 private:
  struct Tap;
  struct Desk;
  /// What somebody did, and when.
  struct Deed {
    Time at{};
    std::optional<BusRequest> request{};
    unsigned from = 0;  ///< a visitor's floors
    unsigned to = 0;
  };

  PlayedNetwork& network() { return *made_.network; }
  World& world() { return network().world(); }
  Time now() { return world().now(); }
  bool has_real() const { return !play_.real.empty(); }
  void build();
  void begin_again(const WorldPlan& plan, Time up_to);
  void run_until(Time until);
  void run_beside_real_buses();
  void take_events();
  void do_deed(const Deed& deed, const SdoDesk::Done& done);
  BusIndex bus_of(const std::string& name) const;
  Desk& desk_of(BusIndex bus);
  void add_fault(const Json& arguments);
  void visit(const Json& arguments);
  void restart(const Json& arguments);
  void check_can_replay() const;
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
  std::vector<std::unique_ptr<Desk>> desks_;
  std::size_t told_ = 0;  ///< of the network's events
  std::vector<Deed> deeds_;
  std::size_t done_ = 0;  ///< of the deeds, in this run
  std::optional<host::CandumpWriter> log_;
  std::optional<std::string> log_failure_;
  std::unique_ptr<Json> summary_;  ///< as of `judged_at_`
  Time judged_at_ = never;
};

}  // namespace canvoy::tools
