// One physical device of a bus on the simulated bus: its virtual devices, its identity, and its
// settings from before it was mounted: pre-configured off-line (CiA 407, 8.1.5).
//
//     BusNode node(world, bus, units, {.name = "ticket-canceller", .id = 6}, environment);
//     node.preset({0x1016, 1, 0x0001'04B0});      // watch the on-board computer
//     node.power(true);
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/remote/identity.hpp"
#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/bus_line/bus_places.hpp"

namespace canvoy::bus_line {

class BusNode {
 public:
  /// Which device it is.
  struct Place {
    std::string_view name;            ///< in files and logs
    DeviceKey key = 0;                ///< which device of a bus it is
    NodeId id = 0;                    ///< 1 to 127
    std::uint32_t serial_number = 0;  ///< 1018h:04h, unique for LSS
    bool is_played = true;            ///< false: a real device has this node-ID
  };
  /// A value after power-on, in place of the default.
  struct Preset {
    std::uint16_t index = 0;  ///< of the object
    std::uint8_t sub = 0;     ///< of its entry
    std::uint32_t value = 0;  ///< in the width of the entry
  };

  /// All must outlive this object. The device has no power yet.
  BusNode(World& world, BusIndex bus, std::span<const cia407::BusUnit* const> units,
          const Place& place, const Environment& environment);
  BusNode(const BusNode&) = delete;
  BusNode& operator=(const BusNode&) = delete;

  /// Takes effect at the next power-on.
  void preset(const Preset& preset) { presets_.push_back(preset); }
  /// All that preset() was given.
  std::span<const Preset> presets() const { return presets_; }
  /// Sets the CAN-ID of the `number`-th PDO with this mapping, 0 the first, from the next power-on.
  /// False where there is none.
  bool preset_rpdo(std::span<const std::uint32_t> mapping, std::uint32_t can_id,
                   unsigned number = 0);
  /// Like preset_rpdo(), of the first TPDO.
  bool preset_tpdo(std::span<const std::uint32_t> mapping, std::uint32_t can_id);

  /// Switches power; a device that gets power starts from its initial state. One that is not
  /// simulated here stays off.
  void power(bool is_on);

  /// As given.
  const Place& place() const { return place_; }
  /// Its virtual devices, as the catalogue names them: `geographical-positioning+time-fixing`.
  std::string device_name() const;
  /// The device; made again at each power-on, so keep no reference.
  cia407::BusDevice& device() { return *device_; }
  /// Its node; see device().
  Node& node() { return device_->node(); }
  /// The cable of its car.
  BusIndex bus() const { return bus_; }
  /// Slot on that cable.
  SlotIndex slot() const { return slot_; }
  /// Number on that cable.
  ControllerId controller() const { return world_.controller(slot_); }
  /// True while it runs.
  bool is_powered() const { return world_.is_running(slot_); }
  /// True if it runs, and is in the NMT state Operational.
  bool is_operational() { return is_powered() && node().state() == NmtState::operational; }
  /// Calls `act`, which does something with the device from outside of the bus: the device is
  /// brought up to the present before, and called again after it. Does nothing without power.
  template <class Act>
  void with(const Act& act) {
    if (!is_powered()) return;
    node().advance(world_.now());
    act();
    world_.touched(slot_);
  }

 private:
  void make();
  void restore(ResetScope scope);
  std::optional<std::uint16_t> find_pdo(std::uint16_t first_mapping,
                                        std::span<const std::uint32_t> mapping, unsigned number);

  World& world_;
  BusIndex bus_;
  SlotIndex slot_;
  std::span<const cia407::BusUnit* const> units_;
  Place place_;
  const Environment& environment_;
  std::vector<Preset> presets_;
  std::unique_ptr<cia407::BusDevice> device_;
  std::optional<Identity> identity_;
  Callback<void(ResetScope)> next_restored_;
};

}  // namespace canvoy::bus_line
