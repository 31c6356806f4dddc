#include "canvoy/sim/taxi/taxi_referee.hpp"

#include <algorithm>
#include <chrono>

#include "canvoy/sim/taxi/read_screens.hpp"
#include "canvoy/sim/taxi/taxi_faults.hpp"

namespace canvoy::taxi {

namespace {

constexpr double cents = 10;  ///< in 0,001 of the currency unit
/// The driver presses a key twice at most.
constexpr Duration wait_bound = 3s;
/// The lights on the roof follow the meter in this time.
constexpr Duration sign_bound = 3s;
/// What the terminal shows of trip and place.
constexpr Duration screen_bound = 5s;
/// All are named and booted by then, also where frames are sent again.
constexpr Time settled_at{TaxiFaults::return_bound};
/// In so much time that no fault excuses somebody is carried.
constexpr Duration long_enough = 2h;

Invariant none(InvariantKind kind, double worst) {
  return {.kind = kind, .worst = worst, .allowed = 0, .held = worst <= 0, .judged = 1};
}

Invariant in_time(InvariantKind kind, Duration worst, Duration allowed) {
  return {.kind = kind,
          .worst = std::chrono::duration<double>(worst).count(),
          .allowed = std::chrono::duration<double>(allowed).count(),
          .held = worst <= allowed,
          .judged = 1};
}

}  // namespace

TaxiReferee::TaxiReferee(TaxiCar& car, const TaxiOptions& options, const Shift& shift,
                         const TripBook& trips, car::Excuse& excuse)
    : car_(car),
      options_(options),
      shift_(shift),
      trips_(trips),
      excuse_(excuse),
      silence_(car.bus()) {}

void TaxiReferee::step(Time now) {
  if (!excuse_.is_excused(now)) without_excuse_ += Shift::step_time;
  judge_service(now);
  judge_devices(now);
  judge_sign(now);
  judge_terminal(now);
}

/// Who wants to ride or to pay, and the meter does not obey.
void TaxiReferee::judge_service(Time now) {
  const Activity activity = shift_.activity();
  const bool waits = activity == Activity::hiring || activity == Activity::stopping ||
                     activity == Activity::releasing || activity == Activity::signing_on;
  // What the meter has lost of a trip, the driver cannot stop; nobody pays for it twice.
  const bool is_lost =
      trips_.is_disturbed() || (trips_.last_was_disturbed() && activity == Activity::releasing);
  // The keys of a real meter are out of the driver's reach.
  const bool has_keys = is_played(taximeter_id);
  wait_.judge(now, !waits || !has_keys || is_lost || excuse_.is_excused(now));
}

/// After each kind of return a device is operational again in time.
void TaxiReferee::judge_devices(Time now) {
  car::CarBus& bus = car_.bus();
  if (excuse_.waits_for_real() && !bus.waits_for_real()) excuse_.all_have_come();
  const bool sleeps = bus.any_sleeps();
  silence_.look(now);
  for (const auto& node : bus.nodes()) {
    const bool is_there = sleeps || excuse_.is_excused(now) || bus.is_at_work(*node);
    missing_.judge(node->place().id, now, is_there);
  }
}

bool TaxiReferee::is_awake(NodeId id) {
  car::CarNode& node = car_.bus().node(id);
  return node.is_powered() && node.device().sleep().state() == cia447::SleepState::awake;
}

/// Who stands at the road sees whether the taxi is vacant.
void TaxiReferee::judge_sign(Time now) {
  const bool is_vacant = car_.meter().display().state == cia447::Taximeter::for_hire;
  const bool can_be_seen =
      now >= settled_at && is_awake(sign_id) && car_.bus().has_power(taximeter_id);
  sign_.judge(now, excuse_.is_excused(now) || !can_be_seen || car_.sign().is_vacant() == is_vacant);
}

void TaxiReferee::judge_terminal(Time now) {
  const bool can_be_read = now >= settled_at && !excuse_.is_excused(now) && is_awake(terminal_id);
  const bool has_fare = can_be_read && is_awake(taximeter_id);
  fare_screen_.judge(now,
                     !has_fare || fare_is_right(car_.screens().fare(), car_.meter().display()));
  const bool has_place = can_be_read && is_awake(driver_id) && is_awake(navigation_id);
  place_screen_.judge(now, !has_place || place_is_shown());
}

bool TaxiReferee::place_is_shown() const {
  const cia447::GpsReading truth = car_.drive().receiver();
  TruePlace place{.destination = car_.guidance().destination(),
                  .has_satellites = car_.has_satellites(),
                  .places = options_.places};
  if (truth.latitude && truth.longitude) place.here = {*truth.latitude, *truth.longitude};
  return place_is_right(car_.screens().place(), place);
}

/// What a real device does is not seen here, and its keys are out of the driver's reach.
bool TaxiReferee::can_be_judged(InvariantKind kind) const {
  const auto are_played = [this](std::initializer_list<NodeId> nodes) {
    return std::ranges::all_of(nodes, [this](NodeId id) { return is_played(id); });
  };
  switch (kind) {
    case InvariantKind::fare:
    case InvariantKind::distance:
    case InvariantKind::duration:
      return are_played({driver_id});  // whose clock says which tariff it is
    case InvariantKind::receipts:
      return are_played({printer_id});
    case InvariantKind::roof_sign:
      return are_played({sign_id, taximeter_id});
    case InvariantKind::terminal_fare:
      return are_played({terminal_id, taximeter_id});
    case InvariantKind::terminal_place:
      return are_played({terminal_id, driver_id, navigation_id});
    case InvariantKind::silence:
      return are_played({cia447::gateway_node_id});  // who has all sleep
    case InvariantKind::no_service:
      return are_played({taximeter_id});
    default:
      return true;
  }
}

/// Whose hands a real meter and a real car are in, nobody knows here.
Invariant TaxiReferee::judge_carried() const {
  const bool is_led = !is_played(taximeter_id) || !is_played(cia447::gateway_node_id);
  const bool was_long_enough = !is_led && without_excuse_ >= long_enough;
  return {.kind = InvariantKind::carried,
          .worst = was_long_enough && shift_.carried() == 0 ? 1.0 : 0.0,
          .held = !was_long_enough || shift_.carried() != 0,
          .judged = was_long_enough ? 1U : 0U};
}

std::vector<Invariant> TaxiReferee::verdicts() const {
  std::vector<Invariant> all = {
      none(InvariantKind::fare, trips_.fare_excess() / cents),
      none(InvariantKind::distance, trips_.distance_excess()),
      none(InvariantKind::duration, trips_.time_excess()),
      none(InvariantKind::totals, trips_.totals_error() / cents),
      none(InvariantKind::receipts, trips_.receipts_error() / cents),
      in_time(InvariantKind::roof_sign, sign_.worst(), sign_bound),
      in_time(InvariantKind::terminal_fare, fare_screen_.worst(), screen_bound),
      in_time(InvariantKind::terminal_place, place_screen_.worst(), screen_bound),
      none(InvariantKind::silence, static_cast<double>(silence_.frames())),
      in_time(InvariantKind::no_service, wait_.worst(), wait_bound),
      judge_carried(),
      in_time(InvariantKind::device_missing, missing_.worst(), TaxiFaults::return_bound)};
  for (Invariant& each : all) {
    if (!can_be_judged(each.kind)) each.judged = 0;
  }
  return all;
}

}  // namespace canvoy::taxi
