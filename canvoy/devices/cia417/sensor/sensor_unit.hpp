// The sensor unit: glass, smoke, damage, pressure and temperature sensors, each a virtual sensor
// with a function, a location, a signal and optionally a value (6012h, 6500h to 657Fh; CiA 417-4,
// 4.13).
//
//     constexpr VirtualSensor sensors[] = {{.function = SensorFunction::smoke,
//                                           .lifts = lift_bit(1), .floor = 3}};
//     SensorUnit unit(node, tpdos, memory, {.sensors = sensors});
//     unit.set_level(0, true, now);    // smoke
//     unit.set_value(1, -40, now);     // in multiples of the unit of its parameter 3
//
// Each change is stored in the sensor groups and sent by the PDO of 6012h, one record after the
// other in the order of the changes. A sensor that changes again before it was sent is sent once,
// with its latest state; but a signal that has meanwhile come and gone is sent before that. When
// the node becomes operational, sensors with a signal and those that measure are sent.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/devices/cia417/virtual_io/io_groups.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_mapping.hpp"
#include "canvoy/devices/cia417/virtual_io/waiting_queue.hpp"

namespace canvoy::cia417 {

/// State of one sensor beside its record.
struct SensorState {
  std::uint32_t stable_at = 0;  ///< end of the debounce time of the level
  std::uint32_t second_at = 0;  ///< end of the second in which events are counted
  std::int16_t value = 0;       ///< last value, in the unit of its parameters
  std::uint16_t told = 0;       ///< the last function data sent
  std::uint8_t events = 0;      ///< in that second
  bool level : 1 = false;       ///< at present
  bool stable : 1 = false;      ///< the debounced level
  bool debouncing : 1 = false;  ///< the level differs from the stable one
  bool counting : 1 = false;    ///< events
  bool held : 1 = false;        ///< an event was beyond the limitation
  bool queued : 1 = false;      ///< it waits for its PDO
  bool missed : 1 = false;      ///< a signal came while it was queued
  SensorSignal condition : 2 = SensorSignal::not_set;  ///< not_set: it works
};

/// Memory of a unit, as much as its dictionary needs.
struct SensorMemory {
  std::span<SensorState> states;   ///< one for each sensor
  std::span<std::uint32_t> queue;  ///< as many
};

/// Records and times of a unit.
struct SensorSettings {
  /// Functions and locations of the sensors, in the order of the groups and sub-indices; their data
  /// is ignored. Must outlive the unit.
  std::span<const VirtualSensor> sensors;
};

/// Parameters (4.13.2 to 4.13.4; a byte of FFh is not used):
/// 1. A disabled sensor has no signal. The error code is that of report().
/// 2. More events a second than the limitation start no message; at the end of the second, the
///    state is sent if it has changed. The sending event is the number of events that start a
///    message.
/// 3. A level counts after the debounce time; edges select the changes of the signal that start a
///    message; polarity 1 inverts the level. A change of a value is no edge, and always starts a
///    message. Unit and prefix are for readers of the value.
class SensorUnit {
 public:
  /// The dictionary has sensor groups and 6012h. All arguments must outlive the unit.
  SensorUnit(Node& node, Tpdos& tpdos, const SensorMemory& memory, const SensorSettings& settings);

  // To be called from outside of the node. `number` counts from 0, in the order of the groups;
  // other numbers are ignored. The cost is linear in the number of groups, and in the number of
  // sensors if a debounce time, a limitation or a sending event is in use.

  /// Takes the level of a sensor, counted from 0.
  void set_level(std::uint32_t number, bool high, Time now);
  /// For pressure and temperature: -8192 to 8191; values beyond are clamped.
  void set_value(std::uint32_t number, std::int16_t value, Time now);
  /// Reports that the sensor is defective, not installed, or works again (not_set). Parameter 1
  /// holds the error code; FFh: none. A defect is also an emergency: FF04h, with the number of the
  /// sensor counted from 1 (CiA 417-1, 8.4). A defect that outlives a reset is reported again.
  void report(std::uint32_t number, SensorSignal condition, Time now,
              std::uint8_t error_code = parameter_not_used);

  std::uint32_t size() const { return groups_.size(); }
  /// The record in its group.
  VirtualSensor sensor(std::uint32_t number) const;
  /// Number of sensors that wait for the bus.
  std::uint32_t waiting() const { return queue_.size(); }

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  AbortCode before_parameter_write(const Entry& entry, std::span<const std::uint8_t> value);
  void parameter_written(const Entry& entry, Source source);

  std::uint8_t parameter(IoPlace place, unsigned number, unsigned byte) const {
    return parameter_byte(node_.dictionary(), place, number, byte);
  }
  std::uint16_t data_of(const SensorState& state, IoPlace place, SensorFunction function) const;
  bool is_told(IoPlace place, SensorSignal before, const VirtualSensor& record) const;
  bool is_message(SensorState& state, IoPlace place);
  void level_changed(std::uint32_t number, IoPlace place);
  void update(std::uint32_t number, IoPlace place, bool by_event);
  void tell(std::uint32_t number, SensorSignal signal);
  void expire(Time now);
  void wake();
  void begin();
  bool waits();
  std::uint64_t next();

  static const AccessHandlers parameter_hook;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;

  Node& node_;
  IoGroups groups_;
  std::span<SensorState> states_;
  WaitingNumbers queue_;  ///< sensors that have changed, each once
  SensorSettings settings_;
  VirtualMapping mapping_;
  Timer timer_;
  HandlerBinding service_{&service_calls, this};
  bool begun_ = false;  ///< operational, and sensors to send first have been found
};

}  // namespace canvoy::cia417
