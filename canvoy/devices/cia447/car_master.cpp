#include "canvoy/devices/cia447/car_master.hpp"

#include <algorithm>

#include "canvoy/can/must_hold.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/profiles/cia447.hpp"

namespace canvoy::cia447 {

namespace {

constexpr NodeId first_add_on = gateway_node_id + 1;

/// What the bus had no room for is sent when it has, and is answered all at once: who measures that
/// takes each device to be slow, and a hundred questions would take minutes.
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

constexpr ServiceCalls CarMaster::service_calls = {.reset = method<&CarMaster::reset>};

CarMaster::CarMaster(CarNetwork& network, CarSleep& sleep, const CarMemory& memory,
                     const CarMasterSettings& settings)
    : network_(network),
      sleep_(sleep),
      memory_(memory),
      settings_(settings),
      lss_(network.node()),
      scan_(network.node(), lss_, scanned_, fastscan_options),
      scan_timer_(Callback<void(Time)>::to<&CarMaster::look>(*this)),
      objection_timer_(Callback<void(Time)>::to<&CarMaster::nobody_objected>(*this)),
      wake_up_timer_(Callback<void(Time)>::to<&CarMaster::wake_up_unheard>(*this)),
      client_(network.node()) {
  if (memory_.load) known_ = memory_.load();
  network.node().attach(service_);
  next_heard_ =
      network.on_heard(Callback<void(NodeId, std::uint8_t)>::to<&CarMaster::heard>(*this));
  next_lost_ = network.on_lost(Callback<void(NodeId)>::to<&CarMaster::lost>(*this));
  sleep.on_change(Callback<void(SleepState)>::to<&CarMaster::sleep_changed>(*this));
  scan_.on_choose(LssScan::Choose::to<&CarMaster::choose>(*this));
  scan_.on_found(LssScan::Report::to<&CarMaster::found>(*this));
  const auto came = Callback<void(const Frame&, Time)>::to<&CarMaster::sleep_message>(*this);
  for (NodeId node = first_add_on; node <= node_id_max; ++node) {
    network.node().router().add(static_cast<std::uint16_t>(sleep_can_id(node)), came);
  }
  network.node().router().add(can_id::nmt,
                              Callback<void(const Frame&, Time)>::to<&CarMaster::commanded>(*this));
}

void CarMaster::reset(ResetScope) {
  present_.reset();
  started_.reset();
  halted_.reset();
  scan_.cancel();
  look_around_at_ = network_.node().now();
  network_.node().timers().arm(scan_timer_, network_.node().now());
  network_.node().timers().arm(wake_up_timer_, network_.node().now() + settings_.wake_up_after);
}

// Names.

void CarMaster::look(Time now) {
  if (sleep_.state() != SleepState::awake) return;
  // The master starts itself as well: nobody else does.
  if (settings_.starts_nodes && network_.node().state() == NmtState::pre_operational) {
    network_.node().command(NmtCommand::start);
  }
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

/// The node-ID that it had before: who has it there was this device, until it restarted. Else one
/// that nobody had; else one of who is not there.
NodeId CarMaster::choose(const LssAddress& address) {
  if (const auto before = known_.find(address)) return *before;
  const NodeId free = find_free();
  if (free == node_id_unconfigured) tell({.kind = CarEvent::Kind::refused});
  return free;
}

NodeId CarMaster::find_free() const {
  NodeId of_absent = node_id_unconfigured;
  for (NodeId node = first_add_on; node <= node_id_max; ++node) {
    if (present_[node]) continue;
    if (!known_.is_known[position_of(node)]) return node;
    if (of_absent == node_id_unconfigured) of_absent = node;
  }
  return of_absent;
}

void CarMaster::found(const LssScan::Found& found) {
  if (!is_node_id(found.id)) return;
  must_hold(found.id >= first_add_on);
  const std::size_t position = position_of(found.id);
  known_.addresses[position] = found.address;
  known_.is_known[position] = true;
  started_[found.id] = false;
  present_[found.id] = true;  // it is watched from its boot-up message on
  if (memory_.store) memory_.store(known_);
  tell({.kind = CarEvent::Kind::named, .node = found.id});
}

// States.

/// Whom a tool stops or makes pre-operational stays so until he is started, or boots.
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

/// A device is started when it boots, and when it is heard pre-operational where nobody has
/// commanded that: not all send a boot-up message, and bus-off or another error may lead there.
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

/// What a device is: one that is none of this profile is told of, and left alone. Who cannot be
/// asked now is asked when he is heard again.
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
  ask_next();
}

void CarMaster::lost(NodeId node) {
  if (next_lost_) next_lost_(node);
  // Who boots anew is heard at once again.
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

/// Who asks for it does not want to sleep: a query that is under way has had its answer.
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
  scan_.cancel();
  sleep_.prepare();
}

/// Somebody has not heard that all sleep: nor was it asked whether it objects to that.
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
