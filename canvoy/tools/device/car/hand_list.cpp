#include "canvoy/tools/device/car/hand_list.hpp"

#include <fmt/format.h>

#include "canvoy/tools/device/car/car_hand_tables.hpp"
#include "canvoy/tools/device/device_catalogue.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/json_event.hpp"

namespace canvoy::tools {

namespace {

using HandedUnits = std::vector<const cia447::CarUnit*>;

HandedUnits units_with_hands() {
  HandedUnits units;
  for (const DeviceKind* kind : device_catalogue()) {
    if (kind->car_unit != nullptr) units.push_back(kind->car_unit);
  }
  return units;
}

HandedUnits units_named(const std::vector<std::string>& devices) {
  HandedUnits units;
  for (const std::string& name : devices) {
    const DeviceKind* const kind = find_any_device_kind(name);
    HandedUnits found = parse_shared_node(name).car;
    if (kind != nullptr && kind->car_unit != nullptr) found.push_back(kind->car_unit);
    if (found.empty()) {
      throw UsageError(fmt::format("--hands: '{}' is no device of CiA 447", name));
    }
    units.insert(units.end(), found.begin(), found.end());
  }
  return units;
}

/// `600Dh`, `60D0h:04h`; several with a comma.
std::string changes_text(const CarHand& hand) {
  std::string text;
  for (const cia447::FieldPlace& place : hand.changes) {
    const std::string sub = place.sub == 0 ? "" : fmt::format(":{:02X}h", place.sub);
    text += fmt::format("{}{:04X}h{}", text.empty() ? "" : ", ", place.index, sub);
  }
  return text;
}

std::string order_text(const CarHand& hand) {
  return hand.form == HandForm::action ? hand.name : hand.name + "=";
}

}  // namespace

void print_hand_list(const std::vector<std::string>& devices, bool json) {
  for (const cia447::CarUnit* unit : devices.empty() ? units_with_hands() : units_named(devices)) {
    for (const CarHand& hand : car_hands(*unit)) {
      const bool is_pressed = hand.form == HandForm::action || hand.form == HandForm::key;
      if (json) {
        JsonEvent line("hand");
        line->key("device").text(unit->info.name);
        line->key("name").text(hand.name);
        line->key("is_pressed").truth(is_pressed);
        line->key("values").text(hand_values_text(hand));
        line->key("changes").text(changes_text(hand));
        line->key("clause").text(hand.clause);
        line.print();
        continue;
      }
      fmt::print("{:<22} {:<34} {}{}{}; {}\n", unit->info.name, order_text(hand),
                 is_pressed ? "press" : "", is_pressed && hand.form == HandForm::key ? ", or " : "",
                 hand_values_text(hand), fmt::format("{}, {}", changes_text(hand), hand.clause));
    }
  }
}

std::string hand_page() {
  std::string page =
      "# Hands on devices of a car\n\nWhat `canvoy device` presses (`--press NAME@TIME`), sets "
      "(`--set NAME=VALUE@TIME`) and takes from standard input (`--stdin`) of devices of CiA "
      "447-3: `canvoy device printer --hands` says the same of one. A hand without `=` is pressed; "
      "a key is pressed and released after 300 ms, or set. `no` and `off`, `yes` and `on` stand "
      "for "
      "the two states of which the first says no. What follows from something else has no hand, "
      "and "
      "the page says from what.\n";
  for (const cia447::CarUnit* unit : units_with_hands()) {
    page +=
        fmt::format("\n## `{}`\n\n| hand | takes | changes | clause |\n| --- | --- | --- | --- |\n",
                    unit->info.name);
    for (const CarHand& hand : car_hands(*unit)) {
      page += fmt::format("| `{}` | {} | {} | {} |\n", order_text(hand), hand_values_text(hand),
                          changes_text(hand), hand.clause);
    }
    const auto without = without_hands(*unit);
    if (!without.empty()) page += "\nWithout a hand:\n\n";
    for (const WithoutHand& one : without) {
      const bool has_sub = one.sub != WithoutHand::all && one.sub != 0;
      page += fmt::format("- {:04X}h{}: {}\n", one.index,
                          has_sub ? fmt::format(":{:02X}h", one.sub) : "", one.why);
    }
  }
  return page;
}

}  // namespace canvoy::tools
