#include "canvoy/can/host/local_addresses.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <algorithm>
#include <array>

namespace canvoy::host {

namespace {

constexpr Duration valid_for = 1s;

bool is_loopback(in_addr address) {
  return (ntohl(address.s_addr) >> 24) == 127;
}

/// Calls `visit(in_addr, bool is_up)` for each interface.
template <class Visit>
void for_each_address(const Visit& visit) {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return;
  for (const ifaddrs* entry = first; entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_addr == nullptr || entry->ifa_addr->sa_family != AF_INET) continue;
    const auto* address = reinterpret_cast<const sockaddr_in*>(entry->ifa_addr);
    visit(address->sin_addr, (entry->ifa_flags & IFF_UP) != 0);
  }
  freeifaddrs(first);
}

}  // namespace

bool LocalAddresses::contains(in_addr address, Time now) {
  const auto known = [&] { return std::ranges::count(addresses_, address.s_addr) != 0; };
  if (is_loopback(address)) return true;
  const bool is_fresh = read_at_ != Time::min() && now < read_at_ + valid_for;
  if (is_fresh) return known();
  read();
  read_at_ = now;
  return known();
}

void LocalAddresses::read() {
  addresses_.clear();
  for_each_address(
      [this](in_addr address, bool /*is_up*/) { addresses_.push_back(address.s_addr); });
}

std::vector<std::string> outside_addresses() {
  std::vector<std::string> all;
  for_each_address([&](in_addr address, bool is_up) {
    if (!is_up || is_loopback(address)) return;
    std::array<char, INET_ADDRSTRLEN> text{};
    all.emplace_back(inet_ntop(AF_INET, &address, text.data(), text.size()));
  });
  return all;
}

}  // namespace canvoy::host
