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

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/sim/told_invariants.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/taxi/meter_watch.hpp"
#include "canvoy/worlds/taxi/real_meter.hpp"
#include "canvoy/worlds/taxi/shift.hpp"
#include "canvoy/worlds/taxi/taxi_car.hpp"
#include "canvoy/worlds/taxi/taxi_event.hpp"
#include "canvoy/worlds/taxi/taxi_faults.hpp"
#include "canvoy/worlds/taxi/taxi_options.hpp"
#include "canvoy/worlds/taxi/taxi_referee.hpp"
#include "canvoy/worlds/taxi/terminal_screens.hpp"
#include "canvoy/worlds/taxi/trip_book.hpp"

namespace canvoy::taxi {

/// Reports of the real devices of a taxi on its bus, for the hardware behind them in the simulated
/// car: a real node has the meter, the alarm key or the wheels that count.
///
///     RealDevices real({.meter = 2}, hands);
///     world.occupy(slot, real);   // it hears all frames of the bus
///
/// They are read at the pre-defined CAN-IDs of their node-IDs.
class RealDevices {
 public:
  /// The node-IDs of real devices; 0: the device is simulated here.
  struct Wanted {
    NodeId gateway = 0;  ///< IVN gateway: the wheels
    NodeId meter = 0;    ///< taximeter
    NodeId alarm = 0;    ///< taxi alarm system

    /// True if any device is real.
    bool any() const { return gateway != 0 || meter != 0 || alarm != 0; }
  };
  /// Functions that receive the reports. None may be empty.
  struct Hands {
    /// State of the meter, 60D0h:01h.
    std::function<void(cia447::Taximeter)> meter{};
    /// The alarm key is pressed.
    std::function<void()> alarm{};
    /// Pulses of the wheels since the last call.
    std::function<void(std::uint32_t pulses)> wheels{};
  };

  /// `pulse_counter_max` is that of CarSettings.
  RealDevices(const Wanted& wanted, const cia447::PdoOffsets& offsets,
              std::uint16_t pulse_counter_max, Hands hands);

  // Required of a node by World. Sends nothing.
  /// Has nothing to do.
  void start(Time) {}
  /// Takes a frame of the bus.
  void receive(const Frame& frame, Time);
  /// Has nothing to do.
  void advance(Time) {}
  /// There is none.
  Time deadline() const { return never; }
  /// Has nothing to do.
  void bus_state(BusState, Time) {}
  /// Has nothing to do.
  void tx_ready(Time) {}
  /// Has nothing to do.
  void overrun(Time) {}

 private:
  void hear_wheels(const Frame& frame);

  Hands hands_;
  std::uint32_t meter_id_ = 0;  ///< CAN-IDs; 0: none is read
  std::uint32_t alarm_id_ = 0;
  std::uint32_t wheels_id_ = 0;
  std::uint32_t counts_;  ///< of the wheel pulse counter
  std::optional<std::uint16_t> count_;
  bool is_pressed_ = false;
};

// State of a taxi at one instant: its bus and devices, meter, driver, lights, displays and paper,
// and the true distance of the car.
//
//     const TaxiSnapshot look = network.snapshot();
//     print(look.screens[0].text);

/// State of everything.
struct TaxiSnapshot {
  Time at{};                            ///< since the start of the run
  BusSnapshot bus;                      ///< of the car, with its load since the start
  std::vector<NodeSnapshot> nodes;      ///< in the order of their node-IDs
  std::vector<std::string_view> names;  ///< of the nodes

  cia447::Taximeter meter = cia447::Taximeter::signed_off;     ///< state of the taximeter
  cia447::TripData trip;                                       ///< as the meter shows it
  Activity driver = Activity::off_duty;                        ///< what the driver does
  bool is_asleep = false;                                      ///< all devices sleep
  unsigned carried = 0;                                        ///< trips that were paid
  double paid = 0;                                             ///< total in currency units
  std::array<cia447::Lamp, cia447::tariff_lamps_max> lamps{};  ///< on the roof, from lamp 1 on
  std::array<Screen, 2> screens;                               ///< of the terminal
  std::vector<std::string> paper;                              ///< its last lines

  // true values
  double metres = 0;  ///< m driven since the start
  double speed = 0;   ///< m/s
};

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
  void report_passengers(Time now, Activity from, Activity to);
  void report_key(Time now, Activity to);
  MeterKeys hands();
  bool clear_meter(const MeterKeys& keys);
  TripExcuse excuse(Time now);
  void watch_meter(Time now);
  void drive(Time now);
  void begin_trip(Time now);
  void choose_destination();
  void pay(Time now);
  void print_papers(Activity from);
  void read_receipts();
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
