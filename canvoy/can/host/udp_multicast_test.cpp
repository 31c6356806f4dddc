#include "canvoy/can/host/udp_multicast.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/msgpack_frame.hpp"
#include "canvoy/can/host/own_network_test.hpp"

namespace canvoy::host::udp_multicast_test {
namespace {

struct Node {
  Node(EventLoop& loop, HostBus& bus) : attachment(loop, bus), port(attachment.port()) {
    attachment.attach(*this);
  }

  void receive(const Frame& frame, Time) { heard.emplace_back(FrameText(frame).view()); }
  void tx_ready(Time) { ++ready; }
  bool send(const Frame& frame) const { return port.send(port.context, frame); }

  Attachment attachment;
  Port port;
  std::vector<std::string> heard;
  int ready = 0;
};

using Heard = std::vector<std::string>;

class UdpMulticastTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!network_.entered()) GTEST_SKIP() << "a network of its own needs root";
  }

  std::unique_ptr<HostBus> open(const char* address = "udp:") {
    Result<std::unique_ptr<HostBus>> bus = open_bus(*loop_, address);
    EXPECT_TRUE(bus) << bus.error().line();
    return bus ? std::move(*bus) : nullptr;
  }

  template <class Condition>
  bool run_until(Condition condition) {
    const Time give_up = loop_->now() + 5s;
    while (!condition() && loop_->now() < give_up) loop_->run_until(loop_->now() + 1ms);
    return condition();
  }

  // A datagram of another program to the default group.
  void send_datagram(std::span<const std::uint8_t> bytes) const {
    const sockaddr_in group = OwnNetwork::address_of("239.74.163.2", 43113);
    const auto* generic = reinterpret_cast<const sockaddr*>(&group);
    EXPECT_EQ(::sendto(network_.socket(), bytes.data(), bytes.size(), 0, generic, sizeof group),
              static_cast<ssize_t>(bytes.size()));
  }

  OwnNetwork network_;
  std::unique_ptr<EventLoop> loop_ = *EventLoop::create();
  const Frame frame_ = Frame::data_frame(0x185, {0x1E, 0x2F});
};

TEST_F(UdpMulticastTest, AFrameReachesSiblingsAndOtherProgramsButNotItsSender) {
  network_.add_multicast_route();
  const auto here = open();
  const auto there = open("udp:239.74.163.2:43113");
  ASSERT_TRUE(here && there);
  Node charger(*loop_, *here);
  Node sibling(*loop_, *here);
  Node stranger(*loop_, *there);
  EXPECT_TRUE(charger.send(frame_));
  EXPECT_TRUE(run_until([&] { return !sibling.heard.empty() && !stranger.heard.empty(); }));
  EXPECT_EQ(sibling.heard, Heard{"185#1E2F"});
  EXPECT_EQ(stranger.heard, Heard{"185#1E2F"});
  EXPECT_EQ(charger.heard, Heard{});
  EXPECT_EQ(here->counters().sent, 1U);
  EXPECT_EQ(here->counters().received, 0U);
  EXPECT_EQ(there->counters().received, 1U);
}

/// A frame within the machine has the address of that interface as its source.
TEST_F(UdpMulticastTest, IsHeardOnAMachineThatHasAnotherInterface) {
  const char* const add =
      "ip link add other type veth peer name end && ip addr add 192.0.2.2/24 dev other && "
      "ip link set other up && ip link set end up";
  if (std::system(add) != 0)
    GTEST_SKIP() << "a pair of interfaces needs `ip` and the kernel's veth";
  network_.add_multicast_route();
  const auto here = open();
  const auto there = open();
  ASSERT_TRUE(here && there);
  Node sender(*loop_, *here);
  Node listener(*loop_, *there);
  EXPECT_TRUE(sender.send(frame_));
  EXPECT_TRUE(run_until([&] { return !listener.heard.empty(); }));
  EXPECT_EQ(listener.heard, Heard{"185#1E2F"});
  EXPECT_EQ(sender.heard, Heard{});
  EXPECT_EQ(here->counters().sent, 1U);
}

TEST_F(UdpMulticastTest, AllKindsOfFramesArriveAsTheyWereAndInOrder) {
  network_.add_multicast_route();
  const auto here = open();
  const auto there = open();
  ASSERT_TRUE(here && there);
  Node listener(*loop_, *there);
  Frame small_extended = frame_;
  small_extended.flags = FrameFlags::extended;
  for (const Frame& frame :
       {frame_, small_extended, Frame::remote_frame(0x701, 8),
        Frame::data_frame(0x1FFFFFFF, {1, 2, 3, 4, 5, 6, 7, 8}), Frame::data_frame(0, {})}) {
    EXPECT_TRUE(here->send(frame));
  }
  EXPECT_TRUE(run_until([&] { return listener.heard.size() == 5; }));
  EXPECT_EQ(listener.heard,
            (Heard{"185#1E2F", "00000185#1E2F", "701#R8", "1FFFFFFF#0102030405060708", "000#"}));
}

