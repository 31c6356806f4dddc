// What hands do on the devices of CiA 447 of one node, and when: as the command line says, or a
// line that comes while they run.
//
//     CarHands hands(units, {.car = &car}, output);
//     hands.join(site);
//     hands.take(parse_hand_order(units, "hire@10s"));
//     hands.step(node, now);   // often
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia447/car_device.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/tools/device/car/car_hand.hpp"
#include "canvoy/tools/device/device_output.hpp"

namespace canvoy::tools {

/// A hand, what it is told, and when: from the start on.
struct HandOrder {
  const cia447::CarUnit* unit = nullptr;
  const CarHand* hand = nullptr;
  HandValue value{};
  Duration at{};
  bool is_press = false;  ///< of a key: it is released after a time
};

/// `hire@10s`, `paper=no@2s`; where several of the units have such a hand, with the device that is
/// meant: `taxi-alarm.reset@2s`. Throws UsageError for what none of these units has, or takes, with
/// what they have.
HandOrder parse_hand_order(std::span<const cia447::CarUnit* const> units, std::string_view text);
/// Whether one of the units has a hand of the name that stands there.
bool has_hand(std::span<const cia447::CarUnit* const> units, std::string_view text);

/// What may stand behind --press (`sets` false) and --set for these units: `hire@`, `paper=no@`.
std::vector<std::string> hand_completions(std::span<const cia447::CarUnit* const> units, bool sets);

class CarHands {
 public:
  /// `around` is what hands act on beside the units. All must outlive this.
  CarHands(std::span<const cia447::CarUnit* const> units, const HandTarget& around,
           const DeviceOutput& output);
  CarHands(const CarHands&) = delete;
  CarHands& operator=(const CarHands&) = delete;

  /// This must outlive the devices that are made there.
  void join(Site& site);
  /// Throws UsageError where more than 10,000 wait.
  void take(const HandOrder& order);
  /// Does what is due. Times count from the first call.
  void step(Node& node, Time now);

  /// The unit of a kind; null: it is none of these.
  template <class Kind>
  typename Kind::Unit* unit() const {
    const auto found = made_.find(Kind::info.name);
    return found == made_.end() ? nullptr : static_cast<typename Kind::Unit*>(found->second);
  }

 private:
  template <class Kind>
  void watch(Site& site);
  template <class Kind>
  void has(typename Kind::Unit& unit, Node& node);
  void act(const HandOrder& order);

  std::vector<const cia447::CarUnit*> units_;
  HandTarget around_;
  const DeviceOutput& output_;
  std::map<std::string_view, void*> made_;  ///< units, by their names
  std::vector<HandOrder> orders_;           ///< by their times
  std::optional<Time> begin_;
};

}  // namespace canvoy::tools
