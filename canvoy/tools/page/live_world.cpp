#include "canvoy/tools/page/live_world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

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
constexpr std::size_t acts_max = 10'000;
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
  actor_.reset();
  taps_.clear();
  log_.reset();
  made_ = options_.make(options_.plan);
  told_ = 0;
  buses_ = network().bus_names();
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
  actor_ = std::make_unique<Actor>(network(), acts_of(options_.plan));
  judged_at_ = never;
  trend_.clear();
  worst_times_.clear();
  next_look_ = {};
}

/// Those of the command, and those that viewers added.
std::vector<Act> LiveWorld::acts_of(const WorldPlan& plan) const {
  std::vector<Act> acts = play_.acts;
  for (Act& added : parse_acts(plan.acts)) {
    added.is_added = true;
    acts.push_back(std::move(added));
  }
  std::ranges::stable_sort(acts, {}, &Act::at);
  return acts;
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
  const MadeWorld tried = options_.make(plan);
  static_cast<void>(Actor(*tried.network, acts_of(plan)));
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
            {"visit", network().takes_visitors()},
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

void LiveWorld::run_until(Time until) {
  actor_->run_until(until);
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
  for (const std::string& act : options_.plan.acts) command += " --act " + act;
  return {{"seed", options_.plan.seed},
          {"faults", options_.plan.faults},
          {"acts", options_.plan.acts},
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
  return {
      {"time", in_seconds(now() - Time{})}, {"play", play_json()},  {"plan", plan_json()},
      {"snapshot", network().snapshot()},   {"summary", summary()}, {"record", recorder().json()}};
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
  if (!network().takes_visitors()) throw NotNow("nobody visits this network");
  act_now({.from = arguments.at("from").get<unsigned>(), .to = arguments.at("to").get<unsigned>()},
          {});
}

/// Does it, and keeps it in the plan.
void LiveWorld::act_now(Act act, const SdoRequests::Done& done) {
  if (playback_.is_seeking()) throw NotNow("the run is on its way to where it was");
  if (actor_->done() >= acts_max) throw NotNow("too much was done already: start anew");
  actor_->act(std::move(act), done);
  options_.plan.acts = actor_->added();
}

/// `seed`, `faults` and `acts`, if they change; `keep`: play up to the present time.
void LiveWorld::restart(const Json& arguments) {
  WorldPlan plan = options_.plan;
  plan.seed = arguments.value("seed", plan.seed);
  plan.faults = arguments.value("faults", plan.faults);
  const bool keeps = arguments.value("keep", false);
  if (!keeps) plan.acts.clear();
  plan.acts = arguments.value("acts", plan.acts);
  begin_again(plan, keeps ? now() : Time{});
}

void LiveWorld::request(const BusRequest& request, const SdoRequests::Done& done) {
  if (std::ranges::find(buses_, request.bus) == buses_.end())
    throw NotThere(fmt::format("there is no bus '{}'", request.bus));
  if (playback_.is_paused() || playback_.is_over() || playback_.speed() == 0) {
    throw NotNow("time stands still, and nobody answers: let the run go on first");
  }
  act_now({.request = request}, done);
}

int LiveWorld::finish() {
  if (log_) ok_or_throw(log_->finish());
  recorder().end();
  fmt::print("{}", network().summary_text());
  return verdict_status(network().summary_json(), play_.require_decided);
}

}  // namespace canvoy::tools
