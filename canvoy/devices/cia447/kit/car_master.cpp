#include "canvoy/devices/cia447/kit/car_master.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/cia447.hpp"

namespace canvoy::cia447 {

namespace {

constexpr NodeId first_add_on = gateway_node_id + 1;

/// Messages for which the bus had no room are sent later, and answered all at once. A measurement
/// of that would take each device for a slow one, and a hundred requests would take minutes.
constexpr LssFastscan::Options fastscan_options = {.time_out_max = 200ms};

constexpr std::size_t position_of(NodeId node) {
  return node - std::size_t{first_add_on};
}

}  // namespace

std::optional<NodeId> KnownDevices::find(const LssAddress& address) const {
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    if (is_known[i] && addresses[i] == address) return static_cast<NodeId>(first_add_on + i);
  }
  return std::nullopt;
}

constexpr ServiceHandlers CarMaster::service_calls = {.reset = method<&CarMaster::reset>};

CarMaster::CarMaster(CarNetwork& network, CarSleep& sleep, const CarMemory& memory,
                     const CarMasterSettings& settings)
    : network_(network),
      sleep_(sleep),
      memory_(memory),
      settings_(settings),
      lss_(network.node()),
      scan_(network.node(), lss_, scanned_, fastscan_options),
      scan_timer_(callback<&CarMaster::look>(*this)),
      objection_timer_(callback<&CarMaster::nobody_objected>(*this)),
      wake_up_timer_(callback<&CarMaster::wake_up_unheard>(*this)),
      client_(network.node()) {
  if (memory_.load) known_ = memory_.load();
  network.node().attach(service_);
  next_heard_ = network.on_heard(callback<&CarMaster::heard>(*this));
  next_lost_ = network.on_lost(callback<&CarMaster::lost>(*this));
  sleep.on_change(callback<&CarMaster::sleep_changed>(*this));
  scan_.on_choose(LssScan::Choose::to<&CarMaster::choose>(*this));
  scan_.on_found(LssScan::Report::to<&CarMaster::found>(*this));
  const auto came = Callback<void(const Frame&, Time)>::to<&CarMaster::sleep_message>(*this);
  for (NodeId node = first_add_on; node <= node_id_max; ++node) {
    network.node().router().add(static_cast<std::uint16_t>(sleep_can_id(node)), came);
  }
  network.node().router().add(can_id::nmt, callback<&CarMaster::commanded>(*this));
}

void CarMaster::reset(ResetScope) {
  present_.reset();
  started_.reset();
  halted_.reset();
  stop_looking();
  look_around_at_ = network_.node().now();
  network_.node().timers().arm(scan_timer_, network_.node().now());
  network_.node().timers().arm(wake_up_timer_, network_.node().now() + settings_.wake_up_after);
}

// Node-IDs.

void CarMaster::look(Time now) {
  if (sleep_.state() != SleepState::awake) return;
  // The master also starts itself: no other node does.
  if (settings_.starts_nodes && network_.node().state() == NmtState::pre_operational) {
    network_.node().command(NmtCommand::start);
  }
  if (move_next()) return;
  if (now < look_around_at_) return look_for_lost();
  const bool begun =
      scan_.start({.pattern = {}, .store = false}, LssScan::Done::to<&CarMaster::scanned>(*this));
  if (!begun) network_.node().timers().arm(scan_timer_, now + settings_.scan_period);
}

/// One at a time.
void CarMaster::look_for_lost() {
  for (unsigned tried = 0; tried < add_on_devices_max; ++tried) {
    looked_for_ = looked_for_ == node_id_max ? first_add_on : looked_for_ + 1;
    const std::size_t position = position_of(looked_for_);
    if (present_[looked_for_] || !known_.is_known[position]) continue;
    constexpr std::array<bool, 4> all{true, true, true, true};
    const LssPattern pattern = {.address = known_.addresses[position], .known = all};
    if (scan_.start({.pattern = pattern}, LssScan::Done::to<&CarMaster::looked>(*this))) return;
  }
  looked({});
}

