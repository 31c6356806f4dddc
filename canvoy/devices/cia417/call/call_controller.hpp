// The call controller of a lift: keeps the calls and special functions that panels send (6010h),
// and reports to the panels their acknowledgements and the state of the lift (6011h; CiA 417-4,
// 4.2.3, 4.2.4, 4.3.1 and 4.4.1).
//
//     CallController calls(node, tpdos, memory, {.lift = 1, .served = {FloorSet::between(1, 20)}});
//     calls.on_change(Callback<void()>::to<&LiftController::update>(lift));
//     next_stop(calls.calls(), car);
//     calls.answered(7, Direction::up);   // the doors open there
//
// This class takes the inputs of panels, and keeps the order of the records sent to them. CallLamps
// keeps the lamps of calls, DestinationCalls the destination calls, SpecialFunctions the keys,
// LiftIndications the rest. This class does not depend on the car; LiftController does.
// docs/decisions.md defines calls, and the choices that the profile leaves.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/devices/cia417/call/call_lamps.hpp"
#include "canvoy/devices/cia417/call/call_records.hpp"
#include "canvoy/devices/cia417/call/destination_calls.hpp"
#include "canvoy/devices/cia417/call/served_floors.hpp"
#include "canvoy/devices/cia417/call/special_functions.hpp"
#include "canvoy/devices/cia417/lift/lift_calls.hpp"
#include "canvoy/devices/cia417/lift/lift_display.hpp"
#include "canvoy/devices/cia417/panel/lamps_out.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_mapping.hpp"
#include "canvoy/devices/cia417/virtual_io/waiting_queue.hpp"

namespace canvoy::cia417 {

/// Settings of a call controller that no object of its dictionary has.
struct CallControllerSettings {
  unsigned lift = 1;  ///< 1 to 8
  /// Floors with a door, for each door of the car.
  std::array<FloorSet, lift_doors_max> served{FloorSet::between(1, FloorSet::floor_max)};
  /// Car calls to these floors are accepted only while key 1 to 4 is turned.
  std::array<FloorSet, key_locks> locked_by_key{};
  /// A call of low priority that has waited for this time becomes a standard one.
  Duration low_priority_max = 60s;
};

/// Number of destination calls that can wait in a lift that is not small: one from the main floor
/// to each other floor of the highest building, all at once, in 2.5 KiB.
inline constexpr std::size_t destinations_default = FloorSet::floor_max;

class CallController {
 public:
  /// Memory of one waiting destination call.
  using Destination = DestinationCalls::Slot;

  /// The dictionary has 6010h and 6011h, and the node a backlog of two frames. The size of
  /// `destinations` limits the number of waiting destination calls. All arguments must outlive
  /// this.
  CallController(Node& node, Tpdos& tpdos, std::span<Destination> destinations,
                 const CallControllerSettings& settings);

  /// Calls `changed` when a call or special function has started or ended at a panel.
  void on_change(Callback<void()> changed) { changed_ = changed; }
  /// Offers hall and destination calls to a group first. If the callback returns true, the group
  /// has the call, and acknowledges it by acknowledge().
  void on_hall_call(Callback<bool(const VirtualInput&)> offered) { offered_ = offered; }

  /// Requests for other systems of a building: access codes, speech and area monitoring connections
  /// (basic functions 0Fh to 11h). A request is affirmed if the callback returns true, and so is
  /// the end of a request by a locking button. Without a callback, no request is affirmed.
  void on_connection(Callback<bool(const VirtualInput&)> asked) { asked_ = asked; }
  /// Reports later that a connection is established, or has ended. During a speech connection, the
  /// panels show that help is coming.
  void connected(const VirtualInput& input, bool on);
  /// True during a speech connection: see connected().
  bool is_help_coming() const { return help_is_coming_; }

  /// Called with each record for the panels (6011h), before it is sent.
  void on_record(Callback<void(const VirtualOutput&)> told) { record_ = told; }

  /// Takes an input as a panel sends it; frames with 6010h are taken automatically. Inputs for
  /// other lifts are ignored.
  void take(const VirtualInput& input);
  /// Takes an input read from a panel that has come or returned: keys and held buttons that have
  /// changed since they were last received. Calls are not taken, as waiting passengers repeat them.
  void take_reading(const VirtualInput& input);
  /// Refuses calls of other kinds, and reports that to the panel.
  void accept(CallKinds kinds) { accepted_ = kinds; }
  /// The building has no floors above `floor`.
  void serve_up_to(unsigned floor) { served_.end_at(floor); }
  /// Adds a call of the lift's own, or one that its group assigned, without a record to the panels.
  /// Doors that do not exist are left out.
  void add(const Call& call);
  /// Adds a destination call that the group assigned.
  bool add_destination(const VirtualInput& input);
  /// Removes a call that another lift has taken over.
  void withdraw(const Call& call);
  /// Removes a destination call that another lift has taken over.
  void withdraw_destination(const VirtualInput& input);
  /// Sets the lamps of a call of the group.
  void acknowledge(const Call& call, bool on);
  /// For destination calls, the panels show which lift comes.
  void acknowledge_destination(const VirtualInput& input, bool on, std::uint8_t lifts);

