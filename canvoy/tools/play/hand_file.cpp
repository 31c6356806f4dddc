#include "canvoy/tools/play/hand_file.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"

namespace canvoy::tools {

SettingTable<HandOfFile> hand_table(std::string device) {
  return {"hands",
          "",
          {mapped<HandOfFile, std::string>(
               {.key = "at",
                .takes = R"(a time, as `"30s"`, or `"0s"`)",
                .read = [](HandOfFile& hand,
                           const std::string& text) { hand.at = parse_moment_argument(text); },
                .write = [](const HandOfFile& hand) { return written(hand.at); },
                .is_needed = true}),
           mapped<HandOfFile, std::string>(
               {.key = "device",
                .takes = std::move(device),
                .read = [](HandOfFile& hand, const std::string& text) { hand.device = text; },
                .write = [](const HandOfFile& hand) { return hand.device; },
                .is_needed = true}),
           setting<&HandOfFile::press>("press", "a key, as in hands.md: `hire`"),
           setting<&HandOfFile::set>("set", "or what it senses: `paper=no`")}};
}

Setting<HandOfFile> place_setting(std::string key, std::string help, unsigned most,
                                  std::function<unsigned(const HandOfFile&)> get,
                                  std::function<void(HandOfFile&, unsigned)> set) {
  return mapped<HandOfFile, double>(
      {.key = std::move(key),
       .takes = fmt::format("a whole number from 1 to {}", most),
       .read =
           [set = std::move(set)](HandOfFile& hand, double value) {
             if (value != std::floor(value)) throw UsageError("it is a whole number");
             set(hand, static_cast<unsigned>(value));
           },
       .write = [get = std::move(get)](const HandOfFile& hand) -> std::optional<double> {
         const unsigned value = get(hand);
         return value == 0 ? std::nullopt : std::optional<double>(value);
       },
       .range = {1, static_cast<double>(most)}},
      std::move(help));
}

HandOrder checked_order(const HandOfFile& hand, std::span<const HandTable> tables) {
  return parse_hand_order(tables, hand.order() + "@0s");
}

HandOrder order_of(const TomlTable& table, const HandOfFile& hand,
                   std::span<const HandTable> tables) {
  if (hand.press.empty() == hand.set.empty()) table.refuse("write press = or set =");
  const char* const key = hand.press.empty() ? "set" : "press";
  if (hand.order().find('@') != std::string::npos) table.refuse(key, "its time is at =");
  HandOrder order;
  try {
    order = checked_order(hand, tables);
  } catch (const UsageError& error) {
    table.refuse(key, error.what());
  }
  if (order.sets() == hand.press.empty()) return order;
  table.refuse(key, order.sets() ? "it is set: write set =" : "it is pressed: write press =");
}

void add_hand(const TomlTable& table, std::vector<HandOfFile>& hands, HandOfFile hand) {
  if (hands.size() == hands_of_file_max) {
    table.refuse(fmt::format("there are more than {} of them", hands_of_file_max));
  }
  hands.push_back(std::move(hand));
}

void plan_hand(World& world, const HandOfFile& hand, const HandOrder& order, const HandAct& act) {
  const auto plan = [&](Duration at, const HandOrder& what, const std::string& text) {
    world.at(Time{} + at, [act, what, text](Time now) { act(now, what, text); });
  };
  plan(hand.at, order, hand.order());
  if (!order.is_press) return;
  HandOrder release = order;
  release.value = hand_key_value(false);
  plan(hand.at + hand_key_time, release, hand.order() + "=released");
}

}  // namespace canvoy::tools
