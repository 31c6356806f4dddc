// What the command line of `canvoy device` says.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"
#include "canvoy/tools/device/bus/device_bus_panel.hpp"
#include "canvoy/tools/device/device_car.hpp"
#include "canvoy/tools/device/device_car_panel.hpp"
#include "canvoy/tools/device/device_catalogue.hpp"
#include "canvoy/tools/device/device_lift_unit.hpp"
#include "canvoy/tools/device/embedded_network.hpp"
#include "canvoy/tools/device/operator_panel.hpp"

namespace canvoy::tools {

struct DeviceOptions {
  std::vector<std::string> kinds;
  std::vector<std::string> node_ids;
  std::vector<std::string> stores;
  std::string bus;
  std::string duration;
  std::string heartbeat;                 ///< `500ms`; empty: as it is
  std::optional<unsigned> heartbeat_ms;  ///< the same in ms
  std::string bit_rate;
  double state_of_charge = 20;
  bool no_manage = false;
  bool json = false;
  bool list = false;
  std::optional<std::uint32_t> serial_number;
  // Of devices of a lift.
  unsigned lift = 1;
  unsigned door = 1;
  unsigned floor = 1;
  unsigned floors = 10;
  std::vector<std::string> presses;  ///< `up@2s`
  std::vector<std::string> sets;     ///< `paper=no@2s`
  bool lists_hands = false;
  bool reads_lines = false;  ///< of standard input: presses and sets
  LiftUnitOptions unit;
  // Of devices of a car.
  DeviceCarOptions car;
  CarPanelOptions car_panel;
  BusPanelOptions bus_panel;  ///< of devices of a bus
  OperatorPanelOptions operator_panel;
  EmbeddedOptions embedded;
  std::string interface = {};  ///< of SocketCAN, of which LSS may set the bit rate
};

/// One of the devices.
struct Wanted {
  std::string name;
  const DeviceKind* kind = nullptr;  ///< null: a file describes it, or it is several
  std::shared_ptr<const formats::DataSheet> sheet = {};
  SharedNode shared = {};  ///< of a node that is several virtual devices
  NodeId id = 0;
  std::string store = {};  ///< file; empty: nothing is kept

  /// The virtual devices of a device of CiA 447; empty: it is none.
  std::vector<const cia447::CarUnit*> car_units() const {
    if (kind != nullptr && kind->car_unit != nullptr) return {kind->car_unit};
    return shared.car;
  }
  /// Those of a device of CiA 407; empty: it is none.
  std::vector<const cia407::BusUnit*> bus_units() const {
    if (kind != nullptr && kind->bus_unit != nullptr) return {kind->bus_unit};
    return shared.bus;
  }
  bool is_operator() const { return kind == &cia852::operator_kind; }
  bool is_bootloader() const { return kind == &bootloader_kind; }
  bool answers_lss() const { return kind == nullptr || kind->answers_lss; }
};

/// Where a device of this kind is put.
inline void put_in_place(Site& site, const DeviceOptions& options) {
  site.lift = options.lift;
  site.door = options.door;
  site.floor = options.floor;
  site.floors = options.floors;
  site.manages_network = !options.no_manage;
}

}  // namespace canvoy::tools
