// Listens to a bus and notes what its nodes report: boot-up, NMT states, emergencies, states of
// their controllers; and the commands of their master.
//
//     BusWatch watch(bus_number, [&](Time now, const BusEvent& what) { note(now, what); });
//     world.bus(bus).observe(watch.tap());
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>

#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/sim/event.hpp"

namespace canvoy {

class BusWatch {
 public:
  /// Called with the time and the event.
  using Note = std::function<void(Time, const BusEvent&)>;

  /// `bus` is the index of the bus in the world.
  BusWatch(std::size_t bus, Note note) : bus_(bus), note_(std::move(note)) {}
  BusWatch(const BusWatch&) = delete;
  BusWatch& operator=(const BusWatch&) = delete;

  /// Says which node the controller belongs to, so that its states can be reported.
  void name(ControllerId controller, NodeId node) { nodes_[controller] = node; }
  /// Valid as long as this object.
  BusTap tap();
  /// State by the last boot-up or heartbeat; `lost` where it is older than `time_out`.
  RemoteState heard_of(NodeId node, Time now, Duration time_out) const;

 private:
  struct Heard {
    RemoteState state = RemoteState::unknown;
    Time at{};
  };

  void hear(Time now, const Frame& frame);
  void hear_error_control(Time now, NodeId node, std::uint8_t byte);
  void state_changed(Time now, ControllerId controller, BusState state);

  std::size_t bus_;
  Note note_;
  std::map<ControllerId, NodeId> nodes_;
  std::array<Heard, 128> heard_{};
};

}  // namespace canvoy
