// One physical device of a car on the simulated bus: its virtual devices, its identity, and LSS,
// by which the gateway gives it a node-ID.
//
//     CarNode node(world, bus, units, {.name = "radio", .id = 5, .serial_number = 1005}, site);
//     node.power(true);
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/canopen/identity.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/devices/cia447/car_kind.hpp"
#include "canvoy/sim/car/application.hpp"
#include "canvoy/sim/device_name.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::car {

/// The virtual devices of a physical one.
template <class... Kind>
inline constexpr const cia447::CarUnit* units_of[] = {&cia447::car_unit<Kind>...};

class CarNode {
 public:
  struct Place {
    std::string_view name;  ///< `taximeter`
    NodeId id = 0;          ///< that it has, or is going to be given
    std::uint32_t serial_number = 0;
    bool is_named_by_lss = true;
    bool is_played = true;
  };

  /// All must outlive this. It has no power yet.
  CarNode(World& world, BusIndex bus, std::span<const cia447::CarUnit* const> units,
          const Place& place, const Site& site)
      : world_(world),
        bus_(bus),
        slot_(world.add_slot(bus)),
        units_(units),
        place_(place),
        site_(site) {
    make();
  }
  CarNode(const CarNode&) = delete;
  CarNode& operator=(const CarNode&) = delete;

  /// A device that gets power is made anew: it remembers what it has kept, and nothing else. One
  /// that is not played stays off.
  void power(bool is_on) {
    world_.stop(slot_);
    if (!is_on || !place_.is_played) return;
    make();
    world_.start(slot_);
  }

  const Place& place() const { return place_; }
  /// Its virtual devices, as the catalogue names them: `gps+navigation`.
  std::string device_name() const {
    return canvoy::device_name<cia447::CarUnit>(units_, no_virtual_device);
  }
  cia447::CarDevice& device() { return *device_; }
  Node& node() { return device_->node(); }
  BusIndex bus() const { return bus_; }
  SlotIndex slot() const { return slot_; }
  ControllerId controller() const { return world_.controller(slot_); }
  bool is_powered() const { return world_.is_running(slot_); }
  /// Has power, and a node-ID, and does its work.
  bool is_operational() {
    return is_powered() && node().id() == place_.id && node().state() == NmtState::operational;
  }
  LssAddress address() const {
    LssAddress address;
    address.parts = {0, units_.front()->info.product_code, 0, place_.serial_number};
    return address;
  }

 private:
  void make() {
    lss_.reset();
    identity_.reset();
    device_.reset();
    device_ = std::make_unique<cia447::CarDevice>(
        units_, world_.port(slot_), place_.is_named_by_lss ? node_id_unconfigured : place_.id,
        site_);
    identity_.emplace(node(), IdentityValues{.serial_number = place_.serial_number});
    if (place_.is_named_by_lss) lss_.emplace(node());
    world_.occupy(slot_, node());
  }

  World& world_;
  BusIndex bus_;
  SlotIndex slot_;
  std::span<const cia447::CarUnit* const> units_;
  Place place_;
  const Site& site_;
  std::unique_ptr<cia447::CarDevice> device_;
  std::optional<Identity> identity_;
  std::optional<LssSlave> lss_;
};

}  // namespace canvoy::car
