// Values from a PDO of another device, which become unknown when that device falls silent.
//
//     CarSource supply(network, {.pdo_number = 84,
//                                .lost = Callback<void()>::to<&Radio::supply_lost>(radio),
//                                .read = Callback<void()>::to<&Radio::look_at_supply>(radio)});
//     supply.came(source);  // after each write to one of its entries
//
// A PDO that is sent on changes is not repeated for a receiver that has missed it. Therefore its
// entries are read by SDO when the source is operational again after a loss without a boot-up,
// after a reset of this node, which has lost them, and after a sign that PDOs were lost (GapWatch).
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"

namespace canvoy::cia447 {

/// Construct it before the node starts.
class CarSource {
 public:
  /// The PDO, and its sender.
  struct Settings {
    unsigned pdo_number = 0;  ///< RPDO by which it comes
    /// Called on a loss; the callback clears the old values where that is needed.
    Callback<void()> lost = {};
    /// Called when the values of a returned source are in their entries. Empty: they are not read
    /// (if the PDO is cyclic, or another reader exists).
    Callback<void()> read = {};
  };

  /// Makes the source; `network` must outlive it.
  CarSource(CarNetwork& network, const Settings& settings);

  /// Takes a write of a value of the PDO. A write by SDO has no monitored source.
  void came(Source source);
  /// The source has answered a request of this node.
  void came_from(NodeId source);

 private:
  void reset(ResetScope scope);
  void node_heard(NodeId node, std::uint8_t state);
  void node_lost(NodeId node);
  void missed(NodeId node);
  void begin_reading();
  void read_next();
  void answered(SdoClient::Outcome outcome);

  CarNetwork& network_;
  Settings settings_;
  Callback<void(NodeId)> next_lost_;
  Callback<void(NodeId)> next_gap_;
  Callback<void(NodeId, std::uint8_t)> next_heard_;
  NodeId source_ = 0;
  NodeId awaited_ = 0;  ///< the former source, which has to be read
  SdoClient client_;
  Items<std::uint32_t> mapping_ = {};
  std::size_t position_ = 0;
  std::array<std::uint8_t, 8> value_{};
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia447
