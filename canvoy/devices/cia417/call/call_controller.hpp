// The call controller of a lift: keeps the calls and special functions that panels send (6010h),
// and tells the panels what became of them and what the lift does (6011h; CiA 417-4, 4.2.3, 4.2.4,
// 4.3.1 and 4.4.1).
//
//     CallController calls(node, tpdos, memory, {.lift = 1, .served = {FloorSet::between(1, 20)}});
//     calls.on_change(Callback<void()>::to<&LiftController::update>(lift));
//     next_stop(calls.calls(), car);
//     calls.answered(7, Direction::up);   // the doors open there
//
// It takes what panels say, and keeps the order in which they are told. What they show of calls is
// kept by CallLamps, who named a destination by DestinationCalls, keys by SpecialFunctions, the
// rest by LiftIndications. It knows nothing of the car: LiftController does. What a call is, and
// the choices that the profile leaves, are in docs/decisions.md.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/devices/cia417/call/call_lamps.hpp"
#include "canvoy/devices/cia417/call/call_records.hpp"
#include "canvoy/devices/cia417/call/destination_calls.hpp"
#include "canvoy/devices/cia417/call/served_floors.hpp"
#include "canvoy/devices/cia417/call/special_functions.hpp"
#include "canvoy/devices/cia417/controller/lift_calls.hpp"
#include "canvoy/devices/cia417/controller/lift_display.hpp"
#include "canvoy/devices/cia417/group/waiting_queue.hpp"
#include "canvoy/devices/cia417/panel/lamps_out.hpp"
#include "canvoy/devices/cia417/panel/virtual_mapping.hpp"

namespace canvoy::cia417 {

struct CallControllerSettings {
  unsigned lift = 1;  ///< 1 to 8
  /// The floors that have a door, for each door of the car.
  std::array<FloorSet, lift_doors_max> served{FloorSet::between(1, FloorSet::floor_max)};
  /// Car calls to these floors are taken while key 1 to 4 is turned only.
  std::array<FloorSet, key_locks> locked_by_key{};
  /// A call of low priority that has waited for so long becomes a standard one.
  Duration low_priority_max = 60s;
};

/// How many destination calls can wait in a lift that is not small: one from the main floor to each
/// other floor of the highest building, where all come in at once, in 2.5 KiB.
inline constexpr std::size_t destinations_default = FloorSet::floor_max;

class CallController {
 public:
  using Destination = DestinationCalls::Slot;

  /// The dictionary has 6010h and 6011h, and the node a backlog of two frames. `destinations`
  /// bounds the destination calls that wait. All must outlive this.
  CallController(Node& node, Tpdos& tpdos, std::span<Destination> destinations,
                 const CallControllerSettings& settings);
  CallController(const CallController&) = delete;
  CallController& operator=(const CallController&) = delete;

  /// Called when a call or special function has come or gone by a panel.
  void on_change(Callback<void()> changed) { changed_ = changed; }
  /// Hall and destination calls are offered to a group first: where it answers true, they are its
  /// own, and it acknowledges them by acknowledge().
  void on_hall_call(Callback<bool(const VirtualInput&)> offered) { offered_ = offered; }

  /// Asked for what is somebody else's in a building: access codes, speech and area monitoring
  /// connections (basic functions 0Fh to 11h). A request is affirmed where it answers true, and so
  /// is the end of one by a button that locks. Without it none is affirmed.
  void on_connection(Callback<bool(const VirtualInput&)> asked) { asked_ = asked; }
  /// The same, later: it is established, or at its end. While one for speech is, the panels show
  /// that help is coming.
  void connected(const VirtualInput& input, bool on);
  bool is_help_coming() const { return help_is_coming_; }

  /// Called with each record that panels are told (6011h), before it leaves.
  void on_record(Callback<void(const VirtualOutput&)> told) { record_ = told; }

  /// An input as a panel sends it; frames that carry 6010h come here by themselves. Inputs for
  /// other lifts are ignored.
  void take(const VirtualInput& input);
  /// The same as it was read from a panel that has come, or come back: keys and held buttons that
  /// have changed since it was heard. Calls are asked for again by those who wait.
  void take_reading(const VirtualInput& input);
  /// Calls of other kinds are refused, which the panel is told.
  void accept(CallKinds kinds) { accepted_ = kinds; }
  /// The building has no floors above.
  void serve_up_to(unsigned floor) { served_.end_at(floor); }
  /// A call of the lift's own, or one that its group assigned: no panel is told of it. Doors that
  /// are not there are left out.
  void add(const Call& call);
  /// A destination call that the group assigned.
  bool add_destination(const VirtualInput& input);
  /// It is another lift's now.
  void withdraw(const Call& call);
  void withdraw_destination(const VirtualInput& input);
  /// What the panels show of a call of the group.
  void acknowledge(const Call& call, bool on);
  /// Of destination calls they show which lift comes.
  void acknowledge_destination(const VirtualInput& input, bool on, std::uint8_t lifts);

  /// The panels show it.
  bool shows(const Call& call) const { return lamps_.shown().contains(call); }
  const LiftCalls& shown() const { return lamps_.shown(); }
  /// The group is gone: what panels show of it is this lift's now, which has the bit `lift` in the
  /// group: that is shown to those who wait with a destination.
  void adopt(std::uint8_t lift);

  /// The car opened its doors there, and leaves in this direction: those calls are done. Who named
  /// his destination is in the car: his target is a car call now.
  void answered(std::uint8_t floor, Direction departure, CallKinds kinds = all_calls);
  /// Calls of these kinds are taken back, which the panels are told.
  void cancel(CallKinds kinds);

  const LiftCalls& calls() const { return calls_; }
  bool is_on(SpecialFunction function) const { return specials_.is_on(function); }
  DoorMask held_doors(SpecialFunction function) const { return specials_.doors(function); }
  /// Sets a special function from inside, as if a key was turned.
  void set(SpecialFunction function, bool on);
  DoorMask doors_at(std::uint8_t floor) const { return served_.doors_at(floor); }

  /// What is shown; call show() after a change.
  LiftDisplay& display() { return indications_.display; }
  const LiftDisplay& display() const { return indications_.display; }
  void show();
  /// All that is shown, and what was once and is not any more, since a panel has come that may not
  /// have heard it. Of destination calls that have ended, those whose memory is not in use again.
  void show_again();
  void ring(std::uint8_t floor, DoorMask doors, Direction direction);

  std::uint32_t defective_inputs() const { return defective_inputs_; }
  /// Destination calls for which there was no memory: the terminal was told that they are not
  /// affirmed, unless the bus was too busy for as many answers.
  std::uint32_t destinations_without_room() const { return destinations_without_room_; }
  std::uint32_t answers_lost() const { return answers_lost_; }
  std::uint8_t lift_mask() const { return lift_bit(lift_); }
  /// It belongs to another lift now (6001h), whose panels are told what is shown.
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
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer low_timer_;
};

}  // namespace canvoy::cia417
