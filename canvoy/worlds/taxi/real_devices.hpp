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
    NodeId gateway = 0;
    NodeId meter = 0;
    NodeId alarm = 0;

    bool any() const { return gateway != 0 || meter != 0 || alarm != 0; }
  };
  /// Functions that receive the reports. None may be empty.
  struct Hands {
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
  void start(Time) {}
  void receive(const Frame& frame, Time);
  void advance(Time) {}
  Time deadline() const { return never; }
  void bus_state(BusState, Time) {}
  void tx_ready(Time) {}
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
