#include "canvoy/devices/cia417/call/call_records.hpp"

namespace canvoy::cia417 {

namespace {

constexpr auto first_hall_call = static_cast<unsigned>(BasicFunction::standard_hall_call);
constexpr auto first_car_call = static_cast<unsigned>(BasicFunction::standard_car_call);

}  // namespace

VirtualOutput acknowledgement_of(const Call& call, std::uint8_t lifts, bool on) {
  const auto priority = static_cast<unsigned>(call.priority);
  const auto door_bits = static_cast<unsigned>(call.doors);
  VirtualOutput output{.lifts = lifts, .data = output_data(on, Property::standard, 0, on)};
  if (call.kind == CallKind::car) {
    output.function = static_cast<BasicFunction>(first_car_call + priority);
    output.sub_function = call.floor;
    output.doors = static_cast<std::uint8_t>(0xF0U | door_bits);
  } else {
    output.function = static_cast<BasicFunction>(first_hall_call + priority);
    output.sub_function = hall_sub_function(call.kind);
    output.floor = call.floor;
    output.doors = static_cast<std::uint8_t>(door_bits << 4);
  }
  return output;
}

VirtualOutput answer_to(const VirtualInput& input, bool on, std::uint8_t lifts) {
  return {.function = input.function,
          .sub_function = input.sub_function,
          .lifts = lifts,
          .floor = input.floor,
          .doors = input.doors,
          .data = output_data(on, Property::standard, 0, on)};
}

std::uint8_t hall_sub_function(CallKind kind) {
  if (kind == CallKind::up) return hall_up;
  return kind == CallKind::down ? hall_down : hall_undirected;
}

Call hall_call_of(const VirtualInput& input, DoorMask doors) {
  Call call{CallKind::any, priority_of(input.function), input.floor, doors};
  const unsigned direction = input.sub_function & unsigned{hall_undirected};
  if (direction == hall_up) call.kind = CallKind::up;
  if (direction == hall_down) call.kind = CallKind::down;
  return call;
}

Call source_call_of(const VirtualInput& input, DoorMask doors) {
  const bool goes_up = input.sub_function > input.floor;
  return {goes_up ? CallKind::up : CallKind::down, priority_of(input.function), input.floor, doors};
}

CallPriority priority_of(BasicFunction function) {
  const unsigned first = is_hall_call(function) ? first_hall_call : first_car_call;
  return static_cast<CallPriority>((static_cast<unsigned>(function) - first) % 3);
}

}  // namespace canvoy::cia417
