// The train bus gateway: forwards the values of this vehicle to the other vehicles of the train,
// and reports the values received from them (CiA 407, 6.10). In a segment without a main on-board
// computer, it provides the objects of that computer, with its pre-defined messages (footnote 1;
// BusSegment).
//
//     TrainBusGatewayUnit gateway(device, {.send = ...}, {});
//     gateway.receive(0x6109, 0, bytes);   // from the train
//     gateway.press_stop_button();         // of this vehicle
//
// A request to stop (6204h) goes both ways. Buttons of a vehicle without a main on-board computer
// are wired to its gateway: it forwards their request to the train, and shows it here when the
// computer confirms it.
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The train bus.
struct TrainBusGatewayHardware {
  /// Sends a value, as stored in the dictionary, to the other vehicles.
  Callback<void(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value)> send =
      {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(TrainBusGatewayHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::send; },
      "the class has no member function of TrainBusGatewayHardware: send");
  if constexpr (requires { &Plain::send; }) hardware.send = callback<&Plain::send>(plain);
}

class TrainBusGatewayUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  TrainBusGatewayUnit(VirtualDevice& device, const TrainBusGatewayHardware& hardware,
                      const NoSettings& /*settings*/)
      : device_(device), hardware_(hardware) {
    device.react(*this, reactions());
  }
  TrainBusGatewayUnit(const TrainBusGatewayUnit&) = delete;
  TrainBusGatewayUnit& operator=(const TrainBusGatewayUnit&) = delete;

  /// False if the gateway is not in service.
  bool press_stop_button() {
    if (!hardware_.send || device_.node().state() != NmtState::operational) return false;
    const auto requested = static_cast<std::uint8_t>(BusStop::requested);
    hardware_.send(bus_stop_request_object.index, 0, std::span(&requested, 1));
    return true;
  }

  /// Takes a value from another vehicle. False if the gateway does not provide the object here, or
  /// the value is not valid for it.
  bool receive(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value) {
    Dictionary& dictionary = device_.node().dictionary();
    const Result<Entry> entry = dictionary.find(index, sub);
    const bool is_relayed = entry && sub_is_value(*entry) && is_object(index);
    if (!is_relayed || !allows(entry->row->access, Access::sdo_read)) return false;
    if (dictionary.check_value(*entry->row, value) != AbortCode::none) return false;
    dictionary.set(*entry, value);
    device_.announce_at(index, sub);
    return true;
  }

 private:
  static std::span<const AccessHandlers> reactions();
  static bool sub_is_value(const Entry& entry) { return entry.row->access != Access::const_; }
  static bool is_object(std::uint16_t index) {
    for (const DeviceObject& object : train_bus_gateway.objects) {
      if (object.index == index) return true;
    }
    return false;
  }
  void relay(const Entry& entry) {
    if (!hardware_.send || !is_object(entry.index)) return;
    if (entry.row->type != DataType::domain) {
      hardware_.send(entry.index, entry.sub, entry.bytes());
    }
  }

  VirtualDevice& device_;
  TrainBusGatewayHardware hardware_;
};

inline std::span<const AccessHandlers> TrainBusGatewayUnit::reactions() {
  static constexpr AccessHandlers rows[] = {after_any_write<&TrainBusGatewayUnit::relay>};
  return rows;
}

/// A pre-defined message (8.1.4.3) that the gateway receives, or sends in place of a missing
/// device.
template <const PdoMessage& message, const auto& mapping>
inline constexpr PdoInfo relayed_rpdo = on(message.cob_id, receives(mapping, message.name));
template <const PdoMessage& message, const auto& mapping>
inline constexpr PdoInfo relayed_tpdo = on(message.cob_id, sends(mapping, message.name));

/// 6204h of another vehicle, for the main on-board computer, which provides 6204h of this one.
inline constexpr PdoInfo train_stop_request_tpdo =
    sends(stop_request_mapping, "bus stop request of the train");

/// Catalogue row of the gateway to other vehicles of the train (6.10);
/// bus_unit makes it a part of a device.
struct TrainBusGatewayKind : BusKind<TrainBusGatewayUnit, TrainBusGatewayHardware> {
  static constexpr DeviceInfo info = {.name = "train-bus-gateway",
                                      .title = "gateway to other vehicles of the train",
                                      .product = "Canvoy CiA 407 train bus gateway",
                                      .product_code = 40709,
                                      .node_id = 30,
                                      .hardware = "the train bus: what other vehicles say"};
  static constexpr const VirtualDeviceInfo& provides = train_bus_gateway;
  static constexpr std::array pdos = {
      own_pdo<relayed_rpdo<time_message, time_mapping>>,
      own_pdo<relayed_rpdo<route_message, route_mapping>>,
      own_pdo<relayed_rpdo<stop_point_message, stop_point_only_mapping>>,
      own_pdo<relayed_rpdo<line_message, line_mapping>>,
      own_pdo<relayed_rpdo<stop_point_name_message, stop_point_name_mapping>>,
      own_pdo<relayed_rpdo<driver_message, driver_mapping>>,
      own_pdo<relayed_rpdo<block_message, block_mapping>>,
      own_pdo<relayed_rpdo<destination_message, destination_mapping>>,
      own_pdo<relayed_tpdo<time_message, time_mapping>>,
      own_pdo<relayed_tpdo<route_message, route_mapping>>,
      own_pdo<relayed_tpdo<stop_point_message, stop_point_mapping>>,
      own_pdo<relayed_tpdo<line_message, line_mapping>>,
      own_pdo<relayed_tpdo<stop_point_name_message, stop_point_name_mapping>>,
      own_pdo<relayed_tpdo<driver_message, driver_mapping>>,
      own_pdo<relayed_tpdo<block_message, block_mapping>>,
      own_pdo<relayed_tpdo<destination_message, destination_mapping>>,
      own_pdo<stop_request_rpdo>,
      own_pdo<train_stop_request_tpdo, OwnPdo::Where::with_main_computer>,
      own_pdo<stop_request_tpdo, OwnPdo::Where::without_main_computer>};
};

}  // namespace canvoy::cia407
