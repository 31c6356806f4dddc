#include "canvoy/worlds/lift/lift_panel.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/devices/cia417/panel/input_panel_device.hpp"
#include "canvoy/devices/cia417/panel/output_panel_unit.hpp"
#include "canvoy/devices/cia417/panel/panel_description.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::lift {

inline constexpr std::uint32_t panel_heartbeat_ms = 1000;

/// A building has hundreds of them: without parameters, unless requested.
template <std::size_t inputs, std::size_t outputs, bool parameters>
inline constexpr auto panel_device =
    describe(cia417::panel<cia417::PanelOptions{.inputs = static_cast<std::uint16_t>(inputs),
                                                .outputs = static_cast<std::uint16_t>(outputs),
                                                .parameters = parameters}>(),
             cia301::identity({.product_code = 41702}),
             cia301::heartbeat_producer(panel_heartbeat_ms), cia301::emergency());
template <std::size_t inputs, std::size_t outputs, bool parameters>
inline constexpr auto panel_layout = lay_out_device<panel_device<inputs, outputs, parameters>>();

namespace {

using cia417::BasicFunction;
using cia417::SpecialFunction;
using cia417::VirtualInput;
using cia417::VirtualOutput;

std::uint8_t at_doors(unsigned doors) {
  return static_cast<std::uint8_t>(doors << 4U);
}

/// Common data of all records of a panel.
struct WallPlace {
  LiftNumber lift = 1;
  FloorNumber floor = cia417::floor_of_car;
  std::uint8_t doors = 0;
};

void add_keys(PanelControls& controls, const std::vector<SpecialFunction>& functions,
              const WallPlace& place, bool has_lamps) {
  for (const SpecialFunction function : functions) {
    controls.inputs.push_back(
        {.function = BasicFunction::special_function,
         .sub_function = cia417::sub_function_of(function),
         .lifts = cia417::lift_bit(place.lift),
         .floor = place.floor,
         .doors = place.doors,
         .data = is_key(function) ? VirtualInput::lock_bit : std::uint8_t{0}});
    if (!has_lamps) continue;
    controls.outputs.push_back({.function = BasicFunction::special_function,
                                .sub_function = cia417::sub_function_of(function),
                                .lifts = cia417::lift_bit(place.lift),
                                .floor = place.floor,
                                .doors = place.doors});
  }
}

void add_displays(PanelControls& controls, const std::vector<PanelDisplay>& displays,
                  const WallPlace& place) {
  for (const PanelDisplay& display : displays) {
    controls.outputs.push_back({.function = display.function,
                                .sub_function = display.sub_function,
                                .lifts = cia417::lift_bit(place.lift),
                                .floor = place.floor,
                                .doors = place.doors});
  }
}

void add_hall_button(PanelControls& controls, const WallPlace& place, std::uint8_t direction) {
  // Any lift of a group may answer it.
  controls.inputs.push_back({.function = BasicFunction::standard_hall_call,
                             .sub_function = direction,
                             .lifts = cia417::all_lifts,
                             .floor = place.floor,
                             .doors = place.doors});
  controls.outputs.push_back({.function = BasicFunction::standard_hall_call,
                              .sub_function = direction,
                              .lifts = cia417::lift_bit(place.lift),
                              .floor = place.floor,
                              .doors = place.doors});
}

/// Adds up and down, where the lift goes on to.
void add_directions(PanelControls& controls, const LandingPanelOptions& options,
                    const WallPlace& place) {
  bool goes_up = false;
  bool goes_down = false;
  for (unsigned to = 1; to <= options.highest; ++to) {
    if (!options.place.serves(static_cast<FloorNumber>(to))) continue;
    goes_up = goes_up || to > place.floor;
    goes_down = goes_down || to < place.floor;
  }
  if (goes_up) add_hall_button(controls, place, cia417::hall_up);
  if (goes_down) add_hall_button(controls, place, cia417::hall_down);
}

void add_destinations(PanelControls& controls, const LandingPanelOptions& options,
                      const WallPlace& place) {
  for (unsigned to = 1; to <= options.highest; ++to) {
    const auto target = static_cast<std::uint8_t>(to);
    if (to == place.floor || !options.place.has_way(place.floor, target)) continue;
    // The door through which people get out depends on the lift that comes.
    const auto doors = static_cast<std::uint8_t>(
        place.doors | (options.place.building == nullptr ? options.doors : 0));
    controls.inputs.push_back({.function = BasicFunction::standard_destination_call,
                               .sub_function = target,
                               .lifts = cia417::all_lifts,
                               .floor = place.floor,
                               .doors = doors});
    // The acknowledgement contains the lift: the display shows those of all lifts.
    controls.outputs.push_back({.function = BasicFunction::standard_destination_call,
                                .sub_function = target,
                                .lifts = cia417::all_lifts,
                                .floor = place.floor,
                                .doors = doors});
  }
}

constexpr PanelDisplay position{BasicFunction::position_indicator};
constexpr PanelDisplay lantern{BasicFunction::hall_lantern};
constexpr PanelDisplay direction{BasicFunction::direction_indication};
constexpr PanelDisplay overload{BasicFunction::special_indication,
                                cia417::sub_function_of(cia417::SpecialIndication::overload)};

std::vector<SpecialFunction> keys_of_car(const CarPanelOptions& options) {
  if (!options.keys) return {};
  std::vector<SpecialFunction> keys{SpecialFunction::door_open, SpecialFunction::door_close,
                                    SpecialFunction::fire_service};
  if (options.place.building == nullptr) return keys;
  const auto& locks = options.place.building->lift(options.place.number).locked_by_key;
  for (std::size_t key = 0; key < locks.size(); ++key) {
    if (!locks.at(key).empty()) keys.push_back(key_lock(key));
  }
  return keys;
}

}  // namespace

