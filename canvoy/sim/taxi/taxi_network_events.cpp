// What happens in the car, on its bus and at its meter: noted, and judged.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "canvoy/devices/cia447/taximeter/receipt.hpp"

#include "canvoy/sim/taxi/taxi_network.hpp"

namespace canvoy::taxi {

namespace {

/// The driver's key is worked off in the meter's next turn.
constexpr Duration key_time = 1s;
/// Of a real one the key is heard of when its state comes over the bus, and while this machine is
/// busy that may take some time.
constexpr Duration heard_key_time = 5s;

}  // namespace

void TaxiNetwork::step(Time now) {
  drive_.step(Shift::step_time);
  if (display_.state == cia447::Taximeter::hired) fares_.step(now, drive_.metres());
  shift_.step(now);
  world_.touched(taximeter_id - SlotIndex{1});
  judge_service(now);
  judge_devices(now);
  judge_sign(now);
  read_trip(now);
  judge_terminal(now);
  if (shift_.is_over() && shift_.activity() == Activity::off_duty && !is_over_) end_of_shift(now);
  check(now);
}

void TaxiNetwork::shift_changed(Time now, Activity from, Activity to) {
  if (from == Activity::signing_on) {
    note(now, ShiftChanged{true});
    if (node(driver_id).is_powered()) driver_reader_->log_in({.id = 4711, .name = "A. Driver"});
    world_.touched(driver_id - SlotIndex{1});
  }
  if (from == Activity::signing_off && node(driver_id).is_powered()) {
    driver_reader_->log_out();
    world_.touched(driver_id - SlotIndex{1});
  }
  if (to == Activity::off_duty) note(now, ShiftChanged{false});
  // The meter obeys when the key is pressed: what it shows is what it then charges for.
  if (from == Activity::hiring && to != Activity::waiting) {
    const bool is_heard = is_real(taximeter_id);
    fares_.hired(now, drive_.metres(), is_heard ? heard_key_time : key_time);
    choose_destination();
    lines_before_trip_ = paper_.lines().size();
    if (now < excused_until_ || faults_present_ != 0) fares_.disturb();
    // What a real clock shows is not on the bus.
    if (is_real(driver_id)) fares_.disturb();
  }
  if (from == Activity::stopping) fares_.stopped(now, drive_.metres());
  if (from == Activity::paying) pay(now);
  if (from == Activity::releasing) {
    print_receipt();
    arrive();
  }
}

/// The passenger reads the display, and pays.
void TaxiNetwork::pay(Time now) {
  cia447::TripData shown = display_.trip;
  if (is_real(taximeter_id) && !is_trip_read_) {
    fares_.disturb();
    shown.distance = shown.duration = shown.fare = shown.total = 0;
  }
  Trip trip = fares_.paid(now, shown);
  // Without a display nobody knows what to pay: the driver lets them go.
  if (!is_trip_read_ && !node(taximeter_id).is_powered()) trip.paid = 0;
  trip.paid += sabotage_.pocketed;
  paid_ += trip.paid;
  trips_.push_back(trip);
  note(now, TripPaid{trip});
}

/// When the trip is over: then it says when that was. A real meter prints by itself.
void TaxiNetwork::print_receipt() {
  constexpr Duration in_time = 20s;
  if (is_real(taximeter_id) && !trips_.empty() && !trips_.back().is_disturbed) {
    world_.at(now() + in_time, [this, paid = trips_.back().paid, first = lines_before_trip_](Time) {
      look_for_receipt(paid, first);
    });
  }
  if (!outputs_) return;
  const cia447::Receipt receipt(display_.trip, {.number = static_cast<std::uint32_t>(trips_.size()),
                                                .taxi = "M-TX 447",
                                                .currency = options_.meter.currency,
                                                .distance_unit = options_.meter.distance_unit});
  outputs_->print(receipt.text());
}

/// A silent alarm, which the driver ends by himself.
void TaxiNetwork::press_alarm(Time now) {
  if (!node(alarm_id).is_powered()) return;
  alarm_->press_key(true);
  alarm_->press_key(false);
  note(now, AlarmPressed{});
  world_.touched(alarm_id - SlotIndex{1});
  world_.at(now + 1min, [this](Time) {
    if (!node(alarm_id).is_powered()) return;
    alarm_->reset_alarm();
    world_.touched(alarm_id - SlotIndex{1});
  });
}

/// Nothing has happened but that a device lacked what it works with.
bool TaxiNetwork::is_only_local() const {
  return std::ranges::all_of(options_.faults.faults,
                             [](const ScheduledFault& fault) { return is_local(fault.kind); });
}

/// What is read on each receipt against what was paid, in 0,001 of the currency unit. Of those that
/// wait for paper the meter keeps the last one only: with such a fault some may be missing.
double TaxiNetwork::receipts_error() const {
  constexpr std::string_view number_word = "Receipt ";
  constexpr std::string_view total_word = "TOTAL";
  std::map<std::size_t, double> totals;  // by the number of the trip
  std::size_t number = 0;
  for (const std::string& line : paper_.lines()) {
    if (line.starts_with(number_word)) number = std::stoul(line.substr(number_word.size()));
    if (!line.starts_with(total_word)) continue;
    totals[number] = std::round(std::stod(line.substr(total_word.size())) * money_unit);
  }
  const bool may_lack = !options_.faults.faults.empty();
  double error = 0;
  for (std::size_t trip = 1; trip <= trips_.size(); ++trip) {
    const auto printed = totals.extract(trip);
    if (printed.empty() && may_lack) continue;
    error += std::abs((printed.empty() ? 0 : printed.mapped()) - trips_[trip - 1].paid);
  }
  for (const auto& [no_trip, total] : totals) error += total;
  return error;
}

/// Who stands at the road sees whether the taxi is vacant.
void TaxiNetwork::judge_sign(Time now) {
  const bool is_vacant = display_.state == cia447::Taximeter::for_hire;
  const bool can_be_seen = node(sign_id).is_powered() && node(taximeter_id).is_powered();
  const bool sleeps = node(sign_id).device().sleep().state() != cia447::SleepState::awake;
  if (is_excused(now) || !can_be_seen || sleeps || vacant_light_ == is_vacant) {
    sign_is_right_at_ = now;
  }
  sign_was_wrong_ = std::max(sign_was_wrong_, now - sign_is_right_at_);
}

void TaxiNetwork::show(const cia447::TaximeterDisplay& display) {
  const Time now = world_.now();
  if (display.state != display_.state) note(now, MeterChanged{display.state});
  const bool is_hired = display.state == cia447::Taximeter::hired;
  if (is_hired && display.trip.level != display_.trip.level) {
    note(now, TariffChanged{display.trip.level});
  }
  display_ = display;
  if (outputs_) outputs_->show(display);
  if (fare_display_ != nullptr) fare_display_->show(display);
}

void TaxiNetwork::car_event(const cia447::CarEvent& event) {
  note(world_.now(), car::NetworkChanged{event});
}

void TaxiNetwork::heard(Time now, const BusEvent& event) {
  std::visit([&](const auto& seen) { note(now, seen); }, event);
}

bool TaxiNetwork::all_sleep() const {
  return std::ranges::all_of(nodes_, [](const std::unique_ptr<car::CarNode>& node) {
    return !node->is_powered() || node->device().sleep().state() == cia447::SleepState::asleep;
  });
}

/// A frame that was under way when the last one fell asleep is not one of those; nor is that by
/// which the first one wakes the others up.
void TaxiNetwork::frame_sent() {
  if (!is_asleep_ || !all_sleep() || is_excused(world_.now())) return;
  ++frames_asleep_;
}

bool TaxiNetwork::is_excused(Time now) const {
  return faults_present_ != 0 || now < excused_until_ || waits_for_real_;
}
bool TaxiNetwork::is_excused_all_along() const {
  return std::ranges::any_of(options_.faults.faults, [](const ScheduledFault& fault) {
    return fault.end() == never && !is_local(fault.kind);
  });
}

/// Who wants to ride or to pay, and the meter does not obey.
void TaxiNetwork::judge_service(Time now) {
  const Activity activity = shift_.activity();
  const bool waits = activity == Activity::hiring || activity == Activity::stopping ||
                     activity == Activity::releasing || activity == Activity::signing_on;
  // What the meter has lost of a trip, the driver cannot stop; nobody pays for it twice.
  const bool is_lost = fares_.is_disturbed() || (!trips_.empty() && trips_.back().is_disturbed &&
                                                 activity == Activity::releasing);
  // The keys of a real meter are out of the driver's reach.
  const bool has_keys = node(taximeter_id).place().is_played;
  if (!waits || !has_keys || is_lost || is_excused(now)) waiting_since_ = now;
  waited_ = std::max(waited_, now - waiting_since_);
}

/// As far as can be known of one that is not played.
bool TaxiNetwork::is_at_work(car::CarNode& node) {
  return canvoy::is_at_work(world_, node, bus_watch_, options_.car_network.nodes.time_out);
}

/// After each kind of return a device is operational again in time.
void TaxiNetwork::judge_devices(Time now) {
  const auto does_work = [this](car::CarNode& node) { return is_at_work(node); };
  waits_for_real_ = waits_for_real_ && car::waits_for_real(nodes_, now, does_work);
  const bool sleeps = std::ranges::any_of(nodes_, [](const std::unique_ptr<car::CarNode>& node) {
    return node->is_powered() && node->device().sleep().state() != cia447::SleepState::awake;
  });
  is_asleep_ = sleeps && all_sleep();
  for (const auto& node : nodes_) {
    Time& since = missing_since_.at(node->place().id);
    if (sleeps || is_excused(now) || is_at_work(*node)) since = now;
    missing_ = std::max(missing_, now - since);
  }
}

/// The totals of the shift, and sleep: then somebody opens a door, and the network wakes up.
void TaxiNetwork::end_of_shift(Time now) {
  is_over_ = true;
  const double income = meter_->record().shift.income;
  const bool is_judged = is_only_local() && node(taximeter_id).is_powered();
  if (is_judged) totals_error_ = std::abs(income - paid_);
  if (is_judged && !is_real(printer_id)) receipts_error_ = receipts_error();
  if (is_real(taximeter_id)) ask_for_totals();
  world_.at(now + 1min, [this](Time) {
    cia447::CarMaster* master = gateway_master();
    if (master != nullptr && !is_real(cia447::gateway_node_id)) master->send_to_sleep();
    world_.touched(0);
  });
  if (sabotage_.speaks_asleep) {
    const ControllerId stranger = world_.bus(bus_).attach({});
    world_.at(now + 10min, [this, stranger](Time) {
      world_.bus(bus_).send(stranger, {.id = 0x7DF, .length = 8});
    });
  }
  world_.at(now + 20min, [this](Time) {
    cia447::CarMaster* master = gateway_master();
    if (master != nullptr && !is_real(cia447::gateway_node_id)) master->wake_up();
    world_.touched(0);
  });
}

/// Tells of each invariant once that it is broken, when it is.
void TaxiNetwork::check(Time now) {
  for (const Invariant& invariant : invariants()) {
    bool& told = told_.at(static_cast<std::size_t>(invariant.kind));
    if (invariant.held || std::exchange(told, true)) continue;
    note(now, InvariantBroken{invariant});
  }
}

}  // namespace canvoy::taxi