void CarMaster::scanned(LssScan::Outcome outcome) {
  if (scan_.came_again()) {
    look_around_at_ = network_.node().now() + settings_.answered_scan_period;
  }
  looked(outcome);
}

void CarMaster::looked(LssScan::Outcome) {
  network_.node().timers().arm(scan_timer_, network_.node().now() + settings_.scan_period);
}

/// The former node-ID, if its present holder is this device before a restart. Otherwise the
/// reserved one; otherwise an unused one; otherwise one of a missing device.
NodeId CarMaster::choose(const LssAddress& address) {
  if (const auto before = known_.find(address)) return *before;
  if (const auto place = place_for(settings_.places, address, present_)) return *place;
  const NodeId chosen = only_place(settings_.places, present_).value_or(find_free());
  if (chosen == node_id_unconfigured) {
    tell({.kind = CarEvent::Kind::refused});
  } else {
    guests_[chosen] = true;
  }
  return chosen;
}

bool CarMaster::is_place(NodeId node) const {
  return std::ranges::find(settings_.places, node, &CarPlace::id) != settings_.places.end();
}

NodeId CarMaster::find_free() const {
  NodeId of_absent = node_id_unconfigured;
  for (NodeId node = first_add_on; node <= node_id_max; ++node) {
    if (present_[node] || is_place(node)) continue;
    if (!known_.is_known[position_of(node)]) return node;
    if (of_absent == node_id_unconfigured) of_absent = node;
  }
  return of_absent;
}

void CarMaster::found(const LssScan::Found& found) {
  if (!is_node_id(found.id)) return;
  check_invariant(found.id >= first_add_on);
  const std::size_t position = position_of(found.id);
  known_.addresses[position] = found.address;
  known_.is_known[position] = true;
  started_[found.id] = false;
  present_[found.id] = true;  // it is monitored from its boot-up message on
  if (memory_.store) memory_.store(known_);
  tell({.kind = CarEvent::Kind::named, .node = found.id});
}

// States.

/// A node that a tool stops or makes pre-operational stays so until it is started, or boots.
void CarMaster::commanded(const Frame& frame, Time) {
  if (frame.length != 2 || frame.data[1] > node_id_max) return;
  const auto command = static_cast<NmtCommand>(frame.data[0]);
  const bool halts = command == NmtCommand::stop || command == NmtCommand::enter_pre_operational;
  const NodeId node = frame.data[1];
  if (node != 0) {
    halted_[node] = halts;
  } else {
    halts ? halted_.set() : halted_.reset();
  }
}

/// A device is started when it boots, and when it is received as pre-operational without a command:
/// some devices send no boot-up message, and bus-off or another error may lead to that state.
void CarMaster::heard(NodeId node, std::uint8_t state) {
  if (next_heard_) next_heard_(node, state);
  if (node < first_add_on) return;
  if (sleep_.state() == SleepState::asleep) return repeat_order();
  constexpr std::uint8_t boot_up = 0;
  present_[node] = true;
  network_.watch(node);
  const bool is_met = state == static_cast<std::uint8_t>(NmtState::pre_operational);
  if (state == boot_up) halted_[node] = false;
  if (state == static_cast<std::uint8_t>(NmtState::operational)) started_[node] = false;
  const bool waits = state == boot_up || (is_met && !started_[node] && !halted_[node]);
  if (waits && settings_.starts_nodes && sleep_.state() == SleepState::awake) start(node);
  ask_next();
}

void CarMaster::start(NodeId node) {
  const Frame start = {
      .id = can_id::nmt, .length = 2, .data = {static_cast<std::uint8_t>(NmtCommand::start), node}};
  started_[node] = network_.node().transmitter().send(start);
  if (!started_[node]) return;  // once more with its next heartbeat
  tell({.kind = CarEvent::Kind::started, .node = node});
  to_be_asked_[node] = true;
}

