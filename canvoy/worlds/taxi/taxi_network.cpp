#include "canvoy/worlds/taxi/taxi_network.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"
#include "canvoy/worlds/car/sleep_plan.hpp"

namespace canvoy::taxi {

namespace {

constexpr unsigned status_pdo_of_meter = 80;
constexpr unsigned status_pdo_of_alarm = 71;
/// Offset of 6055h in PDO 17, and its length.
constexpr std::size_t wheel_count_place = 4;
constexpr std::size_t wheel_pdo_length = 7;

std::uint32_t can_id_of(NodeId node, unsigned pdo_number, const cia447::PdoOffsets& offsets) {
  for (std::size_t i = 0; node != 0 && i < cia447::predefined.size(); ++i) {
    if (cia447::predefined[i].number == pdo_number) return cia447::pdo_base(node) + offsets[i];
  }
  return 0;
}

/// A field of the object with the first byte `bytes[0]`, within that byte.
template <class Handle>
unsigned field_of(std::uint8_t byte, const Handle& handle) {
  const cia447::FieldPlace place = cia447::place_of(handle);
  return byte >> place.first_bit & ((1U << place.bits) - 1);
}

}  // namespace

RealDevices::RealDevices(const Wanted& wanted, const cia447::PdoOffsets& offsets,
                         std::uint16_t pulse_counter_max, Hands hands)
    : hands_(std::move(hands)),
      meter_id_(can_id_of(wanted.meter, status_pdo_of_meter, offsets)),
      alarm_id_(can_id_of(wanted.alarm, status_pdo_of_alarm, offsets)),
      wheels_id_(can_id_of(wanted.gateway, cia447::wheel_pdo_number, offsets)),
      counts_(pulse_counter_max + 1U) {}

void RealDevices::receive(const Frame& frame, Time) {
  if (frame.is_remote() || frame.is_extended() || frame.id == 0 || frame.length == 0) return;
  if (frame.id == meter_id_) {
    hands_.meter(static_cast<cia447::Taximeter>(field_of(frame.data[0], cia447::taximeter_status)));
  } else if (frame.id == alarm_id_) {
    const auto key = static_cast<cia447::Signal>(
        field_of(frame.data[0], cia447::taxi_alarm_system_status_silent_activated));
    const bool was_pressed = std::exchange(is_pressed_, key == cia447::Signal::yes);
    if (is_pressed_ && !was_pressed) hands_.alarm();
  } else if (frame.id == wheels_id_) {
    hear_wheels(frame);
  }
}

/// A counter that restarts has no information about the time before.
void RealDevices::hear_wheels(const Frame& frame) {
  if (frame.length < wheel_pdo_length) return;
  const auto count = load<std::uint16_t>(frame.data.data() + wheel_count_place);
  const auto valid = static_cast<cia447::Signal>(frame.data[wheel_count_place + 2] & 3U);
  if (valid != cia447::Signal::yes) return count_.reset();
  const std::optional<std::uint16_t> before = std::exchange(count_, count);
  if (before && count < counts_) hands_.wheels((count + counts_ - *before) % counts_);
}

namespace {

constexpr std::size_t paper_lines = 4;  ///< lines that hang out of the printer
/// The meter processes the driver's key in its next cycle.
constexpr Duration key_time = 1s;
/// The key of a real meter takes effect here when its state comes over the bus, which may take some
/// time while this machine is busy.
constexpr Duration heard_key_time = 5s;
/// By then, a paper is out of the printer.
constexpr Duration printing = 30s;

ShiftOptions shift_options(const TaxiOptions& options) {
  ShiftOptions made = options.shift;
  // A person at a real meter takes time for each action.
  const bool has_hands = std::ranges::find(options.real, taximeter_id) != options.real.end();
  if (has_hands) made.presses_max = UINT32_MAX;
  if (has_hands) made.break_after = options.length;  // that person gets no report of it
  constexpr Duration evening = 1h;                   // for the way home, sleep and waking
  made.end = Time{} + std::max<Duration>(options.length - evening, options.length / 2);
  return made;
}

car::CarBus::Settings bus_settings(const TaxiOptions& options) {
  return {.bit_rate = options.bit_rate,
          .seed = options.faults.seed,
          .names = device_names,
          .serial_numbers = 1000,
          .real = options.real,
          .identities = options.identities,
          .time_out = options.car_network.nodes.time_out,
          .master = options.car_network.master};
}

}  // namespace

TaxiNetwork::TaxiNetwork(TaxiOptions options)
    : options_(std::move(options)),
      bus_(world_, bus_settings(options_),
           [this](Time now, const BusEvent& heard) { events_.hear(now, heard); }),
      car_(bus_, options_, sabotage_, events_),
      shift_(shift_options(options_), options_.faults.seed, car_.drive(), hands()),
      trips_(options_.tariff_of_town, {local_seconds(options_.begin), options_.zone}),
      real_meter_(car_, trips_),
      watch_(options_.meter.longest_power_cut),
      faults_(car_, options_.faults, trips_, watch_, excuses_, tampering_, events_),
      referee_(car_, options_, shift_, trips_, watch_, excuses_, tampering_) {
  car_.meter().on_recorded(callback<&TaxiNetwork::meter_recorded>(*this));
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
  world_.add_plant(callback<&TaxiNetwork::step>(*this), Shift::step_time);
  faults_.plan();
  world_.at(Time{} + std::min(options_.alarm, options_.length / 3), [this](Time now) {
    if (car_.press_alarm()) events_.note(now, AlarmPressed{});
  });
  for (const auto& node : bus_.nodes()) car_.power(*node, true);
}

TaxiNetwork::~TaxiNetwork() = default;

/// The car and its driver follow the reports of real devices.
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
  watch_shift(now);
  watch_meter(now);
  shift_.step(now);
  watch_meter(now);
  car_.meter().step();
  bus_.touched(taximeter_id);
  referee_.step(now);
  if (tampering_.acts() != 0 && referee_.passengers_see()) tampering_.passengers_see();
  real_meter_.read(now);
  if (shift_.is_over() && shift_.activity() == Activity::off_duty && !is_over_) end_shift(now);
  told_.report_broken(invariants(),
                      [&](const Invariant& broken) { events_.note(now, InvariantBroken{broken}); });
}

