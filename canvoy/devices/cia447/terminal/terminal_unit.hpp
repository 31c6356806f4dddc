// The terminal: keys, two displays, a buzzer, warning lamps and icons (CiA 447-3, 4.2.9). Add-on
// devices lock the parts that they need; a person presses keys and reads.
//
//     TerminalUnit terminal(network, {.show = ...}, {.display_1 = TextArea{.lines = 2}});
//     terminal.press(NumberPadKey::key_1);
//     terminal.sense(TerminalPart::display_1, PartState::off);
//
// The holder of a part is the SDO client with its node-ID. Other clients that lock the part, or
// write to it, get 0800 0022h. The part belongs to the car again when its holder releases it, falls
// silent, or boots, and after a reset of the terminal. Keys are sent while their part works, for
// any holder: the holder is in the same PDO.
#pragma once

#include <array>
#include <bitset>
#include <string_view>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/devices/cia447/terminal/icon_row.hpp"
#include "canvoy/devices/cia447/terminal/part_lock.hpp"
#include "canvoy/devices/cia447/terminal/pressed_keys.hpp"
#include "canvoy/devices/cia447/terminal/terminal_display.hpp"
#include "canvoy/devices/cia447/terminal/terminal_part.hpp"
#include "canvoy/devices/cia447/terminal/text_area.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"

namespace canvoy::cia447 {

/// The functional warnings, in the order of their commands (60A2h).
enum class TerminalWarning : std::uint8_t {
  fire_cartridge_empty = 1,
  fire_active,
  fire_on,
  fire_fault,
  air_cylinder_empty,
  air_active,
  air_inactive
};
inline constexpr unsigned terminal_warning_count = 7;  ///< of TerminalWarning

/// Empty callbacks have no effect.
struct TerminalHardware {
  Callback<void(const DisplayContent&)> show = {};        ///< on each change of a display
  Callback<void(const ShownIcon&)> show_icon = {};        ///< on each change of an icon
  Callback<void(bool is_on)> buzz = {};                   ///< on or off
  Callback<void(TerminalWarning, bool is_on)> warn = {};  ///< a warning lamp, on or off
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(TerminalHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::show; } || requires { &Plain::show_icon; } || requires { &Plain::buzz; } ||
          requires { &Plain::warn; },
      "the class has no member function of TerminalHardware: show, show_icon, buzz or warn");
  if constexpr (requires { &Plain::show; }) hardware.show = callback<&Plain::show>(plain);
  if constexpr (requires { &Plain::show_icon; })
    hardware.show_icon = callback<&Plain::show_icon>(plain);
  if constexpr (requires { &Plain::buzz; }) hardware.buzz = callback<&Plain::buzz>(plain);
  if constexpr (requires { &Plain::warn; }) hardware.warn = callback<&Plain::warn>(plain);
}

/// Sizes of the displays.
struct TerminalSettings {
  TextArea display_1 = {.lines = 4, .columns = 20, .characters = 80};  ///< with a title
  TextArea display_2 = {.lines = 2, .columns = 16, .characters = 32};  ///< without a title
  /// Parts that this terminal lacks, by the numbers of TerminalPart.
  std::bitset<terminal_part_count> missing = {};
};

class TerminalUnit {
 public:
  /// Makes the unit; what `hardware` refers to must outlive it.
  TerminalUnit(CarNetwork& network, const TerminalHardware& hardware,
               const TerminalSettings& settings);

  // Actions of the person. A key stays pressed until it is released.

  /// Reports that a key of a pad, or a tip switch, is pressed.
  template <class Key>
  void press(Key key) {
    pad_of(key).keys.press(key);
    tell(pad_of(key).part);
  }
  /// Reports that a key of a pad, or a tip switch, is released.
  template <class Key>
  void release(Key key) {
    pad_of(key).keys.release(key);
    tell(pad_of(key).part);
  }
  /// Reports the emergency key.
  void press_emergency_key(bool is_pressed = true);

  /// Sets the state of a part. A missing part stays missing.
  void sense(TerminalPart part, PartState state);

  /// Holder: 1 to 16, or 0 for the car itself.
  unsigned holder(TerminalPart part) const { return locks_[number_of(part)].holder(); }
  /// What a display shows at present.
  DisplayContent content(TerminalDisplay display) const;
  /// True while a warning lamp is lit.
  bool is_warning(TerminalWarning warning) const {
    return warnings_[static_cast<unsigned>(warning) - 1];
  }

