#include "canvoy/canopen/pdo/tpdo.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

namespace {

constexpr unsigned watchers_max = 32;  ///< bits of ObjectState::watchers

/// True for types that are sent because of an event, at once or at the next SYNC.
constexpr bool knows_events(std::uint8_t type) {
  return is_event_driven(type) || type == transmission_type::acyclic;
}

/// There may be hundreds of TPDOs, and many events concern none of them.
[[maybe_unused]] constexpr bool concerns_tpdos(ServiceEvent::Kind kind) {
  return kind == ServiceEvent::reset || kind == ServiceEvent::state_entered ||
         kind == ServiceEvent::values_changed || kind == ServiceEvent::tx_ready ||
         kind == ServiceEvent::bus_recovered || kind == ServiceEvent::value_set;
}

}  // namespace

constexpr PdoKind Tpdos::kind = {
    .direction = PdoDirection::transmit,
    .mappable = Access::tpdo,
    .parameter_first = object_index::tpdo_parameter,
    .route = Pdo::has_routes ? &Tpdos::answer_routed : nullptr,
    .on_event = &Tpdos::on_event,
};

void Tpdos::on_event(NodeService& service, ServiceEvent& event) {
  Tpdos& self = static_cast<Tpdos&>(service);
  if constexpr (!is_small_machine) {
    if (event.kind == ServiceEvent::sample) return self.sync(event.counter());
    if (event.kind == ServiceEvent::values_changed && self.values_changed(event)) return;
    if (event.kind == ServiceEvent::watch_asked) return self.find_watcher(event);
    if (event.kind == ServiceEvent::value_set && self.value_set(event)) return;
  }
  if (event.kind == ServiceEvent::before_write) {
    return event.refuse(self.check_write(event.entry(), load_word(event.value())));
  }
  if (event.kind == ServiceEvent::after_write) return self.parameter_written(event.entry());
  if (event.kind == ServiceEvent::reset && self.mpdos_ != nullptr) {
    self.mpdos_->calls->event(self.mpdos_->source, 0, MpdoMode::none, MpdoEvent::reset);
  }
  if constexpr (!is_small_machine) {
    if (!concerns_tpdos(event.kind)) return;
    // The controller becomes ready again and again.
    if (event.kind == ServiceEvent::tx_ready && !std::exchange(self.any_waits_, false)) return;
  }
  self.notify_each(event);
  if (event.kind != ServiceEvent::reset) return;
  self.reload_all();
  self.watch(~0U);
}

void Tpdos::on_event(PdoService& service, Tpdo& pdo, ServiceEvent& event) {
  Tpdos& self = static_cast<Tpdos&>(service);
  if (!self.is_at_work(pdo) && event.kind > ServiceEvent::state_entered) return;
  switch (event.kind) {
    case ServiceEvent::reset:
    case ServiceEvent::state_entered:
      self.end(pdo);
      // A transmission at the beginning may end it: an answer of the application, a full bus.
      return self.begin(pdo);
    case ServiceEvent::bus_recovered:
    case ServiceEvent::values_changed:
      if (!knows_events(pdo.type_)) return;
      if (event.kind == ServiceEvent::bus_recovered) return self.bus_recovered(pdo);
      return self.values_changed(pdo, event.watchers());
    case ServiceEvent::value_set:
      if constexpr (!is_small_machine) self.value_set(pdo, event.entry(), event.number != 0);
      return;
    case ServiceEvent::tx_ready:
      return self.tx_ready(pdo);
    case ServiceEvent::sample:
      return self.sync(pdo, event.counter());
    case ServiceEvent::timer_expired:
      return self.look_at_time(pdo);
    case ServiceEvent::frame_came:
      if (self.takes(pdo, event)) self.answer(pdo);
      return;
    default:
      return;
  }
}

bool Tpdos::trigger(std::uint16_t number) {
  if (!works(number)) return false;
  Tpdo& pdo = (*this)[number];
  if (!knows_events(pdo.type_) || pdo.mode() == MpdoMode::destination) return false;
  occur(pdo);
  return true;
}

bool Tpdos::is_ready(std::uint16_t number, MpdoMode mode) const {
  return works(number) && pdos_[position_of(number)].mode() == mode;
}

bool Tpdos::has_other(std::uint16_t number, MpdoMode mode) const {
  return std::ranges::any_of(
      all(), [&](const Tpdo& pdo) { return number_of(pdo) != number && pdo.mode() == mode; });
}