/// For the passengers in the car, whatever the state of the meter.
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

/// The display of a real meter cannot be seen here.
void TaxiNetwork::watch_meter(Time now) {
  if (!is_played(taximeter_id)) return;
  const cia447::TaximeterDisplay& display = car_.meter().display();
  if (const auto total = watch_.look(now, display)) trips_.meter_ended(*total);
  const bool has_fare =
      display.state == cia447::Taximeter::hired && display.trip.fare != cia447::TripData::unknown;
  if (has_fare) trips_.look(now, display.trip.fare);
}

/// A driver who finds the meter with the previous passengers, since it had no power when they left,
/// clears it first.
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
  made.charge = [this, keys](unsigned kind) {
    const bool is_added = keys.charge(kind);
    if (is_added) trips_.press_extra(kind);
    return is_added;
  };
  made.clear_supplements = [this, keys] {
    const bool is_cleared = keys.clear_supplements();
    if (is_cleared) trips_.clear_extras();
    return is_cleared;
  };
  made.agree_price = [this, keys](std::uint32_t price) {
    const bool is_agreed = keys.agree_price(price);
    if (is_agreed) trips_.agree(price);
    return is_agreed;
  };
  return made;
}

void TaxiNetwork::shift_changed(Time now, Activity from, Activity to) {
  if (from == Activity::signing_on) {
    driven_ = {.begin = now, .metres = car_.drive().metres()};
    events_.note(now, ShiftChanged{true});
    car_.log_driver_in();
  }
  if (from == Activity::signing_off) car_.log_driver_out();
  if (to == Activity::off_duty) events_.note(now, ShiftChanged{false});
  if (from == Activity::hiring && to != Activity::waiting) begin_trip(now);
  if (from == Activity::stopping) trips_.stop(now, car_.drive().metres());
  if (from == Activity::paying) pay(now);
  report_passengers(now, from, to);
  if (!is_played(taximeter_id)) report_key(now, to);
  if (from == Activity::releasing) {
    released_ = now;
    car_.guidance().arrive();
  }
  print_papers(from);
}

void TaxiNetwork::report_passengers(Time now, Activity from, Activity to) {
  using enum PassengersSeen::Doing;
  if (to == Activity::boarding) events_.note(now, PassengersSeen{get_in});
  if (to == Activity::unmet) events_.note(now, PassengersSeen{stay_away});
  if (from == Activity::paying) events_.note(now, PassengersSeen{get_out});
  if (from == Activity::hiring && to == Activity::waiting) {
    events_.note(now, PassengersSeen{walk_away});
  }
}

/// The key is pressed outside of this world.
void TaxiNetwork::report_key(Time now, Activity to) {
  using cia447::Taximeter;
  constexpr std::pair<Activity, Taximeter> keys[] = {
      {Activity::signing_on, Taximeter::for_hire},
      {Activity::hiring, Taximeter::hired},
      {Activity::stopping, Taximeter::stopped},
      {Activity::releasing, Taximeter::for_hire},
      {Activity::signing_off, Taximeter::signed_off}};
  const auto* const key = std::ranges::find(keys, to, &std::pair<Activity, Taximeter>::first);
  if (key != std::end(keys)) events_.note(now, MeterWaitedFor{key->second});
}