 private:
  template <class Key>
  struct Pad {
    TerminalPart part;
    PressedKeys<Key>& keys;
  };

  static constexpr unsigned number_of(TerminalPart part) { return static_cast<unsigned>(part); }
  Pad<NumberPadKey> pad_of(NumberPadKey) { return {TerminalPart::number_pad, number_pad_}; }
  Pad<FunctionKey> pad_of(FunctionKey) { return {TerminalPart::function_pad, function_keys_}; }
  Pad<ControlKey> pad_of(ControlKey) { return {TerminalPart::control_pad, control_keys_}; }
  Pad<TipSwitch> pad_of(TipSwitch) { return {TerminalPart::switch_pad, switch_pad_}; }

  void reset(ResetScope scope);
  void lost(NodeId node);
  AbortCode refuses(const Commanded& wanted);
  void commanded(const Commanded& wanted);
  void command_warnings(WarningCommand command);
  void set_warning(TerminalWarning warning, bool is_on);
  void buzz(bool is_on, NodeId client);
  AbortCode check_title(const Entry& entry, std::span<const std::uint8_t> text);
  AbortCode check_text_1(const Entry& entry, std::span<const std::uint8_t> text);
  AbortCode check_text_2(const Entry& entry, std::span<const std::uint8_t> text);
  AbortCode check_text(TerminalPart part, const TextArea& area,
                       std::span<const std::uint8_t> text) const;
  void display_1_written();
  void display_2_written();
  void tell(TerminalPart part);
  template <class Handle, class Code>
  void report_sensed(TerminalPart part, const Handle& handle, Code sensed);
  void report_warnings();
  TerminalAccess access(TerminalPart part) const;
  void report_display(TerminalDisplay display);
  void report_parameters();
  void list_lacking();
  PartState state(TerminalPart part) const { return states_[number_of(part)]; }
  bool has(TerminalPart part) const { return state(part) != PartState::not_available; }

  CarNetwork& network_;
  TerminalHardware hardware_;
  TerminalSettings settings_;
  Values values_;
  std::array<PartState, terminal_part_count> states_{};
  std::array<PartLock, lockable_part_count> locks_{};

  PressedKeys<NumberPadKey> number_pad_;
  PressedKeys<FunctionKey> function_keys_;
  PressedKeys<ControlKey> control_keys_;
  PressedKeys<TipSwitch> switch_pad_;
  bool emergency_key_ = false;

  bool takes_iso_tp_ = false;  ///< display 1 is locked for contents by ISO-TP
  bool is_buzzing_ = false;
  NodeId buzzed_by_ = 0;
  std::array<bool, terminal_warning_count> warnings_{};

  /// Fields of commands of missing parts: an icon's command has three.
  static constexpr std::size_t lacking_max = lockable_part_count + 2 + 2 * 3 * IconRow::icons;
  std::array<FieldPlace, lacking_max> lacking_{};
  std::size_t lacking_count_ = 0;

  Callback<void(NodeId)> next_lost_;
  Commands commands_;
  IconRow icons_1_;
  IconRow icons_2_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// Other devices write the texts; the terminal is their consumer (rw).
inline constexpr const ObjectInfo* terminal_texts[] = {
    &display_1_text_object, &display_1_title_object, &display_2_text_object};
/// Objects of the virtual device without the texts.
inline constexpr auto terminal_own_list = [] {
  ObjectList<terminal_list.size() - std::size(terminal_texts)> own{};
  std::size_t count = 0;
  for (const ObjectInfo* object : terminal_list) {
    if (std::ranges::find(terminal_texts, object) == std::end(terminal_texts))
      own[count++] = object;
  }
  return own;
}();
inline constexpr VirtualDeviceInfo terminal_with_texts = device_of<terminal_own_list>(
    terminal_device.name, terminal_device.clause, terminal_device.description);

/// Catalogue row of the terminal (4.2.9); car_unit makes it a part of a device.
struct TerminalKind : CarKind<TerminalUnit, TerminalHardware, TerminalSettings> {
  static constexpr DeviceInfo info = {
      .name = "terminal",
      .title = "terminal",
      .product = "Canvoy CiA 447 terminal",
      .product_code = 44706,
      .node_id = 2,
      .hardware = "keys pressed by a person; texts, icons, buzzer and warnings shown"};
  static constexpr const VirtualDeviceInfo& provides = terminal_with_texts;
  static constexpr const auto& consumes = terminal_texts;
};

}  // namespace canvoy::cia447
