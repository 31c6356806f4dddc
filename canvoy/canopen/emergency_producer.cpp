#include "canvoy/canopen/emergency_producer.hpp"

#include <algorithm>

namespace canvoy {

namespace {

constexpr std::uint16_t error_register_object = 0x1001;
constexpr std::uint16_t history_object = 0x1003;
constexpr std::uint16_t cob_id_object = 0x1014;
constexpr std::uint16_t inhibit_object = 0x1015;

constexpr Error passive_error{.code = emergency_code::error_passive,
                              .register_bits = error_register::communication};
constexpr Error recovery{.code = emergency_code::bus_off_recovered,
                         .register_bits = error_register::communication};
constexpr Error overrun_error{.code = emergency_code::can_overrun,
                              .register_bits = error_register::communication};

/// What tells the one who reads which error of its kind it is.
std::array<std::uint8_t, 5> info_of(const Error& error) {
  const bool given = std::ranges::any_of(error.info, [](std::uint8_t byte) { return byte != 0; });
  if (given) return error.info;
  return {static_cast<std::uint8_t>(error.instance), static_cast<std::uint8_t>(error.instance >> 8),
          0, 0, 0};
}

}  // namespace

constexpr ServiceCalls EmergencyProducer::service_calls = {
    .reset = method<&EmergencyProducer::reset>,
    .state_entered = method<&EmergencyProducer::state_entered>,
    .bus_state_changed = method<&EmergencyProducer::bus_state_changed>,
    .error_changed = method<&EmergencyProducer::error_changed>,
    .tx_ready = method<&EmergencyProducer::tx_ready>};
constexpr HookCalls EmergencyProducer::hook_calls[] = {
    {.first = history_object,
     .last = history_object,
     .before_read = method<&EmergencyProducer::before_history_read>,
     .before_write = method<&EmergencyProducer::before_history_write>,
     .after_write = method<&EmergencyProducer::history_written>},
    {.first = cob_id_object,
     .last = inhibit_object,
     .before_write = method<&EmergencyProducer::before_parameter_write>,
     .after_write = method<&EmergencyProducer::parameter_written>}};

EmergencyProducer::EmergencyProducer(Node& node, std::span<Error> present,
                                     std::span<Emergency> waiting)
    : node_(node),
      present_(present),
      waiting_(waiting),
      inhibit_(Callback<void(Time)>::to<&EmergencyProducer::flush>(*this)),
      overrun_(Callback<void(Time)>::to<&EmergencyProducer::end_overrun>(*this)) {
  node_.attach(service_);
  node_.dictionary().attach(hooks_);
}

void EmergencyProducer::reset(ResetScope scope) {
  node_.timers().disarm(inhibit_);
  node_.timers().disarm(overrun_);
  waiting_count_ = 0;
  sent_at_ = Time::min();
  // What is wrong with the device itself outlives a reset of its communication, and is told anew.
  const std::size_t before = scope == ResetScope::node ? 0 : present_count_;
  present_count_ = 0;
  for (std::size_t i = 0; i < before; ++i) {
    const Error error = present_[i];
    if ((error.register_bits & error_register::communication) == 0) come(error);
  }
  update_register();
  bus_state_ = node_.bus_state();
  if (bus_state_ == BusState::error_passive) come(passive_error);
}

void EmergencyProducer::state_entered(NmtState) {
  flush(node_.now());
}

void EmergencyProducer::bus_state_changed(BusState state) {
  const BusState previous = std::exchange(bus_state_, state);
  if (previous == BusState::bus_off) node_.raise(recovery);
  if (state == BusState::error_passive) node_.raise(passive_error);
  if (state == BusState::error_active) node_.clear(passive_error);
  if (previous == BusState::bus_off) node_.clear(recovery);
  flush(node_.now());
}

void EmergencyProducer::error_changed(const Error& error, bool present) {
  if (error.code == emergency_code::no_error) return;
  if (!present) return go(error);
  come(error);
  if (error.code == emergency_code::can_overrun) {
    node_.timers().arm(overrun_, node_.now() + overrun_time);
  }
}

void EmergencyProducer::end_overrun(Time) {
  node_.clear(overrun_error);
}

void EmergencyProducer::come(const Error& error) {
  if (find(error) != nullptr) return;
  if (present_count_ < present_.size()) present_[present_count_++] = error;
  update_register();
  keep_in_history(error);
  const unsigned bits = register_ | error.register_bits | error_register::generic;
  tell({error.code, static_cast<std::uint8_t>(bits), info_of(error)});
}

void EmergencyProducer::go(const Error& error) {
  Error* gone = find(error);
  if (gone == nullptr) return;
  std::move(gone + 1, present_.data() + present_count_, gone);
  --present_count_;
  update_register();
  tell({emergency_code::no_error, register_, {}});
}

Error* EmergencyProducer::find(const Error& error) const {
  for (Error& candidate : present_.first(present_count_)) {
    if (candidate.code == error.code && candidate.instance == error.instance) return &candidate;
  }
  return nullptr;
}

void EmergencyProducer::update_register() {
  unsigned bits = 0;
  for (const Error& error : present()) bits |= error.register_bits | error_register::generic;
  register_ = static_cast<std::uint8_t>(bits);
  node_.dictionary().set_number(error_register_object, 0, register_);
}

/// How many errors 1003h has room for.
unsigned EmergencyProducer::history_depth() const {
  unsigned depth = 0;
  while (depth < 254 &&
         node_.dictionary().find(history_object, static_cast<std::uint8_t>(depth + 1))) {
    ++depth;
  }
  return depth;
}

/// The newest stands at sub-index 1, and pushes the others on.
void EmergencyProducer::keep_in_history(const Error& error) {
  Dictionary& dictionary = node_.dictionary();
  const auto count =
      std::min<std::uint64_t>(dictionary.number(history_object, 0) + 1, history_depth());
  if (count == 0) return;
  for (auto sub = static_cast<std::uint8_t>(count); sub > 1; --sub) {
    const auto previous = static_cast<std::uint8_t>(sub - 1);
    dictionary.set_number(history_object, sub, dictionary.number(history_object, previous));
  }
  const auto info = info_of(error);
  const std::uint32_t detail = info[0] | static_cast<std::uint32_t>(info[1] << 8);
  dictionary.set_number(history_object, 1, error.code | detail << 16);
  dictionary.set_number(history_object, 0, count);
}

AbortCode EmergencyProducer::before_history_read(const Entry& entry) {
  const bool empty = entry.sub > node_.dictionary().number(history_object, 0);
  return empty ? AbortCode::no_data : AbortCode::none;
}

AbortCode EmergencyProducer::before_history_write(const Entry& entry,
                                                  std::span<const std::uint8_t> value) {
  const bool clears = entry.sub == 0 && load_unsigned(value) == 0;
  return clears ? AbortCode::none : AbortCode::value_range;
}

void EmergencyProducer::history_written(const Entry&, Source) {
  for (unsigned sub = history_depth(); sub > 0; --sub) {
    node_.dictionary().set_number(history_object, static_cast<std::uint8_t>(sub), 0);
  }
}

AbortCode EmergencyProducer::before_parameter_write(const Entry& entry,
                                                    std::span<const std::uint8_t> value) {
  if (entry.index != cob_id_object) return AbortCode::none;
  return check_emergency_cob_id(cob_id(), {static_cast<std::uint32_t>(load_unsigned(value))});
}

void EmergencyProducer::parameter_written(const Entry&, Source) {
  if (!cob_id().valid()) waiting_count_ = 0;
  flush(node_.now());
}

void EmergencyProducer::tell(const Emergency& emergency) {
  if (waiting_.empty() || !cob_id().valid()) return;
  if (waiting_count_ == waiting_.size()) make_room();
  waiting_at(waiting_count_++) = emergency;
  flush(node_.now());
}

/// Forgets the oldest message that says no more than that an error is gone, since a later one tells
/// a later register; where there is none the newest, of which the error stands in the history.
void EmergencyProducer::make_room() {
  ++coalesced_;
  --waiting_count_;
  std::size_t position = 0;
  while (position < waiting_count_ && waiting_at(position).code != emergency_code::no_error) {
    ++position;
  }
  for (; position < waiting_count_; ++position) waiting_at(position) = waiting_at(position + 1);
}

void EmergencyProducer::flush(Time now) {
  node_.timers().disarm(inhibit_);
  const Duration inhibit = from_100_microseconds(
      static_cast<std::uint16_t>(node_.dictionary().number(inhibit_object, 0)));
  while (waiting_count_ > 0 && may_send()) {
    if (now < sent_at_ + inhibit) return node_.timers().arm(inhibit_, sent_at_ + inhibit);
    if (node_.transmitter().full()) return;  // until tx_ready
    if (!node_.transmitter().send(encode(waiting_at(0), cob_id().can_id()))) return;
    waiting_first_ = place(waiting_first_ + 1);
    --waiting_count_;
    sent_at_ = now;
  }
}

bool EmergencyProducer::may_send() const {
  const bool state_allows =
      node_.state() == NmtState::pre_operational || node_.state() == NmtState::operational;
  return state_allows && bus_state_ != BusState::bus_off && cob_id().valid();
}

CobId EmergencyProducer::cob_id() const {
  const Result<Entry> entry = node_.dictionary().find(cob_id_object, 0);
  if (!entry) return {};
  const CobId cob_id{static_cast<std::uint32_t>(load_unsigned(entry->bytes()))};
  return cob_id.is_base_frame() ? cob_id : CobId{};
}

}  // namespace canvoy
