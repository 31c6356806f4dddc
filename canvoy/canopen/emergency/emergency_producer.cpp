#include "canvoy/canopen/emergency/emergency_producer.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "canvoy/can/array_insert.hpp"
#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

namespace {

constexpr Error passive_error{.code = emergency_code::error_passive,
                              .register_bits = error_register::communication};
constexpr Error recovery{.code = emergency_code::bus_off_recovered,
                         .register_bits = error_register::communication};
constexpr Error overrun_error{.code = emergency_code::can_overrun,
                              .register_bits = error_register::communication};

/// Emergency for an error: if the device adds nothing, it has the instance.
Emergency emergency_of(const Error& error, unsigned register_bits) {
  Emergency emergency{error.code, static_cast<std::uint8_t>(register_bits), error.info};
  unsigned given = 0;
  for (const std::uint8_t byte : error.info) given |= byte;
  if (given == 0) store(emergency.info.data(), error.instance);
  return emergency;
}

}  // namespace

/// Handles writes of masters to 1014h and 1015h.
void EmergencyProducer::on_event(NodeService& service, ServiceEvent& event) {
  EmergencyProducer& self = static_cast<EmergencyProducer&>(service);
  if (!event.is_access() || event.entry().index == object_index::error_history) {
    return on_constant_event(service, event);
  }
  if (event.kind == ServiceEvent::before_write &&
      event.entry().index == object_index::cob_id_emergency) {
    event.refuse(check_emergency_cob_id(self.cob_id(), {load_word(event.value())}));
  } else if (event.kind == ServiceEvent::after_write &&
             event.entry().index >= object_index::cob_id_emergency) {
    self.cob_id_or_inhibit_time_written();
  }
}

void EmergencyProducer::on_constant_event(NodeService& service, ServiceEvent& event) {
  EmergencyProducer& self = static_cast<EmergencyProducer&>(service);
  switch (event.kind) {
    case ServiceEvent::reset:
      return self.reset(event.scope());
    case ServiceEvent::state_entered:
    case ServiceEvent::tx_ready:
      return self.flush();
    case ServiceEvent::bus_state_changed:
    case ServiceEvent::bus_recovered:
      return self.bus_state_changed(event.bus_state());
    case ServiceEvent::error_came:
      return self.come(event.error());
    case ServiceEvent::error_went:
      return self.go(event.error());
    case ServiceEvent::before_read:
      if (self.is_empty(event.entry())) event.refuse(AbortCode::no_data);
      return;
    case ServiceEvent::before_write:
      // The history can be cleared.
      if (event.entry().sub != 0 || load_word(event.value()) != 0) {
        event.refuse(AbortCode::value_range);
      }
      return;
    case ServiceEvent::after_write:
      return self.clear_history();
    default:
      return;
  }
}

void EmergencyProducer::expire(void* producer, Time) {
  static_cast<EmergencyProducer*>(producer)->flush();
}

