// Address of a TCP server: an address of this machine and a port, both as numbers.
//
//     host::Result<TcpAddress> address = parse_tcp_address("127.0.0.1:60000");
#pragma once

#include <sys/socket.h>

#include <string>
#include <string_view>

#include "canvoy/can/host/result.hpp"

namespace canvoy::gateway {

struct TcpAddress {
  sockaddr_storage storage{};  ///< of an IPv4 or IPv6 socket
  socklen_t length = 0;        ///< bytes used of it

  /// For system calls.
  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
  /// True for 127.0.0.0/8 and ::1.
  bool is_loopback() const;
  /// The address in the form that parse_tcp_address() reads.
  std::string text() const;
};

/// Parses `127.0.0.1:60000` or `[::1]:60000`; names are not resolved.
host::Result<TcpAddress> parse_tcp_address(std::string_view text);

}  // namespace canvoy::gateway
