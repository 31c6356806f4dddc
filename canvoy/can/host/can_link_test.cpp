// Messages to and from rtnetlink. Those that set something are the messages of `ip` of iproute2
// 6.1, as recorded on their way to the kernel for an interface with the index 1.
#include "canvoy/can/host/can_link.hpp"

#include <gtest/gtest.h>

namespace canvoy::host::can_link_test {
namespace {

// ip link set lo down, ip link set lo up
const LinkMessage ip_down = {0x20, 0x00, 0x00, 0x00, 0x10, 0x00, 0x05, 0x00, 0x95, 0xE9, 0x01,
                             0x6B, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00,
                             0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00};

// ip link set lo type can bitrate 125000 listen-only on berr-reporting on
const LinkMessage ip_listen = {
    0x60, 0x00, 0x00, 0x00, 0x10, 0x00, 0x05, 0x00, 0x95, 0xE9, 0x01, 0x6B, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x40, 0x00, 0x12, 0x00, 0x07, 0x00, 0x01, 0x00, 0x63, 0x61, 0x6E, 0x00, 0x34, 0x00, 0x02, 0x00,
    0x24, 0x00, 0x01, 0x00, 0x48, 0xE8, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x0C, 0x00, 0x05, 0x00, 0x12, 0x00, 0x00, 0x00, 0x12, 0x00, 0x00, 0x00};

constexpr std::uint32_t ip_sequence = 0x6B01'E995;

TEST(CanLinkMessage, takesAnInterfaceDownAndUpAsIpDoes) {
  EXPECT_EQ(up_message(1, false, ip_sequence), ip_down);
  LinkMessage ip_up = ip_down;
  ip_up[24] = 0x01;
  EXPECT_EQ(up_message(1, true, ip_sequence), ip_up);
}

TEST(CanLinkMessage, setsBitRateAndListenOnlyModeAsIpDoes) {
  EXPECT_EQ(bit_rate_message(1, 125'000, true, ip_sequence), ip_listen);
  LinkMessage ip_active = ip_listen;
  ip_active[92] = 0x00;  // neither, as with listen-only off berr-reporting off
  EXPECT_EQ(bit_rate_message(1, 125'000, false, ip_sequence), ip_active);
}

TEST(CanLinkMessage, leavesTheReportingOfErrorsAloneForAControllerThatHasNone) {
  LinkMessage ip_silent = ip_listen;
  ip_silent[88] = 0x02;  // it is not even named
  ip_silent[92] = 0x02;
  EXPECT_EQ(bit_rate_message(1, 125'000, true, ip_sequence, false), ip_silent);
  ip_silent[92] = 0x00;
  EXPECT_EQ(bit_rate_message(1, 125'000, false, ip_sequence, false), ip_silent);
}

/// Answer of the kernel for a controller in this state, by linux/can/netlink.h.
LinkMessage kernel_answer(std::uint8_t state) {
  LinkMessage answer = ip_listen;
  answer[24] = 0x01;  // IFF_UP
  const LinkMessage can_state = {0x08, 0x00, 0x04, 0x00, state, 0x00, 0x00, 0x00};
  answer.insert(answer.end(), can_state.begin(), can_state.end());
  answer[0] += 8;  // the message, IFLA_LINKINFO and IFLA_INFO_DATA are longer by that
  answer[32] += 8;
  answer[44] += 8;
  return answer;
}

TEST(CanLinkMessage, tellsStateBitRateAndMode) {
  const BusState states[] = {BusState::error_active, BusState::error_warning,
                             BusState::error_passive, BusState::bus_off};
  for (std::uint8_t state = 0; state < 4; ++state) {
    const std::optional<CanLink> link = parse_link_message(kernel_answer(state));
    ASSERT_TRUE(link);
    EXPECT_TRUE(link->has_controller);
    EXPECT_TRUE(link->is_up);
    EXPECT_TRUE(link->listens_only);
    EXPECT_EQ(link->bit_rate, 125'000U);
    EXPECT_EQ(link->state, states[state]);
  }
  EXPECT_EQ(parse_link_message(kernel_answer(4))->state, std::nullopt) << "stopped";
}

TEST(CanLinkMessage, tellsAControllerFromAVirtualInterface) {
  LinkMessage answer = kernel_answer(0);
  answer[38] = 0x78;
  EXPECT_FALSE(parse_link_message(answer)->has_controller);
}

TEST(CanLinkMessage, hasNoBitRateWhereTheInterfaceHasNone) {
  const std::optional<CanLink> link = parse_link_message(ip_down);
  ASSERT_TRUE(link);
  EXPECT_FALSE(link->has_controller);
  EXPECT_FALSE(link->is_up);
  EXPECT_EQ(link->bit_rate, 0U);
  EXPECT_EQ(link->state, std::nullopt);
}

TEST(CanLinkMessage, isReadWholeOrNotAtAllHoweverItIsCutOffOrChanged) {
  const LinkMessage good = kernel_answer(2);
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_FALSE(parse_link_message(std::span(good).first(length))) << length;
  }
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    LinkMessage changed = good;
    changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ 1U << bit % 8);
    parse_link_message(changed);  // checked by the sanitizers
  }
}

TEST(CanLink, isReadFromTheKernel) {
  const Result<CanLink> loopback = read_can_link("lo");
  ASSERT_TRUE(loopback) << loopback.error().line();
  EXPECT_EQ(loopback->bit_rate, 0U);
  EXPECT_EQ(loopback->state, std::nullopt);
  EXPECT_FALSE(loopback->has_controller);
  EXPECT_FALSE(restart_can_link("lo", 125'000, true));
  const Result<CanLink> after = read_can_link("lo");
  ASSERT_TRUE(after);
  EXPECT_EQ(after->is_up, loopback->is_up) << "it was not touched";
  EXPECT_FALSE(restore_can_link("lo", *loopback));
  EXPECT_EQ(read_can_link("lo")->is_up, loopback->is_up) << "it was not touched";
  EXPECT_FALSE(restore_can_link("no-such-can0", *loopback));
  EXPECT_FALSE(read_can_link("no-such-can0"));
  EXPECT_FALSE(restart_can_link("no-such-can0", 125'000, true));
}

}  // namespace
}  // namespace canvoy::host::can_link_test
