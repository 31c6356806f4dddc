#include "canvoy/canopen/pdo/pdo.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

/// Assigns the data of hosts: places of mapped values, and the owner of each PDO.
void PdoService::share(std::span<MappedValue> values) {
  places_.value.values = values.data();
  places_.value.share =
      static_cast<std::uint16_t>(std::min<std::size_t>(values.size() / count_, pdo_values_max));
  MappedValue* next = values.data();
  for (Pdo& pdo : all()) {
    pdo.owner_.value = this;
    pdo.values_.value = next;
    next += places_.value.share;
  }
}

bool PdoService::works(std::uint16_t number) const {
  return operational_ && has(number) && pdos_[position_of(number)].is_active();
}

Pdo* PdoService::find(const Entry& entry) const {
  const unsigned position =
      position_of(static_cast<std::uint16_t>(entry.index % pdo_count_max + 1));
  return position < count_ ? &pdos_[position] : nullptr;
}

/// A small machine divides by the size of a PDO in one place only.
std::uint16_t PdoService::find_number(const Pdo& pdo) const {
  return static_cast<std::uint16_t>(&pdo - pdos_ + first_);
}

std::uint32_t PdoService::parameter(const Pdo& pdo, unsigned sub, std::uint32_t absent) const {
  const unsigned record =
      kind_.parameter_first + number_of(pdo) - 1U + sub / mapping * pdo_count_max;
  return node_.dictionary().word(static_cast<std::uint16_t>(record), static_cast<std::uint8_t>(sub),
                                 absent);
}

std::uint32_t PdoService::mapped(const Pdo& pdo, unsigned sub) const {
  node_.count_mapping_read();
  return parameter(pdo, mapping + sub, nothing);
}

AbortCode PdoService::check_write(const Entry& entry, std::uint32_t wanted) {
  Pdo* pdo = find(entry);
  if (pdo == nullptr) return AbortCode::none;
  const CobId cob_id{parameter(*pdo, pdo_sub::cob_id, CobId::bit31)};
  if (is_mapping(entry)) {
    return cob_id.valid() ? AbortCode::unsupported_access : check_mapping(*pdo, entry, wanted);
  }
  if (entry.sub == pdo_sub::cob_id) return check_cob_id(*pdo, cob_id, CobId{wanted});
  bool fits = true;
  if (entry.sub == pdo_sub::transmission_type) {
    // Without SYNC, a PDO that waits for it would never work.
    fits = !is_reserved_type(wanted) &&
           (sync_ != nullptr || wanted > transmission_type::remote_synchronous);
  } else if (!is_receive() &&
             (entry.sub == pdo_sub::inhibit_time || entry.sub == pdo_sub::sync_start)) {
    const bool is_start = entry.sub == pdo_sub::sync_start;
    fits = !(is_start && wanted > transmission_type::cyclic_max) &&
           (!cob_id.valid() || wanted == entry.word());
  }
  return fits ? AbortCode::none : AbortCode::value_range;
}

inline AbortCode PdoService::check_cob_id(const Pdo& pdo, CobId present, CobId wanted) const {
  const AbortCode answer = check_pdo_cob_id(present, wanted);
  if constexpr (!Pdo::has_routes) return answer;
  if (answer != AbortCode::none || pdo.routed_ || !wanted.valid()) return answer;
  const bool needs_route = is_receive() || (wanted.raw & CobId::bit30) == 0;
  return needs_route && node_.router().full() ? AbortCode::out_of_memory : AbortCode::none;
}

/// Checks a PDO that is not valid, in the order of CiA 301: sub-index 0 is zero while entries are
/// written.
inline AbortCode PdoService::check_mapping(Pdo& pdo, const Entry& entry, std::uint32_t wanted) {
  if (entry.sub == 0) {
    const bool is_mpdo =
        multiplexed_ != nullptr && multiplexed_(transmission_type::event_profile, wanted) != 0;
    return is_mpdo ? AbortCode::none : map(pdo, wanted);
  }
  if (mapped(pdo, 0) != 0) return AbortCode::unsupported_access;
  // Zero clears an entry, as masters do with unused ones.
  Entry object;
  return wanted == 0 ? AbortCode::none : find_mapped(wanted, object);
}

bool PdoService::reload(Pdo& pdo) {
  const CobId cob_id{parameter(pdo, pdo_sub::cob_id, CobId::bit31)};
  const auto type = static_cast<std::uint8_t>(
      parameter(pdo, pdo_sub::transmission_type, transmission_type::event_profile));
  if constexpr (Pdo::has_plans) {
    // What is switched off has no times: they are read when it is switched on.
    pdo.times_.value = {};
    if (is_usable(cob_id)) {
      pdo.times_.value.period = static_cast<std::uint16_t>(parameter(pdo, pdo_sub::event_timer, 0));
      pdo.times_.value.inhibit =
          static_cast<std::uint16_t>(parameter(pdo, pdo_sub::inhibit_time, 0));
    }
  }
  std::uint16_t can_id = 0;
  unsigned count = 0;
  if (is_usable(cob_id) && !is_reserved_type(type)) {
    can_id = static_cast<std::uint16_t>(cob_id.can_id());
    count = mapped(pdo, 0);
  }
  const bool is_other = type != pdo.type_ || can_id != pdo.can_id_;
  pdo.type_ = type;
  // If the record cannot be mapped nothing is mapped: a master may write a better one later.
  static_cast<void>(map(pdo, count));
  pdo.length_ = static_cast<std::uint8_t>((pdo.bits_ + 7U) / 8);
  check_invariant(pdo.length_ <= pdo_bytes_max && (pdo.length_ == 0 || can_id != 0));
  bool is_routed = is_receive() || (cob_id.raw & CobId::bit30) == 0;
  pdo.mode_ = (multiplexed_ == nullptr ? 0 : multiplexed_(type, count)) & Pdo::mode_mask;
  if (pdo.mode_ != 0) {
    pdo.length_ = pdo_bytes_max;
    is_routed = is_receive();
  }
  if (!is_small_machine && !is_receive()) {
    choose(pdo, pdo.is_active() && type <= transmission_type::remote_synchronous);
  }
  route(pdo, can_id, is_routed && pdo.is_active());
  return is_other;
}

