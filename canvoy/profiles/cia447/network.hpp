// How the nodes of a CiA 447 network find and reach each other: the CAN-IDs of PDOs and SDOs, and
// the messages that put the network to sleep.
//
// Parts 1 and 4 define this and are not at hand. The contents are from public implementations that
// agree with each other; facts that none of them gives are marked as unknown.
//
//     sdo_request(2, 7);   // 256h: node 2 asks node 7
//     pdo_base(2);         // 200h
#pragma once

#include <cstdint>

namespace canvoy::cia447 {

inline constexpr unsigned profile_number = 447;

/// The gateway is the NMT master. Add-on devices get node-IDs 2 to 16 by LSS Fastscan.
inline constexpr unsigned gateway_node_id = 1;
inline constexpr unsigned node_id_max = 16;
/// True for 1 to 16: node-IDs of CiA 447.
constexpr bool is_node_id(unsigned node_id) {
  return node_id >= gateway_node_id && node_id <= node_id_max;
}

/// First CAN-ID of the PDOs of a node, which has 32 CAN-IDs. It is not known which of them a
/// pre-defined PDO has.
constexpr std::uint32_t pdo_base(unsigned node_id) {
  const unsigned n = node_id - 1;
  return 0x180 + ((n & 7) << 7) + ((n & 8) << 2);
}
inline constexpr unsigned pdos_per_node = 32;

/// CAN-ID of the request of a node to `server`: each node is a client of each other one. For a node
/// itself, it is no SDO but its ISO-TP (UDS) request. 600h and 580h plus node-ID are available in
/// addition.
constexpr std::uint32_t sdo_request(unsigned client, unsigned server) {
  const unsigned n = client - 1;
  return 0x240 + ((n & 0x0C) << 6) + ((n & 0x03) << 4) + (server - 1);
}
/// CAN-ID of the answers of a server to one client of the mesh (CiA 447-4).
constexpr std::uint32_t sdo_response(unsigned client, unsigned server) {
  return sdo_request(client, server) - 0x80;
}

/// CAN-ID of sleep and wake-up messages, 8 bytes: command, reason, zeros. A device without a
/// node-ID may send with 0, only to wake up.
constexpr std::uint32_t sleep_can_id(unsigned node_id) {
  return 0x690 + node_id;
}
/// Command of the message for sleep and wake-up.
enum class SleepCommand : std::uint8_t {
  query_objection = 0x01,  ///< of the gateway: asks for objections
  set_sleep_mode = 0x02,   ///< of the gateway
  request_sleep = 0x03,    ///< of an add-on device
  objection = 0x81,        ///< of an add-on device, with its reason
  wake_up = 0x82,
};
inline constexpr std::uint8_t no_reason = 0xFE;

}  // namespace canvoy::cia447
