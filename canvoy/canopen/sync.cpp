#include "canvoy/canopen/sync.hpp"

#include "canvoy/canopen/pdo_parameter.hpp"

namespace canvoy {

namespace {

constexpr std::uint16_t cob_id_index = 0x1005;
constexpr std::uint16_t period_index = 0x1006;
constexpr std::uint16_t window_index = 0x1007;
constexpr std::uint16_t overflow_index = 0x1019;
constexpr std::uint32_t overflow_max = 240;

constexpr Error length_error{.code = emergency_code::sync_length,
                             .register_bits = error_register::communication};

}  // namespace

constexpr ServiceCalls Sync::service_calls = {.reset = method<&Sync::reset>,
                                              .state_entered = method<&Sync::state_entered>};
constexpr HookCalls Sync::hook_calls[] = {{.first = cob_id_index,
                                           .last = window_index,
                                           .before_write = method<&Sync::before_write>,
                                           .after_write = method<&Sync::after_write>},
                                          {.first = overflow_index,
                                           .last = overflow_index,
                                           .before_write = method<&Sync::before_write>,
                                           .after_write = method<&Sync::after_write>}};

Sync::Sync(Node& node) : node_(node), timer_(Callback<void(Time)>::to<&Sync::expire>(*this)) {
  node_.dictionary().attach(hooks_);
  node_.attach(service_);
}

void Sync::reset(ResetScope) {
  bad_length_ = false;
  read_parameters();
  listen();
}

void Sync::state_entered(NmtState state) {
  const bool runs = state == NmtState::pre_operational || state == NmtState::operational;
  if (runs == running_) return;
  running_ = runs;
  restart();
}

AbortCode Sync::before_write(const Entry& entry, std::span<const std::uint8_t> value) {
  const auto wanted = static_cast<std::uint32_t>(load_unsigned(value));
  if (entry.index == cob_id_index) return check_cob_id(CobId{wanted});
  if (entry.index == overflow_index) return check_overflow(wanted);
  return AbortCode::none;
}

/// Bit 31 means nothing here.
AbortCode Sync::check_cob_id(CobId wanted) const {
  const std::uint32_t can_id = wanted.can_id();
  if (!wanted.is_base_frame() || is_restricted(can_id)) return AbortCode::value_range;
  const bool stays_producer = (cob_id_.raw & wanted.raw & CobId::bit30) != 0;
  if (stays_producer && can_id != cob_id_.can_id()) return AbortCode::value_range;
  return can_id_ == 0 && node_.router().full() ? AbortCode::out_of_memory : AbortCode::none;
}

AbortCode Sync::check_overflow(std::uint32_t wanted) const {
  if (wanted == 1 || wanted > overflow_max) return AbortCode::value_range;
  return period_ != Duration::zero() && wanted != overflow_ ? AbortCode::device_state
                                                            : AbortCode::none;
}

void Sync::after_write(const Entry&, Source) {
  const bool produced = is_producer();
  const Duration period = period_;
  read_parameters();
  listen();
  if (is_producer() != produced) return restart();
  if (period_ == period) return;
  if (produced) return schedule(node_.now());
  node_.timers().disarm(timer_);
  set_lost(false);
}

void Sync::read_parameters() {
  const Dictionary& dictionary = node_.dictionary();
  cob_id_.raw = read_parameter(dictionary, cob_id_index, 0, can_id::sync);
  period_ = std::chrono::microseconds(read_parameter(dictionary, period_index, 0, 0));
  window_ = std::chrono::microseconds(read_parameter(dictionary, window_index, 0, 0));
  overflow_ = static_cast<std::uint8_t>(read_parameter(dictionary, overflow_index, 0, 0));
}

void Sync::listen() {
  const bool usable = cob_id_.is_base_frame() && !is_restricted(cob_id_.can_id());
  const auto wanted = usable ? static_cast<std::uint16_t>(cob_id_.can_id()) : std::uint16_t{0};
  if (wanted == can_id_) return;
  const auto receiver = Router::Receiver::to<&Sync::receive>(*this);
  if (can_id_ != 0) node_.router().remove(can_id_, receiver);
  can_id_ = wanted != 0 && node_.router().add(wanted, receiver) ? wanted : std::uint16_t{0};
}

bool Sync::is_producer() const {
  return (cob_id_.raw & CobId::bit30) != 0 && period_ != Duration::zero() && can_id_ != 0;
}

void Sync::restart() {
  counter_ = 0;
  node_.timers().disarm(timer_);
  set_lost(false);
  if (running_ && is_producer()) schedule(node_.now());
}

/// The SYNC after one that was due at `previous`. Those that nobody had time for are left out.
void Sync::schedule(Time previous) {
  due_ = previous + period_;
  const Duration late = node_.now() - due_;
  if (late >= Duration::zero()) {
    // What was missed is not made up for. In 32 bits, and so an hour late the beat begins anew.
    const bool is_too_late = late.count() > UINT32_MAX;
    const std::uint32_t beyond = is_too_late ? 0
                                             : static_cast<std::uint32_t>(late.count()) %
                                                   static_cast<std::uint32_t>(period_.count());
    due_ = node_.now() + period_ - Duration(beyond);
  }
  node_.timers().arm(timer_, due_);
}

void Sync::expire(Time) {
  if (is_producer()) return produce();
  set_lost(true);
}

void Sync::set_lost(bool lost) {
  if (lost == lost_) return;
  lost_ = lost;
  lost_changed(lost);
}

void Sync::produce() {
  schedule(due_);
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

void Sync::receive(const Frame& frame, Time) {
  if (!running_) return;
  const bool good_length = frame.length == (overflow_ == 0 ? 0 : 1);
  if (good_length == bad_length_) {
    bad_length_ = !good_length;
    if (bad_length_) {
      node_.raise(length_error);
    } else {
      node_.clear(length_error);
    }
  }
  if (!good_length) return node_.count_malformed();
  set_lost(false);
  if (period_ != Duration::zero() && !is_producer()) {
    node_.timers().arm(timer_, node_.now() + period_ + period_ / 2);
  }
  announce(frame.length == 0 ? std::uint8_t{0} : frame.data[0]);
}

void Sync::announce(std::uint8_t counter) {
  received_at_ = node_.now();
  for (SyncListener* listener = listeners_; listener != nullptr; listener = listener->next) {
    listener->received(counter);
  }
}

}  // namespace canvoy
