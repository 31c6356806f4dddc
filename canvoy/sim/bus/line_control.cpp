#include "canvoy/sim/bus/line_control.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/devices/cia407/bus_time.hpp"
#include "canvoy/sim/bus/line_texts.hpp"

namespace canvoy::bus {

namespace {

constexpr Duration look_period = 50ms;
constexpr Duration start_period = 1s;
/// A device that boots may tell an old journey for a moment.
constexpr Duration settled = 10s;
constexpr Duration refresh_after = 200ms;
constexpr Duration time_is_fresh = 5s;
/// Its own clock may be wrong: it waits for that of the satellites.
constexpr Duration clock_patience = 3s;

}  // namespace

LineControl::LineControl(cia407::VirtualDevice& device, const LineControlHardware& hardware,
                         LineControlSettings settings)
    : device_(device),
      hardware_(hardware),
      settings_(std::move(settings)),
      remotes_(std::make_unique<std::array<NmtMaster::RemoteNode, node_id_max>>()),
      master_(device.node(), *remotes_),
      displays_(device.node(), master_, hardware.computer->texts()),
      timer_(Callback<void(Time)>::to<&LineControl::look>(*this)) {
  for (const DisplayServer::Display& display : settings_.displays) displays_.add(display);
  device.on_reset = Callback<void(ResetScope)>::to<&LineControl::reset>(*this);
  device.on_written = Callback<void(const Entry&)>::to<&LineControl::written>(*this);
  master_.on_change(Callback<void(NodeId, RemoteState)>::to<&LineControl::changed>(*this));
  for (const NodeId id : settings_.nodes) {
    master_.set_time_out(
        id, id == settings_.identification ? settings_.identification_time_out : node_time_out);
  }
  if (settings_.train_stop_request_id != 0) {
    device.node().router().add(settings_.train_stop_request_id,
                               Router::Receiver::to<&LineControl::train_told>(*this));
  }
}

/// The timers of the nodes that it watches are gone before other units of its device end, which
/// still take theirs out of the queue.
LineControl::~LineControl() {
  for (NodeId id = node_id_min; id <= node_id_max; ++id) {
    master_.set_time_out(id, Duration::zero());
  }
  node().timers().disarm(timer_);
}

void LineControl::reset(ResetScope) {
  forget_all();
  booted_ = node().now();
  node().timers().arm(timer_, node().now());
}

void LineControl::forget_all() {
  has_begun_ = false;
  has_journey_told_ = false;
  journey_ = nullptr;
  is_located_ = false;
  fix_.reset();
  time_base_.reset();
  told_time_ = false;
  told_.reset();
  refresh_at_ = never;
  train_wants_stop_.reset();
  displays_.forget_all();
}

/// Nobody knows what the others have: they go dark, and begin anew.
void LineControl::begin() {
  master_.command(NmtMaster::all_nodes, NmtCommand::enter_pre_operational);
  master_.command(NmtMaster::all_nodes, NmtCommand::start);
  is_started_.fill(true);
  has_begun_ = true;
}

void LineControl::look(Time now) {
  node().timers().arm(timer_, now + look_period);
  // Its own controller may have failed for a time: it has missed what others told.
  if (has_begun_ && node().state() != NmtState::operational) forget_all();
  if (!has_begun_) begin();
  if (now >= next_start_) start_waiting();
  if (now >= refresh_at_) refresh();
  sense_motion(now);
  watch_clock();
  if (journey_ != nullptr && !is_located_) {
    is_located_ = locate();
    // The route begins anew, were it at the same place.
    if (is_located_) told_.reset();
  }
  if (is_located_) follow(now);
  tell();
  displays_.serve();
}

/// Who is not operational is started, again where that was not heard.
void LineControl::start_waiting() {
  next_start_ = node().now() + start_period;
  for (const NodeId id : settings_.nodes) {
    const RemoteState state = master_.remote(id).state();
    const bool waits = state == RemoteState::boot_up || state == RemoteState::pre_operational ||
                       state == RemoteState::stopped;
    if (waits) start(id);
  }
  const bool is_heard =
      master_.remote(settings_.identification).state() == RemoteState::operational;
  if (is_heard && !has_journey_told_) tell_again(settings_.identification);
}

/// It tells all that it has when it enters operational (8.1.4.3).
void LineControl::tell_again(NodeId id) {
  master_.command(id, NmtCommand::enter_pre_operational);
  master_.command(id, NmtCommand::start);
}

/// It has missed what was told: all is told again (8.1.4.3: once after reaching operational).
void LineControl::start(NodeId id) {
  is_started_.at(id) = master_.command(id, NmtCommand::start);
  refresh_at_ = node().now() + refresh_after;
}

void LineControl::refresh() {
  refresh_at_ = never;
  tell_again(node().id());
  // Who drives what tells the identification device.
  tell_again(settings_.identification);
}

void LineControl::changed(NodeId id, RemoteState state) {
  const bool is_ours = std::ranges::find(settings_.nodes, id) != settings_.nodes.end();
  if (!is_ours || !has_begun_) return;
  // Who left operational, or comes back, has nothing of what it was told.
  const bool begins_anew = state != RemoteState::operational || !is_started_.at(id);
  if (begins_anew) displays_.forget(id);
  if (id == settings_.identification && begins_anew) {
    lose_journey();
    has_journey_told_ = false;
  }
  if (id == settings_.positioning && begins_anew) fix_.reset();
  // Whether a door was open meanwhile is not known: who still wants to get off presses again.
  if (id == settings_.doors && begins_anew) hardware_.computer->request_stop(false);
  if (state == RemoteState::lost) {
    is_started_.at(id) = false;
  } else if (begins_anew) {
    // Who was not heard for a time tells all that it has, once more.
    if (state == RemoteState::operational) master_.command(id, NmtCommand::enter_pre_operational);
    start(id);
  }
}

void LineControl::written(const Entry& entry) {
  switch (entry.index) {
    case cia407::journey_number_object.index:
      return take_journey();
    case cia407::position_object.index:
      return entry.sub == 2 ? take_fix() : void();
    case cia407::time_universal_reference_object.index:
      return entry.sub == 8 ? take_time() : void();
    default:
      return;
  }
}

// Who drives what, where and when.

void LineControl::take_journey() {
  has_journey_told_ = true;
  const std::uint32_t block_number = device_[cia407::block_id].raw();
  const std::uint32_t number = device_[cia407::journey_number].raw();
  const Journey* found = nullptr;
  for (const Block& block : line().blocks) {
    if (block.number != block_number) continue;
    for (const Journey& journey : block.journeys) {
      if (journey.number == number) found = &journey;
    }
  }
  if (found == nullptr) return lose_journey();
  if (found == journey_) return;
  has_just_begun_ = journey_ != nullptr && is_located_ && is_at_end();
  has_changed_ = journey_ != nullptr && is_standing_ && node().now() - journey_since_ > settled;
  journey_since_ = node().now();
  journey_ = found;
  is_located_ = false;
  place_ = reached_ = 0;
}

void LineControl::lose_journey() {
  journey_ = nullptr;
  is_located_ = false;
}

void LineControl::take_fix() {
  const std::optional<double> latitude = device_[cia407::latitude].value();
  const std::optional<double> longitude = device_[cia407::longitude].value();
  fix_.reset();
  if (!latitude || !longitude) return;
  fix_ = Fix{{*latitude, *longitude}, hardware_.odometer()};
  if (is_located_ && !is_exact_) refine();
}

void LineControl::take_time() {
  const auto utc = cia407::read_clock(device_.values(), cia407::universal_clock);
  const std::optional<double> hours = device_[cia407::universal_local_hour].value();
  const std::optional<double> minutes = device_[cia407::universal_local_minute].value();
  if (!utc) return;
  const auto offset = static_cast<std::int64_t>(hours.value_or(0)) * cia447::seconds_an_hour +
                      static_cast<std::int64_t>(minutes.value_or(0)) * cia447::seconds_a_minute;
  const std::int64_t local = cia447::seconds_since_1970(*utc) + offset;
  time_heard_ = node().now();
  // Between two messages it goes by its own oscillator: they come a little late, now and then.
  const auto passed = std::chrono::floor<std::chrono::seconds>(time_heard_ - time_at_).count();
  if (time_base_ && std::abs(*time_base_ + passed - local) <= 1) return;
  // Summer time begins or ends: what was told last is not so any more.
  if (time_base_) hardware_.computer->clock_changed();
  time_base_ = local;
  time_at_ = time_heard_;
}

std::optional<cia407::CivilTime> LineControl::local_time() const {
  const Time now = device_.node().now();
  if (time_base_ && now - time_heard_ < time_is_fresh) {
    const auto passed = std::chrono::floor<std::chrono::seconds>(now - time_at_).count();
    return cia447::civil_time(*time_base_ + passed);
  }
  if (now - booted_ < clock_patience || !hardware_.clock) return std::nullopt;
  return hardware_.clock();
}

void LineControl::watch_clock() {
  const bool is_told = local_time().has_value();
  if (std::exchange(told_time_, is_told) != is_told) hardware_.computer->clock_changed();
}

/// What the train wants first may be left from before: only from then on a request is a new one.
void LineControl::train_told(const Frame& frame, Time) {
  if (frame.length == 0) return;
  const bool wants_stop = (frame.data[0] & 1U) != 0;
  const std::optional<bool> before = std::exchange(train_wants_stop_, wants_stop);
  if (before == false && wants_stop) press_stop_button();
}

bool LineControl::press_stop_button() {
  if (node().state() != NmtState::operational) return false;
  hardware_.computer->request_stop();
  return true;
}

}  // namespace canvoy::bus
