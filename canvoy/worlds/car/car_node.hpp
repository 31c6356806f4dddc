// One physical device of a car on the simulated bus: its virtual devices, its identity, and LSS, by
// which the gateway assigns a node-ID.
//
//     CarNode node(world, bus, units, {.name = "radio", .id = 5, .serial_number = 1005},
//                  environment);
//     node.power(true);
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/remote/identity.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/sim/device_name.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/car/application.hpp"

namespace canvoy::car {

/// The virtual devices of a physical one.
template <class... Kind>
inline constexpr const cia447::CarUnit* units_of[] = {&cia447::car_unit<Kind>...};

class CarNode {
 public:
  /// Which device it is.
  struct Place {
    std::string_view name;            ///< `taximeter`
    NodeId id = 0;                    ///< its node-ID, present or future
    std::uint32_t serial_number = 0;  ///< 1018h:04h, by which LSS finds it
    bool is_named_by_lss = true;      ///< false: it has its node-ID from the start, as the gateway
    bool is_played = true;            ///< false: a real device has this node-ID
    std::uint32_t vendor_id = 0;      ///< 0: that of this project
  };

  /// All must outlive this object. The device has no power yet.
  CarNode(World& world, BusIndex bus, std::span<const cia447::CarUnit* const> units,
          const Place& place, const Environment& environment)
      : world_(world),
        bus_(bus),
        slot_(world.add_slot(bus)),
        units_(units),
        place_(place),
        environment_(environment) {
    make();
  }
  CarNode(const CarNode&) = delete;
  CarNode& operator=(const CarNode&) = delete;

  /// Switches power; a device that gets power starts from its initial state, with its persistent
  /// memory alone. One that is not simulated here stays off.
  void power(bool is_on) {
    world_.stop(slot_);
    if (!is_on || !place_.is_played) return;
    make();
    world_.start(slot_);
  }

  /// As given.
  const Place& place() const { return place_; }
  /// Its virtual devices, as the catalogue names them: `gps+navigation`.
  std::string device_name() const {
    return canvoy::device_name<cia447::CarUnit>(units_, no_virtual_device);
  }
  /// Its virtual devices.
  std::span<const cia447::CarUnit* const> units() const { return units_; }
  /// What its first virtual device provides.
  const VirtualDeviceInfo& provides() const { return *units_.front()->provides; }
  /// The device; made again at each power-on, so keep no reference.
  cia447::CarDevice& device() { return *device_; }
  /// Its node; see device().
  Node& node() { return device_->node(); }
  /// Its bus.
  BusIndex bus() const { return bus_; }
  /// Its slot on that bus.
  SlotIndex slot() const { return slot_; }
  /// Its number on that bus.
  ControllerId controller() const { return world_.controller(slot_); }
  /// True while it runs.
  bool is_powered() const { return world_.is_running(slot_); }
  /// True if it has power and a node-ID, and does its work.
  bool is_operational() {
    return is_powered() && node().id() == place_.id && node().state() == NmtState::operational;
  }
  /// Its address, by which the gateway assigns the node-ID (CiA 305).
  LssAddress address() const {
    LssAddress address;
    address.parts = {place_.vendor_id, units_.front()->info.product_code, 0, place_.serial_number};
    return address;
  }

 private:
  void make() {
    lss_.reset();
    identity_.reset();
    device_.reset();
    device_ = std::make_unique<cia447::CarDevice>(
        units_, world_.port(slot_), place_.is_named_by_lss ? node_id_unconfigured : place_.id,
        environment_);
    identity_.emplace(node(), IdentityValues{.vendor_id = place_.vendor_id,
                                             .serial_number = place_.serial_number});
    if (place_.is_named_by_lss) lss_.emplace(node());
    world_.occupy(slot_, node());
  }

  World& world_;
  BusIndex bus_;
  SlotIndex slot_;
  std::span<const cia447::CarUnit* const> units_;
  Place place_;
  const Environment& environment_;
  std::unique_ptr<cia447::CarDevice> device_;
  std::optional<Identity> identity_;
  std::optional<LssSlave> lss_;
};

}  // namespace canvoy::car
