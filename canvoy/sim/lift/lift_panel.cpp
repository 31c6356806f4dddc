#include "canvoy/sim/lift/lift_panel.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/devices/cia417/input_panel_device.hpp"
#include "canvoy/devices/cia417/output_panel_unit.hpp"
#include "canvoy/devices/cia417/panel_description.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy::lift {

namespace {

using cia417::BasicFunction;
using cia417::SpecialFunction;
using cia417::VirtualInput;
using cia417::VirtualOutput;

constexpr std::uint32_t heartbeat_ms = 1000;

/// Hundreds of them are in a building: without parameters.
template <std::size_t inputs, std::size_t outputs>
constexpr auto panel_device =
    describe(cia417::panel<cia417::PanelOptions{.inputs = static_cast<std::uint16_t>(inputs),
                                                .outputs = static_cast<std::uint16_t>(outputs),
                                                .parameters = false}>(),
             cia301::identity({.product_code = 41702}), cia301::heartbeat_producer(heartbeat_ms),
             cia301::emergency());
template <std::size_t inputs, std::size_t outputs>
constexpr auto panel_layout = lay_out_device<panel_device<inputs, outputs>>();

std::uint8_t at_doors(unsigned doors) {
  return static_cast<std::uint8_t>(doors << 4U);
}

VirtualInput special_input(LiftNumber lift, FloorNumber floor, SpecialFunction function,
                           std::uint8_t doors, bool locks) {
  return {.function = BasicFunction::special_function,
          .sub_function = cia417::sub_function_of(function),
          .lifts = cia417::lift_bit(lift),
          .floor = floor,
          .doors = doors,
          .data = locks ? VirtualInput::lock_bit : std::uint8_t{0}};
}

void add_hall_button(PanelControls& controls, const LandingPanelOptions& options, FloorNumber floor,
                     std::uint8_t direction) {
  const std::uint8_t doors = at_doors(options.doors);
  // Any lift of a group may answer it.
  controls.inputs.push_back({.function = BasicFunction::standard_hall_call,
                             .sub_function = direction,
                             .lifts = cia417::all_lifts,
                             .floor = floor,
                             .doors = doors});
  controls.outputs.push_back({.function = BasicFunction::standard_hall_call,
                              .sub_function = direction,
                              .lifts = cia417::lift_bit(options.lift),
                              .floor = floor,
                              .doors = doors});
}

void add_destinations(PanelControls& controls, const LandingPanelOptions& options,
                      FloorNumber floor) {
  for (unsigned to = 1; to <= options.highest; ++to) {
    if (to == floor) continue;
    const auto target = static_cast<std::uint8_t>(to);
    const auto doors = static_cast<std::uint8_t>(at_doors(options.doors) | options.doors);
    controls.inputs.push_back({.function = BasicFunction::standard_destination_call,
                               .sub_function = target,
                               .lifts = cia417::all_lifts,
                               .floor = floor,
                               .doors = doors});
    // Which lift it is, its acknowledgement says: the display shows those of all.
    controls.outputs.push_back({.function = BasicFunction::standard_destination_call,
                                .sub_function = target,
                                .lifts = cia417::all_lifts,
                                .floor = floor,
                                .doors = doors});
  }
}

}  // namespace

PanelControls landing_controls(const LandingPanelOptions& options) {
  PanelControls controls;
  const std::uint8_t lift = cia417::lift_bit(options.lift);
  const std::uint8_t doors = at_doors(options.doors);
  for (const FloorNumber floor : options.floors) {
    if (options.destinations) {
      add_destinations(controls, options, floor);
    } else {
      if (floor < options.highest) add_hall_button(controls, options, floor, cia417::hall_up);
      if (floor > 1) add_hall_button(controls, options, floor, cia417::hall_down);
    }
    for (const BasicFunction shown :
         {BasicFunction::position_indicator, BasicFunction::hall_lantern}) {
      controls.outputs.push_back(
          {.function = shown, .lifts = lift, .floor = floor, .doors = doors});
    }
    if (options.fire_key) {
      controls.inputs.push_back(
          special_input(options.lift, floor, SpecialFunction::fire_service_enable, doors, true));
    }
  }
  return controls;
}

