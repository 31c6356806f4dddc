#include "canvoy/devices/cia419/charger.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::cia419 {

namespace {

constexpr std::uint16_t battery_profile = 418;
constexpr Duration command_interval = 1s;
constexpr Duration reminder_interval = 15s;

constexpr std::uint8_t cob_id_sub = 1;
constexpr std::uint8_t event_timer_sub = 5;

/// Codes of CiA 301, since CiA 419 adds none (5.3).
constexpr Error pilot_lost{.code = 0x5000};
constexpr Error temperature_error{.code = 0x4000, .register_bits = error_register::temperature};
constexpr Error measurement_error{.code = 0x9000};
constexpr Error voltage_error{.code = 0x3300, .register_bits = error_register::voltage};
/// A PDO of the battery that the charger would misread, or vice versa.
constexpr Error misfit_error{.code = 0x6300, .register_bits = error_register::communication};

/// The error with which a stop is reported; none for stops that are no error, or that a service
/// reports.
const Error* error_of(StopReason reason) {
  switch (reason) {
    case StopReason::too_hot:
    case StopReason::too_cold:
      return &temperature_error;
    case StopReason::invalid_temperature:
    case StopReason::invalid_voltage:
      return &measurement_error;
    case StopReason::voltage_too_high:
    case StopReason::voltage_too_low:
      return &voltage_error;
    default:
      return nullptr;
  }
}

/// Compares all but the heartbeat and the values written to the battery.
bool is_linked_alike(const BatteryOffer& one, const BatteryOffer& other) {
  const auto has_same_ids = [](const auto& ids, const auto& others) {
    return std::ranges::equal(ids, others, {}, &CobId::raw, &CobId::raw);
  };
  return has_same_ids(one.tpdo, other.tpdo) && has_same_ids(one.rpdo, other.rpdo) &&
         one.tpdo_event_timer_ms == other.tpdo_event_timer_ms &&
         one.misfit_tpdos == other.misfit_tpdos && one.misfit_rpdos == other.misfit_rpdos &&
         one.capacity_ampere_hours == other.capacity_ampere_hours &&
         one.current_max_ampere == other.current_max_ampere && one.cells == other.cells;
}

constexpr double hours(Duration duration) {
  return std::chrono::duration<double, std::ratio<3600>>(duration).count();
}

}  // namespace

constexpr ServiceHandlers Charger::service_calls = {
    .reset = method<&Charger::reset>,
    .state_entered = method<&Charger::state_entered>,
    .bus_state_changed = method<&Charger::bus_state_changed>,
    .error_changed = method<&Charger::error_changed>};

Charger::Charger(Node& node, const ChargerServices& services, const ChargerHardware& hardware,
                 const ChargerSettings& settings)
    : node_(node),
      services_(services),
      hardware_(hardware),
      settings_(settings),
      battery_status_(node.dictionary()),
      charger_status_(node.dictionary()),
      temperature_(node.dictionary()),
      voltage_(node.dictionary()),
      requested_(node.dictionary()),
      state_of_charge_(node.dictionary()),
      estimate_(node.dictionary()),
      returned_(node.dictionary()),
      charge_control_(settings.limits),
      curve_(settings.curve),
      scan_(node, {.profile = battery_profile}),
      link_(node),
      timer_(callback<&Charger::control>(*this)),
      gaps_(node, callback<&Charger::ask_anew>(*this)),
      rivals_(node) {
  node.attach(service_);
  scan_.on_found(callback<&Charger::battery_found>(*this));
  link_.on_answered(callback<&Charger::battery_answered>(*this));
  link_.on_failed(callback<&Charger::battery_silent>(*this));
  services_.heartbeats.on_change(callback<&Charger::battery_changed>(*this));
  if (services_.network != nullptr) {
    services_.network->on_change(callback<&Charger::network_changed>(*this));
  }
  if (services_.time_stamp != nullptr && hardware_.time_of_day) {
    services_.time_stamp->produce_each(settings_.time_period);
  }
  services_.tpdos.before_transmit = callback<&Charger::refresh>(*this);
  services_.rpdos.received = callback<&Charger::pdo_received>(*this);
  services_.rpdos.timed_out = callback<&Charger::pdo_timed_out>(*this);
}

