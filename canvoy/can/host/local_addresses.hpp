// Which IPv4 addresses are those of this machine (of this network namespace).
//
//     if (!local_.contains(sender, loop.now())) ignore(datagram);
#pragma once

#include <netinet/in.h>

#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy::host {

/// The kernel drops what comes from elsewhere with one of them as its source, so that a source
/// among them was sent here.
class LocalAddresses {
 public:
  /// An address that was added less than a second ago may not be known yet. Linear in the number of
  /// addresses; asks the kernel at most once a second.
  bool contains(in_addr address, Time now);

 private:
  void read();

  std::vector<in_addr_t> addresses_;
  Time read_at_ = Time::min();
};

}  // namespace canvoy::host
