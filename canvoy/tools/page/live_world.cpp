#include "canvoy/tools/page/live_world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/page/refusal.hpp"

namespace canvoy::tools {

namespace {

using Clock = std::chrono::steady_clock;

/// Maximum duration of one call of advance(), by the clock.
constexpr auto world_work_most = std::chrono::milliseconds(35);
/// Duration played between two reads of the clock.
constexpr Duration slice = 100ms;
/// Interval of verdicts, in the time of the run; at most one in an advance.
constexpr Duration verdict_period = 500ms;
constexpr Duration fault_after = 1ms;
constexpr Duration step_most = 1h;
constexpr std::size_t actions_max = 10'000;
constexpr std::size_t faults_max = 200;

Duration seconds(const nlohmann::ordered_json& value) {
  return Duration(static_cast<Duration::rep>(std::llround(value.get<double>() * 1e6)));
}

}  // namespace

/// Tap of one bus: passes its frames to viewers, and into the log.
struct LiveWorld::Tap {
  void hear(Time at, const Frame& frame) const {
    world->feed_.add(at - Time{}, name, frame);
    world->recorder().hear(at, name, frame);
    if (!world->log_) return;
    const host::Result<void> written = world->log_->write(at, name, frame);
    if (!written) world->log_failure_ = written.error().line();
  }
  LiveWorld* world;
  std::string name;
};

/// A node on a bus of the world that sends requests for viewers.
struct LiveWorld::Desk {
  Desk(World& world, BusIndex bus) : slot(world.add_slot(bus)), port(world.port(slot)), desk(port) {
    world.occupy(slot, desk.node());
    world.start(slot);
  }
  SlotIndex slot;
  Port port;
  SdoRequests desk;
};

LiveWorld::LiveWorld(LiveWorldOptions options, const PlayOptions& play, WritePermission permission,
                     host::EventLoop& loop)
    : LiveNetwork(options.decoding, std::move(permission)),
      options_(std::move(options)),
      play_(play),
      loop_(loop),
      playback_(play.duration, has_real() ? 1 : options_.speed) {
  build();
}

LiveWorld::~LiveWorld() {
  loop_.cancel(real_timer_);
}

void LiveWorld::build() {
  desks_.clear();
  taps_.clear();
  log_.reset();
  made_ = options_.make(options_.plan);
  told_ = 0;
  buses_ = network().bus_names();
  desks_.resize(buses_.size());
  for (BusIndex i = 0; i < buses_.size(); ++i) {
    taps_.push_back(std::make_unique<Tap>(Tap{this, buses_[i]}));
    world().bus(i).observe({.context = taps_.back().get(),
                            .on_frame = [](void* self, Time at, ControllerId, const Frame& frame) {
                              static_cast<Tap*>(self)->hear(at, frame);
                            }});
  }
  if (has_real()) {
    real_ = std::make_unique<RealBuses>(world(), play_.real, loop_);
    run_beside_real_buses();
  }
  done_ = 0;
  judged_at_ = never;
  trend_.clear();
  worst_times_.clear();
  next_look_ = {};
}

void LiveWorld::begin_log() {
  if (!play_.log.empty()) log_.emplace(value_or_throw(LogWriter::create(play_.log)));
}

void LiveWorld::check_can_replay() const {
  if (has_real()) {
    throw NotNow("a run with real buses cannot be played from its start once more");
  }
}

/// The plan is tried before the present run is given up.
void LiveWorld::begin_again(const WorldPlan& plan, Time up_to) {
  check_can_replay();
  static_cast<void>(options_.make(plan));
  options_.plan = plan;
  recorder().end();  // it belongs to one run
  begin_anew();
  build();
  begin_log();
  playback_.restart(up_to);
}

LiveSource::Json LiveWorld::description() {
  Json faults = Json::array();
  for (const FaultRow& kind : options_.grammar.kinds) {
    faults.push_back({{"fault", kind.name}, {"text", kind.description}});
  }
  Json places = Json::array();
  for (const FaultPlaceName& place : options_.grammar.places) {
    places.push_back({{"place", place.name}, {"most", place.most}});
  }
  return {{"kind", options_.kind},
          {"time_is", "run"},
          {"command", options_.command},
          {"end", in_seconds(play_.duration)},
          {"buses", buses_},
          {"faults", faults},
          {"places", places},
          {"can",
           {{"play", true},
            {"replay", !has_real()},
            {"visit", made_.visit != nullptr},
            {"read", true},
            {"record", recorder().is_allowed()},
            {"write", permission().text()},
            {"nmt", permission().allows_nmt()}}},
          {"scenery", made_.scenery ? *made_.scenery : Json::object()}};
}

void LiveWorld::advance(Time clock) {
  const Time wanted = has_real() ? now() : playback_.wanted(clock);
  const auto begun = Clock::now();
  while (now() < wanted && Clock::now() - begun < world_work_most) {
    run_until(std::min(wanted, now() + slice));
  }
  playback_.reached(now());
  take_events();
  recorder().flush_each_second(clock);
  if (log_) ok_or_throw(log_->flush_each_second(clock));
  if (log_failure_) throw Failure(*log_failure_);
}

/// Repeats actions at their times.
void LiveWorld::run_until(Time until) {
  while (done_ < actions_.size() && actions_[done_].at <= until) {
    network().run_until(actions_[done_].at);
    do_action(actions_[done_++], {});
  }
  network().run_until(until);
  look_back();
}

/// Records what is shown of the past.
void LiveWorld::look_back() {
  if (trend_.is_due(now())) trend_.add(now(), network().snapshot());
  if (now() < next_look_) return;
  worst_times_.look(now(), network().judged());
  next_look_ = now() + verdict_period;
}

/// More often than the page is updated: real nodes wait only milliseconds for an answer.
void LiveWorld::run_beside_real_buses() {
  real_timer_ = loop_.at(loop_.now() + RealBuses::period, [this](Time clock) {
    run_until(std::min(playback_.end(), real_->reach(clock)));
    if (now() < playback_.end()) run_beside_real_buses();
  });
}

void LiveWorld::take_events() {
  for (; told_ < network().event_count(); ++told_) {
    events_.add(network().event(told_));
  }
}

LiveSource::Json LiveWorld::play_json() {
  Json play = {{"speed", playback_.speed()},
               {"paused", playback_.is_paused()},
               {"seeking", playback_.is_seeking()},
               {"over", playback_.is_over()}};
  if (real_) {
    play["left_out"] = in_seconds(real_->left_out());
    play["trouble"] = real_->trouble();
    play["frames_lost"] = real_->frames_lost();
  }
  return play;
}

/// The plan that repeats this run.
LiveSource::Json LiveWorld::plan_json() const {
  std::string command = options_.command + fmt::format(" --seed {}", options_.plan.seed);
  for (const std::string& fault : options_.plan.faults) command += " --fault " + fault;
  return {{"seed", options_.plan.seed},
          {"faults", options_.plan.faults},
          {"deeds", actions_.size()},
          {"command", command}};
}

const LiveSource::Json& LiveWorld::summary() {
  if (judged_at_ == never || now() < judged_at_ || now() >= judged_at_ + verdict_period) {
    summary_ = std::make_unique<Json>(network().summary_json());
    const std::vector<Judged> judged = network().judged();
    worst_times_.look(now(), judged);
    if (!judged.empty()) worst_times_.add_to((*summary_)["invariants"], judged);
    judged_at_ = now();
  }
  return *summary_;
}

LiveSource::Json LiveWorld::state() {
  return {{"time", in_seconds(now() - Time{})}, {"play", play_json()},  {"plan", plan_json()},
          {"snapshot", network().snapshot()},   {"summary", summary()}, {"counts", counts()},
          {"record", recorder().json()}};
}

void LiveWorld::act(std::string_view what, const Json& arguments, const Done& done) {
  if (what == "pause") {
    check_can_replay();
    playback_.set_paused(arguments.value("paused", true));
  } else if (what == "speed") {
    check_can_replay();
    playback_.set_speed(arguments.at("speed").get<double>());
    playback_.set_paused(false);
  } else if (what == "step") {
    check_can_replay();
    playback_.step(std::min(seconds(arguments.at("step_s")), step_most));
  } else if (what == "seek") {
    check_can_replay();
    const Time to = Time(seconds(arguments.at("time")));
    if (to < now()) begin_again(options_.plan, to);
    playback_.seek(to);
  } else if (what == "fault") {
    add_fault(arguments);
  } else if (what == "visit") {
    visit(arguments);
  } else if (what == "restart") {
    restart(arguments);
  } else if (what == "trend") {
    return done(trend_.json(listed_names(text_of(arguments, "names"))));
  } else {
    return LiveNetwork::act(what, arguments, done);
  }
  done({{"done", true}});
}

/// `fault`: with its place, without a time: it begins now. `duration_s`: 0 for the rest.
void LiveWorld::add_fault(const Json& arguments) {
  check_can_replay();
  if (options_.plan.faults.size() >= faults_max) throw NotNow("there are many faults already");
  const Time start = now() + fault_after;
  if (start >= playback_.end()) throw NotNow("the run is over: go back, or start anew");
  std::string text = fmt::format("{}@{}", text_of(arguments, "fault"), written(start - Time{}));
  const Duration duration = seconds(arguments.at("duration_s"));
  if (duration != Duration::zero()) text += "+" + written(duration);
  const FaultParse parsed = parse_fault(options_.grammar, text);
  if (!parsed.fault) throw UsageError(parsed.error);
  WorldPlan plan = options_.plan;
  plan.faults.push_back(text);
  begin_again(plan, start);
}

void LiveWorld::visit(const Json& arguments) {
  if (!made_.visit) throw NotNow("nobody visits this network");
  if (playback_.is_seeking()) throw NotNow("the run is on its way to where it was");
  if (done_ >= actions_max) throw NotNow("too much was done already: start anew");
  actions_.resize(done_);
  const UserAction action{.at = now(),
                          .from = arguments.at("from").get<unsigned>(),
                          .to = arguments.at("to").get<unsigned>()};
  if (!made_.visit(action.from, action.to))
    throw UsageError("there is no way between these floors");
  actions_.push_back(action);
  done_ = actions_.size();
}

/// `seed` and `faults`, if they change; `keep`: play up to the present time.
void LiveWorld::restart(const Json& arguments) {
  WorldPlan plan = options_.plan;
  plan.seed = arguments.value("seed", plan.seed);
  plan.faults = arguments.value("faults", plan.faults);
  const bool keeps = arguments.value("keep", false);
  if (!keeps) actions_.clear();
  begin_again(plan, keeps ? now() : Time{});
}

void LiveWorld::request(const BusRequest& request, const SdoRequests::Done& done) {
  if (playback_.is_paused() || playback_.is_over() || playback_.speed() == 0) {
    throw NotNow("time stands still, and nobody answers: let the run go on first");
  }
  if (playback_.is_seeking()) throw NotNow("the run is on its way to where it was");
  if (done_ >= actions_max) throw NotNow("too much was done already: start anew");
  static_cast<void>(bus_of(request.bus));
  actions_.resize(done_);
  actions_.push_back({.at = now(), .request = request});
  do_action(actions_[done_++], done);
}

void LiveWorld::do_action(const UserAction& action, const SdoRequests::Done& done) {
  if (!action.request) {
    made_.visit(action.from, action.to);
    return;
  }
  const SdoRequests::Done told = done ? done : [](const SdoRequests::Answer&) {};
  const BusRequest& wanted = *action.request;
  Desk& desk = desk_of(bus_of(wanted.bus));
  if (wanted.kind == BusRequest::Kind::nmt) {
    desk.port.send(desk.port.context,
                   Frame::data_frame(can_id::nmt, {wanted.bytes[0], wanted.node}));
    return;
  }
  desk.desk.node().advance(now());
  if (wanted.kind == BusRequest::Kind::read) {
    desk.desk.read(wanted.node, wanted.index, wanted.sub, told);
  } else {
    desk.desk.write(wanted.node, wanted.index, wanted.sub, wanted.bytes, told);
  }
  world().touched(desk.slot);
}

BusIndex LiveWorld::bus_of(const std::string& name) const {
  const auto found = std::ranges::find(buses_, name);
  if (found == buses_.end()) throw NotThere(fmt::format("there is no bus '{}'", name));
  return static_cast<BusIndex>(found - buses_.begin());
}

LiveWorld::Desk& LiveWorld::desk_of(BusIndex bus) {
  if (!desks_[bus]) desks_[bus] = std::make_unique<Desk>(world(), bus);
  return *desks_[bus];
}

int LiveWorld::finish() {
  if (log_) ok_or_throw(log_->finish());
  recorder().end();
  fmt::print("{}", network().summary_text());
  return verdict_status(network().summary_json(), play_.require_decided);
}

}  // namespace canvoy::tools
