#include "canvoy/canopen/pdo.hpp"

#include <algorithm>

namespace canvoy {

PdoService::PdoService(Node& node, const PdoKind& kind, std::span<Pdo> pdos,
                       std::span<MappedValue> values, Sync* sync)
    : node_(node),
      kind_(kind),
      pdos_(pdos.first(std::min<std::size_t>(pdos.size(), pdo_count_max))),
      values_(values.data()),
      sync_(sync),
      timer_(Callback<void(Time)>(kind.expired, this)),
      service_{&kind.service, this} {
  if (pdos_.empty()) return;
  share_ = static_cast<std::uint16_t>(
      std::min<std::size_t>(values.size() / pdos_.size(), pdo_values_max));
  for (Pdo& pdo : pdos_) pdo.owner_ = this;
  node_.attach(service_);
  if (sync == nullptr) return;
  listener_.phase = kind.phase;
  listener_.received = Callback<void(std::uint8_t)>(kind.at_sync, this);
  sync->attach(listener_);
}

bool PdoService::works(std::uint16_t number) const {
  return operational_ && number - 1U < pdos_.size() && pdos_[number - 1U].is_active();
}

Pdo* PdoService::find(const Entry& entry) const {
  const unsigned position = entry.index % pdo_count_max;
  return position < pdos_.size() ? &pdos_[position] : nullptr;
}

std::uint32_t PdoService::parameter(const Pdo& pdo, std::uint8_t sub, std::uint32_t absent) const {
  return read_parameter(node_.dictionary(), parameter_index(pdo), sub, absent);
}

std::uint32_t PdoService::mapped(const Pdo& pdo, unsigned sub) const {
  const auto record = static_cast<std::uint16_t>(parameter_index(pdo) + pdo_count_max);
  return read_parameter(node_.dictionary(), record, static_cast<std::uint8_t>(sub), nothing);
}

AbortCode PdoService::before_write(const Entry& entry, std::span<const std::uint8_t> value) {
  Pdo* pdo = find(entry);
  if (pdo == nullptr) return AbortCode::none;
  const std::uint32_t wanted = load_number(value);
  const CobId cob_id{parameter(*pdo, pdo_sub::cob_id, CobId::bit31)};
  if (is_mapping(entry)) {
    return cob_id.valid() ? AbortCode::unsupported_access : check_mapping(*pdo, entry, wanted);
  }
  if (entry.sub == pdo_sub::cob_id) return check_cob_id(*pdo, cob_id, CobId{wanted});
  bool fits = true;
  if (entry.sub == pdo_sub::transmission_type) {
    fits = !is_reserved_type(wanted);
  } else if (!is_receive() &&
             (entry.sub == pdo_sub::inhibit_time || entry.sub == pdo_sub::sync_start)) {
    fits = !cob_id.valid() || wanted == load_number(entry.bytes());
    if (entry.sub == pdo_sub::sync_start) fits = fits && wanted <= transmission_type::cyclic_max;
  }
  return fits ? AbortCode::none : AbortCode::value_range;
}

AbortCode PdoService::check_cob_id(const Pdo& pdo, CobId present, CobId wanted) const {
  const AbortCode answer = check_pdo_cob_id(present, wanted);
  if (answer != AbortCode::none || pdo.routed_ || !wanted.valid()) return answer;
  const bool needs_route = is_receive() || (wanted.raw & CobId::bit30) == 0;
  return needs_route && node_.router().full() ? AbortCode::out_of_memory : AbortCode::none;
}

/// Of a PDO that is not valid, in the order that CiA 301 prescribes: sub-index 0 is zero while
/// entries are written.
AbortCode PdoService::check_mapping(Pdo& pdo, const Entry& entry, std::uint32_t wanted) {
  if (entry.sub == 0) {
    const bool is_mpdo = multiplexed_ && mpdo_mode(wanted) != MpdoMode::none;
    return is_mpdo ? AbortCode::none : map(pdo, wanted);
  }
  if (mapped(pdo, 0) != 0) return AbortCode::unsupported_access;
  // Zero empties an entry, as masters do with those that they do not use.
  Entry object;
  return wanted == 0 ? AbortCode::none : find_mapped(wanted, object);
}

bool PdoService::reload(Pdo& pdo) {
  const CobId cob_id{parameter(pdo, pdo_sub::cob_id, CobId::bit31)};
  const auto type = static_cast<std::uint8_t>(
      parameter(pdo, pdo_sub::transmission_type, transmission_type::event_profile));
  pdo.period_ = static_cast<std::uint16_t>(parameter(pdo, pdo_sub::event_timer, 0));
  pdo.inhibit_ = static_cast<std::uint16_t>(parameter(pdo, pdo_sub::inhibit_time, 0));
  std::uint16_t can_id = 0;
  unsigned count = 0;
  if (is_usable(cob_id) && !is_reserved_type(type)) {
    can_id = static_cast<std::uint16_t>(cob_id.can_id());
    count = mapped(pdo, 0);
  }
  const bool is_other = type != pdo.type_ || can_id != pdo.can_id_;
  pdo.type_ = type;
  // Where the record cannot be mapped nothing is: a master may yet write a better one.
  static_cast<void>(map(pdo, count));
  pdo.length_ = static_cast<std::uint8_t>((pdo.bits_ + 7U) / 8);
  bool is_routed = is_receive() || (cob_id.raw & CobId::bit30) == 0;
  pdo.mode_ = 0;
  if (multiplexed_ && is_event_driven(type) && mpdo_mode(count) != MpdoMode::none) {
    pdo.mode_ = count & Pdo::mode_mask;
    pdo.length_ = pdo_bytes_max;
    is_routed = is_receive();
  }
  route(pdo, can_id, is_routed && pdo.is_active());
  return is_other;
}

/// RPDOs get their frames, TPDOs the remote frames that ask for them.
void PdoService::route(Pdo& pdo, std::uint16_t can_id, bool wanted) {
  Router& router = node_.router();
  const Router::Receiver receiver(kind_.frame, &pdo);
  const auto kind = is_receive() ? Router::Kind::data : Router::Kind::remote;
  if (pdo.routed_ && !(wanted && can_id == pdo.can_id_)) {
    router.remove(pdo.can_id_, receiver, kind);
    pdo.routed_ = false;
  }
  pdo.can_id_ = can_id;
  if (wanted && !pdo.routed_) pdo.routed_ = router.add(can_id, receiver, kind);
}

std::uint32_t PdoService::time_left(const Pdo& pdo, std::uint32_t limit) const {
  const std::uint32_t over = ticks() - pdo.since_;
  return over < limit ? limit - over : 0;
}

void PdoService::wake_in(std::uint32_t microseconds) {
  const Time at = node_.now() + Duration(microseconds);
  if (at < timer_.at()) node_.timers().arm(timer_, at);
}

}  // namespace canvoy
