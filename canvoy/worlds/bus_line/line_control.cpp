#include "canvoy/worlds/bus_line/line_control.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/worlds/bus_line/line_texts.hpp"

namespace canvoy::bus_line {

namespace {

constexpr Duration look_period = RoutePosition::look_period;
constexpr Duration start_period = 1s;
constexpr Duration refresh_after = 200ms;
/// Until this time, a message of doors that open has come.
constexpr Duration doors_told_after = 500ms;

}  // namespace

constexpr AccessHandlers LineControl::hook_calls[] = {
    after_write<&LineControl::take_journey, cia407::journey_number_object>,
    after_write<&LineControl::take_fix, cia407::longitude>,
    after_write<&LineControl::take_time, cia407::universal_second>};

LineControl::LineControl(cia407::VirtualDevice& device, const LineControlHardware& hardware,
                         LineControlSettings settings)
    : device_(device),
      hardware_(hardware),
      settings_(std::move(settings)),
      remotes_(std::make_unique<std::array<NmtMaster::RemoteNode, node_id_max>>()),
      master_(device.node(), *remotes_),
      gaps_(device.node(), callback<&LineControl::ask_anew>(*this), rhythms_),
      displays_(device.node(), master_, hardware.computer->texts()),
      timer_(callback<&LineControl::look>(*this)),
      position_({.odometer = hardware.odometer, .has_open_door = hardware.has_open_door}),
      clock_(hardware.clock) {
  for (const DisplayServer::Display& display : settings_.displays) displays_.add(display);
  if (JourneyTexts::need_more_sets(line())) {
    displays_.ask_for_sets(callback<&LineControl::sets_learnt>(*this));
  }
  device.on_reset = callback<&LineControl::reset>(*this);
  device.react(*this, hook_calls);
  master_.on_message(callback<&LineControl::heard>(*this));
  master_.on_change(callback<&LineControl::changed>(*this));
  for (const NodeId id : settings_.nodes) {
    master_.set_time_out(
        id, id == settings_.identification ? settings_.identification_time_out : node_time_out);
  }
  if (settings_.train_stop_request_id != 0) {
    device.node().router().add(settings_.train_stop_request_id,
                               Router::Receiver::to<&LineControl::train_told>(*this));
  }
  if (settings_.diagnostics != 0) hear_errors();
}

/// Destroys the timers of the watched nodes before other units of its device, which still remove
/// theirs from the queue.
LineControl::~LineControl() {
  for (NodeId id = node_id_min; id <= node_id_max; ++id) {
    master_.set_time_out(id, Duration::zero());
  }
  node().timers().disarm(timer_);
}

void LineControl::reset(ResetScope) {
  forget_all();
  clock_.begin(node().now());
  node().timers().arm(timer_, node().now());
}

void LineControl::forget_all() {
  has_begun_ = false;
  has_journey_told_ = false;
  journey_ = interrupted_ = nullptr;
  position_.forget();
  clock_.forget();
  told_.reset();
  refresh_at_ = never;
  train_wants_stop_.reset();
  errors_.fill(0);
  displays_.forget_all();
}

/// The state of the other devices is unknown: they go dark, and start from the beginning.
void LineControl::begin() {
  master_.command(NmtMaster::all_nodes, NmtCommand::enter_pre_operational);
  master_.command(NmtMaster::all_nodes, NmtCommand::start);
  is_started_.fill(true);
  has_begun_ = true;
}

void LineControl::look(Time now) {
  node().timers().arm(timer_, now + look_period);
  // Its own controller may have failed for a time: messages may be lost.
  if (has_begun_ && node().state() != NmtState::operational) forget_all();
  if (!has_begun_) begin();
  if (now >= next_start_) start_waiting();
  if (now >= refresh_at_) refresh();
  position_.sense(now);
  watch_doors(now);
  if (clock_.has_come_or_gone(now)) hardware_.computer->clock_changed();
  locate();
  tell();
  displays_.serve();
}

void LineControl::locate() {
  if (position_.locate()) {
    hardware_.computer->begin_route({});
    // The route begins again, even if at the same position.
    told_.reset();
  }
  if (position_.is_located()) position_.follow();
}

/// Starts nodes that are not operational, again where they have not received it.
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
  if (is_heard && !has_journey_told_) report_again(settings_.identification);
}