inline void EmergencyProducer::reset(ResetScope scope) {
  node_.timers().disarm(timer_);
  node_.timers().disarm(overrun_timer_);
  waiting_count_ = 0;
  sent_at_ = Time::min();
  // An error of the device itself survives a reset of its communication, and is sent again.
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

inline void EmergencyProducer::bus_state_changed(BusState state) {
  const BusState previous = std::exchange(bus_state_, state);
  if (previous == BusState::bus_off) node_.raise(recovery);
  if (state != BusState::bus_off) {
    node_.report(passive_error, state == BusState::error_passive);
  }
  if (previous == BusState::bus_off) node_.clear(recovery);
  flush();
}

void EmergencyProducer::end_overrun(void* producer, Time) {
  static_cast<EmergencyProducer*>(producer)->node_.clear(overrun_error);
}

void EmergencyProducer::come(const Error& error) {
  if (error.code == emergency_code::no_error) return;
  if (error.code == emergency_code::can_overrun) {
    node_.timers().arm_in(overrun_timer_, static_cast<std::uint32_t>(overrun_time.count()));
  }
  if (find(error) != nullptr) return;
  if (present_count_ < present_max_) present_[present_count_++] = error;
  update_register();
  const unsigned bits = register_ | error.register_bits | error_register::generic;
  const Emergency emergency = emergency_of(error, bits);
  keep_in_history(emergency);
  notify(emergency);
}

inline void EmergencyProducer::go(const Error& error) {
  Error* gone = find(error);
  if (gone == nullptr) return;
  take_out(present_, present_count_--, static_cast<std::size_t>(gone - present_));
  update_register();
  notify({emergency_code::no_error, register_, {}});
}

Error* EmergencyProducer::find(const Error& error) const {
  for (Error& candidate : std::span(present_, present_count_)) {
    if (candidate.code == error.code && candidate.instance == error.instance) return &candidate;
  }
  return nullptr;
}

void EmergencyProducer::update_register() {
  unsigned bits = 0;
  for (const Error& error : present()) bits |= error.register_bits | error_register::generic;
  register_ = static_cast<std::uint8_t>(bits);
  node_.dictionary().set_word(object_index::error_register, register_);
}

/// The newest is at sub-index 1, and moves the others: consecutive numbers. Each has the code and
/// the first two bytes of the manufacturer-specific field.
inline void EmergencyProducer::keep_in_history(const Emergency& emergency) {
  Dictionary& dictionary = node_.dictionary();
  Entry newest{.index = object_index::error_history, .sub = 1};
  if (dictionary.locate(newest) != AbortCode::none) return;
  const auto count = std::min<std::uint32_t>(dictionary.word(object_index::error_history) + 1,
                                             newest.row->sub_last);
  constexpr std::size_t size = 4;
  for (std::size_t i = size * count; i-- > size;) newest.value[i] = newest.value[i - size];
  store(newest.value, emergency.code);
  newest.value[2] = emergency.info[0];
  newest.value[3] = emergency.info[1];
  dictionary.set_word(object_index::error_history, count);
}

inline bool EmergencyProducer::is_empty(const Entry& entry) const {
  return entry.sub > node_.dictionary().word(object_index::error_history);
}

inline void EmergencyProducer::cob_id_or_inhibit_time_written() {
  if (!cob_id().valid()) waiting_count_ = 0;
  flush();
}

inline void EmergencyProducer::clear_history() {
  Entry newest{.index = object_index::error_history, .sub = 1};
  if (node_.dictionary().locate(newest) != AbortCode::none) return;
  std::memset(newest.value, 0, std::size_t{4} * newest.row->sub_last);
}

void EmergencyProducer::notify(const Emergency& emergency) {
  if (waiting_max_ == 0 || !cob_id().valid()) return;
  if (waiting_count_ == waiting_max_) make_room();
  waiting_[waiting_count_++] = emergency;
  flush();
}

/// Drops the oldest message that only reports the end of an error, since a later one has a later
/// register; if there is none, the newest, since its error is in the history.
inline void EmergencyProducer::make_room() {
  ++coalesced_;
  std::size_t position = 0;
  while (position + 1 < waiting_count_ && waiting_[position].code != emergency_code::no_error) {
    ++position;
  }
  drop_waiting(position);
}

void EmergencyProducer::drop_waiting(std::size_t position) {
  check_invariant(position < waiting_count_ && waiting_count_ <= waiting_max_);
  take_out(waiting_, waiting_count_--, position);
}

void EmergencyProducer::flush() {
  node_.timers().disarm(timer_);
  while (waiting_count_ > 0 && may_send() && send_next()) {
  }
}

/// False if it must wait, for the inhibit time or for room in the controller.
[[gnu::always_inline]] inline bool EmergencyProducer::send_next() {
  const auto units =
      static_cast<std::uint16_t>(node_.dictionary().word(object_index::emergency_inhibit_time));
  const std::uint32_t inhibit_time = units * std::uint32_t{100};
  const std::uint32_t elapsed = node_.elapsed_since(sent_at_);
  if (elapsed < inhibit_time) {
    node_.timers().arm_in(timer_, inhibit_time - elapsed);
    return false;
  }
  if (node_.transmitter().full()) return false;
  // Removed before it leaves: an answer to it may raise another error at once.
  const Emergency next = waiting_[0];
  drop_waiting(0);
  sent_at_ = node_.now();
  return node_.transmitter().send(
      static_cast<std::uint16_t>(cob_id().can_id()),
      {reinterpret_cast<const std::uint8_t*>(&next), Emergency::length});
}

inline bool EmergencyProducer::may_send() const {
  return has_services(node_.state()) && bus_state_ != BusState::bus_off && cob_id().valid();
}

CobId EmergencyProducer::cob_id() const {
  const CobId cob_id{node_.dictionary().word(object_index::cob_id_emergency)};
  return cob_id.raw != 0 && cob_id.is_base_frame() ? cob_id : CobId{};
}

}  // namespace canvoy
