// The car door controller of a lift: commands up to four doors (6300h), and knows what they do by
// their statuswords, positions and light barriers (6301h, 6302h, 6310h; CiA 417-4, 4.6 to 4.8).
//
//     CarDoorController doors(node, {.doors = 0b0011});
//     doors.on_change(Callback<void()>::to<&LiftController::update>(lift));
//     doors.open(0b0001);
//     doors.view(1).state  // DoorState::opening
//     LiftController lift(node, {.doors = doors.interface()}, ...);
//
// A door that does not do what it was told is told again: a frame was lost, the door has started
// again, or has stopped since it did not hear its controller. A door with an error is reset first.
// It is asked for its state as well: what it did may not have been heard.
//
// Where a door unit or light barrier unit is in 1016h and its heartbeat is lost, what it said
// before counts no longer.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/devices/cia417/controller/lift_interfaces.hpp"
#include "canvoy/devices/cia417/door/door_words.hpp"
#include "canvoy/devices/cia417/panel/virtual_io.hpp"
#include "canvoy/profiles/cia417/handles.hpp"

namespace canvoy::cia417 {

struct CarDoorControllerSettings {
  unsigned lift = 1;        ///< 1 to 8
  DoorMask doors = 0b0001;  ///< those that the car has
  /// Their node-IDs; the recommended ones of CiA 417-2 by default. There is none for door 4.
  std::array<NodeId, door_count> door_units = {6, 7, 8, 0};
  /// Of light barriers that are nodes of their own; 0: the door's node, or nobody's.
  std::array<NodeId, door_count> light_barrier_units = {};
  /// A door that closes and finds something in its way is opened. The door may do so by itself, too
  /// (6304h to 6307h).
  bool reopens = true;
  /// After which a door that does not obey is told again.
  Duration repeat_time = 3s;
};

/// What is known of a door.
struct DoorView {
  bool is_known = false;  ///< heard of, and its heartbeat is not lost
  DoorReport report;
  std::optional<std::uint16_t> position_mm{};
  Detection light_barrier = Detection::not_available;

  friend constexpr bool operator==(const DoorView&, const DoorView&) = default;
};

class CarDoorController {
 public:
  enum class Force : std::uint8_t { limited, unlimited };

  /// With `rpdos`, the RPDOs of the node, it asks by remote frame for what it does not know;
  /// without them it waits until a door tells it.
  CarDoorController(Node& node, const CarDoorControllerSettings& settings, Rpdos* rpdos = nullptr);
  CarDoorController(const CarDoorController&) = delete;
  CarDoorController& operator=(const CarDoorController&) = delete;

  // Commands to doors of the car; others are left out. What was ordered already, and is done, is
  // not ordered again. From outside of a callback of the node, call Node::advance() before and
  // after.
  void open(DoorMask doors, Force force = Force::limited);
  void close(DoorMask doors, DoorClosing closing = DoorClosing::normal,
             Force force = Force::limited);
  void stop(DoorMask doors, Force force = Force::limited);
  /// Ends an error that is no longer there; the door stands.
  void reset(DoorMask doors);
  /// Whether a closed door locks.
  void lock(DoorMask doors, bool locks = true);
  void enable_motion_detector(DoorMask doors, bool enabled = true);
  void enable_finger_protector(DoorMask doors, bool enabled = true);
  void enable_battery(DoorMask doors, bool enabled = true);
  /// The device belongs to another lift now (6001h): what it heard was of other doors.
  void begin_anew();
  /// 6001h was written, or restored.
  void lift_changed(std::uint8_t lift) {
    if (std::exchange(lift_, lift) != lift) begin_anew();
  }
  /// PDOs may have been lost (see GapWatch): all doors are asked for their state. Where that is not
  /// as it was ordered they are told again.
  void ask_anew();
  /// A boot-up message or heartbeat of a node: of a door that has begun anew nothing is known, and
  /// one that becomes operational is asked. Losses and returns of those in 1016h are known here.
  void heard(NodeId node, RemoteState state);

  /// `door` is 1 to 4.
  const DoorView& view(unsigned door) const { return doors_[door - 1].view; }
  /// What was ordered last.
  const DoorOrder& order(unsigned door) const { return doors_[door - 1].order; }
  DoorsStatus status() const;
  /// Called when a view has changed.
  void on_change(Callback<void()> changed) { changed_ = changed; }

  /// For a LiftController; valid as long as this.
  LiftDoors interface();

 private:
  struct Door {
    DoorOrder order;
    DoorView view;
    DoorClosing closing = DoorClosing::normal;
    Time told_at{};
    Time tell_at = never;  ///< when the order follows a word that makes the door listen
    bool is_lost = false;
    bool barrier_is_lost = false;
  };

  void reset_state(ResetScope scope);
  void state_entered(NmtState state);
  void error_changed(const Error& error, bool present);
  void state_received(const Entry& entry);
  void received(const Entry& entry);
  bool has_door(unsigned number) const;

  template <class Change>
  void change(DoorMask doors, const Change& change);
  void order(unsigned door, const DoorOrder& order);
  void tell(unsigned door);
  void tell_again(unsigned door);
  void refresh(unsigned door);
  void react(unsigned door);
  void forget(unsigned door);
  void ask(unsigned door);
  void expired(Time now);
  void plan();
  void open_for_lift(DoorMask doors) { open(doors); }
  void close_for_lift(DoorMask doors, DoorClosing closing) { close(doors, closing); }
  void stop_for_lift(DoorMask doors) { stop(doors); }
  DoorsStatus status_for_lift() { return status(); }

  Node& node_;
  CarDoorControllerSettings settings_;
  std::uint8_t lift_ = lift_bit(settings_.lift);  ///< as 6001h has it
  Rpdos* rpdos_;
  Callback<void()> changed_;
  std::array<Door, door_count> doors_;
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;
};

}  // namespace canvoy::cia417
