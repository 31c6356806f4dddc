#include "canvoy/can/host/bus_address.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace canvoy::host {

namespace {

constexpr std::size_t interface_length_max = 15;  // IFNAMSIZ without the closing zero
constexpr std::string_view forms =
    "a bus is written can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0 or sim";

Error refuse(std::string_view text, std::string_view what) {
  return {"bus \"" + std::string(text) + "\"", std::string(what), std::string(forms)};
}

// Parses all of `text` as a decimal number up to `max`.
std::optional<unsigned> number(std::string_view text, unsigned max) {
  unsigned value = 0;
  const char* end = text.data() + text.size();
  const auto [stopped_at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped_at != end || value > max) return std::nullopt;
  return value;
}

// Returns the part before `separator`; `text` keeps the part after it, or nothing.
std::string_view cut(std::string_view& text, char separator) {
  const std::size_t position = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, position);
  text.remove_prefix(std::min(position + 1, text.size()));
  return part;
}

bool parse_group(std::string_view text, std::array<std::uint8_t, 4>& group) {
  if (std::ranges::count(text, '.') != 3) return false;
  for (std::uint8_t& byte : group) {
    const std::optional<unsigned> value = number(cut(text, '.'), 255);
    if (!value) return false;
    byte = static_cast<std::uint8_t>(*value);
  }
  return group[0] >= 224 && group[0] <= 239;
}

Result<BusAddress> parse_udp(std::string_view text, std::string_view rest) {
  BusAddress address{.kind = BusType::udp_multicast};
  const bool has_option = rest.find('?') != std::string_view::npos;
  std::string_view endpoint = cut(rest, '?');
  if (has_option) {
    const std::optional<unsigned> ttl =
        rest.starts_with("ttl=") ? number(rest.substr(4), 255) : std::nullopt;
    if (!ttl) return refuse(text, "the only option is ?ttl=, with a number of hops from 0 to 255");
    address.udp.ttl = static_cast<std::uint8_t>(*ttl);
  }
  if (endpoint.empty()) return address;
  const bool has_port = endpoint.find(':') != std::string_view::npos;
  if (!parse_group(cut(endpoint, ':'), address.udp.group)) {
    return refuse(text,
                  "the group is not one of the multicast addresses 224.0.0.0 to 239.255.255.255");
  }
  if (has_port) {
    const std::optional<unsigned> port = number(endpoint, 65535);
    if (!port || *port == 0) return refuse(text, "the port is not a number from 1 to 65535");
    address.udp.port = static_cast<std::uint16_t>(*port);
  }
  return address;
}

// True for a valid interface name of the kernel that can be printed in a log.
bool is_interface_name(std::string_view text) {
  return text != "." && text != ".." && std::ranges::all_of(text, [](char character) {
           return character > ' ' && character < 0x7F && character != '/' && character != ':';
         });
}

// True for a valid host: letters, digits and dots; IPv6 in brackets.
bool is_host(std::string_view text) {
  constexpr std::size_t length_max = 253;
  return !text.empty() && text.size() <= length_max && std::ranges::all_of(text, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' ||
           c == '-' || c == '_' || c == ':';
  });
}

// Takes `bench.local`, `10.0.0.7` or `[fe80::1]` from the front of `rest`.
std::string_view take_host(std::string_view& rest) {
  if (!rest.starts_with('[')) return cut(rest, ':');
  rest.remove_prefix(1);
  if (rest.find(']') == std::string_view::npos) return {};
  const std::string_view host = cut(rest, ']');
  if (!rest.empty() && cut(rest, ':').size() > 0) return {};
  return host;
}

Result<BusAddress> check_interface(std::string_view text, std::string_view name,
                                   BusAddress address) {
  if (name.size() > interface_length_max)
    return refuse(text, "an interface's name has at most 15 characters");
  if (!is_interface_name(name)) return refuse(text, "this is no interface's name");
  address.interface = name;
  return address;
}

Result<BusAddress> parse_tcp(std::string_view text, std::string_view rest) {
  BusAddress address{.kind = BusType::socketcand};
  const std::size_t slash = rest.find('/');
  if (slash == std::string_view::npos || slash + 1 == rest.size())
    return refuse(text, "the server's bus is missing behind a /");
  std::string_view server = rest.substr(0, slash);
  const std::string_view host = take_host(server);
  if (!is_host(host)) return refuse(text, "the server has no name");
  address.tcp.host = host;
  if (!server.empty()) {
    const std::optional<unsigned> port = number(server, 65535);
    if (!port || *port == 0) return refuse(text, "the port is not a number from 1 to 65535");
    address.tcp.port = static_cast<std::uint16_t>(*port);
  }
  return check_interface(text, rest.substr(slash + 1), address);
}

}  // namespace

std::string to_string(const BusAddress& address) {
  if (address.kind == BusType::simulated) return "sim";
  if (address.kind == BusType::socketcan) return address.interface;
  if (address.kind == BusType::socketcand) {
    const bool is_ip6 = address.tcp.host.find(':') != std::string::npos;
    const std::string host = is_ip6 ? '[' + address.tcp.host + ']' : address.tcp.host;
    return "tcp:" + host + ':' + std::to_string(address.tcp.port) + '/' + address.interface;
  }
  std::string text = "udp:";
  for (const std::uint8_t byte : address.udp.group) text += std::to_string(byte) + '.';
  text.back() = ':';
  text += std::to_string(address.udp.port);
  if (address.udp.ttl > 0) text += "?ttl=" + std::to_string(address.udp.ttl);
  return text;
}

Result<BusAddress> parse_bus_address(std::string_view text) {
  if (text == "sim") return BusAddress{.kind = BusType::simulated};
  if (text.starts_with("udp:")) return parse_udp(text, text.substr(4));
  if (text.starts_with("tcp:")) return parse_tcp(text, text.substr(4));
  if (text.empty()) return refuse(text, "the name is empty");
  if (text == "any") return refuse(text, "one bus has to be named");
  if (text.find(':') != std::string_view::npos)
    return refuse(text, "this kind of bus is not known");
  return check_interface(text, text, BusAddress{.kind = BusType::socketcan});
}

}  // namespace canvoy::host
