#include "canvoy/worlds/lift/real_devices.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/cia417/pdos.hpp"

namespace canvoy::lift {

namespace {

using cia417::BasicFunction;
using cia417::Detection;
using cia417::SpecialFunction;

/// While one of these is turned, a lift does not serve passengers.
constexpr SpecialFunction service_keys[] = {
    SpecialFunction::fire_service_enable,   SpecialFunction::fire_service,
    SpecialFunction::hall_call_disable,     SpecialFunction::attendant_service,
    SpecialFunction::vip_service,           SpecialFunction::out_of_order,
    SpecialFunction::bed_passenger_service, SpecialFunction::special_service,
    SpecialFunction::service_run,           SpecialFunction::dogging_service_enable};

/// The CAN-ID of the PDO of lift 1 that begins with this entry.
consteval std::uint32_t can_id_of(const ObjectInfo& object, unsigned sub) {
  for (const cia417::LiftPdo& row : cia417::lift_pdo_table<1>) {
    if (row.mapping[0] == cia417::mapped_in(1, object, sub)) return row.cob_id;
  }
  throw "no PDO begins with it";
}
constexpr std::uint32_t load_signals = can_id_of(cia417::load_signaling_object, 1);
constexpr std::uint32_t car_position = can_id_of(cia417::position_value_object, 1);
constexpr double metres_of_step = 0.0001;
constexpr std::uint32_t door_status[doors_max] = {
    can_id_of(cia417::door_statusword_object, 1), can_id_of(cia417::door_statusword_object, 2),
    can_id_of(cia417::door_statusword_object, 3), can_id_of(cia417::door_statusword_object, 4)};
constexpr std::uint32_t light_barrier_status[doors_max] = {
    can_id_of(cia417::light_barrier_status_object, 1),
    can_id_of(cia417::light_barrier_status_object, 2),
    can_id_of(cia417::light_barrier_status_object, 3),
    can_id_of(cia417::light_barrier_status_object, 4)};
/// CAN-ID of virtual inputs, without the node-ID.
constexpr std::uint32_t virtual_inputs = 0x480;

constexpr std::uint16_t no_position = 0xFFFF;
constexpr std::uint8_t record_length = 6;

template <class Handle>
bool is_set(std::uint8_t bits, const Handle& /*flag*/) {
  return extract(bits, Handle::Place::bits) != 0;
}

}  // namespace

RealDevices::RealDevices(Wanted wanted, Hands hands)
    : wanted_(std::move(wanted)), hands_(std::move(hands)) {}

void RealDevices::receive(const Frame& frame, Time now) {
  if (frame.is_remote() || frame.is_extended()) return;
  if (wanted_.drive) hands_.drive(frame);
  for (unsigned i = 0; i < doors_max; ++i) {
    const auto door = static_cast<DoorNumber>(i + 1);
    const bool has_door = (wanted_.doors >> i & 1U) != 0;
    const bool has_barrier = (wanted_.light_barriers >> i & 1U) != 0;
    if (has_door && frame.id == door_status[i]) hear_door(door, frame);
    if (has_barrier && frame.id == light_barrier_status[i] && frame.length >= 1) {
      const auto seen = cia417::field_of<Detection>(frame.data[0], cia417::light_barrier_status);
      hands_.light_barrier(door, seen);
    }
  }
  if (wanted_.load && frame.id == load_signals && frame.length >= 1) {
    hands_.load({.full = is_set(frame.data[0], cia417::full_load_reached),
                 .overload = is_set(frame.data[0], cia417::overload_reached)});
  }
  if (wanted_.position && frame.id == car_position && frame.length >= 4) {
    hands_.position(load<std::int32_t>(frame.data.data()) * metres_of_step);
  }
  hear_input(frame, now);
}

void RealDevices::hear_door(DoorNumber door, const Frame& frame) {
  if (frame.length < 2) return;
  std::optional<std::uint16_t> position_mm;
  if (frame.length >= 4) position_mm = load<std::uint16_t>(frame.data.data() + 2);
  if (position_mm == no_position) position_mm.reset();
  hands_.door(door, cia417::DoorReport::of(load<std::uint16_t>(frame.data.data())), position_mm);
}

void RealDevices::hear_input(const Frame& frame, Time now) {
  const std::uint32_t id = frame.id - virtual_inputs;
  if (frame.length != record_length || id > node_id_max) return;
  if (!wanted_.panels.contains(static_cast<NodeId>(id))) return;
  std::uint64_t record = 0;
  for (unsigned i = 0; i < record_length; ++i) {
    record |= std::uint64_t{frame.data[i]} << (8 * i);
  }
  const cia417::VirtualInput input = cia417::decode_input(record);
  const bool is_key = input.function == BasicFunction::special_function;
  if (!is_key || (input.lifts & cia417::lift_bit(1)) == 0 || !keys_.take(input)) return;
  if (is_in_service_) in_service_until_ = now;
  is_in_service_ =
      std::ranges::any_of(service_keys, [this](SpecialFunction key) { return keys_.is_on(key); });
  hands_.keys();
}

Time RealDevices::in_service_until(Time now) const {
  return is_in_service_ ? now : in_service_until_;
}

}  // namespace canvoy::lift
