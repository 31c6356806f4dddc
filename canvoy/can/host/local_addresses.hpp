// The IPv4 addresses of this machine (of this network namespace).
//
//     if (!local_.contains(sender, loop.now())) ignore(datagram);
#pragma once

#include <netinet/in.h>

#include <string>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy::host {

/// Recognises local addresses. The kernel drops frames from elsewhere with one of them as source,
/// so a source among them was sent by this machine.
class LocalAddresses {
 public:
  /// True if the address is local. An address that was added less than a second ago may be missing.
  /// Linear in the number of addresses; queries the kernel at most once a second.
  bool contains(in_addr address, Time now);

 private:
  void read();

  std::vector<in_addr_t> addresses_;
  Time read_at_ = Time::min();
};

/// Addresses by which other machines reach this one, as `192.168.1.5`: of interfaces that are up,
/// except the loopback. Empty if the kernel does not report them.
std::vector<std::string> outside_addresses();

}  // namespace canvoy::host
