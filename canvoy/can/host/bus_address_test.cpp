#include "canvoy/can/host/bus_address.hpp"

#include <gtest/gtest.h>

namespace canvoy::host::bus_address_test {
namespace {

TEST(BusAddress, ABareNameIsAnInterfaceOfSocketCan) {
  const Result<BusAddress> address = parse_bus_address("vcan0");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->kind, BusType::socketcan);
  EXPECT_EQ(address->interface, "vcan0");
  EXPECT_TRUE(parse_bus_address("slcan-left_12.3"));
}

TEST(BusAddress, SimIsTheSimulatedBus) {
  const Result<BusAddress> address = parse_bus_address("sim");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->kind, BusType::simulated);
}

TEST(BusAddress, UdpNamesGroupAndPort) {
  const Result<BusAddress> address = parse_bus_address("udp:224.1.2.255:5000");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->kind, BusType::udp_multicast);
  EXPECT_EQ(address->udp, (UdpGroup{{224, 1, 2, 255}, 5000, 0}));
}

TEST(BusAddress, WhatUdpLeavesOutIsAsInPythonCanButStaysOnThisMachine) {
  EXPECT_EQ(parse_bus_address("udp:")->udp, (UdpGroup{{239, 74, 163, 2}, 43113, 0}));
  EXPECT_EQ(parse_bus_address("udp:239.1.1.1")->udp, (UdpGroup{{239, 1, 1, 1}, 43113, 0}));
  EXPECT_EQ(parse_bus_address("udp:?ttl=1")->udp, (UdpGroup{{239, 74, 163, 2}, 43113, 1}));
}

TEST(BusAddress, TcpNamesASocketcandAndItsBus) {
  const Result<BusAddress> address = parse_bus_address("tcp:bench-2.local:28600/can1");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->kind, BusType::socketcand);
  EXPECT_EQ(address->tcp, (TcpServer{"bench-2.local", 28600}));
  EXPECT_EQ(address->interface, "can1");
  EXPECT_EQ(parse_bus_address("tcp:10.0.0.7/can0")->tcp, (TcpServer{"10.0.0.7", 29536}));
  EXPECT_EQ(parse_bus_address("tcp:[fe80::1]:28600/can0")->tcp, (TcpServer{"fe80::1", 28600}));
  EXPECT_EQ(parse_bus_address("tcp:[::1]/can0")->tcp, (TcpServer{"::1", 29536}));
}

TEST(BusAddress, IsWrittenInFull) {
  EXPECT_EQ(to_string(*parse_bus_address("tcp:10.0.0.7/can0")), "tcp:10.0.0.7:29536/can0");
  EXPECT_EQ(to_string(*parse_bus_address("tcp:[::1]/can0")), "tcp:[::1]:29536/can0");
  EXPECT_EQ(to_string(*parse_bus_address("can0")), "can0");
  EXPECT_EQ(to_string(*parse_bus_address("sim")), "sim");
  EXPECT_EQ(to_string(*parse_bus_address("udp:")), "udp:239.74.163.2:43113");
  EXPECT_EQ(to_string(*parse_bus_address("udp:239.1.1.1?ttl=3")), "udp:239.1.1.1:43113?ttl=3");
}

class BusAddressRefuses : public testing::TestWithParam<const char*> {};

TEST_P(BusAddressRefuses, InOneLineThatQuotesItAndShowsTheForms) {
  const Result<BusAddress> address = parse_bus_address(GetParam());
  ASSERT_FALSE(address);
  EXPECT_EQ(address.error().where, std::string("bus \"") + GetParam() + "\"");
  EXPECT_FALSE(address.error().what.empty());
  EXPECT_EQ(address.error().remedy,
            "a bus is written can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0 or sim");
}

INSTANTIATE_TEST_SUITE_P(
    Texts, BusAddressRefuses,
    testing::Values("", "any", "..", "can 0", "can/0", "can0\n", "sixteencharacter",
                    "tcp:1.2.3.4:5", "sim:", "can0:", "udp:239.74.163:43113", "udp:239.74.163.2.1",
                    "udp:239.74.163.256", "udp:239.74.-1.2", "udp:192.168.0.1:43113",
                    "udp:240.0.0.1", "udp:239.74.163.2:", "udp:239.74.163.2:0",
                    "udp:239.74.163.2:65536", "udp:239.74.163.2:43113:1", "udp:239.74.163.2:+1",
                    "udp::43113", "udp:?ttl=256", "udp:?ttl=", "udp:?hops=1", "udp:239.74.163.2?",
                    "udp:ff15::1", "tcp:", "tcp:/can0", "tcp:host", "tcp:host/", "tcp:host:0/can0",
                    "tcp:host:65536/can0", "tcp:host:1:2/can0", "tcp:[::1/can0", "tcp:[::1]1/can0",
                    "tcp:[]/can0", "tcp:ho st/can0", "tcp:host/can/0", "tcp:host/sixteencharacter",
                    "tcp:host/can0 >"));

}  // namespace
}  // namespace canvoy::host::bus_address_test
