// A shift of a taxi in a simulated world: the car and its IVN gateway, the add-on devices that the
// gateway assigns node-IDs to and starts, a driver, passengers, faults by plan, and referees.
//
//     TaxiOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .start = Time(20min), .node = 2}};
//     TaxiNetwork network(options);
//     network.run_until(Time(12h));
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// The shift begins when the network is up, and ends an hour before the end; then the driver has the
// network sent to sleep, and woken once more. The same options give the same frames at the same
// times.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/told_invariants.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/taxi/meter_watch.hpp"
#include "canvoy/worlds/taxi/real_devices.hpp"
#include "canvoy/worlds/taxi/real_meter.hpp"
#include "canvoy/worlds/taxi/shift.hpp"
#include "canvoy/worlds/taxi/taxi_car.hpp"
#include "canvoy/worlds/taxi/taxi_event.hpp"
#include "canvoy/worlds/taxi/taxi_faults.hpp"
#include "canvoy/worlds/taxi/taxi_options.hpp"
#include "canvoy/worlds/taxi/taxi_referee.hpp"
#include "canvoy/worlds/taxi/taxi_snapshot.hpp"
#include "canvoy/worlds/taxi/trip_book.hpp"

namespace canvoy::taxi {

class TaxiNetwork {
 public:
  /// Makes all devices that are simulated here, and gives them power at time 0.
  explicit TaxiNetwork(TaxiOptions options);
  ~TaxiNetwork();
  TaxiNetwork(const TaxiNetwork&) = delete;
  TaxiNetwork& operator=(const TaxiNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until) { world_.run_until(until); }
  /// Time since the start of the run.
  Time now() const { return world_.now(); }

  /// State at present, for a drawing.
  TaxiSnapshot snapshot() const;
  /// All events since the start, oldest first.
  std::span<const TaxiEvent> events() const { return events_.all(); }
  /// All paid trips, the oldest first.
  std::span<const Trip> trips() const { return trips_.trips(); }
  /// Verdicts at present.
  std::vector<Invariant> invariants() const { return referee_.verdicts(); }
  /// True if no invariant is broken.
  bool all_hold() const;

  // Access for tests, and for tools that take part.
  /// Failures that the referees must detect; they may be set at any time.
  Sabotage& sabotage() { return sabotage_; }
  /// The world of the bus; time passes only in run_until().
  World& world() { return world_; }
  /// The taximeter, for hands from outside; made again when it gets power.
  cia447::TaximeterUnit& meter() { return car_.meter().unit(); }
  /// The gateway; made again when it gets power.
  cia447::IvnGatewayUnit& gateway() { return car_.gateway(); }
  /// The navigation system; made again when it gets power.
  cia447::NavigationUnit& navigation() { return car_.guidance().navigation(); }
  /// Motion of the car.
  car::Drive& drive() { return car_.drive(); }
  /// Device with a node-ID, which must exist.
  car::CarNode& node(NodeId id) { return bus_.node(id); }
  /// All devices, in the order of their node-IDs.
  std::span<const std::unique_ptr<car::CarNode>> nodes() const { return bus_.nodes(); }
  /// Options that it was made with.
  const TaxiOptions& options() const { return options_; }
  /// Notes an action by hand from outside.
  void note_hand(Time now, const HandActed& acted) { events_.note(now, acted); }
  /// Text on the printer's paper.
  PaperText& paper() { return car_.paper(); }

 private:
  void hear_real_devices();
  void step(Time now);
  void shift_changed(Time now, Activity from, Activity to);
  void tell_passengers(Time now, Activity from, Activity to);
  void tell_key(Time now, Activity to);
  MeterKeys hands();
  bool clear_meter(const MeterKeys& keys);
  TripExcuse excuse(Time now);
  void watch_meter(Time now);
  void drive(Time now);
  void begin_trip(Time now);
  void choose_destination();
  void pay(Time now);
  void print_papers(Activity from);
  void watch_shift(Time now);
  void judge_slip(std::size_t first_line);
  PaperTruth paper_truth() const;
  void end_shift(Time now);
  void meter_recorded(const cia447::AuditEntry& entry) { tampering_.recorded(entry); }
  bool is_played(NodeId id) const { return bus_.is_played(id); }

  TaxiOptions options_;
  Sabotage sabotage_;
  World world_;
  EventLog<TaxiEvent> events_;
  car::CarBus bus_;
  TaxiCar car_;
  Shift shift_;
  TripBook trips_;
  RealMeter real_meter_;
  std::optional<RealDevices> real_;
  MeterWatch watch_;
  TaxiExcuses excuses_;
  TamperWatch tampering_;
  TaxiFaults faults_;
  TaxiReferee referee_;
  ToldInvariants<invariant_kinds> told_;
  Time released_{};       ///< last time that the driver cleared the meter
  bool is_over_ = false;  ///< the shift is over, and its totals are judged
  DrivenShift driven_{};  ///< times in the shift; metres from the start, until it ends
  /// True: no fault may have affected the shift or its slip.
  bool is_whole_ = true;
};

}  // namespace canvoy::taxi