/// A device sends all its data when it enters operational (8.1.4.3).
void LineControl::report_again(NodeId id) {
  master_.command(id, NmtCommand::enter_pre_operational);
  master_.command(id, NmtCommand::start);
}

/// A device that enters operational sends all its data (8.1.4.3).
void LineControl::ask_anew(NodeId id) {
  if (!has_begun_) return;
  for (const NodeId source : settings_.sources) {
    const bool is_meant = id == GapWatch::everyone || id == source;
    if (is_meant && master_.remote(source).state() == RemoteState::operational)
      report_again(source);
  }
  report_again(node().id());
}

/// The node has missed earlier messages: all is sent again (8.1.4.3: once after reaching
/// operational).
void LineControl::start(NodeId id) {
  is_started_.at(id) = master_.command(id, NmtCommand::start);
  refresh_at_ = node().now() + refresh_after;
}

void LineControl::refresh() {
  refresh_at_ = never;
  report_again(node().id());
  // The identification device has the journey.
  report_again(settings_.identification);
  // Counters that were away have missed a door that has opened.
  if (std::exchange(has_returned_, false)) report_again(settings_.doors);
}

void LineControl::changed(NodeId id, RemoteState state) {
  const bool is_ours = std::ranges::find(settings_.nodes, id) != settings_.nodes.end();
  if (!is_ours || !has_begun_) return;
  // A node that has left operational, or returns, has lost its data.
  const bool begins_anew = state != RemoteState::operational || !is_started_.at(id);
  if (begins_anew) displays_.forget(id);
  has_returned_ = has_returned_ || (begins_anew && was_operational_.at(id));
  if (state == RemoteState::operational) was_operational_.at(id) = true;
  if (id == settings_.identification && begins_anew) {
    interrupt_journey();
    has_journey_told_ = false;
  }
  if (id == settings_.positioning && begins_anew) position_.take_fix({});
  // Whether a door was open meanwhile is unknown: passengers who still want to get off press again.
  if (id == settings_.doors && begins_anew) hardware_.computer->request_stop(false);
  // What it sends then may be old.
  if (id == settings_.train_gateway && begins_anew) train_wants_stop_.reset();
  if (state == RemoteState::lost) {
    is_started_.at(id) = false;
  } else if (begins_anew) {
    // A node that was not heard for a time sends all its data once more.
    if (state == RemoteState::operational) master_.command(id, NmtCommand::enter_pre_operational);
    start(id);
  }
}

// Journey, position and time.

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
  const Journey* interrupted = std::exchange(interrupted_, nullptr);
  if (interrupted != nullptr && found != interrupted) lose_journey();
  journey_ = found;
  if (found != interrupted) position_.begin(route(), node().now());
}

/// The vehicle may go on along its route meanwhile: the position is known when the device is back.
void LineControl::interrupt_journey() {
  if (journey_ != nullptr) interrupted_ = std::exchange(journey_, nullptr);
}

void LineControl::lose_journey() {
  journey_ = interrupted_ = nullptr;
  position_.lose_route();
}

void LineControl::take_fix() {
  const std::optional<double> latitude = device_[cia407::latitude].value();
  const std::optional<double> longitude = device_[cia407::longitude].value();
  std::optional<GeoPoint> point;
  if (latitude && longitude) point = {*latitude, *longitude};
  position_.take_fix(point);
}

void LineControl::take_time() {
  const auto utc = cia407::read_clock(device_.values(), cia407::universal_clock);
  const std::optional<double> hours = device_[cia407::universal_local_hour].value();
  const std::optional<double> minutes = device_[cia407::universal_local_minute].value();
  if (!utc) return;
  const auto offset = static_cast<std::int64_t>(hours.value_or(0)) * cia447::seconds_an_hour +
                      static_cast<std::int64_t>(minutes.value_or(0)) * cia447::seconds_a_minute;
  const std::int64_t local = cia447::seconds_since_1970(*utc) + offset;
  // Then the last time that was reported is wrong.
  if (clock_.hear(local, node().now())) hardware_.computer->clock_changed();
}

