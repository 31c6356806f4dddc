// The notation of a bus for users: can0, vcan0, udp:239.74.163.2:43113, tcp:bench.local/can0, sim.
//
//     Result<BusAddress> address = parse_bus_address("udp:239.74.163.2:43113");
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "canvoy/can/host/result.hpp"

namespace canvoy::host {

/// How frames reach the bus.
enum class BusType : std::uint8_t { socketcan, udp_multicast, socketcand, simulated };

/// A multicast group and its range. The defaults are those of python-can, except the time to live:
/// 0 keeps frames on this machine and accepts none of others, 1 lets them into and from the local
/// network.
struct UdpGroup {
  std::array<std::uint8_t, 4> group{239, 74, 163, 2};  ///< IPv4 address
  std::uint16_t port = 43113;                          ///< of the datagrams
  std::uint8_t ttl = 0;  ///< time to live: routers that may pass frames on, plus one

  friend bool operator==(const UdpGroup&, const UdpGroup&) = default;
};

/// Address of a socketcand; its usual port is 29536.
struct TcpServer {
  std::string host;            ///< a name or an address, IPv6 without brackets
  std::uint16_t port = 29536;  ///< 1 to 65535

  friend bool operator==(const TcpServer&, const TcpServer&) = default;
};

struct BusAddress {
  BusType kind = BusType::socketcan;  ///< which of the members below counts
  std::string interface = {};         ///< of SocketCAN, local or at the server: 1 to 15 characters
  UdpGroup udp = {};                  ///< for UDP multicast
  TcpServer tcp = {};                 ///< for socketcand
};

/// Complete text of an address: can0, udp:239.74.163.2:43113, udp:239.74.163.2:43113?ttl=1,
/// tcp:bench.local:29536/can0, sim.
std::string to_string(const BusAddress& address);

/// Parses `<interface>`, `sim`, `udp:[<group>[:<port>]][?ttl=<0 to 255>]`, or
/// `tcp:<host>[:<port>]/<interface>`.
Result<BusAddress> parse_bus_address(std::string_view text);

}  // namespace canvoy::host
