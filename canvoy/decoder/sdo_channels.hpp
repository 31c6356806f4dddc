// Client and server of the SDO channels on a bus, by CAN-ID: the default channel of each node (CiA
// 301, 7.3.3), the SDO parameters of nodes (1200h to 12FFh), and the mesh of a car (CiA 447-4).
//
//     SdoChannels channels;
//     channels.learn(7, 0x1201, 1, 0x0000'0621);
//     if (const auto route = channels.find(can_id, false)) follow(*route);
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/decoder/by_can_id.hpp"

namespace canvoy::decoder {

/// Client and server of the SDO channel with a CAN-ID.
struct SdoRoute {
  std::uint16_t channel = 0;  ///< CAN-ID of the requests
  NodeId client = 0;          ///< 0: unknown
  NodeId server = 0;          ///< node-ID; 0: unknown
  bool is_request = false;    ///< from client to server
};

class SdoChannels {
 public:
  /// Takes an SDO parameter of a node.
  void learn(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint32_t value);
  /// Discards the SDO parameters of a node: another device has its node-ID.
  void forget(NodeId node);

  /// The channel with this CAN-ID. Learned channels take precedence over the default channels, and
  /// these over the mesh of a car.
  std::optional<SdoRoute> find(std::uint32_t can_id, bool has_car) const;

 private:
  /// SDO parameters of a server (from 1200h) or of a client (from 1280h).
  struct Parameters {
    CobId to_server;
    CobId to_client;
    NodeId partner = 0;
    std::uint16_t placed_request = 0;  ///< 0: not stored
    std::uint16_t placed_response = 0;
  };

  static constexpr std::size_t channels_max = 4096;

  void place(NodeId node, std::uint16_t index, Parameters& own);

  std::map<std::pair<NodeId, std::uint16_t>, Parameters> parameters_;
  ByCanId<SdoRoute> routes_;  ///< learned channels; channel 0: none
};

}  // namespace canvoy::decoder