std::optional<cia407::CivilTime> LineControl::local_time() const {
  return clock_.local(device_.node().now());
}

// Output: numbers by the pre-defined messages, texts to displays.

JourneyTexts LineControl::texts() const {
  const std::size_t reached = position_.is_located() ? position_.reached() : 0;
  return {
      line(), journey_, {.place = position_.place(), .is_known = knows_stop(), .reached = reached}};
}

/// Sends nothing that is unknown.
void LineControl::tell() {
  const Told now = {journey_, knows_stop(), position_.has_reached_stop(), position_.place(),
                    position_.reached()};
  if (std::exchange(told_, now) == now) return;
  hardware_.computer->block_tickets(!now.knows_stop);
  if (now.knows_stop) {
    report_position();
  } else {
    hardware_.computer->set_position({});
  }
  displays_.want(
      [texts = texts()](DisplayUse use, CharacterSets sets) { return texts.view_of(use, sets); });
  keep_texts();
}

/// Makes the texts readable here for other devices (5.2).
void LineControl::keep_texts() {
  if (journey_ == nullptr) return;
  for (const DisplayText& text : texts().all()) {
    const Result<Entry> entry = node().dictionary().find(text.index, text.sub);
    if (entry) node().dictionary().set(*entry, text.octets);
  }
}

void LineControl::report_position() {
  const std::size_t place = position_.place();
  const BusStop& stop = line().stop(journey_->route, place);
  // On the way to the first stop it has not reached another zone.
  if (position_.has_reached_stop()) told_stop_ = route().stops[position_.reached()];
  using cia407::JourneyDirection;
  hardware_.computer->set_line_name(to_ascii(line().names_of(route()).name));
  hardware_.computer->set_stop_name(to_ascii(stop.short_name));
  hardware_.computer->set_position(
      {.stop_point_id = stop.number,
       .number_of_running = static_cast<std::uint8_t>(std::min<std::size_t>(place + 1, 255)),
       .fare_zone = told_stop_.fare_zone,
       .route_segment = told_stop_.route_segment,
       .direction = route().is_backward ? JourneyDirection::backward : JourneyDirection::forward});
}

/// The first request of the train may be old: only a later one is new.
void LineControl::train_told(const Frame& frame, Time) {
  if (frame.length == 0) return;
  const bool wants_stop = (frame.data[0] & 1U) != 0;
  const std::optional<bool> before = std::exchange(train_wants_stop_, wants_stop);
  if (before == false && wants_stop) press_stop_button();
}

void LineControl::hear_errors() {
  for (const NodeId id : settings_.nodes) {
    node().router().add(can_id::emergency + id,
                        Router::Receiver::to<&LineControl::error_told>(*this));
  }
}

/// Writes an error to sub-index 01h when it comes, and not again while it lasts (9.2.27.1). The
/// device code is the node-ID: codes are up to the system.
void LineControl::error_told(const Frame& frame, Time) {
  if (frame.length < 2) return;
  const std::uint32_t id = frame.id - can_id::emergency;
  const auto code = load<std::uint16_t>(frame.data.data());
  const bool is_new = std::exchange(errors_.at(id), code) != code && code != 0;
  if (!is_new || master_.remote(settings_.diagnostics).state() != RemoteState::operational) return;
  hardware_.computer->texts().send(
      settings_.diagnostics, cia407::short_diagnostic_error_field_object.index, 1, id << 16 | code);
}

/// Doors that open end a request to stop (9.2.8.5): the computer has their contacts where the
/// message was lost.
void LineControl::watch_doors(Time now) {
  const bool is_open = hardware_.has_open_door && hardware_.has_open_door();
  if (!std::exchange(had_open_door_, is_open) && is_open) opened_at_ = now;
  if (opened_at_ == never || now < opened_at_ + doors_told_after) return;
  opened_at_ = never;
  const bool is_left = device_[cia407::bus_stop_request].is(cia407::BusStop::requested);
  if (is_left) hardware_.computer->request_stop(false);
}

bool LineControl::press_stop_button() {
  if (node().state() != NmtState::operational) return false;
  hardware_.computer->request_stop();
  return true;
}

}  // namespace canvoy::bus_line