void Tpdos::restart_mpdos(MpdoMode mode) {
  for (Tpdo& pdo : all()) {
    if (pdo.mode() != mode) continue;
    end(pdo);
    watch(watcher_of(number_of(pdo)));
    begin(pdo);
  }
}

/// Handles TPDOs that map one of the changed values, in the order of their numbers. False if they
/// are unknown, or too many: then each possible one is checked.
bool Tpdos::values_changed(const ServiceEvent& event) {
  if constexpr (is_small_machine) return false;
  if (!operational_) return true;
  const ChangedPlaces& changed = event.places();
  if (changed.are_too_many() || mpdos_ != nullptr || places_.value.share == 0) return false;
  const PlacesOfValues values(places_.value.values, unsigned{places_.value.share} * count_,
                              node_.dictionary().values());
  if (!places_.value.are_found) find_values(values);
  if (changed.count == 1) [[likely]] {
    const unsigned value = values.first(changed.places[0]);
    if (value == PlacesOfValues::nothing) return true;
    if (values.next(value) == PlacesOfValues::nothing) {
      value_changed(*static_cast<Tpdo*>(values.owner(value)));
      return true;
    }
  }
  return values_changed(changed, values);
}

/// The same of several values, or of one in several TPDOs.
bool Tpdos::values_changed(const ChangedPlaces& changed, const PlacesOfValues& values) {
  if constexpr (is_small_machine) return false;
  std::array<Tpdo*, 16> pdos;
  std::size_t count = 0;
  for (std::size_t i = 0; i < changed.count; ++i) {
    unsigned value = values.first(changed.places[i]);
    for (; value != PlacesOfValues::nothing; value = values.next(value)) {
      if (count == pdos.size()) return false;
      pdos[count++] = static_cast<Tpdo*>(values.owner(value));
    }
  }
  if (count > 1) std::sort(pdos.data(), pdos.data() + count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 0 || pdos[i] != pdos[i - 1]) value_changed(*pdos[i]);
  }
  return true;
}

/// Finds the TPDOs for a value in a watched row. Multiplexed TPDOs may send any of them.
void Tpdos::find_watcher(ServiceEvent& event) {
  if constexpr (is_small_machine) return;
  if (mpdos_ != nullptr) return event.want();
  if (places_.value.share == 0) return;
  const PlacesOfValues values(places_.value.values, unsigned{places_.value.share} * count_,
                              node_.dictionary().values());
  if (!places_.value.are_found) find_values(values);
  const unsigned value = values.first(event.number);
  if (value == PlacesOfValues::nothing) return;
  event.want();
  if (values.next(value) == PlacesOfValues::nothing) event.subject = values.owner(value);
}

void Tpdos::find_values(PlacesOfValues values) {
  values.clear();
  for (Tpdo& pdo : all()) {
    const auto first = static_cast<unsigned>(values_of(pdo) - places_.value.values);
    if (!pdo.is_active() || !knows_events(pdo.type_)) continue;
    for (unsigned i = 0, bits = 0; bits < pdo.bits_ && i < places_.value.share; ++i) {
      values.add(first + i, &pdo);
      bits += values_of(pdo)[i].bits();
    }
  }
  places_.value.are_found = true;
}

[[gnu::always_inline]] inline void Tpdos::values_changed(Tpdo& pdo, std::uint32_t watchers) {
  if (!is_small_machine && (watchers & watcher_of(number_of(pdo))) == 0) return;
  if (Pdo::has_plans && is_plain(pdo)) return send_changed(pdo);
  if (has_changed(pdo)) event(pdo);
}

/// For hosts, of any TPDO. One with an event that waits is sent with the present values anyway.
inline void Tpdos::value_changed(Tpdo& pdo) {
  if constexpr (is_small_machine) return;
  if (pdo.event_ && pdo.mode_ == 0) return;
  if (!is_at_work(pdo) || !knows_events(pdo.type_)) return;
  if (is_plain(pdo)) return send_changed(pdo);
  if (has_changed(pdo)) event(pdo);
}

/// True if its values need copying only.
inline bool Tpdos::is_plain(const Tpdo& pdo) const {
  return pdo.plan_ != Pdo::mixed && pdo.mode_ == 0 && is_event_driven(pdo.type_) &&
         !is_stale(pdo) && !before_transmit;
}

/// Fast path for such PDOs: the compared image is the one sent.
inline void Tpdos::send_changed(Tpdo& pdo) {
  if (pdo.event_) return;
  PdoImage present{};
  pack(pdo, present, false);
  if ((present == pdo.image_ && !has_event(pdo)) || keep_inhibited(pdo)) return;
  if (node_.transmitter().crowded()) return wait(pdo);
  pdo.image_ = present;
  pdo.sampled_ = true;
  transmit_sample(pdo);
}

