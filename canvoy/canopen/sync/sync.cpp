#include "canvoy/canopen/sync/sync.hpp"

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

namespace {

constexpr std::uint32_t overflow_max = 240;

/// A small processor has no instruction to divide, and needs one only here.
std::uint32_t remainder(std::uint32_t dividend, std::uint32_t divisor) {
  if constexpr (!is_small_machine) return dividend % divisor;
  std::uint32_t part = divisor;
  while (part <= dividend / 2) part *= 2;
  for (; dividend >= divisor; part /= 2) {
    if (dividend >= part) dividend -= part;
  }
  return dividend;
}

constexpr Error length_error{.code = emergency_code::sync_length,
                             .register_bits = error_register::communication};

}  // namespace

void Sync::on_event(NodeService& service, ServiceEvent& event) {
  Sync& self = static_cast<Sync&>(service);
  switch (event.kind) {
    case ServiceEvent::reset:
      self.bad_length_ = false;
      return self.read_parameters();
    case ServiceEvent::before_write:
      return event.refuse(self.check(event.entry(), load_word(event.value())));
    case ServiceEvent::after_write:
      return self.parameter_written();
    default:
      return on_constant_event(service, event);
  }
}

void Sync::on_constant_event(NodeService& service, ServiceEvent& event) {
  Sync& self = static_cast<Sync&>(service);
  switch (event.kind) {
    case ServiceEvent::reset:
      self.bad_length_ = false;
      return self.use(self.cob_id());
    case ServiceEvent::state_entered:
      return self.state_entered(event.state());
    case ServiceEvent::frame_came:
      return self.receive(event.frame(), self.node_.now());
    default:
      return;
  }
}

void Sync::attach(SyncListener& listener) {
  SyncListener** place = &listeners_;
  while (*place != nullptr) place = &(*place)->next;
  *place = &listener;
}

bool Sync::is_window_open() const {
  return window_ == 0 || life_ != Life::beats || node_.elapsed_since(received_at_) <= window_;
}

inline void Sync::state_entered(NmtState state) {
  const bool runs = has_services(state);
  if (runs == (life_ != Life::rests)) return;
  life_ = runs ? Life::waits : Life::rests;
  counter_ = 0;
  beat(Beat::restart);
}

inline AbortCode Sync::check(const Entry& entry, std::uint32_t wanted) const {
  if (entry.index == object_index::cob_id_sync) {
    if (!fits(CobId{entry.word()}, CobId{wanted})) return AbortCode::value_range;
    // Without 1006h it cannot produce SYNC.
    if (keep_period_ == nullptr && (wanted & CobId::bit30) != 0) return AbortCode::value_range;
    if (can_id_ == 0 && !node_.router().has_room_to_listen()) return AbortCode::out_of_memory;
  } else if (entry.index == object_index::sync_counter_overflow) {
    if (wanted == 1 || wanted > overflow_max) return AbortCode::value_range;
    if (period_ != 0 && wanted != overflow_) return AbortCode::device_state;
  }
  return AbortCode::none;
}

/// Bit 31 has no meaning here. A producer keeps its CAN-ID.
inline bool Sync::fits(CobId present, CobId wanted) const {
  const bool stays_producer = (present.raw & wanted.raw & CobId::bit30) != 0;
  return has_free_id(wanted) && (!stays_producer || wanted.can_id() == present.can_id());
}

inline void Sync::parameter_written() {
  const bool was_producer = is_producer_;
  const std::uint32_t period = period_;
  read_parameters();
  if (is_producer_ != was_producer) {
    counter_ = 0;
  } else if (period_ == period) {
    return;
  }
  beat(Beat::restart);
}

CobId Sync::cob_id() const {
  return CobId{node_.dictionary().word(object_index::cob_id_sync, 0, can_id::sync)};
}

void Sync::use(CobId cob_id) {
  const Dictionary& dictionary = node_.dictionary();
  window_ = dictionary.word(object_index::sync_window);
  overflow_ = static_cast<std::uint8_t>(dictionary.word(object_index::sync_counter_overflow));
  const auto wanted = static_cast<std::uint16_t>(cob_id.can_id());
  if (wanted != can_id_) {
    const bool hears = node_.router().listen<&Sync::receive>(*this, can_id_, wanted);
    can_id_ = hears ? wanted : std::uint16_t{0};
  }
  beat(Beat::configured);
}

/// SYNC is not lost before the first one, or after one was received.
void Sync::keep_period(Sync& self, Beat beat) {
  if (beat == Beat::configured) {
    self.period_ = self.node_.dictionary().word(object_index::sync_period);
    const bool may_produce = (self.cob_id().raw & CobId::bit30) != 0 && self.can_id_ != 0;
    self.is_producer_ = may_produce && self.period_ != 0;
    return;
  }
  TimerQueue& timers = self.node_.timers();
  self.set_lost(false);
  if (beat == Beat::restart) {
    timers.disarm(self.timer_);
    if (self.life_ != Life::rests && self.is_producer_) self.schedule(0);
  } else if (self.period_ != 0 && !self.is_producer_) {
    timers.arm(self.timer_, self.node_.now() + Duration(self.period_) + Duration(self.period_ / 2));
  }
}

/// Schedules the next SYNC after one that is `late` by that many microseconds. Missed ones are
/// skipped.
void Sync::schedule(std::uint32_t late) {
  check_invariant(period_ != 0);
  const std::uint32_t left = period_ - remainder(late, period_);
  due_ = low_ticks(node_.now()) + left;
  node_.timers().arm_in(timer_, left);
}

void Sync::expire(void* sync, Time) {
  Sync& self = *static_cast<Sync*>(sync);
  if (self.is_producer_) return self.produce();
  self.set_lost(true);
}

void Sync::set_lost(bool lost) {
  if (lost == lost_) return;
  lost_ = lost;
  lost_changed(lost);
}

inline void Sync::produce() {
  schedule(low_ticks(node_.now()) - due_);
  check_invariant(can_id_ != 0);  // otherwise it would be a command of NMT
  Frame frame;
  frame.id = can_id_;
  if (overflow_ != 0) {
    counter_ = counter_ >= overflow_ ? std::uint8_t{1} : static_cast<std::uint8_t>(counter_ + 1);
    frame.length = 1;
    frame.data[0] = counter_;
  }
  // SYNCs of a bus-off period would all leave at once after it, and each of them is a command to
  // all.
  if (node_.bus_state() != BusState::bus_off) node_.transmitter().send(frame);
  announce(counter_);
}

inline void Sync::receive(const Frame& frame, Time) {
  if (life_ == Life::rests) return;
  const bool is_bad = frame.length != (overflow_ == 0 ? 0 : 1);
  if (is_bad != bad_length_) {
    bad_length_ = is_bad;
    node_.report(length_error, is_bad);
  }
  if (is_bad) return node_.count_malformed();
  beat(Beat::received);
  announce(frame.length == 0 ? std::uint8_t{0} : frame.data[0]);
}

void Sync::announce(std::uint8_t counter) {
  received_at_ = node_.now();
  life_ = Life::beats;
  node_.notify_sync(ServiceEvent::actuate, counter);
  for (SyncListener* listener = listeners_; listener != nullptr; listener = listener->next) {
    listener->received(counter);
  }
  node_.notify_sync(ServiceEvent::sample, counter);
}

}  // namespace canvoy
