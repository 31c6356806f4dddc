#include "canvoy/worlds/taxi/taxi_referee.hpp"

#include <algorithm>
#include <chrono>

#include "canvoy/worlds/taxi/read_screens.hpp"

namespace canvoy::taxi {

namespace {

constexpr double cents = 10;  ///< in 0.001 of the currency unit
/// The driver presses a key at most twice.
constexpr Duration wait_bound = 3s;
/// Time in which the lights on the roof follow the meter.
constexpr Duration sign_bound = 3s;
/// Time for the emergency light on the roof, and the call to the control room.
constexpr Duration alarm_bound = 5s;
/// Time for the display of trip and place on the terminal.
constexpr Duration screen_bound = 5s;
/// By then all devices have a node-ID and have booted, also where frames are repeated.
constexpr Time settled_at{car::return_bound};
/// In this time without an excuse, a passenger is carried.
constexpr Duration long_enough = 2h;

Invariant none(InvariantKind kind, double worst, std::uint64_t judged) {
  return {.kind = kind, .worst = worst, .allowed = 0, .held = worst <= 0, .judged = judged};
}

Invariant in_time(InvariantKind kind, Duration worst, Duration allowed, std::uint64_t judged) {
  return {.kind = kind,
          .worst = std::chrono::duration<double>(worst).count(),
          .allowed = std::chrono::duration<double>(allowed).count(),
          .held = worst <= allowed,
          .judged = judged};
}
Invariant in_time(InvariantKind kind, const WrongTime& wrong, Duration allowed) {
  return in_time(kind, wrong.worst(), allowed, wrong.judged());
}

}  // namespace

TaxiReferee::TaxiReferee(TaxiCar& car, const TaxiOptions& options, const Shift& shift,
                         const TripBook& trips, const MeterWatch& watch, const TaxiExcuses& excuses,
                         const TamperWatch& tampering)
    : car_(car),
      options_(options),
      shift_(shift),
      trips_(trips),
      watch_(watch),
      excuses_(excuses),
      tampering_(tampering),
      waits_for_real_(!options.real.empty()),
      silence_(car.bus()) {}

void TaxiReferee::step(Time now) {
  if (waits_for_real_ && !car_.bus().waits_for_real()) waits_for_real_ = false;
  if (!is_excused(InvariantKind::carried, now)) without_excuse_ += Shift::step_time;
  judge_silence(now);
  judge_service(now);
  judge_devices(now);
  judge_sign(now);
  judge_alarm(now);
  judge_terminal(now);
}

void TaxiReferee::judge_silence(Time now) {
  silence_.look(now);
  if (silence_.is_asleep() && !is_excused(InvariantKind::silence, now)) ++quiet_;
}

/// Judges people who want to ride or to pay, while the meter does not obey.
void TaxiReferee::judge_service(Time now) {
  const Activity activity = shift_.activity();
  const bool waits = activity == Activity::hiring || activity == Activity::stopping ||
                     activity == Activity::releasing || activity == Activity::signing_on;
  // The driver cannot stop a trip that the meter has lost; no passenger pays for it twice.
  const bool is_lost = (activity == Activity::stopping || activity == Activity::releasing) &&
                       trips_.has_lost_power();
  // The keys of a real meter are out of the driver's reach.
  const bool has_keys = is_played(taximeter_id);
  if (waits && has_keys && !is_lost && !is_excused(InvariantKind::no_service, now)) {
    wait_.judge(now, false);
  } else {
    wait_.pass(now);
  }
}

/// After each kind of return, a device is operational again in time.
void TaxiReferee::judge_devices(Time now) {
  car::CarBus& bus = car_.bus();
  const bool sleeps = bus.any_sleeps();
  for (const auto& node : bus.nodes()) {
    const NodeId id = node->place().id;
    const bool may_come_yet = waits_for_real_ && bus.may_come_yet(id);
    if (sleeps || may_come_yet || excuses_.may_be_missing(id, now)) {
      missing_.pass(id, now);
    } else {
      missing_.judge(id, now, bus.is_at_work(*node));
    }
  }
}

bool TaxiReferee::is_awake(NodeId id) {
  car::CarNode& node = car_.bus().node(id);
  return node.is_powered() && node.device().sleep().state() == cia447::SleepState::awake;
}

/// People at the road see whether it is a taxi at work, whether it is vacant, and by which level of
/// the tariff passengers are driven.
void TaxiReferee::judge_sign(Time now) {
  using cia447::Taximeter;
  const Taximeter state = car_.meter().display().state;
  const bool can_be_seen =
      now >= settled_at && is_awake(sign_id) && car_.bus().has_power(taximeter_id);
  const bool is_free = !can_be_seen || is_excused(InvariantKind::roof_sign, now);
  sign_.judge_unless(is_free, now, car_.sign().is_vacant() == (state == Taximeter::for_hire));
  const bool is_at_work = state != Taximeter::signed_off && state != Taximeter::standby_mode;
  taxi_light_.judge_unless(is_free, now, car_.sign().is_lit() == is_at_work);
  level_sign_.judge_unless(is_free || state != Taximeter::hired, now, level_is_shown(now));
}

bool TaxiReferee::level_is_shown(Time now) const {
  const auto levels = trips_.levels_about(now);
  return !levels || std::ranges::find(*levels, car_.sign().level()) != levels->end();
}

/// People at the road see it and call the police, and the control room receives it; and for a while
/// after it, that it is over.
void TaxiReferee::judge_alarm(Time now) {
  constexpr Duration aftermath = 30s;
  const bool has_alarm = car_.has_alarm();
  if (has_alarm) alarm_seen_ = now;
  const bool is_over_long = alarm_seen_ == Time{} || now > alarm_seen_ + aftermath;
  const bool is_seen = car_.sign().has_alarm();
  const bool is_right = has_alarm ? is_seen && car_.alarm_is_heard() : !is_seen;
  alarm_.judge_unless(is_over_long || is_excused(InvariantKind::alarm, now), now, is_right);
}

void TaxiReferee::judge_terminal(Time now) {
  const bool can_be_read = now >= settled_at && is_awake(terminal_id);
  const bool has_fare = can_be_read && is_awake(taximeter_id);
  fare_screen_.judge_unless(
      !has_fare || is_excused(InvariantKind::terminal_fare, now), now,
      fare_is_right(car_.screens().fare(), car_.meter().display(), options_.currency_of_town));
  const bool has_place = can_be_read && is_awake(driver_id) && is_awake(navigation_id);
  const bool is_free = !has_place || is_excused(InvariantKind::terminal_place, now);
  place_screen_.judge_unless(is_free, now, is_free || place_is_shown());
}

bool TaxiReferee::place_is_shown() const {
  const cia447::GpsReading truth = car_.drive().receiver();
  TruePlace place{.destination = car_.guidance().destination(),
                  .has_satellites = car_.has_satellites(),
                  .places = options_.places};
  if (truth.latitude && truth.longitude) place.here = {*truth.latitude, *truth.longitude};
  return place_is_right(car_.screens().place(), place);
}

/// The actions of a real device cannot be seen, and its keys are out of the driver's reach.
bool TaxiReferee::can_be_judged(InvariantKind kind) const {
  const auto are_played = [this](std::initializer_list<NodeId> nodes) {
    return std::ranges::all_of(nodes, [this](NodeId id) { return is_played(id); });
  };
  switch (kind) {
    case InvariantKind::receipts:
    case InvariantKind::receipt_lines:
    case InvariantKind::shift_slip:
      return are_played({printer_id});
    case InvariantKind::roof_sign:
      return are_played({sign_id, taximeter_id});
    case InvariantKind::alarm:
      return are_played({sign_id, alarm_id});
    case InvariantKind::terminal_fare:
      return are_played({terminal_id, taximeter_id});
    case InvariantKind::terminal_place:
      return are_played({terminal_id, driver_id, navigation_id});
    case InvariantKind::silence:
      return are_played({cia447::gateway_node_id});  // it sends all to sleep
    case InvariantKind::no_service:
      return are_played({taximeter_id});
    default:
      return true;
  }
}

/// The people at a real meter and a real car are unknown here.
Invariant TaxiReferee::judge_carried() const {
  const bool is_led = !is_played(taximeter_id) || !is_played(cia447::gateway_node_id);
  const bool was_long_enough = !is_led && without_excuse_ >= long_enough;
  return {.kind = InvariantKind::carried,
          .worst = was_long_enough && shift_.carried() == 0 ? 1.0 : 0.0,
          .held = !was_long_enough || shift_.carried() != 0,
          .judged = was_long_enough ? 1U : 0U};
}

Invariant TaxiReferee::of_trips(InvariantKind kind, double unit) const {
  return none(kind, trips_.worst(kind) / unit, trips_.judged(kind));
}

bool TaxiReferee::passengers_see() const {
  constexpr InvariantKind of_money[] = {InvariantKind::fare,          InvariantKind::distance,
                                        InvariantKind::duration,      InvariantKind::waiting,
                                        InvariantKind::total,         InvariantKind::totals,
                                        InvariantKind::receipt_lines, InvariantKind::shift_slip};
  return std::ranges::any_of(of_money,
                             [this](InvariantKind kind) { return trips_.worst(kind) > 0; });
}

std::vector<Invariant> TaxiReferee::verdicts() const {
  std::vector<Invariant> all = {
      of_trips(InvariantKind::fare, cents),
      of_trips(InvariantKind::distance, 1),
      of_trips(InvariantKind::duration, 1),
      of_trips(InvariantKind::waiting, 1),
      of_trips(InvariantKind::total, cents),
      of_trips(InvariantKind::totals, cents),
      of_trips(InvariantKind::receipts, cents),
      of_trips(InvariantKind::receipt_lines, 1),
      of_trips(InvariantKind::shift_slip, 1),
      in_time(InvariantKind::roof_sign,
              std::max({sign_.worst(), taxi_light_.worst(), level_sign_.worst()}), sign_bound,
              sign_.judged()),
      in_time(InvariantKind::alarm, alarm_, alarm_bound),
      in_time(InvariantKind::terminal_fare, fare_screen_, screen_bound),
      in_time(InvariantKind::terminal_place, place_screen_, screen_bound),
      none(InvariantKind::silence, static_cast<double>(silence_.frames()), quiet_),
      in_time(InvariantKind::no_service, wait_, wait_bound),
      judge_carried(),
      in_time(InvariantKind::device_missing, missing_.worst(), car::return_bound,
              missing_.judged())};
  for (Invariant& each : all) {
    if (!can_be_judged(each.kind)) each.judged = 0;
  }
  if (watch_.cuts() != 0) {
    all.push_back(
        none(InvariantKind::power_cut, static_cast<double>(watch_.wrong_ends()), watch_.cuts()));
  }
  if (tampering_.acts() != 0) {
    const Time now = car_.bus().world().now();
    all.push_back(none(InvariantKind::tampering, static_cast<double>(tampering_.missed(now)),
                       tampering_.judged(now)));
  }
  return all;
}

}  // namespace canvoy::taxi