/// The meter obeys when the key is pressed: it charges by what it shows then.
void TaxiNetwork::begin_trip(Time now) {
  trips_.begin(now, car_.drive().metres(), is_played(taximeter_id) ? key_time : heard_key_time);
  choose_destination();
  real_meter_.trip_begins();
  // The time of a real clock is not on the bus.
  if (!is_played(driver_id)) trips_.lack_clock();
  if (!is_played(taximeter_id)) trips_.knows_no_extras();
}

/// The driver enters it. The end of a recorded drive is unknown.
void TaxiNetwork::choose_destination() {
  const car::Drive& drive = car_.drive();
  if (drive.has_record()) return;
  car_.guidance().choose(car::Drive::town_position(drive.metres() + shift_.to_go()));
}

/// The passenger reads the display, adds fare and extras, and pays the sum.
void TaxiNetwork::pay(Time now) {
  constexpr std::uint32_t unknown = cia447::TripData::unknown;
  const bool is_real = !is_played(taximeter_id);
  const bool is_lit = is_real ? real_meter_.has_told_trip() : bus_.has_power(taximeter_id);
  const cia447::TripData& display = car_.meter().display().trip;
  const bool is_read = is_lit && display.fare != unknown && display.total != unknown &&
                       display.supplements != unknown;
  std::optional<cia447::TripData> shown;
  if (is_read) shown = display;
  const Payment payment = {.pocketed = sabotage_.pocketed, .is_by_card = shift_.pays_by_card()};
  events_.note(now, TripPaid{trips_.pay(now, shown, payment)});
}

/// Prints a receipt after the trip, so that it has the time of its end; and a slip after the shift.
void TaxiNetwork::print_papers(Activity from) {
  if (from == Activity::releasing) {
    real_meter_.expect_receipt();
    if (tampering_.acts() != 0) world_.at(now() + printing, [this](Time) { read_receipts(); });
    car_.meter().print_receipt(
        static_cast<std::uint32_t>(trips_.trips().size()),
        trips_.trips().back().is_by_card != sabotage_.swaps_payment ? "card" : "cash");
  } else if (from == Activity::signing_off) {
    driven_.end = now();
    driven_.metres = car_.drive().metres() - driven_.metres;
    if (bus_.has_power(taximeter_id)) car_.meter().print_slip();
  }
}

PaperTruth TaxiNetwork::paper_truth() const {
  return {.clock = {local_seconds(options_.begin), options_.zone},
          .tariff = options_.tariff_of_town,
          .currency = options_.currency_of_town,
          .taxi = options_.business.taxi,
          .company = options_.business.company,
          .driver = options_.business.driver,
          .vat_percent = options_.business.vat_percent};
}

/// A fault may affect the shift, or at the end its slip.
void TaxiNetwork::watch_shift(Time now) {
  const bool is_on = shift_.activity() != Activity::off_duty || is_over_;
  const bool is_excused =
      is_over_ ? excuses_.is_excused(InvariantKind::shift_slip, now) : excuse(now).any();
  if (is_on && is_excused) is_whole_ = false;
}

/// The driver has had time to take it from the printer.
void TaxiNetwork::judge_slip(std::size_t first_line) {
  if (!is_whole_ || !trips_.all_were_read()) return;
  const std::span<const std::string> lines = car_.paper().lines();
  trips_.judge_slip(lines.subspan(std::min(first_line, lines.size())), paper_truth(), driven_);
}

/// Passengers read their receipt when they get it, not at the end of the shift.
void TaxiNetwork::read_receipts() {
  if (!is_played(taximeter_id) || !is_played(printer_id)) return;
  const auto read = judge_receipts(car_.paper().lines(), trips_.trips(), paper_truth());
  if (read.wrong_lines != 0) tampering_.passengers_see();
}

/// Judges the totals of the shift, and sends the network to sleep.
void TaxiNetwork::end_shift(Time now) {
  is_over_ = true;
  if (bus_.has_power(taximeter_id)) {
    trips_.judge_income(car_.meter().unit().record().shift.income);
  }
  const bool is_read = is_played(taximeter_id) && is_played(printer_id);
  if (is_read) trips_.judge_receipts(car_.paper().lines(), paper_truth());
  if (is_read && is_played(driver_id) && is_played(cia447::gateway_node_id)) {
    world_.at(now + printing,
              [this, first = car_.paper().lines().size()](Time) { judge_slip(first); });
  }
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
