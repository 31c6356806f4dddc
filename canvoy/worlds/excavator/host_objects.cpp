#include "canvoy/worlds/excavator/host_objects.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::excavator {

namespace {

constexpr std::uint16_t to_parameter = object_index::rpdo_parameter;
constexpr std::uint16_t to_mapping = object_index::rpdo_mapping;
constexpr std::uint16_t transmit = 0x400;  ///< offset from RPDOs to TPDOs

NodeValue host_value_of(std::uint16_t index, unsigned sub, std::uint32_t value, unsigned bytes) {
  NodeValue made{.index = index, .sub = static_cast<std::uint8_t>(sub)};
  for (unsigned i = 0; i < bytes; ++i) {
    made.bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
  }
  return made;
}

struct HostPdo {
  std::uint16_t number_and_way = 0;
  std::uint32_t can_id = 0;
  unsigned inhibit_ms = 0;
  unsigned timer_ms = 0;
  std::vector<std::uint32_t> mapping{};
};

void add_pdo(std::vector<NodeValue>& values, const HostPdo& pdo) {
  constexpr unsigned hundred_microseconds_a_ms = 10;
  const auto parameter = static_cast<std::uint16_t>(to_parameter + pdo.number_and_way);
  const auto mapping = static_cast<std::uint16_t>(to_mapping + pdo.number_and_way);
  unsigned sub = 0;
  for (const std::uint32_t mapped : pdo.mapping) {
    values.push_back(host_value_of(mapping, ++sub, mapped, 4));
  }
  values.push_back(host_value_of(mapping, 0, sub, 1));
  values.push_back(host_value_of(parameter, 2, 0xFF, 1));
  if (pdo.inhibit_ms != 0) {
    values.push_back(host_value_of(parameter, 3, pdo.inhibit_ms * hundred_microseconds_a_ms, 2));
  }
  values.push_back(host_value_of(parameter, 5, pdo.timer_ms, 2));
  values.push_back(host_value_of(parameter, 1, pdo.can_id, 4));
}

constexpr std::uint32_t mapped(std::uint16_t index, unsigned sub, unsigned bits) {
  return std::uint32_t{index} << 16 | sub << 8 | bits;
}
std::vector<std::uint32_t> mapped_array(std::uint16_t index, unsigned first, unsigned count,
                                        unsigned bits) {
  std::vector<std::uint32_t> made;
  for (unsigned i = 0; i < count; ++i) made.push_back(mapped(index, first + i, bits));
  return made;
}
std::vector<std::uint32_t> mapped_joystick(unsigned joystick) {
  std::vector<std::uint32_t> made = mapped_array(axis_values, 3 * joystick - 2, 3, 16);
  made.push_back(mapped(joystick_values, 2 * joystick - 1, 8));
  made.push_back(mapped(joystick_values, 2 * joystick, 8));
  return made;
}

constexpr std::uint16_t number_of(Input input) {
  return static_cast<std::uint16_t>(static_cast<unsigned>(input) - 1);
}
constexpr std::uint16_t number_of(Output output) {
  return static_cast<std::uint16_t>(transmit + static_cast<unsigned>(output) - 1);
}

void add_trainer(std::vector<NodeValue>& values, unsigned stale) {
  add_pdo(values, {number_of(Input::trainer_left), trainer_left_id, 0, stale, mapped_joystick(3)});
  add_pdo(values,
          {number_of(Input::trainer_right), trainer_right_id, 0, stale, mapped_joystick(4)});
}

void add_inputs(std::vector<NodeValue>& values, unsigned stale) {
  add_pdo(values, {number_of(Input::left_stick), left_stick_id, 0, stale, mapped_joystick(1)});
  add_pdo(values, {number_of(Input::right_stick), right_stick_id, 0, stale, mapped_joystick(2)});
  add_pdo(values, {number_of(Input::pedals),
                   pedals_id,
                   0,
                   stale,
                   {mapped(pedal_memories, 1, 8), mapped(pedal_values, 1, 16),
                    mapped(pedal_memories, 2, 8), mapped(pedal_values, 2, 16)}});
  add_pdo(values, {number_of(Input::buttons), buttons_id, 0, 0, {mapped(button_values, 1, 8)}});
  add_pdo(values,
          {number_of(Input::wheels), wheels_id, 0, stale, mapped_array(wheel_values, 1, 2, 16)});
  add_pdo(values, {number_of(Input::knob), knob_id, 0, 0, {mapped(knob_value, 1, 32)}});
  add_pdo(values,
          {number_of(Input::angles), angles_id, 0, 0, mapped_array(sensor_values, 1, 4, 16)});
  add_pdo(values,
          {number_of(Input::engine), engine_id, 0, 0, mapped_array(sensor_values, 5, 4, 16)});
}

void add_outputs(std::vector<NodeValue>& values) {
  constexpr unsigned lamps_again_ms = 500;
  constexpr unsigned display_ms = 200;
  constexpr unsigned display_again_ms = 1000;
  add_pdo(values, {number_of(Output::lamps), lamps_id, 0, lamps_again_ms,
                   mapped_array(lamp_values, 1, 8, 8)});
  add_pdo(values, {number_of(Output::display), display_id, display_ms, display_again_ms,
                   mapped_array(shown_values, 1, 4, 16)});
  add_pdo(values, {number_of(Output::more_display), more_display_id, display_ms, display_again_ms,
                   mapped_array(shown_values, 5, 4, 16)});
  add_pdo(values, {number_of(Output::switches), switches_id, 0, refresh_ms,
                   mapped_array(switch_values, 1, 8, 8)});
  add_pdo(values, {number_of(Output::valves), valve_id, 0, refresh_ms,
                   mapped_array(valve_values, 1, 4, 16)});
  add_pdo(values, {number_of(Output::more_valves), more_valves_id, 0, refresh_ms,
                   mapped_array(valve_values, 5, 4, 16)});
}

}  // namespace

std::vector<NodeValue> host_configuration(Duration seat_time_out, bool has_trainer) {
  constexpr std::uint16_t consumers = object_index::heartbeat_consumers;
  const auto in_ms = [](Duration time) {
    return static_cast<std::uint32_t>(
        std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
  };
  std::vector<NodeValue> values;
  values.push_back(
      host_value_of(consumers, 1, std::uint32_t{seat_id} << 16 | in_ms(seat_time_out), 4));
  values.push_back(
      host_value_of(consumers, 2, std::uint32_t{valves_id} << 16 | in_ms(consumer_time), 4));
  const unsigned stale = seat_time_out == consumer_time ? stale_ms : in_ms(seat_time_out);
  add_inputs(values, stale);
  if (has_trainer) add_trainer(values, stale);
  add_outputs(values);
  return values;
}

}  // namespace canvoy::excavator
