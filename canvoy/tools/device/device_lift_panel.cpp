#include "canvoy/tools/device/device_lift_panel.hpp"

#include <fmt/format.h>

#include <charconv>

#include "canvoy/profiles/cia417.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr std::string_view car_kind = "lift-car-panel";
constexpr Duration press_time = 300ms;

std::optional<unsigned> number_of(std::string_view text) {
  unsigned number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return number;
}

/// `up`, `down`, `open`, `close` or a floor.
std::optional<PanelPress> button_of(std::string_view kind, std::string_view name,
                                    const Site& site) {
  using cia417::BasicFunction, cia417::SpecialFunction, cia417::sub_function_of;
  if (kind != car_kind) {
    const bool up = name == "up" && site.floor < site.floors;
    const bool down = name == "down" && site.floor > 1;
    if (!up && !down) return std::nullopt;
    return PanelPress{BasicFunction::standard_hall_call, up ? cia417::hall_up : cia417::hall_down};
  }
  if (name == "open" || name == "close") {
    const auto function = name == "open" ? SpecialFunction::door_open : SpecialFunction::door_close;
    return PanelPress{BasicFunction::special_function, sub_function_of(function)};
  }
  const std::optional<unsigned> floor = number_of(name);
  if (!floor || *floor < 1 || *floor > site.floors) return std::nullopt;
  return PanelPress{BasicFunction::standard_car_call, static_cast<std::uint8_t>(*floor)};
}

PanelPress press_of(std::string_view kind, std::string_view text, const Site& site) {
  const std::size_t at = text.find('@');
  std::optional<PanelPress> press;
  if (at != std::string_view::npos) press = button_of(kind, text.substr(0, at), site);
  if (!press) {
    throw UsageError(
        fmt::format("--press: '{}' is no button of a {} with a time: write {}", text, kind,
                    kind == car_kind ? "7@2s, open@2s or close@2s" : "up@2s or down@2s"));
  }
  press->at = parse_moment_argument(text.substr(at + 1));
  return *press;
}

/// `Standard hall call acknowledgement 1`: the profile's own word, and the sub-function.
std::string name_of(cia417::BasicFunction function, std::uint8_t sub_function) {
  constexpr ValueInfo functions = {.names = cia417::output_function_names};
  const NamedValue* name = find_name(functions, static_cast<std::int64_t>(function), 8, false);
  std::string_view word = name == nullptr ? "" : name->name;
  if (function == cia417::BasicFunction::special_function) {
    constexpr ValueInfo specials = {.names = cia417::special_acknowledgement_names};
    if (const NamedValue* special = find_name(specials, sub_function, 8, false)) {
      return std::string(special->name);
    }
  }
  return fmt::format("{} {}", word, sub_function);
}

}  // namespace

LiftPanel::LiftPanel(std::string kind, const std::vector<std::string>& presses, Site& site,
                     const DeviceOutput& output)
    : kind_(std::move(kind)), site_(site), output_(output) {
  for (const std::string& text : presses) presses_.push_back(press_of(kind_, text, site));
  site.offer(Callback<cia417::OutputHardware()>::to<&LiftPanel::hardware>(*this));
  site.watch(Callback<void(cia417::InputPanelUnit&, Node&)>::to<&LiftPanel::has_inputs>(*this));
  site.watch(Callback<void(cia417::OutputPanelUnit&, Node&)>::to<&LiftPanel::has_outputs>(*this));
}

void LiftPanel::take(std::string_view press) {
  if (inputs_ == nullptr) {
    throw UsageError(fmt::format("'{}': a {} has no buttons", press, kind_));
  }
  std::erase_if(presses_, [](const PanelPress& each) { return each.done; });
  presses_.push_back(press_of(kind_, press, site_));
}

cia417::OutputHardware LiftPanel::hardware() {
  return {.show = Callback<void(std::uint32_t, const cia417::OutputView&)>::to<&LiftPanel::show>(
              *this)};
}

void LiftPanel::show(std::uint32_t number, const cia417::OutputView& view) {
  if (views_.size() <= number) views_.resize(number + 1);
  if (views_[number] == view) return;
  const bool was_on = views_[number].on;
  views_[number] = view;
  if ((!view.on && !was_on) || outputs_ == nullptr) return;
  const cia417::VirtualOutput record = outputs_->output(number);
  output_.say(kind_,
              fmt::format("{}: {}{}", name_of(record.function, view.sub_function),
                          view.on ? "on" : "off", view.flash_millihertz != 0 ? ", flashing" : ""));
}

void LiftPanel::step(Time now) {
  const Time begin = begin_.value_or(now);
  begin_ = begin;
  const Duration passed = now - begin;
  for (PanelPress& press : presses_) {
    const bool is_due = passed >= press.at;
    const bool is_over = passed >= press.at + press_time;
    if (press.done || !is_due || (press.pressed && !is_over)) continue;
    press.done = press.pressed;
    press.pressed = !press.pressed;
    for (std::uint32_t input = 0; inputs_ != nullptr && input < inputs_->size(); ++input) {
      const cia417::VirtualInput record = inputs_->input(input);
      const bool is_it =
          record.function == press.function && record.sub_function == press.sub_function;
      if (is_it) inputs_->set_level(input, press.pressed, now);
    }
  }
}

}  // namespace canvoy::tools
