#include "canvoy/canopen/tpdo.hpp"

#include <algorithm>
#include <utility>

namespace canvoy {

namespace {

constexpr std::uint16_t parameter_first = 0x1800;
constexpr std::uint16_t mapping_first = 0x1A00;
constexpr unsigned watchers_max = 32;  ///< bits of ObjectState::watchers

constexpr std::uint16_t parameter_index(std::uint16_t number) {
  return static_cast<std::uint16_t>(parameter_first + number - 1);
}
constexpr std::uint16_t mapping_index(std::uint16_t number) {
  return static_cast<std::uint16_t>(mapping_first + number - 1);
}
std::uint32_t watcher_bit(std::uint16_t number) {
  return 1U << (number % watchers_max);
}

constexpr bool is_reserved_type(std::uint32_t type) {
  return type > transmission_type::cyclic_max && type < transmission_type::remote_synchronous;
}

/// Types that are sent because of an event, at once or at the next SYNC.
constexpr bool knows_events(std::uint8_t type) {
  return is_event_driven(type) || type == transmission_type::acyclic;
}

}  // namespace

void Tpdo::answer(const Frame&, Time) {
  owner_->answer(*this);
}

void Tpdo::inhibit_over(Time) {
  if (event_) owner_->transmit(*this);
}

/// The timer is not moved at each transmission, but looked at when it expires.
void Tpdo::event_timer_expired(Time now) {
  const Time due = sent_at_ + event_period_;
  if (due > now) return owner_->node_.timers().arm(event_timer_, due);
  owner_->node_.timers().arm(event_timer_, now + event_period_);
  owner_->occur(*this);
}

constexpr ServiceCalls Tpdos::service_calls = {.reset = method<&Tpdos::reset>,
                                               .state_entered = method<&Tpdos::state_entered>,
                                               .values_changed = method<&Tpdos::values_changed>,
                                               .tx_ready = method<&Tpdos::tx_ready>};
constexpr HookCalls Tpdos::hook_calls[] = {{.first = parameter_first,
                                            .last = parameter_index(pdo_count_max),
                                            .before_write = method<&Tpdos::before_parameter_write>,
                                            .after_write = method<&Tpdos::parameter_written>},
                                           {.first = mapping_first,
                                            .last = mapping_index(pdo_count_max),
                                            .before_write = method<&Tpdos::before_mapping_write>}};

Tpdos::Tpdos(Node& node, std::span<Tpdo> pdos, std::span<MappedValue> values, Sync* sync,
             AtStart at_start)
    : node_(node),
      pdos_(pdos.first(std::min<std::size_t>(pdos.size(), pdo_count_max))),
      sync_(sync),
      at_start_(at_start) {
  const std::size_t share = pdos_.empty() ? 0 : values.size() / pdos_.size();
  for (std::size_t i = 0; i < pdos_.size(); ++i) {
    pdos_[i].owner_ = this;
    pdos_[i].number_ = static_cast<std::uint16_t>(i + 1);
    pdos_[i].mapping_.use(values.subspan(i * share, share));
  }
  if (pdos_.empty()) return;
  node_.dictionary().attach(hooks_);
  node_.attach(service_);

  listener_.phase = SyncPhase::sample;
  listener_.received = Callback<void(std::uint8_t)>::to<&Tpdos::at_sync>(*this);
  if (sync != nullptr) sync->attach(listener_);
}

bool Tpdos::trigger(std::uint16_t number) {
  if (!operational_ || number == 0 || number > pdos_.size()) return false;
  Tpdo& pdo = (*this)[number];
  if (!pdo.is_active() || !knows_events(pdo.type_) || pdo.mode_ == MpdoMode::destination) {
    return false;
  }
  occur(pdo);
  return true;
}

bool Tpdos::is_ready(std::uint16_t number, MpdoMode mode) const {
  return operational_ && number != 0 && number <= pdos_.size() && pdos_[number - 1U].is_active() &&
         pdos_[number - 1U].mode_ == mode;
}

bool Tpdos::has_other(std::uint16_t number, MpdoMode mode) const {
  return std::ranges::any_of(
      pdos_, [&](const Tpdo& pdo) { return pdo.number_ != number && pdo.mode_ == mode; });
}

void Tpdos::restart_mpdos(MpdoMode mode) {
  for (Tpdo& pdo : pdos_) {
    if (pdo.mode_ == mode) restart(pdo);
  }
}

void Tpdos::reset(ResetScope) {
  if (has_source()) mpdos_.calls->event(mpdos_.source, 0, MpdoMode::none, MpdoEvent::reset);
  for (Tpdo& pdo : pdos_) load(pdo);
  node_.dictionary().unwatch(~0U);
  for (const Tpdo& pdo : pdos_) watch(pdo);
}

void Tpdos::state_entered(NmtState state) {
  operational_ = state == NmtState::operational;
  for (Tpdo& pdo : pdos_) {
    end(pdo);
    // What is sent at the beginning may end it: an answer of the application, a full bus.
    if (operational_) begin(pdo);
  }
}

void Tpdos::values_changed(std::uint32_t watchers) {
  for (unsigned bit = 0; watchers != 0 && operational_; ++bit, watchers >>= 1) {
    if ((watchers & 1) == 0) continue;
    for (std::size_t number = bit == 0 ? watchers_max : bit; number <= pdos_.size();
         number += watchers_max) {
      Tpdo& pdo = pdos_[number - 1];
      if (pdo.is_active() && knows_events(pdo.type_) && has_changed(pdo)) event(pdo);
    }
  }
}

/// The source of a multiplexed PDO finds out by itself what has changed.
bool Tpdos::has_changed(const Tpdo& pdo) const {
  if (pdo.mode_ == MpdoMode::none) return !pdo.event_ && pdo.mapping_.pack() != pdo.image_;
  tell_source(pdo, MpdoEvent::change);
  return true;
}

void Tpdos::tx_ready() {
  if (!any_waits_) return;
  any_waits_ = false;
  for (Tpdo& pdo : pdos_) {
    if (!pdo.waiting_) continue;
    pdo.waiting_ = false;
    if (pdo.type_ >= transmission_type::remote) {
      transmit(pdo);
    } else if (pdo.type_ == transmission_type::remote_synchronous || is_in_time()) {
      transmit_sample(pdo);
    } else {
      // Too late for this SYNC. What an acyclic one has to tell it tells at the next.
      pdo.event_ = true;
    }
  }
}

/// The synchronous window is open.
bool Tpdos::is_in_time() const {
  return sync_ == nullptr || sync_->is_window_open();
}

void Tpdos::at_sync(std::uint8_t counter) {
  if (!operational_) return;
  for (Tpdo& pdo : pdos_) {
    if (!pdo.is_active() || pdo.type_ > transmission_type::remote_synchronous) continue;
    if (pdo.type_ == transmission_type::remote_synchronous) {
      sample(pdo);
    } else if (is_turn(pdo, counter)) {
      pdo.event_ = false;
      sample(pdo);
      transmit_sample(pdo);
    }
  }
}

/// Counts the SYNC. The one that carries the SYNC start value is the first. An acyclic PDO needs an
/// event; what this SYNC brought to RPDOs is one that nobody has announced yet.
bool Tpdos::is_turn(Tpdo& pdo, std::uint8_t counter) {
  if (pdo.type_ == transmission_type::acyclic) {
    return pdo.event_ || pdo.mapping_.pack() != pdo.image_;
  }
  if (!pdo.counting_) {
    if (pdo.sync_start_ != 0 && counter != 0 && counter != pdo.sync_start_) return false;
    pdo.counting_ = true;
  }
  ++pdo.syncs_;
  if (pdo.syncs_ < pdo.type_) return false;
  pdo.syncs_ = 0;
  return true;
}

AbortCode Tpdos::before_parameter_write(const Entry& entry, std::span<const std::uint8_t> value) {
  if (!owns(entry)) return AbortCode::none;
  const Tpdo& pdo = at(entry);
  const auto wanted = static_cast<std::uint32_t>(load_unsigned(value));
  const bool changes_while_valid =
      pdo.cob_id_.valid() && wanted != static_cast<std::uint32_t>(load_unsigned(entry.bytes()));
  bool fits = true;
  switch (entry.sub) {
    case pdo_sub::cob_id:
      return check_cob_id(pdo, CobId{wanted});
    case pdo_sub::transmission_type:
      fits = !is_reserved_type(wanted);
      break;
    case pdo_sub::inhibit_time:
      fits = !changes_while_valid;
      break;
    case pdo_sub::sync_start:
      fits = !changes_while_valid && wanted <= transmission_type::cyclic_max;
      break;
    default:
      break;
  }
  return fits ? AbortCode::none : AbortCode::value_range;
}

AbortCode Tpdos::check_cob_id(const Tpdo& pdo, CobId wanted) const {
  const AbortCode answer = check_pdo_cob_id(pdo.cob_id_, wanted);
  if (answer != AbortCode::none) return answer;
  const bool needs_route = wanted.valid() && (wanted.raw & CobId::bit30) == 0 && pdo.route_ == 0;
  return needs_route && node_.router().full() ? AbortCode::out_of_memory : AbortCode::none;
}

void Tpdos::parameter_written(const Entry& entry, Source) {
  if (!owns(entry)) return;
  Tpdo& pdo = at(entry);
  const std::uint32_t before = pdo.cob_id_.raw;
  const std::uint8_t type_before = pdo.type_;
  read_parameters(pdo);
  switch (entry.sub) {
    case pdo_sub::cob_id:
      if (pdo.cob_id_.raw != before) restart(pdo);
      return;
    case pdo_sub::transmission_type:
      if (pdo.type_ != type_before) restart(pdo);
      return;
    case pdo_sub::event_timer:
      return start_event_timer(pdo);
    default:
      return;
  }
}

AbortCode Tpdos::before_mapping_write(const Entry& entry, std::span<const std::uint8_t> value) {
  if (!owns(entry)) return AbortCode::none;
  Tpdo& pdo = at(entry);
  return check_mapping_write(node_.dictionary(), entry, value,
                             {.direction = PdoDirection::transmit,
                              .valid = pdo.cob_id_.valid(),
                              .can_be_multiplexed = has_source()},
                             pdo.mapping_);
}

void Tpdos::load(Tpdo& pdo) {
  end(pdo);
  read_parameters(pdo);
  resolve(pdo);
}

void Tpdos::read_parameters(Tpdo& pdo) {
  const Dictionary& dictionary = node_.dictionary();
  const std::uint16_t index = parameter_index(pdo.number_);
  const auto read = [&](std::uint8_t sub, std::uint32_t absent) {
    return read_parameter(dictionary, index, sub, absent);
  };
  pdo.cob_id_.raw = read(pdo_sub::cob_id, CobId::bit31);
  pdo.type_ =
      static_cast<std::uint8_t>(read(pdo_sub::transmission_type, transmission_type::event_profile));
  pdo.inhibit_time_ =
      from_100_microseconds(static_cast<std::uint16_t>(read(pdo_sub::inhibit_time, 0)));
  pdo.event_period_ = from_milliseconds(static_cast<std::uint16_t>(read(pdo_sub::event_timer, 0)));
  pdo.sync_start_ = static_cast<std::uint8_t>(read(pdo_sub::sync_start, 0));
}

void Tpdos::resolve(Tpdo& pdo) {
  const std::uint16_t record = mapping_index(pdo.number_);
  const Dictionary& dictionary = node_.dictionary();
  const bool usable = is_usable(pdo.cob_id_) && !is_reserved_type(pdo.type_);
  const unsigned count = usable ? read_parameter(dictionary, record, 0, 0) : 0U;
  const bool may_be_multiplexed = has_source() && is_event_driven(pdo.type_);
  pdo.mode_ = may_be_multiplexed ? mpdo_mode(count) : MpdoMode::none;
  const bool is_mpdo = pdo.mode_ != MpdoMode::none;
  // Where the record cannot be mapped nothing is: a master may yet write a better one.
  static_cast<void>(pdo.mapping_.resolve(dictionary, record, count, PdoDirection::transmit));
  pdo.length_ = static_cast<std::uint8_t>(is_mpdo ? pdo_bytes_max : pdo.mapping_.bytes());
  const bool answers = pdo.is_active() && (pdo.cob_id_.raw & CobId::bit30) == 0 && !is_mpdo;
  listen(pdo, answers ? static_cast<std::uint16_t>(pdo.cob_id_.can_id()) : 0);
}

void Tpdos::listen(Tpdo& pdo, std::uint16_t can_id) {
  if (can_id == pdo.route_) return;
  Router& router = node_.router();
  const auto receiver = Router::Receiver::to<&Tpdo::answer>(pdo);
  if (pdo.route_ != 0) router.remove(pdo.route_, receiver, Router::Kind::remote);
  pdo.route_ = can_id != 0 && router.add(can_id, receiver, Router::Kind::remote) ? can_id : 0;
}

void Tpdos::restart(Tpdo& pdo) {
  end(pdo);
  resolve(pdo);
  node_.dictionary().unwatch(watcher_bit(pdo.number_));
  for (std::size_t i = (pdo.number_ - 1U) % watchers_max; i < pdos_.size(); i += watchers_max) {
    watch(pdos_[i]);
  }
  if (operational_) begin(pdo);
}

void Tpdos::watch(const Tpdo& pdo) {
  if (!pdo.is_active() || !knows_events(pdo.type_)) return;
  if (pdo.mode_ != MpdoMode::none)
    return mpdos_.calls->watch(mpdos_.source, pdo.mode_, watcher_bit(pdo.number_));
  for (const MappedValue& value : pdo.mapping_.values()) {
    node_.dictionary().watch(value.entry, watcher_bit(pdo.number_));
  }
}

void Tpdos::begin(Tpdo& pdo) {
  if (!pdo.is_active()) return;
  pdo.sent_at_ = node_.now();
  start_event_timer(pdo);
  if (!knows_events(pdo.type_)) return;
  if (at_start_ == AtStart::send) return occur(pdo);
  pdo.image_ = pdo.mapping_.pack();
  tell_source(pdo, MpdoEvent::begin);
}

void Tpdos::end(Tpdo& pdo) {
  node_.timers().disarm(pdo.inhibit_);
  node_.timers().disarm(pdo.event_timer_);
  tell_source(pdo, MpdoEvent::end);
  pdo.syncs_ = 0;
  pdo.sampled_ = pdo.sent_ = pdo.event_ = pdo.waiting_ = pdo.counting_ = false;
}

void Tpdos::start_event_timer(Tpdo& pdo) {
  const bool runs = operational_ && pdo.is_active() && is_event_driven(pdo.type_) &&
                    pdo.event_period_ != Duration::zero();
  node_.timers().arm(pdo.event_timer_, runs ? node_.now() + pdo.event_period_ : never);
}

void Tpdos::tell_source(const Tpdo& pdo, MpdoEvent event) const {
  if (pdo.mode_ == MpdoMode::none) return;
  mpdos_.calls->event(mpdos_.source, pdo.number_, pdo.mode_, event);
}

/// An event that is none of a value.
void Tpdos::occur(Tpdo& pdo) {
  tell_source(pdo, MpdoEvent::all);
  event(pdo);
}

void Tpdos::event(Tpdo& pdo) {
  if (pdo.type_ == transmission_type::acyclic) {
    pdo.event_ = true;
  } else if (!is_inhibited(pdo)) {
    transmit(pdo);
  }
}

/// If so, the event is kept until the inhibit time is over.
bool Tpdos::is_inhibited(Tpdo& pdo) {
  const Time allowed_at = pdo.sent_at_ + pdo.inhibit_time_;
  if (!pdo.sent_ || allowed_at <= node_.now()) return false;
  pdo.event_ = true;
  if (!pdo.inhibit_.armed()) node_.timers().arm(pdo.inhibit_, allowed_at);
  return true;
}

void Tpdos::answer(Tpdo& pdo) {
  if (!operational_) return;
  if (is_event_driven(pdo.type_)) return event(pdo);
  if (pdo.type_ == transmission_type::remote) return transmit(pdo);
  if (!pdo.sampled_) sample(pdo);
  transmit_sample(pdo);
}

void Tpdos::sample(Tpdo& pdo) {
  before_transmit(pdo.number_);
  Dictionary& dictionary = node_.dictionary();
  if (pdo.mapping_.revision() != dictionary.revision()) resolve(pdo);
  pdo.mapping_.refresh(dictionary);
  pdo.image_ = pdo.mapping_.pack();
  pdo.sampled_ = true;
}

/// Samples as late as can be: not before there is room for the frame.
void Tpdos::transmit(Tpdo& pdo) {
  pdo.event_ = false;
  if (node_.transmitter().crowded()) {
    pdo.waiting_ = any_waits_ = true;
    return;
  }
  if (pdo.mode_ != MpdoMode::none) {
    return mpdos_.calls->transmit(mpdos_.source, pdo.number_, pdo.mode_);
  }
  sample(pdo);
  transmit_sample(pdo);
}

bool Tpdos::may_send_mpdo(std::uint16_t number) {
  Tpdo& pdo = (*this)[number];
  if (is_inhibited(pdo)) return false;
  if (!node_.transmitter().crowded()) return true;
  pdo.waiting_ = any_waits_ = true;
  return false;
}

bool Tpdos::send_mpdo(std::uint16_t number, const PdoImage& image) {
  Tpdo& pdo = (*this)[number];
  pdo.image_ = image;
  transmit_sample(pdo);
  return !pdo.waiting_;
}

void Tpdos::transmit_sample(Tpdo& pdo) {
  pdo.waiting_ = false;
  Frame frame;
  frame.id = pdo.cob_id_.can_id();
  frame.length = pdo.length_;
  frame.data = pdo.image_;
  if (node_.transmitter().crowded()) {
    pdo.waiting_ = any_waits_ = true;
    return;
  }
  // Noted before it leaves: what answers it may come at once, and is inhibited by it or ends it.
  const Time sent_at = std::exchange(pdo.sent_at_, node_.now());
  const bool sent = std::exchange(pdo.sent_, true);
  if (node_.transmitter().send(frame)) return;
  pdo.sent_at_ = sent_at;
  pdo.sent_ = sent;
  pdo.waiting_ = any_waits_ = true;
}

}  // namespace canvoy