void Charger::reset(ResetScope) {
  // The PDOs are invalid again (6.1), and no battery is known.
  hardware_.deliver(0);
  set_point_ = 0;
  scan_.stop();
  link_.cancel();
  link_.use(nullptr);
  is_connected_ = false;
  linked_rpdos_.reset();
  rivals_.forget();
  forget_values();
  counted_at_ = node_.now();
  pilot_signal_ = false;
  // The counts of a battery that has gone do not apply to the next one.
  if (!hardware_.pilot_signal()) {
    charging_ = false;
    link_.forget();
  }
  enter(ChargerPhase::unplugged);
  node_.timers().arm(timer_, node_.now());
}

// Values from before a state without PDOs are out of date: current flows only on new values.
void Charger::state_entered(NmtState state) {
  fresh_rpdos_.reset();
  if (state == NmtState::operational) request_first_values();
  if (state != NmtState::initialisation) act();
}

void Charger::bus_state_changed(BusState state) {
  if (state == BusState::bus_off) fresh_rpdos_.reset();
}

/// A PDO that was not taken, for a value beyond its range or for its length, leaves the values of
/// the one before, which hold no longer.
void Charger::error_changed(const Error& error, bool present) {
  const bool is_of_pdo =
      error.code == emergency_code::protocol || error.code == emergency_code::pdo_too_short;
  const bool is_linked = error.instance >= 1 && error.instance <= BatteryOffer::pdos;
  if (present && is_of_pdo && is_linked) note_pdo(error.instance, false);
}

/// Measures, decides and drives; called every settings_.control_period.
void Charger::control(Time now) {
  node_.timers().arm(timer_, now + settings_.control_period);
  watch_pilot_signal();
  watch_rivals(now);
  report_time();
  if (settings_.manage_network) manage(now);
  remind_battery(now);
  follow_curve();
  act();
}

/// It goes on only while its current flows.
void Charger::follow_curve() {
  if (!curve_.is_used() || linked_rpdos_[2] || set_point_ <= 0) return;
  curve_.advance(settings_.control_period,
                 {.volt = voltage_.value().value_or(0),
                  .cells = static_cast<double>(offer_.cells.value_or(0))});
  if (curve_.phase() == ChargeCurve::Phase::finished) end_charge();
}

/// A battery that sends no heartbeat by itself may not have received the request, or have lost it;
/// a lost one may have been configured to send none.
void Charger::remind_battery(Time now) {
  if (phase_ != ChargerPhase::linked || is_battery_heard()) return;
  if (now < asked_at_ + reminder_interval) return;
  if (offer_.heartbeat_ms == 0) return ask_for_heartbeat();
  if (!is_lost_) return;
  asked_at_ = now;
  link_.ask(offer_.id);
}

void Charger::ask_for_heartbeat() {
  asked_at_ = node_.now();
  link_.write_heartbeat(offer_.id, asked_heartbeat_ms());
}

std::uint16_t Charger::asked_heartbeat_ms() const {
  return static_cast<std::uint16_t>(settings_.battery_heartbeat / 1ms);
}

void Charger::watch_pilot_signal() {
  const bool present = hardware_.pilot_signal();
  if (present == pilot_signal_) return;
  pilot_signal_ = present;
  if (present) {
    node_.clear(pilot_lost);
    return search();
  }
  const bool was_linked = phase_ == ChargerPhase::linked;
  act();
  charging_ = false;
  unlink();
  link_.forget();
  enter(ChargerPhase::unplugged);
  if (!was_linked) return;
  node_.raise(pilot_lost);
  services_.error_behaviour.device_failure();
}

/// Two chargers would deliver twice the current that the battery requests.
void Charger::watch_rivals(Time now) {
  rivals_.advance(now);
  if (!rivals_.is_to_leave()) return;
  charging_ = false;
  unlink();
  link_.forget();
  search(rivals_.turn());
  act();
}

/// The service sends the time; this is its clock.
void Charger::report_time() {
  if (services_.time_stamp == nullptr) return;
  const std::optional<TimeOfDay> time = hardware_.time_of_day();
  if (time) services_.time_stamp->set_clock(*time);
}

/// As the NMT master of two nodes: both have to be operational, unless there is an error here.
void Charger::manage(Time now) {
  if (phase_ != ChargerPhase::linked || services_.network == nullptr) return;
  if (node_.bus_state() == BusState::bus_off || battery_state() == RemoteState::lost) return;
  if (node_.state() != NmtState::operational) node_.command(NmtCommand::start);
  if (battery_state() == RemoteState::operational || now < commanded_at_ + command_interval) return;
  commanded_at_ = now;
  command_node(node_, offer_.id, NmtCommand::start);
}

