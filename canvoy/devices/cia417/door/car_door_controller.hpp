// The car door controller of a lift: commands up to four doors (6300h), and evaluates their
// statuswords, positions and light barriers (6301h, 6302h, 6310h; CiA 417-4, 4.6 to 4.8).
//
//     CarDoorController doors(node, {.doors = 0b0011});
//     doors.on_change(Callback<void()>::to<&LiftController::update>(lift));
//     doors.open(0b0001);
//     doors.view(1).report.state;  // DoorState::opening
//     LiftController lift(node, {.doors = doors.interface()}, ...);
//
// A command without effect is sent again: a frame was lost, or the door has restarted, or has
// stopped since it did not receive its controller. A door with an error is reset first. The state
// of the door is requested as well, as its message may have been lost.
//
// When a door unit or light barrier unit in 1016h loses its heartbeat, its last state is discarded.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/devices/cia417/kit/door_words.hpp"
#include "canvoy/devices/cia417/lift/lift_interfaces.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/profiles/cia417/handles.hpp"

namespace canvoy::cia417 {

/// Settings of a car door controller that no object of its dictionary has.
struct CarDoorControllerSettings {
  unsigned lift = 1;        ///< 1 to 8
  DoorMask doors = 0b0001;  ///< the doors of the car
  /// Their node-IDs; by default the recommended ones of CiA 417-2, which has none for door 4.
  std::array<NodeId, door_count> door_units = {6, 7, 8, 0};
  /// Node-IDs of light barriers that are separate nodes; 0: the door's node, or none.
  std::array<NodeId, door_count> light_barrier_units = {};
  /// Opens a door that closes and meets an obstacle. The door may also do so by itself (6304h to
  /// 6307h).
  bool reopens = true;
  /// Time after which a command without effect is repeated.
  Duration repeat_time = 3s;
};

/// The known state of a door.
struct DoorView {
  bool is_known = false;                               ///< state received, and heartbeat not lost
  DoorReport report;                                   ///< statusword, 6301h
  std::optional<std::uint16_t> position_mm{};          ///< 6302h; nothing: not measured
  Detection light_barrier = Detection::not_available;  ///< 6310h

  friend constexpr bool operator==(const DoorView&, const DoorView&) = default;
};

class CarDoorController {
 public:
  /// Whether the drive limits its force to a harmless value.
  enum class Force : std::uint8_t { limited, unlimited };

  /// With `rpdos`, the RPDOs of the node, an unknown state is requested by remote frame; without
  /// them, the controller waits for the message of the door.
  CarDoorController(Node& node, const CarDoorControllerSettings& settings, Rpdos* rpdos = nullptr);

  // Commands doors of the car; others are left out. A command that is already carried out is not
  // sent again. From outside of a callback of the node, call Node::advance() before and after.
  /// Opens these doors.
  void open(DoorMask doors, Force force = Force::limited);
  /// Closes these doors.
  void close(DoorMask doors, DoorClosing closing = DoorClosing::normal,
             Force force = Force::limited);
  /// Stops these doors where they are.
  void stop(DoorMask doors, Force force = Force::limited);
  /// Ends an error that does not exist any more; the door stands.
  void reset(DoorMask doors);
  /// Selects whether a closed door locks.
  void lock(DoorMask doors, bool locks = true);
  /// Switches the motion detectors of these doors.
  void enable_motion_detector(DoorMask doors, bool enabled = true);
  /// Switches the finger protectors of these doors.
  void enable_finger_protector(DoorMask doors, bool enabled = true);
  /// Selects whether these doors may use their batteries.
  void enable_battery(DoorMask doors, bool enabled = true);
  /// Discards all states: the device belongs to another lift (6001h).
  void begin_anew();
  /// Call it when 6001h was written or restored.
  void lift_changed(std::uint8_t lift) {
    if (std::exchange(lift_, lift) != lift) begin_anew();
  }
  /// Requests the state of all doors, as PDOs may have been lost (see GapWatch). If it is not as
  /// commanded, the command is repeated.
  void ask_anew();
  /// Takes a boot-up message or heartbeat of a node. The state of a door that has restarted is
  /// discarded; the state of a node that becomes operational is requested. Losses and returns of
  /// nodes in 1016h are detected automatically.
  void heard(NodeId node, RemoteState state);

  /// `door` is 1 to 4.
  const DoorView& view(unsigned door) const { return doors_[door - 1].view; }
  /// The last command.
  const DoorOrder& order(unsigned door) const { return doors_[door - 1].order; }
  /// State of all doors of the car together.
  DoorsStatus status() const;
  /// Calls `changed` when a view has changed.
  void on_change(Callback<void()> changed) { changed_ = changed; }

  /// For a LiftController; valid as long as this.
  LiftDoors interface();

 private:
  struct Door {
    DoorOrder order;
    DoorView view;
    DoorClosing closing = DoorClosing::normal;
    Time reported_at{};
    Time report_at = never;  ///< when the command follows a word that makes the door accept it
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
  void report_again(unsigned door);
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
  std::uint8_t lift_ = lift_bit(settings_.lift);  ///< as in 6001h
  Rpdos* rpdos_;
  Callback<void()> changed_;
  std::array<Door, door_count> doors_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;
};

}  // namespace canvoy::cia417