void PdoService::load(Pdo& pdo) {
  const CobId cob_id{parameter(pdo, pdo_sub::cob_id, CobId::bit31)};
  pdo.type_ = static_cast<std::uint8_t>(
      parameter(pdo, pdo_sub::transmission_type, transmission_type::event_profile));
  unsigned bits = 0;
  for (unsigned i = cob_id.valid() ? mapped(pdo, 0) : 0; i != 0; --i) bits += mapped(pdo, i) % 256;
  // Valid by default; the device may have written another value.
  if (bits > pdo_bytes_max * 8) bits = 0;
  pdo.bits_ = static_cast<std::uint8_t>(bits);
  pdo.length_ = static_cast<std::uint8_t>((bits + 7) / 8);
  pdo.can_id_ = static_cast<std::uint16_t>(cob_id.raw);
  listen(pdo, pdo.is_active() && (is_receive() || (cob_id.raw & CobId::bit30) == 0));
}

inline void PdoService::listen(Pdo& pdo, bool wanted) {
  if (wanted || pdo.routed_) node_.router().filter(pdo.can_id_, wanted);
  pdo.routed_ = wanted;
}

unsigned PdoService::mode_bits(std::uint8_t type, unsigned count) {
  const bool is_mpdo = is_event_driven(type) && mpdo_mode(count) != MpdoMode::none;
  return is_mpdo ? count & Pdo::mode_mask : 0;
}

/// RPDOs receive their frames, TPDOs remote frames that request them.
inline void PdoService::route(Pdo& pdo, std::uint16_t can_id, bool wanted) {
  Router& router = node_.router();
  const bool stays = wanted && can_id == pdo.can_id_;
  const std::uint16_t previous = pdo.can_id_;
  pdo.can_id_ = can_id;
  if (!is_small_machine && can_id != previous) node_.transmitter().drop(previous);
  if constexpr (!Pdo::has_routes) {
    const bool was_routed = pdo.routed_;
    pdo.routed_ = wanted;
    if (was_routed) router.filter(previous, listens(previous));
    if (wanted) router.filter(can_id, true);
    return;
  }
  const Router::Receiver receiver(kind_.route, &pdo);
  const auto kind = is_receive() ? Router::Kind::data : Router::Kind::remote;
  if (pdo.routed_ && !stays) {
    router.remove(previous, receiver, kind);
    pdo.routed_ = false;
  }
  if (wanted && !pdo.routed_) pdo.routed_ = router.add(can_id, receiver, kind);
}

inline bool PdoService::listens(std::uint16_t can_id) const {
  return std::ranges::any_of(all(),
                             [&](const Pdo& pdo) { return pdo.routed_ && pdo.can_id_ == can_id; });
}

bool PdoService::takes(const Pdo& pdo, ServiceEvent& event) const {
  const Frame& frame = event.frame();
  if (!pdo.routed_ || pdo.can_id_ != frame.id || frame.is_remote() == is_receive()) return false;
  event.want();
  return true;
}

void PdoService::notify_each(ServiceEvent& event) {
  // The scope of a reset is not such a state.
  if (event.kind <= ServiceEvent::state_entered) {
    operational_ = event.state() == NmtState::operational;
  }
  for (Pdo& pdo : all()) kind_.on_event(*this, pdo, event);
}

void PdoService::on_constant_event(NodeService& service, ServiceEvent& event) {
  PdoService& self = static_cast<PdoService&>(service);
  if (event.kind == ServiceEvent::reset) {
    for (Pdo& pdo : self.all()) self.listen(pdo, false);
    for (Pdo& pdo : self.all()) self.load(pdo);
  }
  self.notify_each(event);
}

void PdoService::expire(void* service, Time) {
  ServiceEvent event{.kind = ServiceEvent::timer_expired};
  static_cast<PdoService*>(service)->notify_each(event);
}

std::uint32_t PdoService::period_of(const Pdo& pdo) const {
  return (Pdo::has_plans ? pdo.times_.value.period : parameter(pdo, pdo_sub::event_timer, 0)) *
         1000U;
}

std::uint32_t PdoService::inhibit_time_of(const Pdo& pdo) const {
  return (Pdo::has_plans ? pdo.times_.value.inhibit : parameter(pdo, pdo_sub::inhibit_time, 0)) *
         100U;
}

std::uint32_t PdoService::time_left(const Pdo& pdo, std::uint32_t limit) const {
  const std::uint32_t over = ticks() - pdo.since_;
  return over < limit ? limit - over : 0;
}

void PdoService::wake_in(std::uint32_t microseconds) {
  node_.timers().arm_earlier(timer_, microseconds);
}

}  // namespace canvoy
