#include "canvoy/worlds/excavator/machine_setup.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/cia852/pdos.hpp"
#include "canvoy/profiles/cia852/values.hpp"
#include "canvoy/worlds/excavator/machine_wiring.hpp"
#include "canvoy/worlds/excavator/seat_panel.hpp"

namespace canvoy::excavator {

namespace {

using Writes = std::vector<SetupWrite>;

constexpr std::uint32_t off = 0x8000'0000;
constexpr std::uint16_t by_delta = 4;  ///< bit 2 of 6421h

std::uint16_t in_ms(Duration time) {
  return static_cast<std::uint16_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
}

void add_error_control(Writes& writes, Duration host_time_out) {
  writes.push_back({object_index::heartbeat_producer, 0, heartbeat_ms, 2});
  writes.push_back({object_index::heartbeat_consumers, 1,
                    std::uint32_t{host_id} << 16 | in_ms(host_time_out), 4});
}

struct SetupPdo {
  unsigned number = 1;
  std::uint32_t can_id = 0;
  unsigned timer_ms = 0;
  unsigned inhibit_ms = 0;
  std::vector<std::uint32_t> mapping{};  ///< replaces the mapping; empty: it stays
};

/// A PDO is invalid while it is changed (CiA 301, 7.5.2.36).
void add_tpdo(Writes& writes, const SetupPdo& pdo) {
  constexpr unsigned hundred_microseconds_a_ms = 10;
  const auto parameter = static_cast<std::uint16_t>(object_index::tpdo_parameter + pdo.number - 1);
  const auto mapping = static_cast<std::uint16_t>(object_index::tpdo_mapping + pdo.number - 1);
  writes.push_back({parameter, 1, off | pdo.can_id, 4});
  if (!pdo.mapping.empty()) {
    writes.push_back({mapping, 0, 0, 1});
    std::uint8_t sub = 0;
    for (const std::uint32_t mapped : pdo.mapping) writes.push_back({mapping, ++sub, mapped, 4});
    writes.push_back({mapping, 0, sub, 1});
  }
  if (pdo.inhibit_ms != 0) {
    writes.push_back({parameter, 3, pdo.inhibit_ms * hundred_microseconds_a_ms, 2});
  }
  if (pdo.timer_ms != 0) writes.push_back({parameter, 5, pdo.timer_ms, 2});
  writes.push_back({parameter, 1, pdo.can_id, 4});
}

void add_rpdo(Writes& writes, unsigned number, std::uint32_t can_id) {
  const auto parameter = static_cast<std::uint16_t>(object_index::rpdo_parameter + number - 1);
  writes.push_back({parameter, 1, off | can_id, 4});
  writes.push_back({parameter, 1, can_id, 4});
}

void add_delta(Writes& writes, unsigned sub, std::uint16_t delta) {
  const auto channel = static_cast<std::uint8_t>(sub);
  writes.push_back({0x6421, channel, by_delta, 1, true});
  writes.push_back({0x6426, channel, delta, 4, true});
}

}  // namespace

std::vector<SetupWrite> seat_setup(const HostSettings& settings) {
  using namespace cia852;  // NOLINT(google-build-using-namespace)
  constexpr unsigned buttons_again_ms = 500;
  constexpr std::uint32_t first_buttons = 0x6000'0008 | push_buttons_sub(1, 1) << 8;
  constexpr std::uint32_t first_encoder = 0x6120'0020 | encoder_position_sub(1) << 8;
  const auto wheel = [](unsigned n) { return 0x6401'0010 | wheel_position_sub(n) << 8; };
  Writes writes;
  add_error_control(writes, consumer_time);
  for (unsigned joystick = 1; joystick <= (settings.has_trainer ? 4U : 2U); ++joystick) {
    for (unsigned axis = 1; axis <= 2; ++axis) {
      add_delta(writes, joystick_axis_sub(joystick, axis), settings.delta);
    }
  }
  for (unsigned pedal = 1; pedal <= pedal_count; ++pedal) {
    add_delta(writes, foot_pedal_position_sub(pedal), settings.delta);
  }
  writes.push_back({0x6003, push_buttons_sub(1, 1),
                    settings.filters_buttons ? std::uint8_t{0xFF} : std::uint8_t{0}, 1, true});
  writes.push_back({0x6423, 0, 1, 1});
  add_tpdo(writes, {joystick_tpdo(1), left_stick_id, refresh_ms});
  add_tpdo(writes, {joystick_tpdo(2), right_stick_id, refresh_ms});
  if (settings.has_trainer) {
    add_tpdo(writes, {joystick_tpdo(3), trainer_left_id, refresh_ms});
    add_tpdo(writes, {joystick_tpdo(4), trainer_right_id, refresh_ms});
  }
  add_tpdo(writes, {foot_pedal_tpdo(1), pedals_id, refresh_ms});
  add_tpdo(writes, {push_button_tpdo(1), buttons_id, buttons_again_ms, 0, {first_buttons}});
  add_tpdo(writes, {wheel_tpdo(1), wheels_id, refresh_ms, 0, {wheel(1), wheel(2)}});
  add_tpdo(writes, {encoder_tpdo(1), knob_id, buttons_again_ms, 0, {first_encoder}});
  writes.push_back({0x6206, 1, settings.sets_error_values ? 0xFFU : 0U, 1});
  writes.push_back({0x6207, 1, static_cast<std::uint32_t>(lamps_without_host.to_ulong()), 1});
  for (unsigned i = 1; i <= shown_parameters; ++i) {
    const auto sub = static_cast<std::uint8_t>(display_sub(1, i));
    writes.push_back({0x6443, sub, 1, 1});
    writes.push_back({0x6444, sub, static_cast<std::uint32_t>(std::int32_t{no_value}), 4});
  }
  add_rpdo(writes, indicator_rpdo(1), lamps_id);
  add_rpdo(writes, display_rpdo(1, 1), display_id);
  add_rpdo(writes, display_rpdo(1, 2), more_display_id);
  return writes;
}

std::vector<SetupWrite> valves_setup(const HostSettings& settings) {
  constexpr unsigned again_ms = 1000;
  constexpr unsigned inhibit_ms = 100;
  constexpr std::uint16_t delta_of[sensors] = {10, 10, 10, 10, 20, 2, 5, 20};
  Writes writes;
  add_error_control(writes, settings.host_time_out);
  for (unsigned i = 1; i <= sensors; ++i) add_delta(writes, i, delta_of[i - 1]);
  writes.push_back({0x6423, 0, 1, 1});
  for (unsigned i = 1; i <= throttle_output; ++i) {
    writes.push_back({0x6443, static_cast<std::uint8_t>(i), 1, 1});
    writes.push_back({0x6444, static_cast<std::uint8_t>(i), 0, 4});
  }
  writes.push_back({0x6206, 1, 0xFF, 1});
  writes.push_back({0x6207, 1, 0, 1});
  add_tpdo(writes, {2, angles_id, again_ms, inhibit_ms});
  add_tpdo(writes, {3, engine_id, again_ms, inhibit_ms});
  add_rpdo(writes, 1, switches_id);
  add_rpdo(writes, 2, valve_id);
  add_rpdo(writes, 3, more_valves_id);
  return writes;
}

}  // namespace canvoy::excavator
