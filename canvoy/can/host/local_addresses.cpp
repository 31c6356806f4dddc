#include "canvoy/can/host/local_addresses.hpp"

#include <ifaddrs.h>

#include <algorithm>

namespace canvoy::host {

namespace {

constexpr Duration valid_for = 1s;

bool is_loopback(in_addr address) {
  return (ntohl(address.s_addr) >> 24) == 127;
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
  ifaddrs* first = nullptr;
  addresses_.clear();
  if (getifaddrs(&first) != 0) return;
  for (const ifaddrs* entry = first; entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_addr == nullptr || entry->ifa_addr->sa_family != AF_INET) continue;
    const auto* address = reinterpret_cast<const sockaddr_in*>(entry->ifa_addr);
    addresses_.push_back(address->sin_addr.s_addr);
  }
  freeifaddrs(first);
}

}  // namespace canvoy::host
