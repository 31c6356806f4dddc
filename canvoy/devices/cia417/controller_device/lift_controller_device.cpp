#include "canvoy/devices/cia417/controller_device/lift_controller_device.hpp"

#include "canvoy/devices/cia417/group/group_device.hpp"
#include "canvoy/devices/cia417/kit/kinds.hpp"

namespace canvoy::cia417 {

namespace {

/// A building with 254 floors has more lamps than one group.
constexpr LiftControllerOptions with_outputs{.outputs = 8 * 254};
constexpr NodeId light_barrier_id = 9;

/// A lift with one door, and floors of one height.
class SitedLiftController {
 public:
  SitedLiftController(const Port& port, NodeId node_id, const Environment& environment)
      : floors_(floors_of(environment.floors)), device_(port, node_id, settings(environment)) {
    environment.made(device_.lift(), device_.node());
  }
  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  auto& device() { return device_; }

 private:
  static constexpr std::int32_t floor_height_micrometre = 3'500'000;
  using Floors = std::array<std::int32_t, FloorSet::floor_max>;

  static constexpr Floors floors_of(unsigned count) {
    Floors floors{};
    for (unsigned floor = 0; floor < count && floor < floors.size(); ++floor) {
      floors[floor] = static_cast<std::int32_t>(floor) * floor_height_micrometre;
    }
    return floors;
  }
  LiftControllerDeviceSettings settings(const Environment& environment) const {
    const auto top = static_cast<std::uint8_t>(environment.floors);
    return {.calls = {.served = {FloorSet::between(1, top)}},
            .doors = {.door_units = {6}, .light_barrier_units = {light_barrier_id}},
            .lift = {.floors = std::span(floors_).first(top), .times = {.dwell_hall = 3s}},
            .manage_network = environment.manages_network};
  }

  Floors floors_;
  LiftControllerDevice<with_outputs, full_lift_controller_layout<with_outputs>,
                       destinations_default, catalogue_routes>
      device_;
};

constexpr DeviceForm lift_controller_forms[] = {
    form_of<SitedLiftController, full_lift_controller<with_outputs>>};

/// On the bus of its group; it is not received on that of the lift.
class SitedGroupMember {
 public:
  SitedGroupMember(const Port& port, NodeId node_id, const Environment& environment)
      : lift_({nullptr, [](void*, const Frame&) { return true; }, nullptr}, node_id, environment),
        member_(port, node_id, lift_.node(), lift_.device().calls(), lift_.device().lift()) {}
  Node& node() { return member_.node(); }
  EmergencyProducer& emergency_producer() { return member_.emergency_producer(); }

 private:
  SitedLiftController lift_;
  GroupMemberDevice<> member_;
};

constexpr DeviceForm group_member_forms[] = {form_of<SitedGroupMember, full_group_member>};

}  // namespace

/// It is mounted inside its lift: LSS assigns it no node-ID.
const DeviceKind lift_controller_kind = {.info = lift_controller_info,
                                         .profile = &profile,
                                         .forms = lift_controller_forms,
                                         .answers_lss = false};
const DeviceKind group_member_kind = {
    .info = group_member_info, .profile = &profile, .forms = group_member_forms};

}  // namespace canvoy::cia417
