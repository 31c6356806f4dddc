// Reports of the real devices of a taxi on its bus, for the hardware behind them in the simulated
// car: a real node has the meter, the alarm key or the wheels that count.
//
//     RealDevices real({.meter = 2}, hands);
//     world.occupy(slot, real);   // it hears all frames of the bus
//
// They are read at the pre-defined CAN-IDs of their node-IDs.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::taxi {

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

}  // namespace canvoy::taxi
