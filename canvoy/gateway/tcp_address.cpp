#include "canvoy/gateway/tcp_address.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <array>
#include <cstring>

#include "canvoy/gateway/number.hpp"

namespace canvoy::gateway {

namespace {

/// Part of the address for its family.
template <class Family>
Family part_of(const sockaddr_storage& storage) {
  Family family{};
  std::memcpy(&family, &storage, sizeof family);
  return family;
}

template <class Family>
TcpAddress address_of(const Family& family) {
  TcpAddress address;
  std::memcpy(&address.storage, &family, sizeof family);
  address.length = sizeof family;
  return address;
}

host::Error no_address(std::string_view text) {
  return {std::string(text), "is no address to listen at", "write 127.0.0.1:60000, or [::1]:60000"};
}

}  // namespace

bool TcpAddress::is_loopback() const {
  if (storage.ss_family == AF_INET6) {
    const in6_addr address = part_of<sockaddr_in6>(storage).sin6_addr;
    return IN6_IS_ADDR_LOOPBACK(&address) != 0;
  }
  constexpr std::uint32_t loopback_network = 127;
  return ntohl(part_of<sockaddr_in>(storage).sin_addr.s_addr) >> 24 == loopback_network;
}

std::string TcpAddress::text() const {
  std::array<char, INET6_ADDRSTRLEN> name{};
  if (storage.ss_family == AF_INET6) {
    const auto v6 = part_of<sockaddr_in6>(storage);
    inet_ntop(AF_INET6, &v6.sin6_addr, name.data(), name.size());
    return "[" + std::string(name.data()) + "]:" + std::to_string(ntohs(v6.sin6_port));
  }
  const auto v4 = part_of<sockaddr_in>(storage);
  inet_ntop(AF_INET, &v4.sin_addr, name.data(), name.size());
  return std::string(name.data()) + ":" + std::to_string(ntohs(v4.sin_port));
}

host::Result<TcpAddress> parse_tcp_address(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return no_address(text);
  const auto port = parse_unsigned(text.substr(colon + 1), UINT16_MAX);
  if (!port) return no_address(text);
  std::string name(text.substr(0, colon));
  const bool brackets = name.size() > 2 && name.starts_with('[') && name.ends_with(']');
  if (brackets) {
    name = name.substr(1, name.size() - 2);
    sockaddr_in6 v6{};
    v6.sin6_family = AF_INET6;
    v6.sin6_port = htons(static_cast<std::uint16_t>(*port));
    if (inet_pton(AF_INET6, name.c_str(), &v6.sin6_addr) != 1) return no_address(text);
    return address_of(v6);
  }
  sockaddr_in v4{};
  v4.sin_family = AF_INET;
  v4.sin_port = htons(static_cast<std::uint16_t>(*port));
  if (inet_pton(AF_INET, name.c_str(), &v4.sin_addr) != 1) return no_address(text);
  return address_of(v4);
}

}  // namespace canvoy::gateway
