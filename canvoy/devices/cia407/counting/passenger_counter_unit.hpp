// The passenger counter of one door: counts from the opening to the closing of the door, and then
// reports how many passengers came in and went out (6700h; CiA 407, 6.21, 9.2.25). More than 200
// cause an event at once.
//
//     PassengerCounterUnit counter(device, {}, {.door = 2});
//     counter.count_in();
//
// 6700h is 0 while the door is open, so that each result other than 0 is reported as a change of
// the value.
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/door_state.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The door that is counted.
struct PassengerCounterSettings {
  unsigned door = 1;  ///< 1 to 12, as in 6488h
};

class PassengerCounterUnit {
 public:
  static constexpr unsigned many = 200;       ///< more passengers cause an event at once
  static constexpr unsigned count_max = 255;  ///< of a field of 6700h

  /// Makes the unit; `device` must outlive it.
  PassengerCounterUnit(VirtualDevice& device, const NoHardware& hardware,
                       const PassengerCounterSettings& settings);

  // Counts people who pass the sensors; at a closed door they are ignored. Call it from the node's
  // callbacks, or after node.advance().
  /// Counts passengers who come in; ignored while the door is closed.
  void count_in(unsigned people = 1) { count(in_, people); }
  /// Counts passengers who go out; ignored while the door is closed.
  void count_out(unsigned people = 1) { count(out_, people); }
  /// For a counter that senses its door itself, where no device provides 6488h.
  void set_door(bool is_open);

  /// True while the door is open.
  bool is_counting() const { return is_counting_; }

 private:
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;

  void state_entered(NmtState state);
  void reset(ResetScope scope);
  void doors_written(const Entry& entry);
  void count(unsigned& counter, unsigned people);
  void tell();

  VirtualDevice& device_;
  PassengerCounterSettings settings_;
  bool is_counting_ = false;
  unsigned in_ = 0;
  unsigned out_ = 0;
  bool was_operational_ = false;
  HandlerBinding service_{&service_calls, this};
};

/// Catalogue row of the passenger counter of a door (6.21); bus_unit makes it a part of a device.
struct PassengerCounterKind : BusKind<PassengerCounterUnit, NoHardware, PassengerCounterSettings> {
  static constexpr DeviceInfo info = {.name = "passenger-counter",
                                      .title = "passenger counter of a door",
                                      .product = "Canvoy CiA 407 passenger counter",
                                      .product_code = 40720,
                                      .node_id = 20,
                                      .hardware = "sensors at a door: in and out"};
  static constexpr const VirtualDeviceInfo& provides = passenger_counter;
  static constexpr std::array pdos = {own_pdo<event_tpdo>, own_pdo<door_count_tpdo>,
                                      own_pdo<command_rpdo>, own_pdo<doors_rpdo>};
};

}  // namespace canvoy::cia407
