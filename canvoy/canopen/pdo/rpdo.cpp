#include "canvoy/canopen/pdo/rpdo.hpp"

#include <iterator>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

namespace {

constexpr std::uint8_t low_byte(std::uint16_t code) {
  return static_cast<std::uint8_t>(code);
}

/// There may be hundreds of RPDOs, and most events concern none of them.
[[maybe_unused]] constexpr bool concerns_rpdos(ServiceEvent::Kind kind) {
  return kind == ServiceEvent::reset || kind == ServiceEvent::state_entered;
}

}  // namespace

constexpr PdoKind Rpdos::kind = {
    .direction = PdoDirection::receive,
    .mappable = Access::rpdo,
    .parameter_first = object_index::rpdo_parameter,
    .route = Pdo::has_routes ? &Rpdos::receive_routed : nullptr,
    .on_event = &Rpdos::on_event,
};

void Rpdos::on_event(NodeService& service, ServiceEvent& event) {
  Rpdos& self = static_cast<Rpdos&>(service);
  if (event.kind == ServiceEvent::before_write) {
    return event.refuse(self.check_write(event.entry(), load_word(event.value())));
  }
  if (event.kind == ServiceEvent::after_write) return self.parameter_written(event.entry());
  if constexpr (!is_small_machine) {
    if (event.kind == ServiceEvent::actuate) {
      return self.for_chosen([&](Rpdo& pdo) {
        self.choose(pdo, false);
        on_event(self, pdo, event);
      });
    }
    if (!concerns_rpdos(event.kind)) return;
  }
  self.notify_each(event);
  if (event.kind == ServiceEvent::reset) self.reload_all();
}

void Rpdos::on_event(PdoService& service, Rpdo& pdo, ServiceEvent& event) {
  Rpdos& self = static_cast<Rpdos&>(service);
  switch (event.kind) {
    case ServiceEvent::reset:
      // The emergency producer ends communication errors by itself.
      pdo.syncs_or_faults_ = 0;
      [[fallthrough]];
    case ServiceEvent::state_entered:
      if (self.operational_) return;
      if constexpr (!is_small_machine) self.node_.transmitter().drop(pdo.can_id_);  // a request
      return rest(pdo);
    case ServiceEvent::actuate:
      if (!pdo.holds_) return;
      pdo.holds_ = false;
      return self.take(pdo, pdo.image_);
    case ServiceEvent::timer_expired:
      return self.look_at_deadline(pdo);
    case ServiceEvent::frame_came:
      if (self.takes(pdo, event)) self.take_any(pdo, event.frame());
      return;
    default:
      return;
  }
}

/// A host takes a frame at once if the PDO is quick: operational, without a time to start, of a
/// type that is taken when it comes, without a fault; take_any() records it.
void Rpdos::receive_routed(void* context, const Frame& frame, Time now) {
  if constexpr (!Pdo::has_routes) return;
  Rpdo& pdo = *static_cast<Rpdo*>(context);
  Rpdos& self = static_cast<Rpdos&>(*pdo.owner_.value);
  if (!pdo.quick_ || frame.length != pdo.length_ ||
      self.places_.value.revision != self.node_.dictionary().revision()) [[unlikely]] {
    return self.take_any(pdo, frame);
  }
  pdo.since_ = low_ticks(now);
  if (pdo.deeds_.value != 0) return self.take_at_once(pdo, frame.data);
  self.copy(pdo, frame.data);
  if (self.received) self.received(self.number_of(pdo));
}

[[gnu::noinline]] void Rpdos::refuse(Rpdo& pdo, std::uint32_t object) {
  raise(pdo, refused, object);
}

void Rpdos::take_any(Rpdo& pdo, const Frame& frame) {
  if (!operational_) return;
  if (frame.length != pdo.length_ || pdo.syncs_or_faults_ != 0) {
    if (!is_long_enough(pdo, frame.length)) return;
  }
  pdo.since_ = ticks();
  if (!pdo.supervised_) {
    const std::uint32_t period = period_of(pdo);
    pdo.supervised_ = period != 0;
    if (period != 0) wake_in(period);
  }
  if (is_synchronous(pdo.type_)) {
    if (sync_ == nullptr || !sync_->is_window_open()) return;
    pdo.image_ = frame.data;
    pdo.holds_ = true;
    if constexpr (!is_small_machine) choose(pdo, true);
    return;
  }
  renew(pdo);
  if constexpr (Pdo::has_plans) pdo.quick_ = pdo.syncs_or_faults_ == 0 && pdo.mode_ == 0;
  take(pdo, frame.data);
}

/// Raises and clears the faults of a received PDO for its length and its arrival. An error may end
/// NMT state operational (1029h), and with it the reception.
inline bool Rpdos::is_long_enough(Rpdo& pdo, std::uint8_t length) {
  if (length < pdo.length_) {
    settle(pdo, too_long);
    raise(pdo, too_short);
    return false;
  }
  settle(pdo, too_short | late);
  report(pdo, too_long, length > pdo.length_ ? present : 0U);
  return operational_ && pdo.is_active();
}

