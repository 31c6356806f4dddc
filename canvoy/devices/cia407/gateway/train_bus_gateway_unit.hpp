// The train bus gateway: hands on to the other vehicles of the train what is told in this one, and
// tells what comes from there (CiA 407, 6.10). In a segment without a main on-board computer it
// provides what that one would, with its pre-defined messages (footnote 1; BusSegment).
//
//     TrainBusGatewayUnit gateway(device, {.send = ...}, {});
//     gateway.receive(0x6109, 0, bytes);   // from the train
//     gateway.press_stop_button();         // of this vehicle
//
// A request to stop (6204h) goes both ways. Buttons of a vehicle without a main on-board computer
// are wired to its gateway: what they ask for goes to the train, and is shown here when the
// computer says so.
#pragma once

#include "canvoy/devices/cia407/bus_kind.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

struct TrainBusGatewayHardware {
  /// To the other vehicles: a value as it stands in the dictionary.
  Callback<void(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value)> send =
      {};
};

class TrainBusGatewayUnit {
 public:
  /// What `hardware` refers to must outlive this.
  TrainBusGatewayUnit(VirtualDevice& device, const TrainBusGatewayHardware& hardware,
                      const NoSettings& /*settings*/)
      : device_(device), hardware_(hardware) {
    device.react(*this, reactions());
  }
  TrainBusGatewayUnit(const TrainBusGatewayUnit&) = delete;
  TrainBusGatewayUnit& operator=(const TrainBusGatewayUnit&) = delete;

  /// False: it is not in service.
  bool press_stop_button() {
    if (!hardware_.send || device_.node().state() != NmtState::operational) return false;
    const auto requested = static_cast<std::uint8_t>(BusStop::requested);
    hardware_.send(bus_stop_request_object.index, 0, std::span(&requested, 1));
    return true;
  }

  /// From another vehicle. False: it is none of what the gateway provides here, or no value of it.
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
  static std::span<const HookCalls> reactions();
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

inline std::span<const HookCalls> TrainBusGatewayUnit::reactions() {
  static constexpr HookCalls rows[] = {after_any_write<&TrainBusGatewayUnit::relay>};
  return rows;
}

/// A pre-defined message (8.1.4.3), as the gateway takes it, or sends it where it stands in for who
/// would.
template <const PdoMessage& message, const auto& mapping>
inline constexpr PdoInfo relayed_rpdo = on(message.cob_id, receives(mapping, message.name));
template <const PdoMessage& message, const auto& mapping>
inline constexpr PdoInfo relayed_tpdo = on(message.cob_id, sends(mapping, message.name));

/// 6204h of another vehicle, for the main on-board computer, which provides that of this one.
inline constexpr PdoInfo train_stop_request_tpdo =
    sends(stop_request_mapping, "bus stop request of the train");

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