/// The source of a multiplexed PDO detects changes by itself.
inline bool Tpdos::has_changed(const Tpdo& pdo) {
  if (pdo.mode_ == 0) return !pdo.event_ && differs(pdo);
  notify_source(pdo, MpdoEvent::change);
  return true;
}

/// With an event it is sent at the next notification of changes, even if it carried the same last.
/// Without one the value counts as sent: a later check of the PDO, for another value, finds no
/// difference. The sample of a synchronous PDO stays unchanged, for remote frames.
inline void Tpdos::value_set(Tpdo& pdo, const Entry& entry, bool is_event) {
  if (!knows_events(pdo.type_) || pdo.mode_ != 0) return;
  PdoImage present;
  pack(pdo, present, false);
  for_places(pdo, entry, [&](unsigned start, unsigned bits) {
    if (is_event) pdo.holds_ = true;
    if (is_event || !is_event_driven(pdo.type_)) return;
    for (unsigned i = start; i < start + bits; ++i) {
      const unsigned bit = 1U << i % 8;
      std::uint8_t& byte = pdo.image_[i / 8];
      byte = static_cast<std::uint8_t>((byte & ~bit) | (present[i / 8] & bit));
    }
  });
}

/// Those that map it. False where it is not known which they are.
bool Tpdos::value_set(const ServiceEvent& event) {
  if (is_small_machine || places_.value.share == 0) return false;
  if (!operational_) return true;
  const PlacesOfValues values(places_.value.values, unsigned{places_.value.share} * count_,
                              node_.dictionary().values());
  if (!places_.value.are_found) find_values(values);
  const Entry& entry = event.entry();
  unsigned value = values.first(node_.dictionary().offset_of(entry));
  for (; value != PlacesOfValues::nothing; value = values.next(value)) {
    Tpdo& pdo = *static_cast<Tpdo*>(values.owner(value));
    // One that maps it twice is told twice, and then nothing is left to be done.
    if (is_at_work(pdo)) value_set(pdo, entry, event.number != 0);
  }
  return true;
}

/// The values are no longer those that were sent or sampled, or one has an event.
bool Tpdos::differs(const Tpdo& pdo) {
  if (has_event(pdo)) return true;
  PdoImage present;
  pack(pdo, present, false);
  if constexpr (!is_small_machine) return present != pdo.image_;
  unsigned difference = 0;
  for (unsigned i = 0; i < present.size(); ++i)
    difference |= present[i] ^ unsigned { pdo.image_[i] };
  return difference != 0;
}

inline void Tpdos::tx_ready(Tpdo& pdo) {
  if (!pdo.waiting_) return;
  pdo.waiting_ = false;
  if (pdo.type_ >= transmission_type::remote) {
    transmit(pdo);
  } else if (pdo.type_ == transmission_type::remote_synchronous || is_in_time()) {
    transmit_sample(pdo);
  } else {
    // Too late for this SYNC. The event of an acyclic PDO is sent at the next.
    pdo.event_ = true;
  }
}

/// Frames that waited for the controller at bus-off were lost, although they counted as sent; later
/// ones are outdated.
inline void Tpdos::bus_recovered(Tpdo& pdo) {
  end(pdo);
  occur(pdo);
}

/// True while the synchronous window is open.
inline bool Tpdos::is_in_time() const {
  return sync_ == nullptr || sync_->is_window_open();
}

/// Handles the PDOs that wait for SYNC; a host has a set of them.
[[gnu::flatten]] void Tpdos::sync(std::uint8_t counter) {
  if constexpr (is_small_machine) return;
  for_chosen([&](Tpdo& pdo) {
    if (is_at_work(pdo)) sync(pdo, counter);
  });
}

[[gnu::always_inline]] inline void Tpdos::sync(Tpdo& pdo, std::uint8_t counter) {
  if (pdo.type_ > transmission_type::remote_synchronous) return;
  if (pdo.type_ == transmission_type::remote_synchronous) return sample(pdo);
  if (!is_turn(pdo, counter)) return;
  pdo.event_ = false;
  sample(pdo);
  transmit_sample(pdo);
}