PanelControls landing_controls(const LandingPanelOptions& options) {
  PanelControls controls;
  for (const FloorNumber floor : options.floors) {
    const WallPlace place{options.lift, floor,
                          at_doors(options.place.doors_at(floor, options.doors))};
    if (!options.panel.calls) {
      // Its keys and displays alone.
    } else if (options.destinations) {
      add_destinations(controls, options, place);
    } else {
      add_directions(controls, options, place);
    }
    add_displays(controls, options.panel.displays.value_or(std::vector{position, lantern}), place);
    std::vector<SpecialFunction> keys;
    if (floor == options.fire_floor) keys.push_back(SpecialFunction::fire_service_enable);
    add_keys(controls, options.panel.keys.value_or(keys), place, options.panel.keys.has_value());
  }
  controls.parameters = options.panel.parameters;
  return controls;
}

PanelControls car_controls(const CarPanelOptions& options) {
  PanelControls controls;
  const WallPlace place{options.lift, cia417::floor_of_car, at_doors(options.doors)};
  const WallPlace buttons{options.lift, cia417::floor_of_car,
                          static_cast<std::uint8_t>(at_doors(options.doors) | options.doors)};
  const std::vector<SpecialFunction> keys = options.panel.keys.value_or(keys_of_car(options));
  for (const SpecialFunction function : keys) {
    const bool is_of_door =
        function == SpecialFunction::door_open || function == SpecialFunction::door_close;
    add_keys(controls, {function}, is_of_door ? buttons : place, options.panel.keys.has_value());
  }
  std::vector<PanelDisplay> displays;
  if (options.keys) displays = {position, direction, overload};
  add_displays(controls, options.panel.displays.value_or(displays), place);
  for (const FloorNumber floor : options.floors) {
    const unsigned doors = options.place.doors_at(floor, options.doors);
    if (doors == 0 || !options.panel.calls) continue;
    const auto both = static_cast<std::uint8_t>(at_doors(options.doors) | doors);
    controls.inputs.push_back({.function = BasicFunction::standard_car_call,
                               .sub_function = floor,
                               .lifts = cia417::lift_bit(options.lift),
                               .doors = both});
    controls.outputs.push_back({.function = BasicFunction::standard_car_call,
                                .sub_function = floor,
                                .lifts = cia417::lift_bit(options.lift),
                                .doors = both});
  }
  controls.parameters = options.panel.parameters;
  return controls;
}

template <std::size_t inputs, std::size_t outputs, bool parameters>
struct LiftPanel::Device {
  static constexpr const auto& layout = panel_layout<inputs, outputs, parameters>;

  Device(LiftPanel& panel, const Port& port, NodeId id)
      : device(port, id),
        input_unit(device.node(), device.tpdos(), arrays.spans(),
                   {.inputs = panel.controls_.inputs}),
        output_unit(device.node(), states, {.show = callback<&LiftPanel::show>(panel)},
                    {.outputs = panel.controls_.outputs}) {}

  DeviceNode<layout> device;
  cia417::InputPanelArrays<layout, 8> arrays;
  std::array<cia417::OutputState, outputs> states{};
  cia417::InputPanelUnit input_unit;
  cia417::OutputPanelUnit output_unit;
};

struct LiftPanel::Body {
  using Small = Device<8, 24>;
  using Large = Device<254, 254>;
  using Largest = Device<inputs_max, outputs_max>;
  using WithParameters = Device<254, 254, true>;
  std::variant<std::unique_ptr<Small>, std::unique_ptr<Large>, std::unique_ptr<Largest>,
               std::unique_ptr<WithParameters>>
      device;
};