PanelControls car_controls(const CarPanelOptions& options) {
  PanelControls controls;
  const std::uint8_t lift = cia417::lift_bit(options.lift);
  const std::uint8_t doors = at_doors(options.doors);
  const auto both = static_cast<std::uint8_t>(doors | options.doors);
  if (options.keys) {
    for (const SpecialFunction button : {SpecialFunction::door_open, SpecialFunction::door_close}) {
      controls.inputs.push_back(
          special_input(options.lift, cia417::floor_of_car, button, both, false));
    }
    controls.inputs.push_back(special_input(options.lift, cia417::floor_of_car,
                                            SpecialFunction::fire_service, doors, true));
    for (const BasicFunction shown :
         {BasicFunction::position_indicator, BasicFunction::direction_indication}) {
      controls.outputs.push_back({.function = shown, .lifts = lift, .doors = doors});
    }
    controls.outputs.push_back(
        {.function = BasicFunction::special_indication,
         .sub_function = cia417::sub_function_of(cia417::SpecialIndication::overload),
         .lifts = lift,
         .doors = doors});
  }
  for (const FloorNumber floor : options.floors) {
    controls.inputs.push_back({.function = BasicFunction::standard_car_call,
                               .sub_function = floor,
                               .lifts = lift,
                               .doors = both});
    controls.outputs.push_back({.function = BasicFunction::standard_car_call,
                                .sub_function = floor,
                                .lifts = lift,
                                .doors = both});
  }
  return controls;
}

template <std::size_t inputs, std::size_t outputs>
struct LiftPanel::Device {
  static constexpr const auto& layout = panel_layout<inputs, outputs>;

  Device(LiftPanel& panel, const Port& port, NodeId id)
      : device(port, id),
        input_unit(device.node(), device.tpdos(), arrays.spans(),
                   {.inputs = panel.controls_.inputs}),
        output_unit(
            device.node(), states,
            {.show = Callback<void(std::uint32_t, const cia417::OutputView&)>::to<&LiftPanel::show>(
                 panel)},
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
  std::variant<std::unique_ptr<Small>, std::unique_ptr<Large>, std::unique_ptr<Largest>> device;
};

LiftPanel::LiftPanel(World& world, BusIndex bus, NodeId id, PanelControls controls, Shown shown)
    : world_(&world),
      slot_(world.add_slot(bus)),
      controls_(std::move(controls)),
      shown_(std::move(shown)) {
  controls_.inputs.resize(std::min(controls_.inputs.size(), inputs_max));
  controls_.outputs.resize(std::min(controls_.outputs.size(), outputs_max));
  fingers_.resize(controls_.inputs.size());
  high_since_.resize(controls_.inputs.size(), never);
  is_defective_.resize(controls_.inputs.size());
  body_ = std::make_unique<Body>();
  if (controls_.inputs.size() <= 8 && controls_.outputs.size() <= 24) {
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
  if (stuck_ != input) set_level(input, pressed);
}

void LiftPanel::stick(std::size_t input, bool stuck) {
  stuck_.reset();
  if (stuck) stuck_ = input;
  set_level(input, stuck || fingers_[input]);
}

/// Without power a button does nothing; the node finds the contact as it is when it begins anew.
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
    tell_defect(input, false);
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
  tell_defect(input, true);
  world_->touched(slot_);
}

void LiftPanel::tell_defect(std::size_t input, bool is_defective) {
  is_defective_[input] = is_defective;
  const auto number = static_cast<std::uint32_t>(input);
  const auto condition = is_defective ? cia417::CallRequest::defective : cia417::CallRequest::none;
  std::visit([&](auto& device) { device->input_unit.report(number, condition, world_->now()); },
             body_->device);
}

void LiftPanel::show(std::uint32_t output, const cia417::OutputView& view) {
  if (output >= controls_.outputs.size() || !shown_) return;
  VirtualOutput shown = controls_.outputs[output];
  // The answer to a destination call names the lift.
  if (shown.function == BasicFunction::standard_destination_call) {
    const std::uint64_t record = node().dictionary().number(0x6011, 0);
    shown.lifts = cia417::decode_output(record).lifts;
  }
  shown_(shown, view);
}

}  // namespace canvoy::lift