/// Reads the identity of a device: one that is not of this profile is reported, and left alone. A
/// device that cannot be read at present is read when it is received again.
void CarMaster::ask_next() {
  const Node& own = network_.node();
  if (client_.busy() || !client_.may_speak() || own.bus_state() == BusState::bus_off) return;
  for (NodeId node = first_add_on; node <= node_id_max; ++node) {
    if (!to_be_asked_[node] || !present_[node]) continue;
    to_be_asked_[node] = false;
    asked_ = node;
    bus_offs_before_ = own.counters().bus_off;
    client_.upload(node, object_index::device_type, 0, device_type_,
                   SdoClient::Done::to<&CarMaster::device_type_came>(*this));
    return;
  }
}

void CarMaster::device_type_came(SdoClient::Outcome outcome) {
  const bool is_cut_off = network_.node().counters().bus_off != bus_offs_before_;
  if (!outcome && (is_cut_off || !client_.may_speak())) {
    to_be_asked_[asked_] = true;
    return;
  }
  const bool is_of_car = outcome && load<std::uint16_t>(device_type_.data()) == device_type;
  if (!is_of_car) tell({.kind = CarEvent::Kind::stranger, .node = asked_});
  if (is_of_car && guests_[asked_]) return ask_place(0);
  ask_next();
}

/// Selects the reserved node-ID of a device among those for any device: the first for which it
/// provides the virtual device.
void CarMaster::ask_place(std::size_t first) {
  for (std::size_t i = first; i < settings_.places.size(); ++i) {
    const CarPlace& place = settings_.places[i];
    if (!place.is_of_anyone() || (present_[place.id] && place.id != asked_)) continue;
    asked_place_ = i;
    const DeviceMark mark = mark_of(*place.provides);
    const AbortCode unsent = client_.upload(asked_, mark.index, mark.sub, device_type_,
                                            SdoClient::Done::to<&CarMaster::place_answered>(*this));
    if (unsent != AbortCode::none) ask_next();
    return;
  }
  // It has none. If it has that of another device, it leaves it.
  if (is_place(asked_)) belongs(find_free());
  ask_next();
}

/// A device that does not answer keeps its node-ID.
void CarMaster::place_answered(SdoClient::Outcome outcome) {
  const bool is_long = outcome.abort() == AbortCode::out_of_memory;  // a text
  const bool has = outcome || outcome.is_refusal() || is_long;
  if (is_absent(outcome)) return ask_place(asked_place_ + 1);
  if (has) belongs(settings_.places[asked_place_].id);
  ask_next();
}

void CarMaster::belongs(NodeId place) {
  guests_[asked_] = false;
  if (canvoy::is_node_id(place) && place != asked_) moves_to_[asked_] = place;
}

/// One at a time, while no device is searched for.
bool CarMaster::move_next() {
  for (NodeId node = first_add_on; node <= node_id_max; ++node) {
    const NodeId to = moves_to_[node];
    if (to == 0 || !present_[node] || present_[to]) continue;
    moving_ = node;
    if (lss_.switch_global(LssState::waiting) &&
        lss_.select(known_.addresses[position_of(node)],
                    LssMaster::Done::to<&CarMaster::selected>(*this))) {
      return true;
    }
  }
  moving_ = 0;
  return false;
}

void CarMaster::selected(const LssMaster::Reply& reply) {
  const bool asks =
      reply.ok() &&
      lss_.configure_node_id(moves_to_[moving_], LssMaster::Done::to<&CarMaster::moved>(*this));
  if (!asks) moved({});
}

