#include "canvoy/worlds/lift/panel_words.hpp"

#include <algorithm>
#include <iterator>

namespace canvoy::lift {

namespace {

using cia417::BasicFunction;
using cia417::SpecialFunction;
using cia417::SpecialIndication;

/// Names from function 01h on.
constexpr std::string_view function_names[] = {"fan-1",
                                               "fan-2",
                                               "load-time-1",
                                               "load-time-2",
                                               "key-lock-1",
                                               "key-lock-2",
                                               "key-lock-3",
                                               "key-lock-4",
                                               "door-open",
                                               "door-close",
                                               "fire-service-enable",
                                               "fire-service",
                                               "hall-call-disable",
                                               "attendant-service",
                                               "vip-service",
                                               "out-of-order",
                                               "bed-passenger-service",
                                               "special-service",
                                               "service-run",
                                               "dogging-service-enable",
                                               "dogging-service-up",
                                               "dogging-service-down"};
static_assert(std::size(function_names) ==
              static_cast<std::size_t>(SpecialFunction::dogging_service_down));

struct Named {
  std::string_view name;
  PanelDisplay display;
};

constexpr PanelDisplay one(SpecialIndication indication) {
  return {BasicFunction::special_indication, cia417::sub_function_of(indication)};
}
constexpr Named displays[] = {
    {"position", {BasicFunction::position_indicator}},
    {"lantern", {BasicFunction::hall_lantern}},
    {"direction", {BasicFunction::direction_indication}},
    {"arrival", {BasicFunction::arrival_indication}},
    {"special", {BasicFunction::special_indication}},
    {"no-load", one(SpecialIndication::no_load)},
    {"full-load", one(SpecialIndication::full_load)},
    {"overload", one(SpecialIndication::overload)},
    {"fire", one(SpecialIndication::fire)},
    {"fire-brigade-service", one(SpecialIndication::fire_brigade_service)},
    {"help-is-coming", one(SpecialIndication::help_is_coming)},
    {"special-service", one(SpecialIndication::special_service)},
    {"load-time", one(SpecialIndication::load_time)},
    {"occupied", one(SpecialIndication::occupied)},
    {"out-of-order", one(SpecialIndication::out_of_order)}};

}  // namespace

std::optional<SpecialFunction> special_function_of(std::string_view name) {
  const auto* const found = std::ranges::find(function_names, name);
  if (found == std::end(function_names)) return std::nullopt;
  return static_cast<SpecialFunction>(found - std::begin(function_names) + 1);
}

std::string_view special_function_name(SpecialFunction function) {
  const auto place = static_cast<std::size_t>(function) - 1;
  return place < std::size(function_names) ? function_names[place] : std::string_view{};
}

std::vector<std::string_view> special_function_names() {
  return {std::begin(function_names), std::end(function_names)};
}

std::optional<PanelDisplay> panel_display_of(std::string_view name) {
  const auto* const found = std::ranges::find(displays, name, &Named::name);
  if (found == std::end(displays)) return std::nullopt;
  return found->display;
}

std::string_view panel_display_name(const PanelDisplay& display) {
  const auto* const found = std::ranges::find(displays, display, &Named::display);
  return found == std::end(displays) ? std::string_view{} : found->name;
}

std::vector<std::string_view> panel_display_names() {
  std::vector<std::string_view> names;
  std::ranges::transform(displays, std::back_inserter(names), &Named::name);
  return names;
}

bool is_key(SpecialFunction function) {
  switch (function) {
    case SpecialFunction::fan_1:
    case SpecialFunction::fan_2:
    case SpecialFunction::load_time_1:
    case SpecialFunction::load_time_2:
    case SpecialFunction::door_open:
    case SpecialFunction::door_close:
    case SpecialFunction::dogging_service_up:
    case SpecialFunction::dogging_service_down:
      return false;
    default:
      return true;
  }
}

}  // namespace canvoy::lift
