#include "canvoy/canopen/sync.hpp"

#include "canvoy/canopen/pdo_parameter.hpp"

namespace canvoy {

namespace {

constexpr std::uint16_t cob_id_index = 0x1005;
constexpr std::uint16_t period_index = 0x1006;
constexpr std::uint16_t window_index = 0x1007;
constexpr std::uint16_t overflow_index = 0x1019;
constexpr std::uint32_t overflow_max = 240;

/// A small processor has no instruction to divide, and no need for one but here.
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

constexpr ServiceCalls Sync::service_calls = {.reset = method<&Sync::reset>,
                                              .state_entered = method<&Sync::state_entered>,
                                              .receive = on_small_machine<&Sync::hear>,
                                              .hooks = {&hook_calls, 1}};
/// What lies between is nothing to it: a write there has it read the same parameters again.
constexpr HookCalls Sync::hook_calls = {.first = cob_id_index,
                                        .last = overflow_index,
                                        .before_write = method<&Sync::before_write>,
                                        .after_write = method<&Sync::after_write>};

void Sync::attach(SyncListener& listener) {
  SyncListener** place = &listeners_;
  while (*place != nullptr) place = &(*place)->next;
  *place = &listener;
}

bool Sync::is_window_open() const {
  return window_ == 0 || node_.elapsed_since(received_at_) <= window_;
}

inline void Sync::reset(ResetScope) {
  bad_length_ = false;
  read_parameters();
}

inline void Sync::state_entered(NmtState state) {
  const bool runs = state == NmtState::pre_operational || state == NmtState::operational;
  if (runs == running_) return;
  running_ = runs;
  counter_ = 0;
  restart();
}

inline AbortCode Sync::before_write(const Entry& entry, std::span<const std::uint8_t> value) {
  const std::uint32_t wanted = load_word(value);
  if (entry.index == cob_id_index) {
    if (!fits(CobId{entry.word()}, CobId{wanted})) return AbortCode::value_range;
    if (can_id_ == 0 && !node_.router().has_room_to_listen()) return AbortCode::out_of_memory;
  } else if (entry.index == overflow_index) {
    if (wanted == 1 || wanted > overflow_max) return AbortCode::value_range;
    if (period_ != 0 && wanted != overflow_) return AbortCode::device_state;
  }
  return AbortCode::none;
}

/// Bit 31 means nothing here. A producer keeps its CAN-ID.
inline bool Sync::fits(CobId present, CobId wanted) const {
  const bool stays_producer = (present.raw & wanted.raw & CobId::bit30) != 0;
  return has_free_id(wanted) && (!stays_producer || wanted.can_id() == present.can_id());
}

inline void Sync::after_write(const Entry&, Source) {
  const bool was_producer = is_producer_;
  const std::uint32_t period = period_;
  read_parameters();
  if (is_producer_ != was_producer) {
    counter_ = 0;
  } else if (period_ == period) {
    return;
  }
  restart();
}

void Sync::read_parameters() {
  const Dictionary& dictionary = node_.dictionary();
  const CobId cob_id{dictionary.word(cob_id_index, 0, can_id::sync)};
  period_ = dictionary.word(period_index);
  window_ = dictionary.word(window_index);
  overflow_ = static_cast<std::uint8_t>(dictionary.word(overflow_index));
  const std::uint32_t wanted = has_free_id(cob_id) ? cob_id.can_id() : 0;
  if (wanted != can_id_) {
    const auto can_id = static_cast<std::uint16_t>(wanted);
    const bool hears = node_.router().listen<&Sync::receive>(*this, can_id_, can_id);
    can_id_ = hears ? can_id : std::uint16_t{0};
  }
  is_producer_ = (cob_id.raw & CobId::bit30) != 0 && period_ != 0 && can_id_ != 0;
}

void Sync::restart() {
  node_.timers().disarm(timer_);
  set_lost(false);
  if (running_ && is_producer_) schedule(0);
}

/// The next SYNC, after one that comes `late` by that many microseconds. Those that nobody had time
/// for are left out.
void Sync::schedule(std::uint32_t late) {
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
  Frame frame;
  frame.id = can_id_;
  if (overflow_ != 0) {
    counter_ = counter_ >= overflow_ ? std::uint8_t{1} : static_cast<std::uint8_t>(counter_ + 1);
    frame.length = 1;
    frame.data[0] = counter_;
  }
  node_.transmitter().send(frame);
  announce(counter_);
}

inline bool Sync::hear(const Frame& frame) {
  const bool is_wanted = frame.id == can_id_ && !frame.is_remote() && can_id_ != 0;
  if (is_wanted) receive(frame, node_.now());
  return is_wanted;
}

inline void Sync::receive(const Frame& frame, Time) {
  if (!running_) return;
  const bool is_bad = frame.length != (overflow_ == 0 ? 0 : 1);
  if (is_bad != bad_length_) {
    bad_length_ = is_bad;
    node_.report(length_error, is_bad);
  }
  if (is_bad) return node_.count_malformed();
  set_lost(false);
  if (period_ != 0 && !is_producer_) {
    node_.timers().arm(timer_, node_.now() + Duration(period_) + Duration(period_ / 2));
  }
  announce(frame.length == 0 ? std::uint8_t{0} : frame.data[0]);
}

void Sync::announce(std::uint8_t counter) {
  received_at_ = node_.now();
  node_.tell_sync(SyncPhase::actuate, counter);
  for (SyncListener* listener = listeners_; listener != nullptr; listener = listener->next) {
    listener->received(counter);
  }
  node_.tell_sync(SyncPhase::sample, counter);
}

}  // namespace canvoy
