#include "canvoy/tools/device/hand_list.hpp"

#include <fmt/format.h>

#include <span>
#include <utility>

#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/json_event.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/car/car_hand_tables.hpp"
#include "canvoy/tools/device/catalogue/device_catalogue.hpp"
#include "canvoy/tools/device/catalogue/operator_elements.hpp"
#include "canvoy/tools/device/seat/seat_hands.hpp"
#include "canvoy/tools/device/wired_hands.hpp"

namespace canvoy::tools {

namespace {

/// The hands of one device of the catalogue, and its statuses without a hand.
struct Handed {
  std::string_view device;
  std::vector<DeviceHand> hands;
  std::span<const WithoutHand> without{};
};

Handed handed(std::string_view name, const DeviceKind* kind) {
  if (kind != nullptr && kind->car_unit != nullptr) {
    return {name, car_hands(*kind->car_unit), without_hands(*kind->car_unit)};
  }
  if (kind != nullptr && kind->bus_unit != nullptr) {
    return {name, bus_press_hands(*kind->bus_unit)};
  }
  if (kind == &cia852::operator_kind) return {name, seat_hands(parse_operator_elements(""))};
  Environment middle;
  middle.floor = 2;  // with both buttons
  return {name, wired_hands(name, middle)};
}

std::vector<Handed> all_handed() {
  std::vector<Handed> all;
  for (const DeviceKind* kind : device_catalogue()) {
    Handed device = handed(kind->info.name, kind);
    if (!device.hands.empty()) all.push_back(std::move(device));
  }
  return all;
}

std::vector<Handed> handed_named(const std::vector<std::string>& devices) {
  std::vector<Handed> all;
  for (const std::string& name : devices) {
    const DeviceKind* const kind = find_any_device_kind(name);
    const SharedNode shared = parse_shared_node(name);
    if (kind == nullptr && shared.empty()) {
      throw UsageError(fmt::format("--hands: '{}' is no device of `canvoy device --list`{}", name,
                                   did_you_mean(name, all_device_names())));
    }
    if (kind != nullptr) all.push_back(handed(kind->info.name, kind));
    for (const cia447::CarUnit* unit : shared.car) {
      all.push_back({unit->info.name, car_hands(*unit), without_hands(*unit)});
    }
    for (const cia407::BusUnit* unit : shared.bus) {
      all.push_back({unit->info.name, bus_press_hands(*unit)});
    }
  }
  return all;
}

/// `600Dh`, `60D0h:04h`; several separated by commas.
std::string changes_text(const DeviceHand& hand) {
  std::string text;
  for (const cia447::FieldPlace& place : hand.changes) {
    const std::string sub = place.sub == 0 ? "" : fmt::format(":{:02X}h", place.sub);
    text += fmt::format("{}{:04X}h{}", text.empty() ? "" : ", ", place.index, sub);
  }
  return text;
}

std::string order_text(const DeviceHand& hand) {
  return hand_name_text(hand) + (hand.form == HandForm::action ? "" : "=");
}

void print_hand(std::string_view device, const DeviceHand& hand) {
  std::string takes = hand.is_pressed() ? "press" : "";
  if (hand.form == HandForm::key) takes += ", or ";
  takes += hand_values_text(hand);
  const std::string changes = changes_text(hand);
  if (!changes.empty()) takes += "; " + changes;
  if (!hand.clause.empty()) takes += fmt::format(", {}", hand.clause);
  fmt::print("{:<22} {:<34} {}\n", device, order_text(hand), takes);
}

void print_hand_json(std::string_view device, const DeviceHand& hand) {
  JsonEvent line("hand");
  line->key("device").text(device);
  line->key("name").text(hand.name);
  line->key("count").number(hand.count);
  line->key("is_pressed").truth(hand.is_pressed());
  line->key("values").text(hand_values_text(hand));
  line->key("changes").text(changes_text(hand));
  line->key("clause").text(hand.clause);
  line.print();
}

void add_device(std::string& page, const Handed& device) {
  page +=
      fmt::format("\n## `{}`\n\n| hand | takes | changes | clause |\n| --- | --- | --- | --- |\n",
                  device.device);
  for (const DeviceHand& hand : device.hands) {
    page += fmt::format("| `{}` | {} | {} | {} |\n", order_text(hand), hand_values_text(hand),
                        changes_text(hand), hand.clause);
  }
  if (!device.without.empty()) page += "\nWithout a hand:\n\n";
  for (const WithoutHand& one : device.without) {
    const bool has_sub = one.sub != WithoutHand::all && one.sub != 0;
    page += fmt::format("- {:04X}h{}: {}\n", one.index,
                        has_sub ? fmt::format(":{:02X}h", one.sub) : "", one.why);
  }
}

}  // namespace

void print_hand_list(const std::vector<std::string>& devices, bool json) {
  for (const Handed& device : devices.empty() ? all_handed() : handed_named(devices)) {
    for (const DeviceHand& hand : device.hands) {
      json ? print_hand_json(device.device, hand) : print_hand(device.device, hand);
    }
    if (device.hands.empty() && !json) {
      fmt::print("{:<22} no hands: all that it does follows from the bus\n", device.device);
    }
  }
}

std::vector<DeviceHand> device_hands(std::string_view device) {
  return handed(device, find_any_device_kind(device)).hands;
}

std::string hand_page() {
  std::string page =
      "# Hands on devices\n\nWhat `canvoy device` presses (`--press NAME@TIME`), sets "
      "(`--set NAME=VALUE@TIME`) and takes from standard input (`--stdin`): `canvoy device printer "
      "--hands` lists those of one device. A hand without `=` is pressed; a key is pressed and "
      "released after 300 ms, or set. `input1 to input64` are 64 hands. `no` and `off`, `yes` and "
      "`on` also stand for the two states of a hand, `0` and `1` for those of a button. A value "
      "that follows from another one has no hand, and the page names its source. Devices without "
      "a section here have no hands: all that they do follows from the bus.\n";
  for (const Handed& device : all_handed()) add_device(page, device);
  return page;
}

}  // namespace canvoy::tools
