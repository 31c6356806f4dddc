#include "canvoy/tools/play/world_hands.hpp"

#include <algorithm>

#include "canvoy/tools/cli/spelling.hpp"

namespace canvoy::tools {

void check_hand(const TomlTable& table, const HandOfFile& hand, std::span<const HandPlace> places) {
  const auto place = std::ranges::find(places, hand.device, &HandPlace::name);
  if (place == places.end()) {
    std::vector<std::string> names;
    for (const HandPlace& each : places) names.push_back(each.name);
    table.refuse("device", fmt::format("there is no '{}'{}: there are {}", hand.device,
                                       did_you_mean(hand.device, names), fmt::join(names, ", ")));
  }
  const HandOrder order = order_of(table, hand, hand_tables(place->units));
  if (!order.hand->is_around) return;
  table.refuse(hand.press.empty() ? "set" : "press",
               fmt::format("{} is the car's own, which the run moves", order.hand->name));
}

HandActed act(const HandOrder& order, car::CarNode& node, const std::string& text) {
  HandActed acted{.node = node.place().id, .what = text};
  if (!node.is_powered()) {
    acted.refused = "it has no power";
    return acted;
  }
  const auto unit = std::ranges::find(node.units(), order.device,
                                      [](const cia447::CarUnit* each) { return each->info.name; });
  HandTarget target{.unit = node.device().unit(**unit)};
  if (!order.hand->act(target, order.value)) acted.refused = why_refused(*order.hand, target);
  return acted;
}

}  // namespace canvoy::tools
