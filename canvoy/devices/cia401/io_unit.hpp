// An input and output module of CiA 401: digital and analogue inputs and outputs, for the objects
// in the dictionary.
//
//     IoUnit io(node, memory, {.digital_inputs = ..., .drive_digital = ...}, {});
//     io.hardware_changed();    // an input has changed, which is then told at once
//
// In NMT state stopped, at bus-off, on the loss of a monitored heartbeat (the communication errors
// of 1029h), and on a failure of the device itself, outputs take their error values. While analogue
// inputs cause no events (6423h), emergency 0080h reports this, from NMT state operational on.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia401/analogue_inputs.hpp"
#include "canvoy/devices/cia401/analogue_outputs.hpp"
#include "canvoy/devices/cia401/widths.hpp"
#include "canvoy/profiles/cia401/handles.hpp"

namespace canvoy::cia401 {

// The digital inputs of CiA 401: polarity, filter, and which changes are events (6000h to 6008h,
// 6020h to 6027h, 6100h to 6108h, 6120h to 6128h).
//
//     DigitalInputs inputs(node, memory, {.sense = Callback<std::uint8_t(unsigned)>::to<
//                                             &Board::inputs>(board)}, {});
//     inputs.look(now);    // when an input may have changed; filtered ones wake up by themselves
//
// The text of CiA 401 is not at hand. Our reading: the objects of each width have their own
// polarity and masks, and an input is filtered if one of them says so. A change that is no event is
// stored without a PDO. The next event is always sent, and the change with it, whatever the PDO
// carried last. The state at a reset is no event.

/// State of 8 inputs beside the dictionary.
struct DigitalInputGroup {
  std::uint8_t number = 0;    ///< its sub-index in 6000h
  bool has_changed = false;   ///< in this check
  std::uint8_t sensed = 0;    ///< at the last check
  std::uint8_t accepted = 0;  ///< behind the filter
  /// Time from which an input differs from its accepted state, in microseconds modulo 2^32.
  std::array<std::uint32_t, 8> since{};
};

/// What no object of CiA 401 sets.
struct DigitalInputSettings {
  /// Time for which a filtered input has to be stable before it counts.
  Duration filter_time = std::chrono::milliseconds(5);
};

/// The digital inputs of CiA 401: polarity, filter, and which changes start a transmission.
class DigitalInputs {
 public:
  /// Returns 8 inputs as wired: the group is the sub-index in 6000h, the first input is bit 0.
  using Sense = Callback<std::uint8_t(unsigned group)>;

  /// All arguments must outlive this. `groups`: one for each element of 6000h, which may have gaps.
  DigitalInputs(Node& node, std::span<DigitalInputGroup> groups, Sense sense,
                const DigitalInputSettings& settings);

  /// Reads the inputs without an event: after a reset.
  void begin();
  /// Reads the inputs; a change that has passed its filter, and that a mask selects, is an event.
  void look(Time now);
  /// Applies written parameters at once, without an event.
  void show();

 private:
  enum class Telling : std::uint8_t { events, nothing };

  void expired(Time now) { look(now); }
  bool filter(DigitalInputGroup& inputs, Time now);
  std::uint8_t filtered(unsigned group) const;
  void report_all(Telling telling);
  void tell(unsigned group, bool may_tell);
  void report_element(const Width& width, unsigned sub, bool may_tell);
  void report_bits(unsigned group, std::uint32_t value, std::uint32_t events);
  const DigitalInputGroup* find_group(unsigned number) const;
  std::uint32_t accepted(unsigned sub, unsigned bytes) const;

  Node& node_;
  std::span<DigitalInputGroup> groups_;
  Sense sense_;
  DigitalInputSettings settings_;
  Timer timer_;
};

/// The digital outputs of CiA 401: polarity, filter mask, and their reaction when the device fails
/// (6200h to 6208h, 6300h to 6308h, 6320h to 6328h).
///
///     DigitalOutputs outputs(node, memory, {.drive = ...});
///     outputs.fail();    // a heartbeat is lost
///
/// The text of CiA 401 is not at hand. Our reading: an output that the filter mask leaves out keeps
/// its state. Objects show the outputs before their polarity, whatever the width in which they were
/// written. After a failure the outputs stay until they are written.
class DigitalOutputs {
 public:
  /// Drives 8 outputs as wired: the group counts from 1, the first output is bit 0.
  using Drive = Callback<void(unsigned group, std::uint8_t outputs)>;

