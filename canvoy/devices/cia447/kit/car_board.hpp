// A device of CiA 447 for a board: one virtual device, with the objects that it has in the
// catalogue (CarDevice), in memory that is known when the program is compiled.
//
//     CarBoard<TariffDisplayKind> display(port, 13, hardware);
//     display.node().start(now);
//     display.unit().lamp(3);  // of the TariffDisplayUnit
//
// An IVN gateway is the master of its network.
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/car_master.hpp"
#include "canvoy/devices/cia447/kit/car_sleep.hpp"
#include "canvoy/devices/kit/plain_hardware.hpp"
#include "canvoy/profiles/model/device_values.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia447 {

namespace composing::detail {

template <class Kind>
constexpr PartArray make_parts() {
  return CarParts<PartArray>(only_unit<Kind>, CarNetworkSettings{}.heartbeat).make();
}
/// A layout of which the tables refuse codes as check_car_number() does.
template <class Layout>
struct CodedLayout : Layout {
  static constexpr auto number_check = &check_car_number;
};
template <class Layout>
constexpr CodedLayout<Layout> with_codes(const Layout& layout) {
  return {layout};
}

}  // namespace composing::detail

/// The objects of a device of this kind, as car_parts() has them.
template <class Kind>
inline constexpr auto car_description = describe_parts<composing::detail::make_parts<Kind>>();
/// Its tables.
template <class Kind>
inline constexpr auto car_layout =
    composing::detail::with_codes(lay_out_device<car_description<Kind>>());

/// Settings of what all devices have in common.
struct CarBoardSettings {
  CarNetworkSettings network = {};  ///< without `heartbeat`: 1017h has the usual one
  CarSleepSettings sleep = {};      ///< times
  CarMemory memory = {};            ///< of the gateway: which devices it knows
  CarMasterSettings master = {};    ///< of the gateway
};

/// `Kind` is that of a virtual device (CarKind); `own_routes` are as in DeviceNode.
template <class Kind, const auto& layout = car_layout<Kind>, std::size_t own_routes = 0>
class CarBoard : public DeviceValues<CarBoard<Kind, layout, own_routes>, layout> {
 public:
  using Unit = typename Kind::Unit;          ///< behaviour of the virtual device
  using Hardware = typename Kind::Hardware;  ///< what the unit senses and drives
  using Settings = typename Kind::Settings;  ///< what no object of the dictionary sets

  /// The context of `port`, and everything to which the others refer, must outlive the device.
  CarBoard(const Port& port, NodeId node_id, const Hardware& hardware,
           const Settings& settings = {}, const CarBoardSettings& car = {})
      : port_(port),
        device_(port_.port(), node_id),
        network_(device_.node(), car.network),
        sleep_(network_, port_, car.sleep),
        master_(network_, sleep_, car.memory, car.master),
        unit_(network_, hardware, settings) {}
  /// The same for hardware that is a plain class, whose members are found by their names.
  template <PlainHardware<Hardware> Plain>
  CarBoard(const Port& port, NodeId node_id, Plain& hardware, const Settings& settings = {},
           const CarBoardSettings& car = {})
      : CarBoard(port, node_id, hardware_of<Hardware>(hardware), settings, car) {}
  CarBoard(const CarBoard&) = delete;
  CarBoard& operator=(const CarBoard&) = delete;

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// The node, for its states and counters.
  const Node& node() const { return device_.node(); }
  /// Behaviour of the virtual device.
  Unit& unit() { return unit_; }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  /// Common duties in the network of the car.
  CarNetwork& network() { return network_; }
  /// Sleep and wake-up.
  CarSleep& sleep() { return sleep_; }
  /// Null if it is not the gateway.
  CarMaster* master() { return master_.get(); }

 private:
  static constexpr bool is_gateway = &Kind::provides == &ivn_gateway_device;
  static constexpr std::size_t routes = CarNetwork::routes + CarSleep::routes +
                                        (is_gateway ? CarMaster::routes : 0) + catalogue_routes +
                                        own_routes;

  MutedPort port_;
  DeviceNode<layout, routes> device_;
  CarNetwork network_;
  CarSleep sleep_;
  [[no_unique_address]] canvoy::detail::Optional<CarMaster, is_gateway> master_;
  Unit unit_;
};

}  // namespace canvoy::cia447
