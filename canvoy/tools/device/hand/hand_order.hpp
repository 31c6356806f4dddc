// Actions by hand on devices, with their times: from the command line, or from lines read at run
// time.
//
//     HandOrders orders(tables);
//     orders.take("hire@10s");
//     orders.step(node, now, [](const HandOrder& order) { ... });   // often
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/tools/device/hand/device_hand.hpp"

namespace canvoy::tools {

/// A hand, its value, and its time from the start.
struct HandOrder {
  std::string_view device;  ///< name in the table
  const DeviceHand* hand = nullptr;
  unsigned number = 0;  ///< number of a numbered hand, from 1
  HandValue value{};
  Duration at{};
  bool is_press = false;  ///< for a key: released after a time

  /// True if a value is set, false for a press.
  bool sets() const { return hand->form != HandForm::action && !is_press; }
};

/// Reads `hire@10s`, `paper=no@2s`, `input5=on@1s`; if several devices have the hand, with the
/// device: `taxi-alarm.reset@2s`. Throws UsageError, with the possible hands or values, if none of
/// these devices accepts it. The hands of the tables must outlive the order.
HandOrder parse_hand_order(std::span<const HandTable> tables, std::string_view text);
/// True if one of the devices has a hand with the name in `text`.
bool has_hand(std::span<const HandTable> tables, std::string_view text);
/// Throws UsageError, with the name of the option, for a press that does not belong to --press, or
/// a value that does not belong to --set (or the option that sets).
void check_hand_options(std::span<const HandTable> tables, std::span<const std::string> presses,
                        std::span<const std::string> sets, const char* set_option = "--set");

/// Completions for --press (`sets` false) and --set with these tables: `hire@`, `paper=no@`.
std::vector<std::string> hand_completions(std::span<const HandTable> tables, bool sets);

/// Orders for several devices, each waiting for its time.
class HandOrders {
 public:
  /// What the tables refer to must outlive this.
  explicit HandOrders(std::vector<HandTable> tables) : tables_(std::move(tables)) {}

  /// True if one of the devices has a hand with the name in `order`.
  bool has(std::string_view order) const { return has_hand(tables_, order); }
  /// Throws UsageError for what parse_hand_order() does not accept, and if more than 10,000 orders
  /// wait.
  void take(std::string_view order) { keep(parse_hand_order(tables_, order)); }
  /// Calls `act` for what is due, after advancing the node to `now`. Times count from the first
  /// call. A pressed key is released after hand_key_time.
  void step(Node& node, Time now, const std::function<void(const HandOrder&)>& act);

 private:
  void keep(const HandOrder& order);

  std::vector<HandTable> tables_;
  std::vector<HandOrder> orders_;  ///< in order of time
  std::optional<Time> begin_;
};

}  // namespace canvoy::tools
