// What a device takes from a PDO of another one, until that one falls silent: then nobody knows.
//
//     CarSource supply(network, {.pdo_number = 84,
//                                .lost = Callback<void()>::to<&Radio::supply_lost>(radio),
//                                .read = Callback<void()>::to<&Radio::look_at_supply>(radio)});
//     void Radio::written(const Entry&, Source source) { supply.came(source); ... }
//
// A PDO that is sent when its values change does not come because its receiver has missed it. So
// its entries are read by SDO when the source is heard to be operational again: after a loss
// without a boot-up, and after a reset of this node, which has forgotten them; and as they are
// after a sign that PDOs were lost (GapWatch).
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/car_network.hpp"

namespace canvoy::cia447 {

/// It has to be made before the node starts.
class CarSource {
 public:
  struct Settings {
    unsigned pdo_number = 0;
    /// What stays behind of the old value is up to who is called: this clears it.
    Callback<void()> lost = {};
    /// The values of a source that came back are in their entries. Empty: they are not read (where
    /// the PDO is sent in a cycle, or somebody else reads them).
    Callback<void()> read = {};
  };

  CarSource(CarNetwork& network, const Settings& settings);
  CarSource(const CarSource&) = delete;
  CarSource& operator=(const CarSource&) = delete;

  /// Something of the PDO was written. What comes by SDO has no source that is watched.
  void came(Source source);
  /// This node was asked for it.
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
  NodeId awaited_ = 0;  ///< who was the source, and is to be read
  SdoClient client_;
  Items<std::uint32_t> mapping_ = {};
  std::size_t position_ = 0;
  std::array<std::uint8_t, 8> value_{};
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
};

}  // namespace canvoy::cia447