/// It has its new node-ID from the reset of its communication on.
void CarMaster::moved(const LssMaster::Reply& reply) {
  const NodeId from = std::exchange(moving_, NodeId{0});
  const NodeId to = std::exchange(moves_to_[from], NodeId{0});
  lss_.switch_global(LssState::waiting);
  if (reply.ok()) {
    constexpr auto reset = static_cast<std::uint8_t>(NmtCommand::reset_communication);
    network_.node().transmitter().send({.id = can_id::nmt, .length = 2, .data = {reset, from}});
    network_.unwatch(from);
    present_[from] = false;
    known_.is_known[position_of(from)] = false;
    LssScan::Found moved_one;
    moved_one.address = known_.addresses[position_of(from)];
    moved_one.id = to;
    found(moved_one);
  }
  looked({});
}

void CarMaster::stop_looking() {
  scan_.cancel();
  if (moving_ != 0) lss_.cancel();
  moving_ = 0;
}

void CarMaster::lost(NodeId node) {
  if (next_lost_) next_lost_(node);
  // A device that boots again is received at once again.
  present_[node] = false;
  started_[node] = false;
  tell({.kind = CarEvent::Kind::lost, .node = node});
}

// Sleep.

void CarMaster::send_to_sleep() {
  if (sleep_.state() != SleepState::awake || objection_timer_.armed()) return;
  sleep_.say(SleepCommand::query_objection);
  network_.node().timers().arm(objection_timer_, network_.node().now() + settings_.objection_time);
}

/// A request to wake up is an objection to sleep: a query that is under way has its answer.
void CarMaster::wake_up() {
  network_.node().timers().disarm(objection_timer_);
  sleep_.wake_up();
}

void CarMaster::sleep_message(const Frame& frame, Time) {
  constexpr std::uint8_t length = 8;
  if (frame.length != length) return;  // CarSleep counts it
  const auto node = static_cast<NodeId>(frame.id - sleep_can_id(0));
  switch (static_cast<SleepCommand>(frame.data[0])) {
    case SleepCommand::objection:
      if (!objection_timer_.armed()) break;
      network_.node().timers().disarm(objection_timer_);
      tell({.kind = CarEvent::Kind::objection, .node = node, .reason = frame.data[1]});
      if (sleep_.state() == SleepState::asleep) wake_up();
      break;
    case SleepCommand::request_sleep:
      send_to_sleep();
      break;
    case SleepCommand::wake_up:
      network_.node().timers().disarm(objection_timer_);
      break;
    default:
      break;
  }
}

void CarMaster::nobody_objected(Time now) {
  sleep_.say(SleepCommand::set_sleep_mode);
  order_again_at_ = now + settings_.order_period;
  if (sleep_.state() != SleepState::awake) return;
  stop_looking();
  sleep_.prepare();
}

/// A device has not received the order to sleep, nor the question for objections.
void CarMaster::repeat_order() {
  const Time now = network_.node().now();
  if (objection_timer_.armed() || now < order_again_at_) return;
  sleep_.say(SleepCommand::query_objection);
  network_.node().timers().arm(objection_timer_, now + settings_.objection_time);
}

/// It may have lost its power while all others slept.
void CarMaster::wake_up_unheard(Time) {
  if (sleep_.state() != SleepState::awake || objection_timer_.armed()) return;
  bool all_are_heard = true;
  for (NodeId node = first_add_on; node <= node_id_max; ++node) {
    all_are_heard = all_are_heard && (present_[node] || !known_.is_known[position_of(node)]);
  }
  if (!all_are_heard) sleep_.wake_up();
}

void CarMaster::sleep_changed(SleepState state) {
  if (state == SleepState::asleep) {
    for (NodeId node = first_add_on; node <= node_id_max; ++node) network_.unwatch(node);
    present_.reset();
    started_.reset();
    tell({.kind = CarEvent::Kind::asleep});
  } else if (state == SleepState::awake) {
    tell({.kind = CarEvent::Kind::awake});
  }
}

void CarMaster::tell(const CarEvent& event) {
  if (told_) told_(event);
}

}  // namespace canvoy::cia447
