#include "canvoy/sim/taxi/taxi_network.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/sim/car/sleep_plan.hpp"

namespace canvoy::taxi {

namespace {

constexpr std::size_t paper_lines = 4;  ///< that hang out of the printer
/// The driver's key is worked off in the meter's next turn.
constexpr Duration key_time = 1s;
/// Of a real one the key is heard of when its state comes over the bus, and while this machine is
/// busy that may take some time.
constexpr Duration heard_key_time = 5s;

ShiftOptions shift_options(const TaxiOptions& options) {
  ShiftOptions made = options.shift;
  // The hands at a real meter take the time that they take.
  const bool has_hands = std::ranges::find(options.real, taximeter_id) != options.real.end();
  if (has_hands) made.presses_max = UINT32_MAX;
  constexpr Duration evening = 1h;  // for the way home, sleep and waking
  made.end = Time{} + std::max<Duration>(options.length - evening, options.length / 2);
  return made;
}

car::CarBus::Settings bus_settings(const TaxiOptions& options) {
  return {.bit_rate = options.bit_rate,
          .seed = options.faults.seed,
          .names = device_names,
          .serial_numbers = 1000,
          .real = options.real,
          .time_out = options.car_network.nodes.time_out};
}

}  // namespace

TaxiNetwork::TaxiNetwork(TaxiOptions options)
    : options_(std::move(options)),
      bus_(world_, bus_settings(options_),
           [this](Time now, const BusEvent& heard) { events_.hear(now, heard); }),
      car_(bus_, options_, sabotage_, events_),
      shift_(shift_options(options_), options_.faults.seed, car_.drive(), hands()),
      trips_(options_.tariff_of_town, local_seconds(options_.begin)),
      real_meter_(car_, trips_),
      watch_(options_.meter.longest_power_cut),
      faults_(car_, options_.faults, trips_, watch_, excuses_, tampering_, events_),
      referee_(car_, options_, shift_, trips_, watch_, excuses_, tampering_) {
  car_.meter().on_recorded(
      Callback<void(const cia447::AuditEntry&)>::to<&TaxiNetwork::meter_recorded>(*this));
  hear_real_devices();
  bus_.bus().observe({.context = this,
                      .on_frame =
                          [](void* self, Time, ControllerId, const Frame&) {
                            auto* network = static_cast<TaxiNetwork*>(self);
                            network->referee_.frame_sent(network->now());
                          },
                      .on_state = nullptr});
  bus_.listen();
  shift_.on_change([this](Time now, Activity from, Activity to) { shift_changed(now, from, to); });
  world_.add_plant(Callback<void(Time)>::to<&TaxiNetwork::step>(*this), Shift::step_time);
  faults_.plan();
  world_.at(Time{} + std::min(options_.alarm, options_.length / 3), [this](Time now) {
    if (car_.press_alarm()) events_.note(now, AlarmPressed{});
  });
  for (const auto& node : bus_.nodes()) car_.power(*node, true);
}

TaxiNetwork::~TaxiNetwork() = default;

/// What they say is what the car and its driver do.
void TaxiNetwork::hear_real_devices() {
  const auto if_real = [this](NodeId id) { return is_played(id) ? NodeId{0} : id; };
  const RealDevices::Wanted wanted = {.gateway = if_real(cia447::gateway_node_id),
                                      .meter = if_real(taximeter_id),
                                      .alarm = if_real(alarm_id)};
  if (!wanted.any()) return;
  if (wanted.gateway != 0) car_.drive().be_led();
  real_.emplace(
      wanted, options_.car_network.nodes.pdo_offsets, options_.car.pulse_counter_max,
      RealDevices::Hands{.meter = [this](cia447::Taximeter state) { real_meter_.says(state); },
                         .alarm = [this] { events_.note(now(), AlarmPressed{}); },
                         .wheels = [this](std::uint32_t pulses) { car_.roll(pulses); }});
  const SlotIndex slot = world_.add_slot(bus_.index(), {.listen_only = true, .accept_all = true});
  world_.occupy(slot, *real_);
  world_.start(slot);
}

void TaxiNetwork::step(Time now) {
  car_.drive().step(Shift::step_time);
  drive(now);
  watch_meter(now);
  shift_.step(now);
  watch_meter(now);
  bus_.touched(taximeter_id);
  referee_.step(now);
  if (tampering_.acts() != 0 && referee_.passengers_see()) tampering_.passengers_see();
  real_meter_.read(now);
  if (shift_.is_over() && shift_.activity() == Activity::off_duty && !is_over_) end_shift(now);
  told_.tell_broken(invariants(),
                    [&](const Invariant& broken) { events_.note(now, InvariantBroken{broken}); });
}

/// Of who is in the car, whatever the meter makes of it.
void TaxiNetwork::drive(Time now) {
  const Activity activity = shift_.activity();
  const bool is_hired = car_.meter().display().state == cia447::Taximeter::hired;
  const bool is_driven = is_hired || activity == Activity::carrying ||
                         activity == Activity::at_lights || activity == Activity::stopping;
  const TripExcuse excused = trips_.excuse(excuse(now));
  if (is_driven) trips_.step(now, car_.drive().metres(), excused);
  const bool is_printing = now <= released_ + car::return_bound;
  if (is_printing && excuses_.is_excused(InvariantKind::receipts, now)) trips_.excuse_receipt();
}

TripExcuse TaxiNetwork::excuse(Time now) {
  return {.fare = excuses_.is_excused(InvariantKind::fare, now),
          .distance = excuses_.is_excused(InvariantKind::distance, now),
          .duration = excuses_.is_excused(InvariantKind::duration, now)};
}

/// The display of a real one is not seen here.
void TaxiNetwork::watch_meter(Time now) {
  if (!is_played(taximeter_id)) return;
  if (const auto total = watch_.look(now, car_.meter().display())) trips_.meter_ended(*total);
}

/// A driver who finds the meter with the passengers of before, since it had no power when they
/// left, clears it first.
bool TaxiNetwork::clear_meter(const MeterKeys& keys) {
  const cia447::Taximeter state = car_.meter().display().state;
  if (state == cia447::Taximeter::hired) keys.stop();
  if (state == cia447::Taximeter::stopped) keys.for_hire();
  return state == cia447::Taximeter::hired || state == cia447::Taximeter::stopped;
}

MeterKeys TaxiNetwork::hands() {
  MeterKeys made = car_.meter().keys();
  if (!is_played(taximeter_id)) return made;
  const MeterKeys keys = made;
  made.hire = [this, keys] { return !clear_meter(keys) && keys.hire(); };
  made.sign_off = [this, keys] { return !clear_meter(keys) && keys.sign_off(); };
  made.for_hire = [this, keys] {
    const bool is_hired = car_.meter().display().state == cia447::Taximeter::hired;
    return is_hired ? keys.stop() && false : keys.for_hire();
  };
  made.add_supplement = [this, keys](std::uint32_t amount) {
    const bool is_added = keys.add_supplement(amount);
    if (is_added) trips_.press_extra(amount);
    return is_added;
  };
  return made;
}

void TaxiNetwork::shift_changed(Time now, Activity from, Activity to) {
  if (from == Activity::signing_on) {
    events_.note(now, ShiftChanged{true});
    car_.log_driver_in();
  }
  if (from == Activity::signing_off) car_.log_driver_out();
  if (to == Activity::off_duty) events_.note(now, ShiftChanged{false});
  if (from == Activity::hiring && to != Activity::waiting) begin_trip(now);
  if (from == Activity::stopping) trips_.stop(now, car_.drive().metres());
  if (from == Activity::paying) pay(now);
  if (from == Activity::releasing) {
    released_ = now;
    print_receipt();
    car_.guidance().arrive();
  }
}

/// The meter obeys when the key is pressed: what it shows is what it then charges for.
void TaxiNetwork::begin_trip(Time now) {
  trips_.begin(now, car_.drive().metres(), is_played(taximeter_id) ? key_time : heard_key_time);
  choose_destination();
  real_meter_.trip_begins();
  // What a real clock shows is not on the bus.
  if (!is_played(driver_id)) trips_.lack_clock();
  if (!is_played(taximeter_id)) trips_.knows_no_extras();
}

/// The driver types it. Where a drive that was recorded ends, nobody has said.
void TaxiNetwork::choose_destination() {
  const car::Drive& drive = car_.drive();
  if (drive.has_record()) return;
  car_.guidance().choose(car::Drive::town_position(drive.metres() + shift_.to_go()));
}

/// The passenger reads the display, adds up fare and extras, and pays what they come to.
void TaxiNetwork::pay(Time now) {
  constexpr std::uint32_t unknown = cia447::TripData::unknown;
  const bool is_real = !is_played(taximeter_id);
  const bool is_lit = is_real ? real_meter_.has_told_trip() : bus_.has_power(taximeter_id);
  const cia447::TripData& display = car_.meter().display().trip;
  const bool is_read = is_lit && display.fare != unknown && display.total != unknown &&
                       display.supplements != unknown;
  std::optional<cia447::TripData> shown;
  if (is_read) shown = display;
  events_.note(now, TripPaid{trips_.pay(now, shown, sabotage_.pocketed)});
}

/// When the trip is over: then it says when that was.
void TaxiNetwork::print_receipt() {
  real_meter_.expect_receipt();
  car_.meter().print_receipt(static_cast<std::uint32_t>(trips_.trips().size()));
}

/// The totals of the shift, and sleep.
void TaxiNetwork::end_shift(Time now) {
  is_over_ = true;
  if (bus_.has_power(taximeter_id)) {
    trips_.judge_income(car_.meter().unit().record().shift.income);
  }
  const bool is_read = is_played(taximeter_id) && is_played(printer_id);
  if (is_read) trips_.judge_receipts(car_.paper().lines());
  real_meter_.ask_for_totals();
  car::SleepPlan plan{.sleep = now + 1min, .wake = now + 20min};
  if (sabotage_.speaks_asleep) plan.stranger_speaks = now + 10min;
  car::plan_sleep(bus_, plan);
}

TaxiSnapshot TaxiNetwork::snapshot() const {
  return {.at = now(),
          .bus = bus_.snapshot(),
          .nodes = bus_.node_snapshots(),
          .names = bus_.names(),
          .meter = car_.meter().display().state,
          .trip = car_.meter().display().trip,
          .driver = shift_.activity(),
          .is_asleep = bus_.all_sleep(),
          .carried = shift_.carried(),
          .paid = trips_.paid() / money_unit,
          .lamps = car_.sign().lamps(),
          .screens = car_.screens().both(),
          .paper = car_.paper().last_lines(paper_lines),
          .metres = car_.drive().metres(),
          .speed = car_.drive().speed()};
}

bool TaxiNetwork::all_hold() const {
  return std::ranges::all_of(invariants(), &Invariant::held);
}

}  // namespace canvoy::taxi
