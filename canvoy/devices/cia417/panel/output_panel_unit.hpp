// The output panel unit: lamps, displays and loudspeakers of a landing or a car, each a virtual
// output with a function, a location and a state (CiA 417-4, 4.4.1 and 4.5).
//
//     constexpr VirtualOutput lamps[] = {{.function = BasicFunction::standard_hall_call,
//                                         .sub_function = hall_up, .lifts = lift_bit(1),
//                                         .floor = 3, .doors = output_door(1)}};
//     OutputPanelUnit panel(node, memory, hardware, {.outputs = lamps});
//
// A record of 6011h, received by PDO or SDO, is stored in all outputs that it addresses (see
// output_address.hpp), in their group (6200h), and the hardware shows it.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia417/panel/output_view.hpp"
#include "canvoy/devices/cia417/virtual_io/io_groups.hpp"

namespace canvoy::cia417 {

/// State of one output beside its record.
struct OutputState {
  std::uint32_t off_at = 0;            ///< the end of an impulse
  std::uint32_t second_at = 0;         ///< end of the second in which events are counted
  std::uint8_t assigned = 0;           ///< the sub-function by which it is addressed
  std::uint8_t messages = 0;           ///< towards the next event
  std::uint8_t events = 0;             ///< in this second
  std::uint8_t held_sub_function = 0;  ///< of a message that an impulse delays
  std::uint8_t held_data = 0;          ///< of a message that an impulse delays
  bool impulse : 1 = false;            ///< it is on until off_at
  bool counting : 1 = false;           ///< events
  bool held : 1 = false;               ///< the last event was beyond the limitation
};

/// Records and hardware of a unit.
struct OutputPanelSettings {
  /// Functions and locations of the outputs, in the order of the groups and sub-indices: written to
  /// 6200h at power-on and NMT reset node, with `data` if parameter 1 has no default value. Further
  /// outputs keep the values stored in 6200h. Must outlive the unit.
  std::span<const VirtualOutput> outputs;
};

/// Parameters (4.5.1 to 4.5.4; a byte of FFh: not used, as if the parameter did not exist):
/// 1. A disabled output is off, and takes no messages. The default value is its function data after
///    power-on. The error code is that of report().
/// 2. The reception event is the number of messages of which the last one is an event. More events
///    a second than the limitation wait until the end of the second, when the last of them takes
///    effect. A message that switches the output on keeps it on for the impulse time, in which no
///    other message is taken; then it goes off. Property impulse has separate times. 0: no impulse.
/// 3. Polarity: 80h to FEh invert the output.
/// 4. Display of properties that a message leaves open: see view_of().
class OutputPanelUnit {
 public:
  /// The dictionary has output groups and 6011h; `states` has one for each output. All arguments
  /// must outlive the unit.
  OutputPanelUnit(Node& node, std::span<OutputState> states, const OutputHardware& hardware,
                  const OutputPanelSettings& settings);

  std::uint32_t size() const { return groups_.size(); }
  /// The record in its group; `output` counts from 0.
  VirtualOutput output(std::uint32_t output) const;
  /// The state that the hardware shows.
  OutputView view(std::uint32_t output) const;
  /// The output with this function at this floor that is addressed by this sub-function (for
  /// outputs that show it: 0); io_nowhere if there is none. Linear in the number of outputs.
  std::uint32_t find(BasicFunction function, std::uint8_t sub_function, std::uint8_t floor) const;
  /// Reports an error of the output in parameter 1; FFh: none. No codes are defined.
  void report(std::uint32_t output, std::uint8_t error_code);

 private:
  void reset(ResetScope scope);
  AbortCode before_write(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);
  void record_came(const Entry& entry, Source source);
  template <class Visit>
  void for_each_of(BasicFunction function, Visit visit) const;

  std::uint8_t parameter(IoPlace place, unsigned number, unsigned byte) const;
  bool is_enabled(IoPlace place) const;
  VirtualOutput assigned(std::uint32_t output, IoPlace place) const;

  void message(std::uint32_t output, IoPlace place, const VirtualOutput& record);
  bool is_event(OutputState& state, IoPlace place);
  bool is_allowed(OutputState& state, IoPlace place);
  void apply(std::uint32_t output, IoPlace place, std::uint8_t sub_function, std::uint8_t data);
  std::uint32_t impulse_time(IoPlace place, OutputData data) const;
  void store(IoPlace place, const VirtualOutput& record);
  void show(std::uint32_t output) const;
  void expire(Time now);
  void wake();

  static const AccessHandlers output_hook;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;

  Node& node_;
  IoGroups groups_;
  std::span<OutputState> states_;
  OutputHardware hardware_;
  OutputPanelSettings settings_;
  Timer timer_;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia417
