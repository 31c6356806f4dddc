#include "canvoy/tools/device/hand/hand_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>

#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"

namespace canvoy::tools {

namespace {

using HandTables = std::span<const HandTable>;

/// `taxi-alarm.reset=...@2s`, split.
struct OrderText {
  std::string_view device{};  ///< empty: not given
  std::string_view name;
  std::optional<std::string_view> value{};
  std::optional<std::string_view> at{};
};

OrderText split_order(HandTables tables, std::string_view text) {
  OrderText parts;
  if (const std::size_t at = text.rfind('@'); at != std::string_view::npos) {
    parts.at = text.substr(at + 1);
    text = text.substr(0, at);
  }
  if (const std::size_t equals = text.find('='); equals != std::string_view::npos) {
    parts.value = text.substr(equals + 1);
    text = text.substr(0, equals);
  }
  const std::size_t dot = text.find('.');
  const bool names_device =
      dot != std::string_view::npos &&
      std::ranges::find(tables, text.substr(0, dot), &HandTable::device) != tables.end();
  if (names_device) {
    parts.device = text.substr(0, dot);
    text = text.substr(dot + 1);
  }
  parts.name = text;
  return parts;
}

/// The number in `input5` for `input`; nothing for another name.
std::optional<unsigned> number_of(const DeviceHand& hand, std::string_view name) {
  if (!name.starts_with(hand.name)) return std::nullopt;
  name.remove_prefix(hand.name.size());
  unsigned number = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data(), end, number);
  const bool is_one = error == std::errc{} && stop == end && !name.starts_with('0');
  return is_one && number <= hand.count ? std::optional(number) : std::nullopt;
}

/// The number of a numbered hand, else 0; nothing for another name.
std::optional<unsigned> called(const DeviceHand& hand, std::string_view name) {
  if (hand.count > 0) return number_of(hand, name);
  constexpr std::string_view usual = "key-";
  if (hand.name == name) return 0;
  // Keys of a terminal, by their labels.
  const bool is_key = hand.form == HandForm::key && hand.name.starts_with(usual) &&
                      std::string_view(hand.name).substr(usual.size()) == name;
  return is_key ? std::optional(0U) : std::nullopt;
}

std::vector<HandOrder> found_hands(HandTables tables, const OrderText& text) {
  std::vector<HandOrder> found;
  for (const HandTable& table : tables) {
    if (!text.device.empty() && text.device != table.device) continue;
    for (const DeviceHand& hand : table.hands) {
      const std::optional<unsigned> number = called(hand, text.name);
      if (!number) continue;
      found.push_back({.device = table.device, .hand = &hand, .number = *number});
      break;
    }
  }
  return found;
}

[[noreturn]] void refuse_hand(HandTables tables, std::string_view text, const OrderText& parts) {
  std::vector<std::string> names;
  std::string list;
  for (const HandTable& table : tables) {
    for (const DeviceHand& hand : table.hands) {
      names.push_back(hand.name);
      list += fmt::format("{}{}{}", list.empty() ? "" : ", ", hand_name_text(hand),
                          hand.is_pressed() ? "" : "=");
    }
  }
  if (list.empty()) {
    throw UsageError(fmt::format("'{}': {} has no hands: all that it does follows from the bus",
                                 text, tables.empty() ? "this" : tables.front().device));
  }
  throw UsageError(fmt::format("'{}': nothing here is '{}'{}: there is {}", text, parts.name,
                               did_you_mean(parts.name, names), list));
}

std::string example_value(const DeviceHand& hand) {
  if (hand.form == HandForm::text) return std::string(hand.example);
  return hand.form == HandForm::number ? fmt::format("{}", hand.most) : hand.words.front().word;
}

}  // namespace

bool has_hand(HandTables tables, std::string_view text) {
  return !found_hands(tables, split_order(tables, text)).empty();
}

HandOrder parse_hand_order(HandTables tables, std::string_view text) {
  const OrderText parts = split_order(tables, text);
  const std::vector<HandOrder> found = found_hands(tables, parts);
  if (found.empty()) refuse_hand(tables, text, parts);
  HandOrder order = found.front();
  const DeviceHand& hand = *order.hand;
  if (found.size() > 1) {
    throw UsageError(fmt::format("'{}': several devices have it: write {}.{} or {}.{}", text,
                                 found[0].device, parts.name, found[1].device, parts.name));
  }
  if (!parts.at) throw UsageError(fmt::format("'{}' has no time: write {}@2s", text, text));
  order.at = parse_moment_argument(*parts.at);
  if (parts.value && hand.form == HandForm::action) {
    throw UsageError(
        fmt::format("'{}': {} takes no value: write {}@2s", text, parts.name, parts.name));
  }
  if (parts.value) {
    order.value = parse_hand_value(hand, *parts.value);
  } else if (hand.form == HandForm::key) {
    order.value = hand_key_value(true);
    order.is_press = true;
  } else if (hand.form != HandForm::action) {
    throw UsageError(fmt::format("'{}': {} takes {}: write {}={}@2s", text, parts.name,
                                 hand_values_text(hand), parts.name, example_value(hand)));
  }
  return order;
}

void check_hand_options(HandTables tables, std::span<const std::string> presses,
                        std::span<const std::string> sets, const char* set_option) {
  const auto check = [&](const char* option, const std::string& text, bool is_set) {
    HandOrder order;
    try {
      order = parse_hand_order(tables, text);
    } catch (const UsageError& error) {
      throw UsageError(fmt::format("{}: {}", option, error.what()));
    }
    if (is_set == order.sets()) return;
    throw UsageError(fmt::format("{}: '{}': {} it: {} {}", option, text, is_set ? "press" : "set",
                                 is_set ? "--press" : set_option, text));
  };
  for (const std::string& text : presses) check("--press", text, false);
  for (const std::string& text : sets) check(set_option, text, true);
}

std::vector<std::string> hand_completions(HandTables tables, bool sets) {
  std::vector<std::string> all;
  for (const HandTable& table : tables) {
    for (const DeviceHand& hand : table.hands) {
      const std::string name = hand.count == 0 ? hand.name : hand.name + "1";
      if (!sets && hand.is_pressed()) all.push_back(name + "@");
      if (!sets || hand.form == HandForm::action) continue;
      if (hand.words.empty()) all.push_back(name + "=");
      for (const HandWord& word : hand.words) {
        all.push_back(fmt::format("{}={}@", name, word.word));
      }
    }
  }
  return all;
}

void HandOrders::keep(const HandOrder& order) {
  constexpr std::size_t orders_max = 10'000;
  if (orders_.size() >= orders_max) {
    throw UsageError(fmt::format("{} hands wait for their time: no more", orders_max));
  }
  const auto behind = std::ranges::upper_bound(orders_, order.at, {}, &HandOrder::at);
  orders_.insert(behind, order);
}

void HandOrders::step(Node& node, Time now, const std::function<void(const HandOrder&)>& act) {
  const Time begin = begin_.value_or(now);
  begin_ = begin;
  while (!orders_.empty() && now - begin >= orders_.front().at) {
    HandOrder order = orders_.front();
    orders_.erase(orders_.begin());
    // An action from outside of the node: the node is advanced to the present.
    node.advance(now);
    act(order);
    if (!order.is_press) continue;
    order.value = hand_key_value(false);
    order.is_press = false;
    order.at = now - begin + hand_key_time;
    keep(order);
  }
}

}  // namespace canvoy::tools
