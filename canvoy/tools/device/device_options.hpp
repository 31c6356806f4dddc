// Options of the command line of `canvoy device`.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/device/bus/device_bus_panel.hpp"
#include "canvoy/tools/device/car/device_car.hpp"
#include "canvoy/tools/device/car/device_car_panel.hpp"
#include "canvoy/tools/device/catalogue/device_catalogue.hpp"
#include "canvoy/tools/device/device_lift_unit.hpp"
#include "canvoy/tools/device/seat/operator_panel.hpp"

namespace canvoy::tools {

// A bus behind an operator environment that `canvoy device` runs, through which hosts reach its
// devices (CiA 852, 5.2).
//
//     EmbeddedNetwork network(loop, module.node(), {.bus = "can1", .network = 2});
//     attachment.attach(network.access());    // in place of the node

struct EmbeddedOptions {
  std::string bus{};  ///< empty: none
  std::uint16_t network = RemoteSettings{}.network;
  unsigned indication = RemoteSettings{}.indication;
  std::string emergency{};  ///< CAN-ID; empty: not reported
};
void add_embedded_options(Verb& command, EmbeddedOptions& options);
/// Throws UsageError for options that are not valid for a device on `host_bus`.
void check_embedded(const EmbeddedOptions& options, const std::string& host_bus);

class EmbeddedNetwork {
 public:
  /// All arguments must outlive this. Throws Failure if the bus cannot be opened.
  EmbeddedNetwork(host::EventLoop& loop, Node& module, const EmbeddedOptions& options);
  EmbeddedNetwork(const EmbeddedNetwork&) = delete;
  EmbeddedNetwork& operator=(const EmbeddedNetwork&) = delete;

  RemoteAccess& access() { return access_; }

 private:
  /// Listener on that bus.
  struct Ear {
    RemoteAccess& access;
    void receive(const Frame& frame, Time now) { access.receive_embedded(frame, now); }
  };

  std::unique_ptr<host::HostBus> bus_;
  host::Attachment attachment_;
  std::array<RemoteChannel, 1> channels_;
  RemoteAccess access_;
  Ear ear_{access_};
};

struct DeviceOptions {
  std::vector<std::string> kinds;
  std::vector<std::string> node_ids;
  std::vector<std::string> stores;
  std::string bus;
  std::string duration;
  std::string heartbeat;                 ///< `500ms`; empty: the default
  std::optional<unsigned> heartbeat_ms;  ///< `heartbeat` in ms
  std::string bit_rate;
  double state_of_charge = 20;
  bool no_manage = false;
  bool json = false;
  bool list = false;
  std::optional<std::uint32_t> serial_number;
  // For devices of a lift.
  unsigned lift = 1;
  unsigned door = 1;
  unsigned floor = 1;
  unsigned floors = 10;
  std::vector<std::string> presses;  ///< `up@2s`
  std::vector<std::string> sets;     ///< `paper=no@2s`
  bool lists_hands = false;
  bool reads_lines = false;  ///< presses and sets, from standard input
  LiftUnitOptions unit;
  // For devices of a car.
  DeviceCarOptions car;
  CarPanelOptions car_panel;
  BusPanelOptions bus_panel;  ///< for devices of a bus
  OperatorPanelOptions operator_panel;
  EmbeddedOptions embedded;
  std::string interface = {};  ///< SocketCAN interface with a bit rate that LSS may set
};

/// All presses and sets.
inline std::vector<std::string> orders_of(const DeviceOptions& options) {
  std::vector<std::string> orders = options.presses;
  orders.insert(orders.end(), options.sets.begin(), options.sets.end());
  return orders;
}

/// A requested device.
struct Wanted {
  std::string name;
  const DeviceKind* kind = nullptr;  ///< null: described by a file, or several virtual devices
  std::shared_ptr<const formats::DataSheet> sheet = {};
  SharedNode shared = {};  ///< for a node of several virtual devices
  NodeId id = 0;
  std::string store = {};  ///< file name; empty: nothing is stored

  /// The virtual devices of a device of CiA 447; empty: another device.
  std::vector<const cia447::CarUnit*> car_units() const {
    if (kind != nullptr && kind->car_unit != nullptr) return {kind->car_unit};
    return shared.car;
  }
  /// The virtual devices of a device of CiA 407; empty: another device.
  std::vector<const cia407::BusUnit*> bus_units() const {
    if (kind != nullptr && kind->bus_unit != nullptr) return {kind->bus_unit};
    return shared.bus;
  }
  bool is_operator() const { return kind == &cia852::operator_kind; }
  bool is_bootloader() const { return kind == &bootloader_kind; }
  bool answers_lss() const { return kind == nullptr || kind->answers_lss; }
};

/// Sets the place of a device of this kind.
inline void put_in_place(Environment& environment, const DeviceOptions& options) {
  environment.lift = options.lift;
  environment.door = options.door;
  environment.floor = options.floor;
  environment.floors = options.floors;
  environment.manages_network = !options.no_manage;
}

}  // namespace canvoy::tools