TEST_F(UdpMulticastTest, ABurstOfAThousandFramesArrivesWhole) {
  network_.add_multicast_route();
  const auto here = open();
  const auto there = open();
  ASSERT_TRUE(here && there);
  Node listener(*loop_, *there);
  for (std::uint32_t i = 0; i < 1000; ++i) ASSERT_TRUE(here->send(Frame::data_frame(i, {})));
  EXPECT_TRUE(run_until([&] { return listener.heard.size() == 1000; }));
  EXPECT_EQ(there->counters().carrier.overrun, 0U);
}

TEST_F(UdpMulticastTest, WhatASocketCannotHoldIsCountedAsOverrun) {
  network_.add_multicast_route();
  const auto here = open();
  const auto there = open();
  ASSERT_TRUE(here && there);
  const MsgpackFrame encoded(frame_, 0);
  for (int i = 0; i < 20'000; ++i) send_datagram(encoded.bytes());
  std::uint64_t heard = 0;
  there->on_frame([&](const BusFrame&) { ++heard; });
  // The count of drops arrives with a later datagram.
  EXPECT_TRUE(run_until([&] {
    send_datagram(encoded.bytes());
    return there->counters().carrier.overrun > 0;
  }));
  EXPECT_GT(heard, 1000U);
  EXPECT_LT(heard, 20'000U);
}

TEST_F(UdpMulticastTest, AnotherGroupAndAnotherPortAreOtherBuses) {
  network_.add_multicast_route();
  const auto here = open("udp:239.74.163.2:43113");
  const auto other_group = open("udp:239.74.163.3:43113");
  const auto other_port = open("udp:239.74.163.2:43114");
  const auto same = open();
  ASSERT_TRUE(here && other_group && other_port && same);
  EXPECT_TRUE(here->send(frame_));
  EXPECT_TRUE(run_until([&] { return same->counters().received == 1; }));
  EXPECT_EQ(other_group->counters().received, 0U);
  EXPECT_EQ(other_port->counters().received, 0U);
}

// Another machine on the same network: a namespace at the other end of a pair of interfaces.
class UdpNeighbour : public UdpMulticastTest {
 protected:
  void SetUp() override {
    UdpMulticastTest::SetUp();
    if (IsSkipped()) return;
    if (!shell("ip link add here type veth peer name there")) {
      GTEST_SKIP() << "a pair of interfaces needs `ip` and the kernel's veth";
    }
    std::thread([this] { move_in(); }).join();
    EXPECT_TRUE(
        shell("ip addr add 10.74.163.1/24 dev here && ip link set here up && "
              "ip route add 239.0.0.0/8 dev here"));
    // Frames sent before the kernel has noticed a carrier at both ends are lost.
    EXPECT_TRUE(run_until([] { return shell("ip link show here | grep -q 'state UP'"); }));
    EXPECT_TRUE(run_until([this] {
      bool is_up = false;
      std::thread([&] {
        const bool is_inside = ::setns(there_.get(), CLONE_NEWNET) == 0;
        is_up = is_inside && shell("ip link show there | grep -q 'state UP'");
      }).join();
      return is_up;
    }));
  }

  /// Sends to the default group, from an address of the neighbour.
  void send_from(const char* address) {
    sockaddr_in source = OwnNetwork::address_of(address, 0);
    const Descriptor& socket = sockets_.at(next_++);
    ASSERT_EQ(::bind(socket.get(), reinterpret_cast<sockaddr*>(&source), sizeof source), 0);
    const sockaddr_in group = OwnNetwork::address_of("239.74.163.2", 43113);
    const MsgpackFrame datagram(reset_, 0);
    ASSERT_EQ(::sendto(socket.get(), datagram.bytes().data(), datagram.bytes().size(), 0,
                       reinterpret_cast<const sockaddr*>(&group), sizeof group),
              static_cast<ssize_t>(datagram.bytes().size()));
  }

  const Frame reset_ = Frame::data_frame(0x000, {0x81, 0x0A});

 private:
  static bool shell(const std::string& command) {
    return std::system((command + " 2> /dev/null").c_str()) == 0;  // NOLINT(cert-env33-c)
  }
  // A thread has a separate network, which exists as long as its sockets. The neighbour has the
  // address of this machine as well.
  void move_in() {
    const Descriptor here{::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC)};
    ASSERT_EQ(::unshare(CLONE_NEWNET), 0);
    there_ = Descriptor{::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC)};
    ASSERT_EQ(::setns(here.get(), CLONE_NEWNET), 0);
    ASSERT_TRUE(shell("ip link set there netns /proc/" + std::to_string(::getpid()) + "/fd/" +
                      std::to_string(there_.get())));
    ASSERT_EQ(::setns(there_.get(), CLONE_NEWNET), 0);
    ASSERT_TRUE(
        shell("ip link set lo up && ip addr add 10.74.163.1/32 dev lo && "
              "ip addr add 10.74.163.2/24 dev there && ip link set there up && "
              "ip route add 239.0.0.0/8 dev there"));
    for (Descriptor& socket : sockets_) {
      socket = Descriptor{::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
    }
  }

  Descriptor there_;  ///< its network
  std::array<Descriptor, 2> sockets_;
  std::size_t next_ = 0;
};

TEST_F(UdpNeighbour, CannotResetADeviceOfThisMachine) {
  const auto bus = open();
  ASSERT_TRUE(bus);
  Node device(*loop_, *bus);
  std::vector<std::string> troubles;
  bus->on_trouble([&](const Error& error) { troubles.push_back(error.line()); });
  send_from("10.74.163.2");
  EXPECT_TRUE(run_until([&] { return bus->counters().carrier.foreign == 1; }));
  send_from("10.74.163.1");  // with this machine's address as its source
  // A program of this machine, with the time to live of python-can, which is 1.
  send_datagram(MsgpackFrame(frame_, 0).bytes());
  EXPECT_TRUE(run_until([&] { return !device.heard.empty(); }));
  EXPECT_EQ(device.heard, Heard{"185#1E2F"});
  EXPECT_EQ(troubles, Heard{"udp:239.74.163.2:43113: frames from 10.74.163.2 are not taken; with "
                            "?ttl=1 the bus reaches beyond this machine"});
}

TEST_F(UdpNeighbour, IsHeardWhereTheAddressHasATimeToLive) {
  const auto bus = open("udp:?ttl=1");
  ASSERT_TRUE(bus);
  Node device(*loop_, *bus);
  send_from("10.74.163.2");
  EXPECT_TRUE(run_until([&] { return !device.heard.empty(); }));
  EXPECT_EQ(device.heard, Heard{"000#810A"});
  EXPECT_EQ(bus->counters().carrier.foreign, 0U);
}

TEST_F(UdpMulticastTest, MalformedDatagramsAreCountedAndTheNextFrameIsHeard) {
  network_.add_multicast_route();
  const auto bus = open();
  ASSERT_TRUE(bus);
  Node listener(*loop_, *bus);
  const MsgpackFrame encoded(frame_, 0);
  std::vector<std::uint8_t> too_long(encoded.bytes().begin(), encoded.bytes().end());
  send_datagram(std::span(too_long).first(too_long.size() - 1));
  send_datagram({});
  too_long.resize(2000);
  send_datagram(too_long);
  send_datagram(encoded.bytes());
  EXPECT_TRUE(run_until([&] { return !listener.heard.empty(); }));
  EXPECT_EQ(bus->counters().carrier.malformed, 3U);
  EXPECT_EQ(listener.heard, Heard{"185#1E2F"});
}

TEST_F(UdpMulticastTest, WithoutARouteTheBusIsRefusedWithWhatToDo) {
  const Result<std::unique_ptr<HostBus>> bus = open_bus(*loop_, "udp:");
  ASSERT_FALSE(bus);
  EXPECT_EQ(bus.error().line(),
            "udp:239.74.163.2:43113: no interface has a route for multicast; within this machine: "
            "`ip link "
            "set lo up multicast on && ip route add 239.0.0.0/8 dev lo`");
}

TEST_F(UdpMulticastTest, ARouteThatIsLostIsReportedOnceAndTheNodeTriesAgainWhenItIsBack) {
  network_.add_multicast_route();
  const auto bus = open();
  ASSERT_TRUE(bus);
  Node charger(*loop_, *bus);
  std::vector<std::string> troubles;
  bus->on_trouble([&](const Error& error) { troubles.push_back(error.what); });
  network_.delete_multicast_route();
  EXPECT_FALSE(charger.send(frame_));
  EXPECT_FALSE(charger.send(frame_));
  EXPECT_TRUE(run_until([&] { return charger.ready > 0; }));
  EXPECT_EQ(troubles, Heard{"no interface has a route for multicast"});
  EXPECT_EQ(bus->counters().refused, 2U);
  network_.add_multicast_route();
  EXPECT_TRUE(charger.send(frame_));
  EXPECT_TRUE(run_until([&] { return bus->counters().sent == 1; }));
}

TEST_F(UdpMulticastTest, APortThatBelongsToAnotherProgramIsRefusedWithWhatToDo) {
  network_.add_multicast_route();
  const sockaddr_in taken = OwnNetwork::address_of("239.74.163.2", 43113);
  ASSERT_EQ(::bind(network_.socket(), reinterpret_cast<const sockaddr*>(&taken), sizeof taken), 0);
  const Result<std::unique_ptr<HostBus>> bus = open_bus(*loop_, "udp:");
  ASSERT_FALSE(bus);
  EXPECT_EQ(bus.error().line(),
            "udp:239.74.163.2:43113: another program has the port for itself; choose another port");
}

}  // namespace
}  // namespace canvoy::host::udp_multicast_test
