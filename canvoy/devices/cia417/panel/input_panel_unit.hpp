// The input panel unit: buttons, keys and contacts of a landing or a car, each a virtual input with
// a function, a location and a state (CiA 417-4, 4.3).
//
//     constexpr VirtualInput buttons[] = {{.function = BasicFunction::standard_hall_call,
//                                          .sub_function = hall_up, .lifts = lift_bit(1),
//                                          .floor = 3, .doors = source_door(1)}};
//     InputPanelUnit panel(node, tpdos, memory, {.inputs = buttons});
//     panel.set_level(0, true, now);    // the button is pressed
//     panel.set_level(0, false, now);   // and let go
//
// Each change is stored in the input groups (6100h) and sent by the PDO of 6010h, one record after
// the other in the order of the changes. If there are more changes than the queue can hold, these
// inputs are sent one by one with their state at that time, preceded by a request that has
// meanwhile ended, so that no call is lost and memory is limited. Inputs that are on, those that
// were sent before, and all with a locking function are sent when the node becomes operational.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/devices/cia417/virtual_io/io_groups.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_mapping.hpp"
#include "canvoy/devices/cia417/virtual_io/waiting_queue.hpp"

namespace canvoy::cia417 {

/// State of one input beside its record.
struct InputState {
  std::uint32_t stable_at = 0;                    ///< end of the debounce time of the level
  std::uint32_t second_at = 0;                    ///< end of the second in which events are counted
  std::uint8_t events = 0;                        ///< in that second
  bool level : 1 = false;                         ///< of the contact: high
  bool stable : 1 = false;                        ///< the debounced level
  bool debouncing : 1 = false;                    ///< the level differs from the stable one
  bool counting : 1 = false;                      ///< events
  bool held : 1 = false;                          ///< an event was beyond the limitation
  bool behind : 1 = false;                        ///< to be sent, and not in the queue
  bool missed : 1 = false;                        ///< a request came while it was behind
  bool was_told : 1 = false;                      ///< since the reset
  CallRequest told : 2 = CallRequest::none;       ///< request that was sent last
  CallRequest condition : 2 = CallRequest::none;  ///< none: it works
};

/// Memory of a unit, as much as its dictionary needs.
struct InputPanelMemory {
  std::span<InputState> states;    ///< one for each input
  std::span<std::uint32_t> queue;  ///< changes that wait for the bus
};

/// Records and times of a unit.
struct InputPanelSettings {
  /// Functions and locations of the inputs, in the order of the groups and sub-indices: written to
  /// 6100h at each reset. Bit 7 of `data` marks a button or key with a locking function. Inputs
  /// with function 00h send nothing: there is no button. Must outlive the unit.
  std::span<const VirtualInput> inputs;
};

/// Parameters (4.3.2 to 4.3.5; a byte of FFh: not used, as if the parameter did not exist):
/// 1. A disabled input has no request, and sends nothing. The error code is that of report().
/// 2. More events a second than the limitation do not start messages; at the end of the second, the
///    state is sent if it has changed. The sending event is the number of events that start a
///    message.
/// 3. A level counts after the debounce time; polarity selects the level that is a request; edges
///    select the changes of the request that start a message; all are stored. FFh: both edges, not
///    inverted; for both with the other polarity, write 83h.
/// 4. Reserved: kept, without meaning.
class InputPanelUnit {
 public:
  /// The dictionary has input groups and 6010h. All arguments must outlive the unit.
  InputPanelUnit(Node& node, Tpdos& tpdos, const InputPanelMemory& memory,
                 const InputPanelSettings& settings);

  // To be called from outside of the node. `number` counts the inputs from 0, in the order of the
  // groups; other numbers are ignored. The cost is linear in the number of groups, and in the
  // number of inputs if a debounce time, a limitation or a sending event is in use.

  /// Sets the level of the contact: high is a request, unless polarity is inverted.
  void set_level(std::uint32_t number, bool high, Time now);
  /// Reports that the input is defective, not installed, or works again (none, request). Parameter
  /// 1 holds the error code; FFh: none. A defect is also an emergency: FF04h, with the number of
  /// the input counted from 1 (CiA 417-1, 8.4). A defect that outlives a reset is reported again.
  void report(std::uint32_t number, CallRequest condition, Time now,
              std::uint8_t error_code = 0xFF);

  /// For another access to the bus: see VirtualMpdoProducer.
  VirtualMapping& mapping() { return mapping_; }

  std::uint32_t size() const { return groups_.size(); }
  /// The record in its group.
  VirtualInput input(std::uint32_t number) const;
  /// The input with this function at this floor; io_nowhere if there is none. Linear in the number
  /// of inputs.
  std::uint32_t find(BasicFunction function, std::uint8_t sub_function, std::uint8_t floor) const;
  /// Number of changes that wait for the bus.
  std::uint32_t waiting() const { return queue_.size() + behind_; }

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  AbortCode before_parameter_write(const Entry& entry, std::span<const std::uint8_t> value);
  void parameter_written(const Entry& entry, Source source);

  std::uint8_t parameter(IoPlace place, unsigned number, unsigned byte) const;
  bool is_inverted(IoPlace place) const;
  bool is_edge_told(IoPlace place, CallRequest request) const;
  CallRequest request_of(const InputState& state, IoPlace place) const;

  void level_changed(std::uint32_t number, IoPlace place);
  void update(std::uint32_t number, IoPlace place, bool by_edge);
  bool is_message(std::uint32_t number, IoPlace place);
  void tell(std::uint32_t number);
  void fall_behind(std::uint32_t number, CallRequest request);
  void begin();
  void expire(Time now);
  void wake();

  bool waits();
  std::uint64_t next();
  std::uint64_t next_behind();
  std::uint64_t record(std::uint32_t number, CallRequest request);

  static const AccessHandlers parameter_hook;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;

  Node& node_;
  IoGroups groups_;
  InputPanelMemory memory_;
  WaitingNumbers queue_;  ///< changes of inputs, each with its state
  InputPanelSettings settings_;
  VirtualMapping mapping_;
  Timer timer_;
  HandlerBinding service_{&service_calls, this};
  std::uint32_t behind_ = 0;  ///< number of inputs that are behind
  std::uint32_t turn_ = 0;    ///< the input that is checked next for being behind
  bool begun_ = false;        ///< operational, and inputs that are on have been found
};

}  // namespace canvoy::cia417