bool Rpdos::request(std::uint16_t number) {
  if (!works(number)) return false;
  const Rpdo& pdo = (*this)[number];
  const CobId cob_id{parameter(pdo, pdo_sub::cob_id, 0)};
  if ((cob_id.raw & CobId::bit30) != 0) return false;
  return node_.transmitter().send(Frame::remote_frame(pdo.can_id_, pdo.length_));
}

/// Deadlines are not moved at each reception, but checked when the first one would be reached.
inline void Rpdos::look_at_deadline(Rpdo& pdo) {
  if (!pdo.supervised_) return;
  const std::uint32_t left = time_left(pdo, period_of(pdo));
  if (left != 0) return wake_in(left);
  pdo.supervised_ = false;
  raise(pdo, late);
  timed_out(number_of(pdo));
}

inline void Rpdos::parameter_written(const Entry& entry) {
  Rpdo* pdo = find(entry);
  if (pdo == nullptr || is_mapping(entry)) return;
  // A PDO with a reserved type by default starts to work with a valid type.
  if (reload(*pdo)) pdo->holds_ = false;
  if (entry.sub == pdo_sub::event_timer) change_deadline(*pdo);
  if (pdo->is_active()) return;
  rest(*pdo);
  settle(*pdo, pdo->syncs_or_faults_);
}

void Rpdos::rest(Rpdo& pdo) {
  pdo.supervised_ = pdo.holds_ = false;
  if constexpr (Pdo::has_plans) pdo.quick_ = false;
}

inline void Rpdos::change_deadline(Rpdo& pdo) {
  const std::uint32_t period = period_of(pdo);
  if (period == 0) {
    pdo.supervised_ = false;
    settle(pdo, late);
  }
  if (!pdo.supervised_) return;
  pdo.since_ = ticks();
  wake_in(period);
}

void Rpdos::take_mpdo(const Rpdos& self, const Rpdo& pdo, const std::uint8_t* data) {
  (*self.mpdo_receiver_)(self.number_of(pdo), pdo.mode(), data);
}

void Rpdos::take(Rpdo& pdo, PdoImage image) {
  if (pdo.mode_ != 0) return take_mpdo_(*this, pdo, image.data());
  renew(pdo);
  const std::uint32_t object = unpack(pdo, image, Step::check);
  if (object != 0) return raise(pdo, refused, object);
  settle(pdo, refused);
  unpack(pdo, image, Step::write);
  unpack(pdo, image, Step::announce);
  received(number_of(pdo));
}

void Rpdos::finish(std::uint16_t number, const MpdoAnswer& answer) {
  Rpdo& pdo = (*this)[number];
  const std::uint32_t object = static_cast<std::uint32_t>(answer.index) << 16 | unsigned{answer.sub}
                                                                                    << 8;
  switch (answer.outcome) {
    case MpdoAnswer::ignored:
      return;
    case MpdoAnswer::missing:
      return raise(pdo, missing, object);
    case MpdoAnswer::refused:
      return raise(pdo, refused, object);
    case MpdoAnswer::taken:
      settle(pdo, missing | refused);
      received(number);
  }
}

/// Reports faults that appear or disappear. The manufacturer-specific field of the emergency
/// contains the PDO and the object that was refused or is missing.
inline void Rpdos::report(Rpdo& pdo, unsigned faults, std::uint32_t object) {
  const bool come = object != 0;
  const unsigned changed = faults & (come ? ~pdo.syncs_or_faults_ : pdo.syncs_or_faults_);
  if (changed == 0) return;
  pdo.syncs_or_faults_ = static_cast<std::uint8_t>(pdo.syncs_or_faults_ ^ changed);
  if constexpr (Pdo::has_plans) pdo.quick_ = false;
  // Their bits are in the order of these codes, which have the same upper byte.
  static constexpr std::uint8_t codes[] = {
      low_byte(emergency_code::pdo_too_short), low_byte(emergency_code::pdo_too_long),
      low_byte(emergency_code::protocol), low_byte(emergency_code::mpdo_destination),
      low_byte(emergency_code::rpdo_time_out)};
  Error error{.instance = number_of(pdo), .register_bits = error_register::communication};
  if (come && (changed & (refused | missing)) != 0) {
    error.info = {static_cast<std::uint8_t>(error.instance),
                  static_cast<std::uint8_t>(error.instance >> 8),
                  static_cast<std::uint8_t>(object >> 16), static_cast<std::uint8_t>(object >> 24),
                  static_cast<std::uint8_t>(object >> 8)};
  }
  for (unsigned fault = 0; fault < std::size(codes); ++fault) {
    if ((changed >> fault & 1) == 0) continue;
    error.code = static_cast<std::uint16_t>(emergency_code::protocol | codes[fault]);
    node_.report(error, come);
  }
}

}  // namespace canvoy