/// Counts the SYNC. The one with the SYNC start value is the first. An acyclic PDO needs an event;
/// a change by this SYNC through RPDOs is one that is not yet reported.
[[gnu::always_inline]] inline bool Tpdos::is_turn(Tpdo& pdo, std::uint8_t counter) {
  if (pdo.type_ == transmission_type::acyclic) {
    if constexpr (is_small_machine) return pdo.event_ || differs(pdo);
    const bool is_told = (node_.dictionary().changes() & watcher_of(number_of(pdo))) == 0;
    return pdo.event_ || (!is_told && differs(pdo));
  }
  if (!pdo.counts_) {
    const std::uint32_t start = parameter(pdo, pdo_sub::sync_start, 0);
    if (start != 0 && counter != 0 && counter != start) return false;
    pdo.counts_ = true;
  }
  check_invariant(pdo.syncs_or_faults_ < pdo.type_);
  ++pdo.syncs_or_faults_;
  if (pdo.syncs_or_faults_ < pdo.type_) return false;
  pdo.syncs_or_faults_ = 0;
  return true;
}

inline void Tpdos::parameter_written(const Entry& entry) {
  Tpdo* pdo = find(entry);
  if (pdo == nullptr || is_mapping(entry)) return;
  if (reload(*pdo)) {
    end(*pdo);
    watch(watcher_of(number_of(*pdo)));
    return begin(*pdo);
  }
  if (entry.sub != pdo_sub::event_timer || !is_at_work(*pdo)) return;
  begin_anew(*pdo);
  wake(*pdo);
}

/// Numbers are distinguished modulo 32.
std::uint32_t Tpdos::watcher_of(std::uint16_t number) {
  return 1U << (number % watchers_max);
}

/// Sets the watchers of the objects of these PDOs, and of no others.
void Tpdos::watch(std::uint32_t watchers) {
  if constexpr (is_small_machine) return;
  places_.value.are_found = false;
  Dictionary& dictionary = node_.dictionary();
  dictionary.unwatch(watchers);
  for (const Tpdo& pdo : all()) {
    const std::uint32_t watcher = watcher_of(number_of(pdo));
    if ((watchers & watcher) == 0 || !pdo.is_active() || !knows_events(pdo.type_)) continue;
    if (pdo.mode_ != 0) {
      mpdos_->calls->watch(mpdos_->source, pdo.mode(), watcher);
      continue;
    }
    for_values(pdo, [&](const MappedValue& value, unsigned) {
      dictionary.watch(value.entry(), watcher);
      return true;
    });
  }
}

void Tpdos::begin(Tpdo& pdo) {
  if (!is_at_work(pdo)) return;
  pdo.since_ = ticks();
  wake(pdo);
  if (!knows_events(pdo.type_)) return;
  const bool is_sent = may_begin_ == nullptr || may_begin_(node_.dictionary(), number_of(pdo));
  if (is_sent) return occur(pdo);
  pack(pdo, pdo.image_, false);
  notify_source(pdo, MpdoEvent::begin);
}

/// Also cancels a transmission that found no room in the controller.
void Tpdos::end(Tpdo& pdo) {
  node_.transmitter().drop(pdo.can_id_);
  notify_source(pdo, MpdoEvent::end);
  pdo.syncs_or_faults_ = 0;
  pdo.sampled_ = pdo.sent_ = pdo.event_ = pdo.waiting_ = pdo.counts_ = false;
  if constexpr (!is_small_machine) pdo.holds_ = false;
}

bool Tpdos::is_inhibited(const Tpdo& pdo) const {
  return pdo.sent_ && PdoService::time_left(pdo, inhibit_time_of(pdo)) != 0;
}

/// Time until the inhibit time is over for a waiting event, or the event timer expires; or until
/// the time of the last transmission must be discarded, before its counter wraps around.
std::uint32_t Tpdos::time_left(const Tpdo& pdo) const {
  constexpr std::uint32_t long_time = UINT32_MAX / 2;
  if (!is_event_driven(pdo.type_) || pdo.waiting_) return no_limit;
  const std::uint32_t inhibit_time = inhibit_time_of(pdo);
  if (pdo.event_) return PdoService::time_left(pdo, inhibit_time);
  std::uint32_t limit = period_of(pdo);
  if (limit == 0) {
    if (!pdo.sent_ || inhibit_time == 0) return no_limit;
    limit = long_time;
  }
  return PdoService::time_left(pdo, limit);
}

void Tpdos::wake(const Tpdo& pdo) {
  const std::uint32_t left = time_left(pdo);
  if (left != no_limit) wake_in(left);
}

/// Times are not moved at each transmission, but checked when the first one would be over.
inline void Tpdos::look_at_time(Tpdo& pdo) {
  if (time_left(pdo) == 0) be_due(pdo);
  wake(pdo);
}

