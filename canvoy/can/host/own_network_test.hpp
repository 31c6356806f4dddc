// A network for one test: a loopback interface only, which may carry multicast. Needs root.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <net/if.h>
#include <net/route.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <cstring>
#include <string>

#include "canvoy/can/host/descriptor.hpp"

namespace canvoy::host {

/// Moves the whole process, and programs that it starts afterwards, into a separate network.
class OwnNetwork {
 public:
  OwnNetwork() {
    if (unshare(CLONE_NEWNET) != 0) return;
    socket_ = Descriptor{::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
    ifreq request{};
    std::strcpy(request.ifr_name, "lo");
    request.ifr_flags = IFF_UP | IFF_LOOPBACK | IFF_MULTICAST;
    EXPECT_EQ(ioctl(socket(), SIOCSIFFLAGS, &request), 0);
  }

  bool entered() const { return static_cast<bool>(socket_); }
  /// An unbound datagram socket.
  int socket() const { return socket_.get(); }

  void add_multicast_route() const { EXPECT_EQ(change_route(SIOCADDRT), 0); }
  void delete_multicast_route() const { EXPECT_EQ(change_route(SIOCDELRT), 0); }

  static sockaddr_in address_of(const char* address, std::uint16_t port) {
    sockaddr_in result{};
    result.sin_family = AF_INET;
    result.sin_port = htons(port);
    inet_pton(AF_INET, address, &result.sin_addr);
    return result;
  }

 private:
  // Routes 224.0.0.0/4 to the loopback interface.
  int change_route(unsigned long operation) const {
    rtentry route{};
    std::string device = "lo";
    const sockaddr_in groups = address_of("224.0.0.0", 0);
    const sockaddr_in mask = address_of("240.0.0.0", 0);
    std::memcpy(&route.rt_dst, &groups, sizeof groups);
    std::memcpy(&route.rt_genmask, &mask, sizeof mask);
    route.rt_flags = RTF_UP;
    route.rt_dev = device.data();
    return ioctl(socket(), operation, &route);
  }

  Descriptor socket_;
};

}  // namespace canvoy::host