  /// True if the panels show the call.
  bool shows(const Call& call) const { return lamps_.shown().contains(call); }
  /// All calls that the panels show.
  const LiftCalls& shown() const { return lamps_.shown(); }
  /// Takes over the calls that panels show when the group is lost. The lift has the bit `lift` in
  /// the group, which is shown to passengers who wait with a destination.
  void adopt(std::uint8_t lift);

  /// Ends the calls that the car answers: it has opened its doors at this floor, and leaves in this
  /// direction. The targets of passengers who named a destination there become car calls.
  void answered(std::uint8_t floor, Direction departure, CallKinds kinds = all_calls);
  /// Cancels calls of these kinds, and reports that to the panels.
  void cancel(CallKinds kinds);

  /// Calls that wait for the car.
  const LiftCalls& calls() const { return calls_; }
  /// True while a key or button requests the function.
  bool is_on(SpecialFunction function) const { return specials_.is_on(function); }
  /// True if the button is held at each station at which the key is turned.
  bool is_on_wherever(SpecialFunction key, SpecialFunction button) const {
    return specials_.is_on_wherever(key, button);
  }
  /// Doors at which a function is held; 0: at none.
  DoorMask held_doors(SpecialFunction function) const { return specials_.doors(function); }
  /// Sets a special function from inside, like a turned key.
  void set(SpecialFunction function, bool on);
  /// Doors of the car at a floor; 0: the lift does not serve it.
  DoorMask doors_at(std::uint8_t floor) const { return served_.doors_at(floor); }

  /// Contents of the displays; call show() after a change.
  LiftDisplay& display() { return indications_.display; }
  /// Contents of the displays.
  const LiftDisplay& display() const { return indications_.display; }
  /// Sends what the displays show, as far as it has changed.
  void show();
  /// Sends all that is shown, and all that was shown before and has ended, since a panel has come
  /// that may not have received it. Of ended destination calls, only those with memory that has not
  /// been reused.
  void show_again();
  /// Rings the arrival gong at these doors of a floor, for the direction of departure.
  void ring(std::uint8_t floor, DoorMask doors, Direction direction);

  /// Number of times that panels have reported an input as defective.
  std::uint32_t defective_inputs() const { return defective_inputs_; }
  /// Number of destination calls without memory. The terminal was notified that they are not
  /// affirmed, unless the bus was too busy for as many answers.
  std::uint32_t destinations_without_room() const { return destinations_without_room_; }
  /// Number of answers to destination terminals that the bus had no time for.
  std::uint32_t answers_lost() const { return answers_lost_; }
  /// Bit of the lift in the records, 01h to 80h.
  std::uint8_t lift_mask() const { return lift_bit(lift_); }
  /// Moves the controller to another lift (6001h). The panels of that lift receive all that is
  /// shown.
  void set_lift_mask(std::uint8_t mask);

 private:
  static constexpr std::size_t answers_max = 8;

  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void received();
  void take_hall_call(const VirtualInput& input);
  void take_car_call(const VirtualInput& input);
  void take_destination(const VirtualInput& input);
  void take_destination_in_car(const VirtualInput& input);
  void refuse_destination(const VirtualInput& input);
  void take_connection(const VirtualInput& input);
  Call target_call_of(const VirtualInput& input) const;
  bool takes_car_call(const Call& call) const;
  void register_call(const Call& call);
  void refuse(const Call& call);
  void refuse_out_of_reach();
  void promote(Time now);
  void watch_low();

  bool waits();
  std::uint64_t next();
  VirtualOutput next_record();
  void answer(const VirtualInput& input, bool on, std::uint8_t lifts);

  DoorMask doors_here(const VirtualInput& input) const;

  Node& node_;
  unsigned lift_;
  Duration low_priority_max_;
  ServedFloors served_;
  DestinationCalls destinations_;
  VirtualMapping mapping_;
  LampsOut lamps_out_;
  LiftIndications indications_;
  SpecialFunctions specials_;
  LiftCalls calls_;
  CallLamps lamps_;
  CallKinds accepted_ = all_calls;
  bool help_is_coming_ = false;
  std::uint32_t defective_inputs_ = 0;
  std::uint32_t destinations_without_room_ = 0;
  std::uint32_t answers_lost_ = 0;
  std::array<std::uint64_t, answers_max> answer_memory_{};
  WaitingRecords answers_{answer_memory_};  ///< to destination calls that are not kept
  Callback<void()> changed_;
  Callback<bool(const VirtualInput&)> offered_;
  Callback<void(const VirtualOutput&)> record_;
  Callback<bool(const VirtualInput&)> asked_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer low_timer_;
};

}  // namespace canvoy::cia417
