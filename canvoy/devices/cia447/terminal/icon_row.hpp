// One icon display: up to four icons, each locked, chosen and highlighted on its own (CiA 447-3,
// 60A6h and 60A7h, 60AAh and 60ABh; errata Z11, Z20, Z24).
//
//     IconRow icons(network, IconDisplay::display_1, {.shown = ...});
//
// One word commands all of an icon: who locks it and names an icon in the same word gets both. What
// is named for an icon that the car has is refused (0800 0022h), unless the same word locks it.
#pragma once

#include <array>
#include <span>

#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/devices/cia447/commands.hpp"
#include "canvoy/devices/cia447/terminal/part_lock.hpp"
#include "canvoy/devices/cia447/terminal/terminal_part.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

enum class IconDisplay : std::uint8_t { display_1, display_2 };

struct ShownIcon {
  IconDisplay display = IconDisplay::display_1;
  unsigned number = 1;     ///< 1 to 4
  bool is_locked = false;  ///< else the car shows what it likes
  Icon icon = Icon::none;
  bool is_highlighted = false;

  friend constexpr bool operator==(const ShownIcon&, const ShownIcon&) = default;
};

class IconRow {
 public:
  static constexpr unsigned icons = 4;

  /// It has to be made behind the Commands that check the same objects.
  IconRow(CarNetwork& network, IconDisplay display, Callback<void(const ShownIcon&)> shown);
  IconRow(const IconRow&) = delete;
  IconRow& operator=(const IconRow&) = delete;

  bool is_mine(const FieldPlace& place) const;
  /// What Commands has accepted.
  void commanded(const Commanded& wanted);
  void lose(NodeId node);
  /// Lets go of all.
  void reset();
  void sense(PartState state);
  const ShownIcon& icon(unsigned number) const { return shown_[number - 1]; }

 private:
  /// From the command of the first display to that of this one.
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
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this, shift_to(display_)};
};

}  // namespace canvoy::cia447
