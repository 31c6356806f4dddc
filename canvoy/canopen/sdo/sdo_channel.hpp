// The COB-IDs of SDO channels: objects 1200h to 127Fh of servers and 1280h to 12FFh of clients (CiA
// 301, 7.5.2.33 and 7.5.2.34).
//
//     SdoChannel channel = sdo_channel(dictionary, 0x1201);
//     if (channel.valid()) listen_to(channel.request);
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

inline constexpr std::uint16_t sdo_server_parameter =
    object_index::sdo_server;  ///< of SDO server 0
inline constexpr std::uint16_t sdo_client_parameter =
    object_index::sdo_client;  ///< of SDO client 0
/// Sub-indices: COB-IDs client to server and back, and the node-ID of the other side.
inline constexpr std::uint8_t sdo_sub_request = 1;
inline constexpr std::uint8_t sdo_sub_response = 2;  ///< COB-ID server to client
inline constexpr std::uint8_t sdo_sub_peer = 3;      ///< node-ID of the other side
/// Limit of servers, and of clients, in a node.
inline constexpr std::uint8_t sdo_channels_max = 128;

/// The CAN-IDs between a client and a server.
struct SdoChannel {
  std::uint16_t request = 0;   ///< client to server
  std::uint16_t response = 0;  ///< server to client

  /// True if the channel can be used.
  constexpr bool valid() const { return request != 0; }
  friend constexpr bool operator==(const SdoChannel&, const SdoChannel&) = default;
};

/// Channel that each node serves by default.
constexpr SdoChannel default_sdo_channel(NodeId server) {
  return {static_cast<std::uint16_t>(can_id::sdo_request + server),
          static_cast<std::uint16_t>(can_id::sdo_response + server)};
}

/// Channel in an object: not valid if the object is absent, or one of its COB-IDs is not valid.
SdoChannel sdo_channel(const Dictionary& dictionary, std::uint16_t index);

/// True for 1200h to 12FFh, whether the node has the object or not.
constexpr bool is_sdo_parameter(std::uint16_t index) {
  return index >= object_index::sdo_server && index <= object_index::sdo_client_last;
}

/// True if `value` of this object is the COB-ID of an SDO channel that comes and goes with a
/// connection (bit 30).
inline bool is_dynamic_channel(std::uint16_t index, std::span<const std::uint8_t> value) {
  return is_sdo_parameter(index) && value.size() == sizeof(std::uint32_t) &&
         (load<std::uint32_t>(value.data()) & CobId::bit30) != 0;
}

/// Checks whether a COB-ID of an SDO channel may become `value`. Its CAN-ID changes only from or to
/// an invalid COB-ID, has 11 bits, and is not restricted; clients may use those of default
/// channels. Abort: value_range.
AbortCode check_sdo_parameter(const Entry& entry, std::span<const std::uint8_t> value);

}  // namespace canvoy
