// One icon display: up to four icons, each locked, selected and highlighted separately (CiA 447-3,
// 60A6h and 60A7h, 60AAh and 60ABh; errata Z11, Z20, Z24).
//
//     IconRow icons(network, IconDisplay::display_1, {.shown = ...});
//
// One word commands all of an icon: a client that locks it and selects an icon in the same word
// gets both. A selection for an icon that the car has is refused (0800 0022h), unless the same word
// locks it.
#pragma once

#include <array>
#include <span>

#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/devices/cia447/terminal/part_lock.hpp"
#include "canvoy/devices/cia447/terminal/terminal_part.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

/// One of the two icon displays.
enum class IconDisplay : std::uint8_t { display_1, display_2 };

/// An icon as it is shown.
struct ShownIcon {
  IconDisplay display = IconDisplay::display_1;  ///< on which it is
  unsigned number = 1;                           ///< 1 to 4
  bool is_locked = false;                        ///< otherwise the car selects what is shown
  Icon icon = Icon::none;                        ///< none: dark
  bool is_highlighted = false;                   ///< drawn stronger

  friend constexpr bool operator==(const ShownIcon&, const ShownIcon&) = default;
};

class IconRow {
 public:
  static constexpr unsigned icons = 4;  ///< in a display

  /// Construct it after the Commands that check the same objects.
  IconRow(CarNetwork& network, IconDisplay display, Callback<void(const ShownIcon&)> shown);

  /// True if a command is for an icon of this display.
  bool is_mine(const FieldPlace& place) const;
  /// Takes a command that Commands has accepted.
  void commanded(const Commanded& wanted);
  /// Releases the icons that a lost node holds.
  void lose(NodeId node);
  /// Releases all icons.
  void reset();
  /// Reports whether the display works.
  void sense(PartState state);
  /// What an icon, 1 to 4, shows.
  const ShownIcon& icon(unsigned number) const { return shown_[number - 1]; }

 private:
  /// Distance from the command of the first display to that of this one.
  static std::uint16_t shift_to(IconDisplay display);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value);
  void release(unsigned number);
  void tell(unsigned number);

  CarNetwork& network_;
  IconDisplay display_;
  Callback<void(const ShownIcon&)> show_;
  PartState state_ = PartState::working;
  std::array<PartLock, icons> locks_{};
  std::array<ShownIcon, icons> shown_{};
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this, shift_to(display_)};
};

}  // namespace canvoy::cia447