  /// All arguments must outlive this. `groups`: one byte for each element of 6200h, which has no
  /// gaps.
  DigitalOutputs(Node& node, std::span<std::uint8_t> groups, Drive drive)
      : node_(node), groups_(groups), drive_(drive) {}
  DigitalOutputs(const DigitalOutputs&) = delete;
  DigitalOutputs& operator=(const DigitalOutputs&) = delete;

  /// Drives the values of the objects: after a reset.
  void begin();
  /// Drives an element of this object that the bus has written. Without effect for other objects.
  void written(std::uint16_t index, std::uint8_t sub);
  /// Sets outputs with error mode 1 to their error value.
  void fail();

 private:
  void change(std::size_t group, std::uint32_t value, std::uint32_t which);
  void show(std::size_t first, std::size_t end);
  void drive(std::size_t group);

  Node& node_;
  std::span<std::uint8_t> groups_;
  Drive drive_;
};

/// A callback may be omitted if the dictionary has no objects for it.
struct IoHardware {
  DigitalInputs::Sense digital_inputs = {};    ///< of 6000h
  DigitalOutputs::Drive drive_digital = {};    ///< of 6200h
  AnalogueInputs::Sense analogue_input = {};   ///< of 6401h
  AnalogueOutputs::Drive drive_analogue = {};  ///< of 6411h
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(IoHardware& hardware, Plain& things) {
  static_assert(
      requires { &Plain::digital_inputs; } || requires { &Plain::drive_digital; } ||
          requires { &Plain::analogue_input; } || requires { &Plain::drive_analogue; },
      "the class has no member function of IoHardware: digital_inputs, drive_digital, "
      "analogue_input or drive_analogue");
  if constexpr (requires { &Plain::digital_inputs; })
    hardware.digital_inputs = callback<&Plain::digital_inputs>(things);
  if constexpr (requires { &Plain::drive_digital; })
    hardware.drive_digital = callback<&Plain::drive_digital>(things);
  if constexpr (requires { &Plain::analogue_input; })
    hardware.analogue_input = callback<&Plain::analogue_input>(things);
  if constexpr (requires { &Plain::drive_analogue; })
    hardware.drive_analogue = callback<&Plain::drive_analogue>(things);
}

/// Settings of a module that no object of its dictionary has.
struct IoSettings {
  /// Period of checks of the inputs; zero: checked when the hardware reports a change.
  Duration sensing_period = std::chrono::milliseconds(10);
  DigitalInputSettings digital = {};    ///< filter
  AnalogueInputSettings analogue = {};  ///< unit of limits
  /// Sends emergency 0080h. It is uncertain for modules that follow CiA 401 alone.
  bool warns_of_disabled_inputs = true;
};

/// Memory of a unit, as much as its dictionary needs.
struct IoMemory {
  std::span<DigitalInputGroup> digital_inputs;    ///< one for each element of 6000h
  std::span<std::uint8_t> digital_outputs;        ///< of 6200h
  std::span<AnalogueInputState> analogue_inputs;  ///< of 6401h
  bool has_analogue_outputs = false;              ///< 6411h
  AnalogueReals* reals = nullptr;  ///< with 6403h or 6413h: a copy of AnalogueReals::calls
};

class IoUnit {
 public:
  /// Everything to which `hardware` and `memory` refer must outlive this.
  IoUnit(Node& node, const IoMemory& memory, const IoHardware& hardware,
         const IoSettings& settings);

  /// Checks the inputs at the next call of the node.
  void hardware_changed() { node_.timers().arm(timer_, node_.now()); }
  /// Sets outputs to their error values: the device has failed.
  void fail();

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void bus_state_changed(BusState state);
  void error_changed(const Error& error, bool present);
  void source_is_read(const Entry& entry);
  AbortCode check_error_mode(const Entry& entry, std::span<const std::uint8_t> value);
  void analogue_parameter_written(const Entry& entry);
  void written(const Entry& entry, Source source);
  void expired(Time now);
  void warn(bool is_operational);

  Node& node_;
  IoSettings settings_;
  bool has_analogue_inputs_;
  DigitalInputs digital_inputs_;
  DigitalOutputs digital_outputs_;
  AnalogueInputs analogue_inputs_;
  AnalogueOutputs analogue_outputs_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia401
