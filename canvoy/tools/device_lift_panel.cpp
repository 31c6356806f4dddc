#include "canvoy/tools/device_lift_panel.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <variant>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/devices/cia417/lift_panel_device.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr std::string_view landing_kind = "lift-landing-panel";
constexpr std::string_view car_kind = "lift-car-panel";
constexpr NodeId landing_id = 21;
constexpr NodeId car_id = 16;
constexpr unsigned floors_max = 64;
constexpr Duration press_time = 300ms;

constexpr cia417::LandingPanelOptions landing_options{};
constexpr cia417::CarPanelOptions car_options{.floors = floors_max};
using Landing = cia417::LiftPanelDevice<landing_options, 16, LssSlave::routes>;
using Car = cia417::LiftPanelDevice<car_options, 16, LssSlave::routes>;

/// One button: what it is for, and when.
struct Press {
  cia417::BasicFunction function = cia417::BasicFunction::none;
  std::uint8_t sub_function = 0;
  Duration at{};
  bool pressed = false;
  bool done = false;
};

std::optional<unsigned> number_of(std::string_view text) {
  unsigned number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return number;
}

/// `up`, `down`, `open`, `close` or a floor.
std::optional<Press> button_of(std::string_view kind, std::string_view name,
                               const LiftPanelOptions& options) {
  using cia417::BasicFunction, cia417::SpecialFunction, cia417::sub_function_of;
  if (kind == landing_kind) {
    const bool up = name == "up" && options.floor < options.floors;
    const bool down = name == "down" && options.floor > 1;
    if (!up && !down) return std::nullopt;
    return Press{BasicFunction::standard_hall_call, up ? cia417::hall_up : cia417::hall_down};
  }
  if (name == "open" || name == "close") {
    const auto function = name == "open" ? SpecialFunction::door_open : SpecialFunction::door_close;
    return Press{BasicFunction::special_function, sub_function_of(function)};
  }
  const std::optional<unsigned> floor = number_of(name);
  if (!floor || *floor < 1 || *floor > options.floors) return std::nullopt;
  return Press{BasicFunction::standard_car_call, static_cast<std::uint8_t>(*floor)};
}

Press press_of(std::string_view kind, std::string_view text, const LiftPanelOptions& options) {
  const std::size_t at = text.find('@');
  std::optional<Press> press;
  if (at != std::string_view::npos) press = button_of(kind, text.substr(0, at), options);
  if (!press) {
    throw UsageError(
        fmt::format("--press: '{}' is no button of a {} with a time: write {}", text, kind,
                    kind == landing_kind ? "up@2s or down@2s" : "7@2s, open@2s or close@2s"));
  }
  press->at = parse_duration_argument(text.substr(at + 1));
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

bool is_lift_panel(const std::string& kind) {
  return kind == landing_kind || kind == car_kind;
}
NodeId node_id_of_panel(const std::string& kind) {
  return kind == landing_kind ? landing_id : car_id;
}

void check_lift_panel(const std::string& kind, const LiftPanelOptions& options) {
  if (options.lift < 1 || options.lift > cia417::lift_count) throw UsageError("--lift: 1 to 8");
  const unsigned most = kind == car_kind ? floors_max : 254;
  if (options.floors < 2 || options.floors > most) {
    throw UsageError(fmt::format("--floors: 2 to {}", most));
  }
  if (options.floor < 1 || options.floor > options.floors) {
    throw UsageError(fmt::format("--floor: 1 to {}", options.floors));
  }
  for (const std::string& text : options.presses) static_cast<void>(press_of(kind, text, options));
}

struct LiftPanel::Device {
  Device(std::string is, const LiftPanelOptions& options, const DeviceOutput& says)
      : kind(std::move(is)), output(says) {
    for (const std::string& text : options.presses) {
      presses.push_back(press_of(kind, text, options));
    }
  }

  cia417::OutputHardware hardware() {
    return {.show =
                Callback<void(std::uint32_t, const cia417::OutputView&)>::to<&Device::show>(*this)};
  }
  void show(std::uint32_t number, const cia417::OutputView& view) {
    if (views.size() <= number) views.resize(number + 1);
    if (views[number] == view) return;
    const bool was_on = views[number].on;
    views[number] = view;
    if (!view.on && !was_on) return;
    std::visit(
        [&](auto& whole) {
          // While the panel is being made, nothing is on.
          if (!whole) return;
          const cia417::VirtualOutput record = whole->outputs().output(number);
          output.say(kind, fmt::format("{}: {}{}", name_of(record.function, view.sub_function),
                                       view.on ? "on" : "off",
                                       view.flash_millihertz != 0 ? ", flashing" : ""));
        },
        panel);
  }

  std::string kind;
  const DeviceOutput& output;
  std::vector<Press> presses;
  std::vector<cia417::OutputView> views;
  std::optional<Time> begin;
  std::variant<std::unique_ptr<Landing>, std::unique_ptr<Car>> panel;
};

LiftPanel::LiftPanel(std::string kind, const Port& port, NodeId id, const LiftPanelOptions& options,
                     const DeviceOutput& output)
    : device_(std::make_unique<Device>(std::move(kind), options, output)) {
  const auto highest = static_cast<std::uint8_t>(options.floors);
  if (device_->kind == landing_kind) {
    const cia417::LandingPanel what{.lifts = cia417::lift_bit(options.lift),
                                    .floor = static_cast<std::uint8_t>(options.floor),
                                    .highest_floor = highest};
    device_->panel = std::make_unique<Landing>(port, id, device_->hardware(), what);
  } else {
    const cia417::CarPanel what{.lift = options.lift, .highest_floor = highest};
    device_->panel = std::make_unique<Car>(port, id, device_->hardware(), what);
  }
}
LiftPanel::~LiftPanel() = default;

Node& LiftPanel::node() {
  return std::visit([](auto& panel) -> Node& { return panel->node(); }, device_->panel);
}
EmergencyProducer& LiftPanel::emergency_producer() {
  return std::visit([](auto& panel) -> EmergencyProducer& { return panel->emergency_producer(); },
                    device_->panel);
}

void LiftPanel::step(Time now) {
  const Time begin = device_->begin.value_or(now);
  device_->begin = begin;
  const Duration passed = now - begin;
  for (Press& press : device_->presses) {
    const bool is_due = passed >= press.at;
    const bool is_over = passed >= press.at + press_time;
    if (press.done || !is_due || (press.pressed && !is_over)) continue;
    press.done = press.pressed;
    press.pressed = !press.pressed;
    const bool high = press.pressed;
    std::visit(
        [&](auto& panel) {
          const std::uint32_t count = panel->inputs().size();
          for (std::uint32_t input = 0; input < count; ++input) {
            const cia417::VirtualInput record = panel->inputs().input(input);
            const bool is_it =
                record.function == press.function && record.sub_function == press.sub_function;
            if (is_it) panel->inputs().set_level(input, high, now);
          }
        },
        device_->panel);
  }
}

}  // namespace canvoy::tools