LiftPanel::LiftPanel(World& world, BusIndex bus, NodeId id, PanelControls controls, Shown shown)
    : world_(&world),
      slot_(world.add_slot(bus)),
      controls_(std::move(controls)),
      shown_(std::move(shown)) {
  controls_.inputs.resize(std::min(controls_.inputs.size(), inputs_max));
  controls_.outputs.resize(std::min(controls_.outputs.size(), outputs_max));
  fingers_.resize(controls_.inputs.size());
  is_stuck_.resize(controls_.inputs.size());
  high_since_.resize(controls_.inputs.size(), never);
  is_defective_.resize(controls_.inputs.size());
  body_ = std::make_unique<Body>();
  if (controls_.parameters) {
    controls_.inputs.resize(std::min(controls_.inputs.size(), parameters_max));
    controls_.outputs.resize(std::min(controls_.outputs.size(), parameters_max));
    body_->device = std::make_unique<Body::WithParameters>(*this, world.port(slot_), id);
  } else if (controls_.inputs.size() <= 8 && controls_.outputs.size() <= 24) {
    body_->device = std::make_unique<Body::Small>(*this, world.port(slot_), id);
  } else if (controls_.inputs.size() <= 254 && controls_.outputs.size() <= 254) {
    body_->device = std::make_unique<Body::Large>(*this, world.port(slot_), id);
  } else {
    body_->device = std::make_unique<Body::Largest>(*this, world.port(slot_), id);
  }
  world.occupy(slot_, node());
}

LiftPanel::~LiftPanel() = default;

Node& LiftPanel::node() {
  return std::visit([](auto& device) -> Node& { return device->device.node(); }, body_->device);
}

std::optional<std::size_t> LiftPanel::find(const PanelInput& wanted) const {
  const auto found = std::find_if(
      controls_.inputs.begin(), controls_.inputs.end(), [&](const VirtualInput& input) {
        return input.function == wanted.function && input.sub_function == wanted.sub_function &&
               input.floor == wanted.floor;
      });
  if (found == controls_.inputs.end()) return std::nullopt;
  return static_cast<std::size_t>(found - controls_.inputs.begin());
}

void LiftPanel::press(std::size_t input, bool pressed) {
  fingers_[input] = pressed;
  if (!is_stuck_[input]) set_level(input, pressed);
}

void LiftPanel::stick(std::size_t input, bool stuck) {
  is_stuck_[input] = stuck;
  set_level(input, stuck || fingers_[input]);
}

/// Without power a button has no effect; the node reads the contact when it starts again.
void LiftPanel::set_level(std::size_t input, bool high) {
  const Time now = world_->now();
  const auto number = static_cast<std::uint32_t>(input);
  const bool runs = world_->is_running(slot_);
  if (runs) node().advance(now);
  std::visit([&](auto& device) { device->input_unit.set_level(number, high, now); }, body_->device);
  watch(input, high);
  if (runs) world_->touched(slot_);
}

void LiftPanel::watch(std::size_t input, bool high) {
  const bool is_call = controls_.inputs[input].function != BasicFunction::special_function;
  if (!is_call || high == (high_since_[input] != never)) return;
  const Time now = world_->now();
  high_since_[input] = high ? now : never;
  if (high) {
    world_->at(now + stuck_after, [this, input, now](Time) { look_at_stuck(input, now); });
  } else if (is_defective_[input]) {
    report_defect(input, false);
  }
}

void LiftPanel::look_at_stuck(std::size_t input, Time since) {
  if (high_since_[input] != since) return;
  const Time now = world_->now();
  if (!world_->is_running(slot_)) {
    return world_->at(now + stuck_after,
                      [this, input, since](Time) { look_at_stuck(input, since); });
  }
  node().advance(now);
  report_defect(input, true);
  world_->touched(slot_);
}

void LiftPanel::report_defect(std::size_t input, bool is_defective) {
  is_defective_[input] = is_defective;
  tell(input, is_defective ? cia417::CallRequest::defective : cia417::CallRequest::none);
}

void LiftPanel::tell(std::size_t input, cia417::CallRequest condition) {
  const auto number = static_cast<std::uint32_t>(input);
  std::visit([&](auto& device) { device->input_unit.report(number, condition, world_->now()); },
             body_->device);
}

void LiftPanel::report(std::size_t input, cia417::CallRequest condition) {
  if (!world_->is_running(slot_)) return;
  node().advance(world_->now());
  tell(input, condition);
  world_->touched(slot_);
}

void LiftPanel::go_dark() {
  if (!shown_) return;
  for (const VirtualOutput& output : controls_.outputs) {
    shown_(output, {.sub_function = output.sub_function});
  }
}

void LiftPanel::show(std::uint32_t output, const cia417::OutputView& view) {
  if (output >= controls_.outputs.size() || !shown_) return;
  VirtualOutput shown = controls_.outputs[output];
  // The answer to a destination call contains the lift.
  if (shown.function == BasicFunction::standard_destination_call) {
    const std::uint64_t record = node().dictionary().number(0x6011, 0);
    shown.lifts = cia417::decode_output(record).lifts;
  }
  shown_(shown, view);
}

}  // namespace canvoy::lift
