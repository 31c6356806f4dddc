// Reports of the real devices of a lift on its bus, for the plants behind them: a real node has the
// door, the light barrier, the scale or the key that counts.
//
//     RealDevices real({.doors = 0b0001, .panels = {22}}, hands);
//     world.occupy(slot, real);   // it hears all frames of the bus
//
// They are read at the pre-defined CAN-IDs of lift 1 (CiA 417-3), as CarFollower reads a drive.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/devices/cia417/call/special_functions.hpp"
#include "canvoy/devices/cia417/kit/door_words.hpp"
#include "canvoy/worlds/lift/building.hpp"

namespace canvoy::lift {

/// Load signals of 6482h:01h.
struct LoadSaid {
  bool full = false;      ///< the unit reports the car as full
  bool overload = false;  ///< the unit reports an overload
};

class RealDevices {
 public:
  /// The devices that are real.
  struct Wanted {
    unsigned doors = 0;           ///< bit 0 is the unit of door 1
    unsigned light_barriers = 0;  ///< bit 0 is the light barrier of door 1
    bool drive = false;           ///< the drive unit
    bool load = false;            ///< the load measuring unit
    bool position = false;        ///< the position unit
    std::set<NodeId> panels{};    ///< panels whose keys count

    /// True if any device is real.
    bool any() const {
      return doors != 0 || light_barriers != 0 || drive || load || position || !panels.empty();
    }
  };
  /// Functions that receive the reports. None may be empty.
  struct Hands {
    /// Report of a door, with its position in mm; empty where the door does not measure it.
    std::function<void(DoorNumber, const cia417::DoorReport&, std::optional<std::uint16_t>)> door{};
    /// State of a light barrier, by its PDO.
    std::function<void(DoorNumber, cia417::Detection)> light_barrier{};
    /// Signals of the load unit.
    std::function<void(const LoadSaid&)> load{};
    /// Position in m, by the default step of 6384h, as the controller reads it.
    std::function<void(double)> position{};
    /// Each frame; the follower of the drive selects its own.
    std::function<void(const Frame&)> drive{};
    /// keys() has changed.
    std::function<void()> keys{};
  };

  /// Listens for the `wanted` devices; `hands` are called from within receive().
  RealDevices(Wanted wanted, Hands hands);

  /// Keys and buttons of real panels that have a special function.
  const cia417::SpecialFunctions& keys() const { return keys_; }
  /// Time until which one of them keeps the lift from passengers.
  Time in_service_until(Time now) const;

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
  void hear_door(DoorNumber door, const Frame& frame);
  void hear_input(const Frame& frame, Time now);

  Wanted wanted_;
  Hands hands_;
  cia417::SpecialFunctions keys_;
  bool is_in_service_ = false;
  Time in_service_until_{};
};

}  // namespace canvoy::lift