void Charger::count(Time now) {
  const double passed = hours(now - counted_at_);
  counted_at_ = now;
  const double ampere_hours = hardware_.current() * passed;
  ampere_hours_total_ += ampere_hours;
  energy_total_ += ampere_hours * voltage_.value().value_or(0);
  if (!charging_) return;
  ampere_hours_ += ampere_hours;
  returned_ = ampere_hours_;
  if (offer_.capacity_ampere_hours && *offer_.capacity_ampere_hours > 0 &&
      state_of_charge_begin_ >= 0) {
    const double gained = ampere_hours_ / *offer_.capacity_ampere_hours * 100;
    estimate_ = state_of_charge_begin_ + gained;  // its value range ends at 100 % (7.2.7)
  }
}

bool Charger::is_battery_heard() const {
  return battery_state() != RemoteState::unknown && battery_state() != RemoteState::lost;
}

ChargeInputs Charger::inputs() const {
  const bool sends_voltage = linked_rpdos_[1];
  const bool sends_request = linked_rpdos_[2];
  return {.pilot_signal = pilot_signal_,
          .bus_off = node_.bus_state() == BusState::bus_off,
          .linked = phase_ == ChargerPhase::linked,
          .heartbeat_alive = is_battery_heard(),
          .operational = node_.state() == NmtState::operational,
          .data_fresh = linked_rpdos_.any() && fresh_rpdos_ == linked_rpdos_ &&
                        battery_state() == RemoteState::operational,
          .battery_ready = battery_status_.is(Readiness::ready),
          .temperature_celsius = temperature_.value(),
          .has_voltage = sends_voltage,
          .voltage_volt = sends_voltage ? voltage_.value() : std::nullopt,
          .has_request = sends_request,
          .requested_ampere = sends_request ? requested_.value() : std::nullopt,
          .state_of_charge_percent = sends_request ? state_of_charge_.value() : std::nullopt,
          .battery_max_ampere = offer_.current_max_ampere,
          .battery_cells = offer_.cells,
          .curve_ampere = curve_.is_used() ? std::optional(curve_.ampere()) : std::nullopt};
}

/// Decides with the present values, drives the power stage, and answers the battery by the status.
void Charger::act() {
  count(node_.now());
  const ChargeDecision decision = charge_control_.decide(inputs());
  const bool ready =
      decision.reason == StopReason::none || decision.reason == StopReason::no_request;
  // The battery is notified that the charger is ready before current flows, and that it is not
  // after.
  if (!ready) ready_told_at_ = never;
  set_point_ = ready && has_told_ready() ? decision.ampere : 0;
  hardware_.deliver(set_point_);
  charger_status_ = ready ? Readiness::ready : Readiness::not_ready;
  if (set_point_ > 0 && !charging_) begin_charge();
  if (decision.reason != reason_) report(decision.reason);
}

/// A frame that was passed to the controller waits there for the bus.
bool Charger::has_told_ready() const {
  if (!tells_status_) return charger_status_.is(Readiness::ready);
  return ready_told_at_ <= node_.now() - settings_.control_period;
}

void Charger::report(StopReason reason) {
  const StopReason before = std::exchange(reason_, reason);
  const Error* gone = error_of(before);
  const Error* come = error_of(reason);
  if (gone != come) {
    if (gone != nullptr) node_.clear(*gone);
    if (come != nullptr) node_.raise(*come);
  }
  event_(Event::reason_changed);
  if (!charging_) return;
  // A battery that is not ready for a while may continue the same charge; a full one starts
  // another.
  if (reason == StopReason::battery_not_ready) link_.write_back(offer_.id, returned_.raw());
  if (reason == StopReason::battery_full) end_charge();
}

void Charger::begin_charge() {
  charging_ = true;
  ampere_hours_ = 0;
  returned_ = 0;
  state_of_charge_begin_ = inputs().state_of_charge_percent.value_or(-1);
  if (state_of_charge_begin_ < 0) estimate_ = std::nullopt;
  event_(Event::charge_began);
}

void Charger::end_charge() {
  charging_ = false;
  link_.write_back(offer_.id, returned_.raw());
  event_(Event::charge_ended);
}

void Charger::search(Duration later) {
  enter(ChargerPhase::searching);
  if (settings_.bay_battery != 0) scan_.prefer(settings_.bay_battery);
  scan_.start(later);
}

void Charger::battery_found(NodeId id) {
  const bool is_of_bay = settings_.bay_battery == 0 || id == settings_.bay_battery;
  if (!is_of_bay || rivals_.is_served(id)) return scan_.go_on();
  enter(ChargerPhase::linking);
  found_ = id;
  const bool is_requested =
      services_.sdo_requester != nullptr &&
      services_.sdo_requester->connect(
          id, battery_connection, SdoRequester::Done::to<&Charger::connection_answered>(*this)) ==
          AbortCode::none;
  if (!is_requested) connection_answered(AbortCode::no_sdo_connection);
}

