#include "canvoy/tools/device_lift_car.hpp"

#include <array>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/devices/cia417/car_drive_device.hpp"
#include "canvoy/devices/cia417/car_position_device.hpp"
#include "canvoy/tools/device_store.hpp"

namespace canvoy::tools {

namespace {

constexpr auto storing_drive = describe(cia417::full_drive<1>, cia301::storage(storage_groups));
constexpr auto storing_drive_layout = cia417::in_any_lift(lay_out_device<storing_drive>());
constexpr auto storing_position =
    describe(cia417::full_car_position<>, cia301::storage(storage_groups));
constexpr auto storing_position_layout = cia417::in_any_lift(lay_out_device<storing_position>());

/// What a car that follows its drive has to hear: control, status, heartbeat.
constexpr std::array<std::uint16_t, 4> of_drive = {0x180, 0x181, 0x185, 0x702};

template <const auto& layout>
LiftDevice make_drive(NodeId id, const Port& port, LiftCar& car) {
  return held(std::make_shared<cia417::CarDriveDevice<layout, LssSlave::routes>>(
      port, id, car.drive_hardware()));
}

template <const auto& layout>
LiftDevice make_position(NodeId id, const Port& port, LiftCar& car) {
  constexpr std::size_t routes = LssSlave::routes + of_drive.size();
  LiftDevice made = held(std::make_shared<cia417::CarPositionDevice<layout, routes>>(
      port, id, car.position_hardware(), cia417::CarPositionSettings{.cams = car.cams()}));
  for (const std::uint16_t can_id : of_drive) {
    made.node->router().add(can_id, Router::Receiver::to<&LiftCar::hear>(car));
  }
  return made;
}

}  // namespace

LiftDevice make_lift_device(std::string_view kind, NodeId id, const Port& port, LiftCar& car,
                            bool stores) {
  if (kind == lift_drive_kind) {
    return stores ? make_drive<storing_drive_layout>(id, port, car)
                  : make_drive<cia417::full_drive_layout<1>>(id, port, car);
  }
  return stores ? make_position<storing_position_layout>(id, port, car)
                : make_position<cia417::full_car_position_layout<>>(id, port, car);
}

}  // namespace canvoy::tools
