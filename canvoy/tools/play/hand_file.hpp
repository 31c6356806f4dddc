// Hands of a network file, at devices that are played: `[[hands]]`.
//
//     [[hands]]
//     at = "10min"
//     device = "printer"
//     set = "paper=no"         # or press = "..."
//
// The hands act like --set and --press of `canvoy device` (docs/hands.md). They are events, and do
// not excuse a broken invariant.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/tools/device/hand/hand_order.hpp"
#include "canvoy/tools/play/world_file.hpp"

namespace canvoy::tools {

inline constexpr std::size_t hands_of_file_max = 10'000;

struct HandOfFile {
  Duration at{};  ///< from the start
  std::string device{};
  std::string press{};  ///< either this
  std::string set{};    ///< `paper=no`

  // For a world with several devices of a kind.
  unsigned lift = 1;
  NodeId node = 0;     ///< 0: the first one
  unsigned floor = 0;  ///< floor of the device; 0: the first one
  unsigned bay = 0;    ///< of a charging yard; 0: the first one

  const std::string& order() const { return press.empty() ? set : press; }
};

/// The keys of `[[hands]]`.
SettingTable<HandOfFile> hand_table(std::string device = "the name of a device's table");
/// A key of `[[hands]]` for a place, a number from 1 to `most`; 0: not written.
Setting<HandOfFile> place_setting(std::string key, std::string help, unsigned most,
                                  std::function<unsigned(const HandOfFile&)> get,
                                  std::function<void(HandOfFile&, unsigned)> set);
/// The order for a device with these tables; their hands must outlive it. Throws Failure with file
/// and line if the device has no such hand.
HandOrder order_of(const TomlTable& table, const HandOfFile& hand,
                   std::span<const HandTable> tables);
/// Like order_of(), but for a hand that was checked.
HandOrder checked_order(const HandOfFile& hand, std::span<const HandTable> tables);
/// Throws Failure with file and line if there are too many.
void add_hand(const TomlTable& table, std::vector<HandOfFile>& hands, HandOfFile hand);

/// Performs an order at its time, with the text of its event.
using HandAct = std::function<void(Time now, const HandOrder& order, const std::string& text)>;
/// Plans a hand at its time. A pressed key is released after hand_key_time.
void plan_hand(World& world, const HandOfFile& hand, const HandOrder& order, const HandAct& act);

}  // namespace canvoy::tools