/// Without an SDO manager, or with one that has no connection, the default channel remains (6.1).
void Charger::connection_answered(SdoEnd end) {
  const NodeId battery = std::exchange(found_, NodeId{0});
  if (battery == 0) {
    if (end) services_.sdo_requester->release(battery_connection);
    return;
  }
  is_connected_ = bool(end);
  link_.use(is_connected_ ? services_.battery_client : nullptr);
  link_.ask(battery);
}

void Charger::battery_silent() {
  if (phase_ == ChargerPhase::linking) search();
}

/// An error for each of the two ends that sends PDOs which the other would misread.
void Charger::report_misfits(bool present) {
  if (offer_.misfit_tpdos.none() && offer_.misfit_rpdos.none()) return;
  if (present) {
    node_.raise(misfit_error);
  } else {
    node_.clear(misfit_error);
  }
}

void Charger::battery_answered(const BatteryOffer& offer) {
  if (phase_ == ChargerPhase::linked) return check_link(offer);
  if (rivals_.is_served(offer.id)) {
    enter(ChargerPhase::searching);
    return scan_.go_on();
  }
  offer_ = offer;
  link();
}

/// A battery that was not received for a while may have restarted meanwhile, or have other
/// parameters: changes are linked again. Its NMT state stays known.
void Charger::check_link(const BatteryOffer& offer) {
  if (is_linked_alike(offer, offer_)) {
    if (offer.heartbeat_ms == battery_period()) return;
    offer_.heartbeat_ms = offer.heartbeat_ms;
    return supervise_battery();
  }
  report_misfits(false);
  rivals_.leave();
  offer_ = offer;
  link();
}

/// Links our PDOs to the battery's (6.1): RPDO 2 in place of RPDO 1 if the battery also sends its
/// voltage (6.2.5), and the optional ones if both have them.
void Charger::link() {
  const auto usable = [this](std::size_t position) {
    return offer_.tpdo[position].valid() && !offer_.misfit_tpdos[position];
  };
  const bool with_voltage = services_.rpdos.size() >= 2 && usable(1);
  linked_rpdos_.reset();
  fresh_rpdos_.reset();
  link_rpdo(0, !with_voltage && usable(0));
  link_rpdo(1, with_voltage);
  link_rpdo(2, usable(2));
  tells_status_ = false;
  for (std::size_t position = 0; position < BatteryOffer::pdos; ++position) {
    if (!link_tpdo(position) || std::exchange(tells_status_, true)) continue;
    rivals_.watch(offer_.id, static_cast<std::uint16_t>(offer_.rpdo[position].can_id()));
  }
  supervise_battery();
  if (!charging_) returned_.set_raw(offer_.ampere_hours_returned.value_or(0xFFFF));
  commanded_at_ = Time{} - command_interval;
  enter(ChargerPhase::linked);
  report_misfits(true);
  request_first_values();
}

void Charger::link_rpdo(std::size_t position, bool use) {
  const auto index = static_cast<std::uint16_t>(object_index::rpdo_parameter + position);
  configure(index, cob_id_sub, CobId::bit31);
  if (!use || position >= services_.rpdos.size()) return;
  const unsigned deadline = settings_.pdo_periods_max * offer_.tpdo_event_timer_ms[position];
  configure(index, event_timer_sub, std::min(deadline, 0xFFFFU));
  const bool linked = configure(index, cob_id_sub, offer_.tpdo[position].can_id());
  linked_rpdos_[position] = linked;
}

bool Charger::link_tpdo(std::size_t position) {
  const auto index = static_cast<std::uint16_t>(object_index::tpdo_parameter + position);
  configure(index, cob_id_sub, CobId::bit31);
  const CobId offered = offer_.rpdo[position];
  const bool usable = offered.valid() && !offer_.misfit_rpdos[position];
  return usable && configure(index, cob_id_sub, offered.can_id());
}

/// Period of its heartbeat, in ms.
unsigned Charger::battery_period() const {
  return offer_.heartbeat_ms == 0 ? asked_heartbeat_ms() : offer_.heartbeat_ms;
}

