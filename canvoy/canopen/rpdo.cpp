#include "canvoy/canopen/rpdo.hpp"

#include <algorithm>

namespace canvoy {

namespace {

constexpr std::uint16_t parameter_first = 0x1400;
constexpr std::uint16_t mapping_first = 0x1600;

constexpr std::uint16_t parameter_index(std::uint16_t number) {
  return static_cast<std::uint16_t>(parameter_first + number - 1);
}
constexpr std::uint16_t mapping_index(std::uint16_t number) {
  return static_cast<std::uint16_t>(mapping_first + number - 1);
}

constexpr bool is_reserved_type(std::uint32_t type) {
  return type > transmission_type::cyclic_max && type < transmission_type::event_manufacturer;
}

}  // namespace

void Rpdo::receive(const Frame& frame, Time now) {
  const bool simple = simple_ && frame.length == length_ &&
                      mapping_.revision() == owner_->node_.dictionary().revision();
  if (!simple) return owner_->take_any(*this, frame);
  received_at_ = now;
  mapping_.copy(frame.data.data());
  received(number_);
}

/// The deadline is not moved at each reception, but looked at when it is reached.
void Rpdo::expire(Time now) {
  const Time due = received_at_ + period_;
  if (due > now) return owner_->node_.timers().arm(deadline_, due);
  owner_->raise(*this, late);
  timed_out(number_);
}

constexpr ServiceCalls Rpdos::service_calls = {.reset = method<&Rpdos::reset>,
                                               .state_entered = method<&Rpdos::state_entered>};
constexpr HookCalls Rpdos::hook_calls[] = {{.first = parameter_first,
                                            .last = parameter_index(pdo_count_max),
                                            .before_write = method<&Rpdos::before_parameter_write>,
                                            .after_write = method<&Rpdos::parameter_written>},
                                           {.first = mapping_first,
                                            .last = mapping_index(pdo_count_max),
                                            .before_write = method<&Rpdos::before_mapping_write>}};

Rpdos::Rpdos(Node& node, std::span<Rpdo> pdos, std::span<MappedValue> values, Sync* sync)
    : node_(node),
      pdos_(pdos.first(std::min<std::size_t>(pdos.size(), pdo_count_max))),
      sync_(sync) {
  const std::size_t share = pdos_.empty() ? 0 : values.size() / pdos_.size();
  for (std::size_t i = 0; i < pdos_.size(); ++i) {
    pdos_[i].owner_ = this;
    pdos_[i].number_ = static_cast<std::uint16_t>(i + 1);
    pdos_[i].mapping_.use(values.subspan(i * share, share));
  }
  if (pdos_.empty()) return;
  node_.dictionary().attach(hooks_);
  node_.attach(service_);

  listener_.phase = SyncPhase::actuate;
  listener_.received = Callback<void(std::uint8_t)>::to<&Rpdos::at_sync>(*this);
  if (sync_ != nullptr) sync_->attach(listener_);
}

/// The way of those PDOs that need more than a copy. It leaves a note where the next one may take
/// the short way: operational, taken at once, of the right length and without a fault, supervised
/// already, and simply mapped.
void Rpdos::take_any(Rpdo& pdo, const Frame& frame) {
  if (!operational_) return;
  if (frame.length != pdo.length_ || pdo.faults_ != 0) {
    if (!is_long_enough(pdo, frame.length)) return;
  }
  pdo.received_at_ = node_.now();
  if (pdo.period_ != Duration::zero() && !pdo.deadline_.armed()) {
    node_.timers().arm(pdo.deadline_, node_.now() + pdo.period_);
  }
  if (is_synchronous(pdo.type_)) {
    if (sync_ == nullptr || !sync_->is_window_open()) return;
    pdo.held_ = frame.data;
    pdo.holds_ = true;
    return;
  }
  pdo.simple_ = pdo.faults_ == 0 && pdo.mapping_.is_simple();
  take(pdo, frame.data.data());
}

/// Raises and clears what the length of a received PDO and its coming at all mean. An error may end
/// NMT state operational (1029h), and with it the reception.
bool Rpdos::is_long_enough(Rpdo& pdo, std::uint8_t length) {
  if (length < pdo.length_) {
    settle(pdo, Rpdo::too_long);
    raise(pdo, Rpdo::too_short);
    return false;
  }
  settle(pdo, Rpdo::too_short | Rpdo::late);
  if (length > pdo.length_) {
    raise(pdo, Rpdo::too_long);
  } else {
    settle(pdo, Rpdo::too_long);
  }
  return operational_ && pdo.is_active();
}

bool Rpdos::request(std::uint16_t number) {
  if (!operational_ || number == 0 || number > pdos_.size()) return false;
  const Rpdo& pdo = (*this)[number];
  if (!pdo.is_active() || (pdo.cob_id_.raw & CobId::bit30) != 0) return false;
  return node_.transmitter().send(Frame::remote_frame(pdo.cob_id_.can_id(), pdo.length_));
}

void Rpdos::reset(ResetScope) {
  for (Rpdo& pdo : pdos_) {
    // The emergency producer forgets errors of communication by itself.
    pdo.faults_ = 0;
    rest(pdo);
    load(pdo);
  }
}

void Rpdos::state_entered(NmtState state) {
  operational_ = state == NmtState::operational;
  if (operational_) return;
  for (Rpdo& pdo : pdos_) rest(pdo);
}

void Rpdos::at_sync(std::uint8_t) {
  if (!operational_) return;
  for (Rpdo& pdo : pdos_) {
    if (!pdo.holds_) continue;
    pdo.holds_ = false;
    take(pdo, pdo.held_.data());
  }
}

AbortCode Rpdos::before_parameter_write(const Entry& entry, std::span<const std::uint8_t> value) {
  if (!owns(entry)) return AbortCode::none;
  const auto wanted = static_cast<std::uint32_t>(load_unsigned(value));
  if (entry.sub == pdo_sub::cob_id) {
    const Rpdo& pdo = at(entry);
    const AbortCode answer = check_pdo_cob_id(pdo.cob_id_, CobId{wanted});
    if (answer != AbortCode::none) return answer;
    const bool needs_route = CobId{wanted}.valid() && pdo.route_ == 0;
    return needs_route && node_.router().full() ? AbortCode::out_of_memory : AbortCode::none;
  }
  if (entry.sub == pdo_sub::transmission_type && is_reserved_type(wanted)) {
    return AbortCode::value_range;
  }
  return AbortCode::none;
}

void Rpdos::parameter_written(const Entry& entry, Source) {
  if (!owns(entry)) return;
  Rpdo& pdo = at(entry);
  const auto written = static_cast<std::uint32_t>(load_unsigned(entry.bytes()));
  switch (entry.sub) {
    case pdo_sub::cob_id:
      pdo.cob_id_.raw = written;
      resolve(pdo);
      if (pdo.is_active()) return;
      rest(pdo);
      return settle(pdo, pdo.faults_);
    case pdo_sub::transmission_type:
      pdo.type_ = static_cast<std::uint8_t>(written);
      pdo.holds_ = false;
      // A PDO whose type by default is a reserved one begins to work with a better type.
      return resolve(pdo);
    case pdo_sub::event_timer:
      return change_deadline(pdo, from_milliseconds(static_cast<std::uint16_t>(written)));
    default:
      return;
  }
}

AbortCode Rpdos::before_mapping_write(const Entry& entry, std::span<const std::uint8_t> value) {
  if (!owns(entry)) return AbortCode::none;
  Rpdo& pdo = at(entry);
  return check_mapping_write(node_.dictionary(), entry, value,
                             {.direction = PdoDirection::receive,
                              .valid = pdo.cob_id_.valid(),
                              .can_be_multiplexed = static_cast<bool>(mpdo_receiver_)},
                             pdo.mapping_);
}

void Rpdos::load(Rpdo& pdo) {
  const Dictionary& dictionary = node_.dictionary();
  const std::uint16_t index = parameter_index(pdo.number_);
  pdo.cob_id_.raw = read_parameter(dictionary, index, pdo_sub::cob_id, CobId::bit31);
  pdo.type_ = static_cast<std::uint8_t>(read_parameter(
      dictionary, index, pdo_sub::transmission_type, transmission_type::event_profile));
  pdo.period_ = from_milliseconds(
      static_cast<std::uint16_t>(read_parameter(dictionary, index, pdo_sub::event_timer, 0)));
  resolve(pdo);
}

void Rpdos::resolve(Rpdo& pdo) {
  const std::uint16_t record = mapping_index(pdo.number_);
  const Dictionary& dictionary = node_.dictionary();
  const bool usable = is_usable(pdo.cob_id_) && !is_reserved_type(pdo.type_);
  const unsigned count = usable ? read_parameter(dictionary, record, 0, 0) : 0U;
  const bool may_be_multiplexed = mpdo_receiver_ && is_event_driven(pdo.type_);
  pdo.mode_ = may_be_multiplexed ? mpdo_mode(count) : MpdoMode::none;
  // Where the record cannot be mapped nothing is: a master may yet write a better one.
  static_cast<void>(pdo.mapping_.resolve(dictionary, record, count, PdoDirection::receive));
  pdo.length_ =
      static_cast<std::uint8_t>(pdo.mode_ == MpdoMode::none ? pdo.mapping_.bytes() : pdo_bytes_max);
  pdo.simple_ = false;
  listen(pdo, pdo.is_active() ? static_cast<std::uint16_t>(pdo.cob_id_.can_id()) : 0);
}

void Rpdos::listen(Rpdo& pdo, std::uint16_t can_id) {
  if (can_id == pdo.route_) return;
  const auto receiver = Router::Receiver::to<&Rpdo::receive>(pdo);
  if (pdo.route_ != 0) node_.router().remove(pdo.route_, receiver);
  pdo.route_ = can_id != 0 && node_.router().add(can_id, receiver) ? can_id : 0;
}

void Rpdos::rest(Rpdo& pdo) {
  node_.timers().disarm(pdo.deadline_);
  pdo.holds_ = pdo.simple_ = false;
}

void Rpdos::change_deadline(Rpdo& pdo, Duration period) {
  const bool supervised = pdo.is_supervised();
  pdo.period_ = period;
  pdo.simple_ = false;
  if (period == Duration::zero()) {
    node_.timers().disarm(pdo.deadline_);
    return settle(pdo, Rpdo::late);
  }
  if (!supervised) return;
  node_.timers().arm(pdo.deadline_, node_.now() + period);
}

void Rpdos::take(Rpdo& pdo, const std::uint8_t* data) {
  if (pdo.mode_ != MpdoMode::none) return mpdo_receiver_(pdo.number_, pdo.mode_, data);
  Dictionary& dictionary = node_.dictionary();
  if (pdo.mapping_.revision() != dictionary.revision()) [[unlikely]] {
    resolve(pdo);
    if (!pdo.is_active()) return;
  }
  if (!pdo.mapping_.is_unchecked()) {
    const MappedValue* refused = pdo.mapping_.find_refused(dictionary, data);
    if (refused != nullptr) {
      return raise_about(pdo, Rpdo::refused, refused->entry.index, refused->entry.sub);
    }
  }
  if ((pdo.faults_ & Rpdo::refused) != 0) settle(pdo, Rpdo::refused);
  pdo.mapping_.write(dictionary, data);
  if (pdo.received) pdo.received(pdo.number_);
}

void Rpdos::finish(std::uint16_t number, const MpdoAnswer& answer) {
  Rpdo& pdo = (*this)[number];
  switch (answer.outcome) {
    case MpdoAnswer::ignored:
      return;
    case MpdoAnswer::missing:
      return raise_about(pdo, Rpdo::missing, answer.index, answer.sub);
    case MpdoAnswer::refused:
      return raise_about(pdo, Rpdo::refused, answer.index, answer.sub);
    case MpdoAnswer::taken:
      settle(pdo, Rpdo::missing | Rpdo::refused);
      pdo.received(pdo.number_);
  }
}

/// Names the PDO and the object in the manufacturer-specific field of the emergency.
void Rpdos::raise_about(Rpdo& pdo, Rpdo::Fault fault, std::uint16_t index, std::uint8_t sub) {
  const auto low = [](std::uint16_t number) { return static_cast<std::uint8_t>(number); };
  const auto high = [](std::uint16_t number) { return static_cast<std::uint8_t>(number >> 8); };
  raise(pdo, fault, {low(pdo.number_), high(pdo.number_), low(index), high(index), sub});
}

std::uint16_t Rpdos::code_of(unsigned fault) {
  switch (fault) {
    case Rpdo::too_short:
      return emergency_code::pdo_too_short;
    case Rpdo::too_long:
      return emergency_code::pdo_too_long;
    case Rpdo::refused:
      return emergency_code::protocol;
    case Rpdo::missing:
      return emergency_code::mpdo_destination;
    default:
      return emergency_code::rpdo_time_out;
  }
}

void Rpdos::raise(Rpdo& pdo, Rpdo::Fault fault, const std::array<std::uint8_t, 5>& info) {
  if ((pdo.faults_ & fault) != 0) return;
  pdo.faults_ |= fault;
  pdo.simple_ = false;
  node_.raise({.code = code_of(fault),
               .instance = pdo.number_,
               .register_bits = error_register::communication,
               .info = info});
}

void Rpdos::settle(Rpdo& pdo, unsigned faults) {
  const unsigned gone = pdo.faults_ & faults;
  pdo.faults_ = static_cast<std::uint8_t>(pdo.faults_ & ~gone);
  for (const unsigned fault :
       {Rpdo::too_short, Rpdo::too_long, Rpdo::refused, Rpdo::late, Rpdo::missing}) {
    if ((gone & fault) == 0) continue;
    node_.clear({.code = code_of(fault),
                 .instance = pdo.number_,
                 .register_bits = error_register::communication});
  }
}

}  // namespace canvoy
