#include "canvoy/canopen/sync/time_stamp.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

namespace {

constexpr Duration since_day_0(const TimeOfDay& time) {
  return std::chrono::days(time.days) + std::chrono::milliseconds(time.milliseconds);
}

}  // namespace

constexpr AccessHandlers TimeStamp::hook_calls = {.first = object_index::cob_id_time,
                                                  .last = object_index::cob_id_time,
                                                  .before_write = method<&TimeStamp::before_write>,
                                                  .after_write = method<&TimeStamp::after_write>};
constexpr ServiceHandlers TimeStamp::service_calls = {
    .reset = method<&TimeStamp::reset>,
    .state_entered = method<&TimeStamp::state_entered>,
    .tx_ready = method<&TimeStamp::tx_ready>,
    .hooks = {&hook_calls, 1}};

TimeStamp::TimeStamp(Node& node) : node_(node), timer_(callback<&TimeStamp::expired>(*this)) {
  node_.attach(service_);
}

// Parameters

void TimeStamp::reset(ResetScope) {
  read_parameter();
  listen();
}

void TimeStamp::state_entered(NmtState state) {
  const bool runs = state == NmtState::pre_operational || state == NmtState::operational;
  if (runs == running_) return;
  running_ = runs;
  restart();
}

AbortCode TimeStamp::before_write(const Entry&, std::span<const std::uint8_t> value) {
  const CobId wanted{static_cast<std::uint32_t>(load_unsigned(value))};
  if (!wanted.is_base_frame() || is_restricted(wanted.can_id())) return AbortCode::value_range;
  const bool stays_producer = (cob_id_.raw & wanted.raw & CobId::bit30) != 0;
  if (stays_producer && wanted.can_id() != cob_id_.can_id()) return AbortCode::value_range;
  const bool needs_route = (wanted.raw & CobId::bit31) != 0 && can_id_ == 0;
  return needs_route && node_.router().full() ? AbortCode::out_of_memory : AbortCode::none;
}

void TimeStamp::after_write(const Entry&, Source) {
  const bool produced = is_producer();
  read_parameter();
  listen();
  if (is_producer() != produced) restart();
}

void TimeStamp::read_parameter() {
  cob_id_.raw = static_cast<std::uint32_t>(node_.dictionary().number(object_index::cob_id_time, 0));
}

bool TimeStamp::usable() const {
  return cob_id_.is_base_frame() && !is_restricted(cob_id_.can_id());
}

void TimeStamp::listen() {
  const bool consumes = (cob_id_.raw & CobId::bit31) != 0 && usable();
  const auto wanted = consumes ? static_cast<std::uint16_t>(cob_id_.can_id()) : std::uint16_t{0};
  if (wanted == can_id_) return;
  const auto receiver = Router::Receiver::to<&TimeStamp::receive>(*this);
  if (can_id_ != 0) node_.router().remove(can_id_, receiver);
  can_id_ = wanted != 0 && node_.router().add(wanted, receiver) ? wanted : std::uint16_t{0};
}

// The clock

bool TimeStamp::set_clock(const TimeOfDay& time) {
  if (!time.valid()) return false;
  midnight_ = node_.now().time_since_epoch() - since_day_0(time);
  has_clock_ = true;
  return true;
}

std::optional<TimeOfDay> TimeStamp::clock(Time at) const {
  if (!has_clock_) return {};
  const Duration elapsed = at.time_since_epoch() - midnight_;
  return to_time_of_day(time_of_day_epoch + std::chrono::floor<std::chrono::milliseconds>(elapsed));
}

void TimeStamp::receive(const Frame& frame, Time now) {
  if (!running_) return;
  if (frame.length != time_of_day_bytes) return node_.count_malformed();
  const auto time = decode_time<TimeOfDay>(std::span(frame.data).first<time_of_day_bytes>());
  if (!time.valid()) return node_.count_malformed();
  const Duration shown = now.time_since_epoch() - midnight_;
  const Duration correction = has_clock_ ? since_day_0(time) - shown : Duration::zero();
  set_clock(time);
  heard_(time, correction);
}

// The producer

void TimeStamp::produce_each(Duration period) {
  period_ = period > Duration::zero() ? period : Duration::zero();
  restart();
}

void TimeStamp::restart() {
  waits_ = false;
  node_.timers().disarm(timer_);
  if (running_ && is_producer() && period_ != Duration::zero()) schedule(node_.now());
}

/// Schedules the TIME after one that was due at `previous`. Missed ones are skipped.
void TimeStamp::schedule(Time previous) {
  due_ = previous + period_;
  if (due_ <= node_.now()) due_ += ((node_.now() - due_) / period_ + 1) * period_;
  node_.timers().arm(timer_, due_);
}

void TimeStamp::expired(Time) {
  schedule(due_);
  send();
}

bool TimeStamp::send() {
  if (!running_ || !is_producer()) return false;
  const std::optional<TimeOfDay> time = clock(node_.now());
  if (!time) return false;
  // In a backlog the time would become outdated: it is read again when there is room.
  waits_ = !node_.transmitter().idle();
  if (!waits_) {
    node_.transmitter().send(Frame::data_frame(cob_id_.can_id(), encode_time(*time)));
  }
  return true;
}

void TimeStamp::tx_ready() {
  if (waits_ && node_.transmitter().idle()) send();
}

}  // namespace canvoy