void Charger::supervise_battery() {
  if (offer_.heartbeat_ms == 0) ask_for_heartbeat();
  const unsigned time = std::min(battery_period() * settings_.heartbeat_periods_max, 0xFFFFU);
  configure(object_index::heartbeat_consumers, 1,
            static_cast<std::uint32_t>(offer_.id) << 16 | time);
}

void Charger::unlink() {
  scan_.stop();
  link_.cancel();
  rivals_.leave();
  found_ = 0;
  if (phase_ == ChargerPhase::linked) report_misfits(false);
  if (std::exchange(is_connected_, false)) services_.sdo_requester->release(battery_connection);
  for (std::size_t position = 0; position < BatteryOffer::pdos; ++position) {
    configure(static_cast<std::uint16_t>(object_index::rpdo_parameter + position), cob_id_sub,
              CobId::bit31);
    configure(static_cast<std::uint16_t>(object_index::tpdo_parameter + position), cob_id_sub,
              CobId::bit31);
  }
  configure(object_index::heartbeat_consumers, 1, 0);
  linked_rpdos_.reset();
  is_lost_ = false;
  forget_values();
}

/// Values of one battery do not apply to the next one.
void Charger::forget_values() {
  curve_.begin();
  battery_status_ = Readiness::not_ready;
  temperature_ = std::nullopt;
  voltage_ = std::nullopt;
  requested_ = std::nullopt;
  state_of_charge_ = std::nullopt;
  estimate_ = std::nullopt;
}

/// Requests a first value by remote frame, if the battery allows it; others come with its event
/// timer (6.2.3.1).
void Charger::request_values(const std::bitset<BatteryOffer::pdos>& wanted) {
  for (std::size_t position = 0; position < BatteryOffer::pdos; ++position) {
    const bool allows_remote = (offer_.tpdo[position].raw & CobId::bit30) == 0;
    if (linked_rpdos_[position] && wanted[position] && allows_remote) {
      services_.rpdos.request(static_cast<std::uint16_t>(position + 1));
    }
  }
}

/// Its values may have changed meanwhile: without event timers they would stay out of date.
void Charger::ask_anew(NodeId) {
  if (phase_ == ChargerPhase::linked) request_values(linked_rpdos_);
}

void Charger::battery_changed(NodeId id, RemoteState state) {
  if (phase_ != ChargerPhase::linked || id != offer_.id) return;
  const bool was_lost = std::exchange(is_lost_, state == RemoteState::lost);
  if (state == RemoteState::boot_up) {
    // It has restarted, possibly with other COB-IDs.
    unlink();
    scan_.prefer(id);
    search();
  } else if (was_lost && !is_lost_) {
    link_.ask(id);
  }
  if (is_lost_) asked_at_ = node_.now();
  if (state != RemoteState::operational) fresh_rpdos_.reset();
  if (state == RemoteState::operational) request_first_values();
  act();
}

/// Any node that is received may be the battery that is searched for.
void Charger::network_changed(NodeId id, RemoteState state) {
  if (phase_ == ChargerPhase::searching && state != RemoteState::lost) scan_.prefer(id);
}

void Charger::pdo_received(std::uint16_t number) {
  // When a lost battery is received again, this is an old value.
  note_pdo(number, battery_state() != RemoteState::lost);
}

void Charger::pdo_timed_out(std::uint16_t number) {
  note_pdo(number, false);
}

/// A maker's charger may have more RPDOs than those of the battery.
void Charger::note_pdo(std::uint16_t number, bool is_fresh) {
  if (number > BatteryOffer::pdos) return;
  fresh_rpdos_[number - 1U] = is_fresh;
  act();
}

/// The data is updated before each transmission (6.2.4.1, 6.2.6.1, 6.2.8.1).
void Charger::refresh(std::uint16_t) {
  count(node_.now());
  if (charger_status_.is(Readiness::ready)) {
    ready_told_at_ = std::min(ready_told_at_, node_.now());
  }
}

void Charger::enter(ChargerPhase phase) {
  if (phase == phase_) return;
  phase_ = phase;
  event_(Event::phase_changed);
}

/// Writes one of our own communication parameters, like a configuration tool.
bool Charger::configure(std::uint16_t index, std::uint8_t sub, std::uint32_t value) {
  const Result<Entry> entry = node_.dictionary().find(index, sub);
  if (!entry) return false;
  std::array<std::uint8_t, 4> bytes{};
  store(bytes.data(), value);
  const auto length = std::min<std::size_t>(bytes.size(), entry->row->capacity);
  return node_.dictionary().write(*entry, std::span(bytes).first(length), Source::application) ==
         AbortCode::none;
}

}  // namespace canvoy::cia419
