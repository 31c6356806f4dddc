// What happens in the car, on its bus and at its meter: noted, and judged.
#include <algorithm>
#include <utility>

#include "canvoy/sim/taxi/taxi_network.hpp"

namespace canvoy::taxi {

void TaxiNetwork::step(Time now) {
  drive_.step(Shift::step_time);
  if (display_.state == cia447::Taximeter::hired) fares_.step(now, drive_.metres());
  shift_.step(now);
  world_.touched(taximeter_id - SlotIndex{1});
  judge_service(now);
  judge_devices(now);
  if (shift_.is_over() && shift_.activity() == Activity::off_duty && !is_over_) end_of_shift(now);
  check(now);
}

void TaxiNetwork::shift_changed(Time now, Activity from, Activity to) {
  if (from == Activity::signing_on) note(now, ShiftChanged{true});
  if (to == Activity::off_duty) note(now, ShiftChanged{false});
  // The meter obeys when the key is pressed: what it shows is what it then charges for.
  if (from == Activity::hiring) {
    fares_.hired(now, drive_.metres());
    if (now < excused_until_ || faults_present_ != 0) fares_.disturb();
  }
  if (from == Activity::stopping) fares_.stopped(now, drive_.metres());
  if (from == Activity::paying) pay(now);
}

/// The passenger reads the display, and pays.
void TaxiNetwork::pay(Time now) {
  Trip trip = fares_.paid(now, display_.trip);
  // Without a display nobody knows what to pay: the driver lets them go.
  if (!node(taximeter_id).is_powered()) trip.paid = 0;
  paid_ += trip.paid;
  trips_.push_back(trip);
  note(now, TripPaid{trip});
}

void TaxiNetwork::show(const cia447::TaximeterDisplay& display) {
  const Time now = world_.now();
  if (display.state != display_.state) note(now, MeterChanged{display.state});
  const bool is_hired = display.state == cia447::Taximeter::hired;
  if (is_hired && display.trip.level != display_.trip.level) {
    note(now, TariffChanged{display.trip.level});
  }
  display_ = display;
}

void TaxiNetwork::car_event(const cia447::CarEvent& event) {
  note(world_.now(), NetworkChanged{event});
}

void TaxiNetwork::heard(Time now, const BusEvent& event) {
  std::visit([&](const auto& seen) { note(now, seen); }, event);
}

bool TaxiNetwork::all_sleep() const {
  return std::ranges::all_of(nodes_, [](const std::unique_ptr<TaxiNode>& node) {
    return !node->is_powered() || node->device().sleep().state() == cia447::SleepState::asleep;
  });
}

/// A frame that was under way when the last one fell asleep is not one of those.
void TaxiNetwork::frame_sent() {
  if (!is_asleep_ || is_excused(world_.now())) return;
  ++frames_asleep_;
}

bool TaxiNetwork::is_excused(Time now) const {
  return faults_present_ != 0 || now < excused_until_;
}
bool TaxiNetwork::is_excused_all_along() const {
  return std::ranges::any_of(options_.faults.faults,
                             [](const ScheduledFault& fault) { return fault.end() == never; });
}

/// Who wants to ride or to pay, and the meter does not obey.
void TaxiNetwork::judge_service(Time now) {
  const Activity activity = shift_.activity();
  const bool waits = activity == Activity::hiring || activity == Activity::stopping ||
                     activity == Activity::releasing || activity == Activity::signing_on;
  if (!waits || is_excused(now)) waiting_since_ = now;
  waited_ = std::max(waited_, now - waiting_since_);
}

/// After each kind of return a device is operational again in time.
void TaxiNetwork::judge_devices(Time now) {
  const bool sleeps = std::ranges::any_of(nodes_, [](const std::unique_ptr<TaxiNode>& node) {
    return node->is_powered() && node->device().sleep().state() != cia447::SleepState::awake;
  });
  is_asleep_ = sleeps && all_sleep();
  for (const auto& node : nodes_) {
    Time& since = missing_since_.at(node->place().id);
    const bool is_real = !node->place().is_played;
    if (is_real || sleeps || is_excused(now) || node->is_operational()) since = now;
    missing_ = std::max(missing_, now - since);
  }
}

/// The totals of the shift, and sleep: then somebody opens a door, and the network wakes up.
void TaxiNetwork::end_of_shift(Time now) {
  is_over_ = true;
  const double income = meter_->record().shift.income;
  const bool is_judged = options_.faults.faults.empty() && node(taximeter_id).is_powered();
  if (is_judged) totals_error_ = std::abs(income - paid_);
  world_.at(now + 1min, [this](Time) {
    if (cia447::CarMaster* master = gateway_master()) master->send_to_sleep();
    world_.touched(0);
  });
  world_.at(now + 20min, [this](Time) {
    if (cia447::CarMaster* master = gateway_master()) master->wake_up();
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