inline void Tpdos::be_due(Tpdo& pdo) {
  begin_anew(pdo);
  if (pdo.event_) {
    transmit(pdo);
  } else if (period_of(pdo) != 0) {
    occur(pdo);
  }
}

/// Restarts the times, unless an inhibit time forbids it.
void Tpdos::begin_anew(Tpdo& pdo) {
  if (is_inhibited(pdo)) return;
  pdo.since_ = ticks();
  pdo.sent_ = false;
}

void Tpdos::notify_mpdos(const Tpdos& self, const Tpdo& pdo, MpdoEvent event) {
  if (pdo.mode_ == 0) return;
  const MpdoSource& mpdos = *self.mpdos_;
  const std::uint16_t number = self.number_of(pdo);
  if (event == MpdoEvent::transmit) return mpdos.calls->transmit(mpdos.source, number, pdo.mode());
  mpdos.calls->event(mpdos.source, number, pdo.mode(), event);
}

/// Handles an event that does not come from a value.
void Tpdos::occur(Tpdo& pdo) {
  notify_source(pdo, MpdoEvent::all);
  event(pdo);
}

void Tpdos::event(Tpdo& pdo) {
  if (pdo.type_ == transmission_type::acyclic) {
    pdo.event_ = true;
  } else if (!keep_inhibited(pdo)) {
    transmit(pdo);
  }
}

/// Keeps an event until the inhibit time is over.
[[gnu::always_inline]] inline bool Tpdos::keep_inhibited(Tpdo& pdo) {
  if (!is_inhibited(pdo)) return false;
  pdo.event_ = true;
  wake(pdo);
  return true;
}

void Tpdos::answer_routed(void* context, const Frame&, Time) {
  if constexpr (!Pdo::has_routes) return;
  Tpdo& pdo = *static_cast<Tpdo*>(context);
  Tpdos& self = static_cast<Tpdos&>(*pdo.owner_.value);
  if (self.is_at_work(pdo)) self.answer(pdo);
}

[[gnu::always_inline]] inline void Tpdos::answer(Tpdo& pdo) {
  if (is_event_driven(pdo.type_)) return event(pdo);
  if (pdo.type_ == transmission_type::remote) return transmit(pdo);
  if (!pdo.sampled_) sample(pdo);
  transmit_sample(pdo);
}

/// A callback for values may end the PDO, by an invalid COB-ID or another NMT state: there is no
/// sample then.
void Tpdos::sample(Tpdo& pdo) {
  pdo.sampled_ = true;
  if (is_small_machine || before_transmit) before_transmit(number_of(pdo));
  renew(pdo);
  pack(pdo, pdo.image_, true);
}

/// Samples as late as possible: not before there is room for the frame.
void Tpdos::transmit(Tpdo& pdo) {
  pdo.event_ = false;
  if (node_.transmitter().crowded()) return wait(pdo);
  if (pdo.mode_ != 0) return notify_source(pdo, MpdoEvent::transmit);
  sample(pdo);
  transmit_sample(pdo);
}

void Tpdos::wait(Tpdo& pdo) {
  pdo.waiting_ = true;
  if constexpr (!is_small_machine) any_waits_ = true;
}

bool Tpdos::may_send_mpdo(std::uint16_t number) {
  Tpdo& pdo = (*this)[number];
  if (keep_inhibited(pdo)) return false;
  if (!node_.transmitter().crowded()) return true;
  wait(pdo);
  return false;
}

bool Tpdos::send_mpdo(std::uint16_t number, const PdoImage& image) {
  Tpdo& pdo = (*this)[number];
  pdo.image_ = image;
  pdo.sampled_ = true;
  transmit_sample(pdo);
  return !pdo.waiting_;
}

void Tpdos::transmit_sample(Tpdo& pdo) {
  if (!pdo.sampled_) return;
  pdo.waiting_ = false;
  if (node_.transmitter().crowded()) return wait(pdo);
  Frame frame;
  frame.id = pdo.can_id_;
  frame.length = pdo.length_;
  frame.data = pdo.image_;
  // Recorded before it leaves: an answer may come at once, and is inhibited by it or ends it.
  pdo.since_ = ticks();
  pdo.sent_ = true;
  if constexpr (!is_small_machine) pdo.holds_ = false;
  if (is_small_machine || pdo.has_times()) wake(pdo);
  if (node_.transmitter().send(frame)) return;
  pdo.sent_ = false;
  wait(pdo);
}

}  // namespace canvoy
