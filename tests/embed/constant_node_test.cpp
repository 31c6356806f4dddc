// A device of a small machine that is constant-initialised does what one does that was constructed.
// That no constructor runs is for the compiler to say: it refuses a constinit that is none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {
namespace {

constexpr ObjectRow variable(std::uint16_t index) {
  return {.index = index, .entry_count = 1};
}

constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({variable(0x1000),
                              variable(0x1001),
                              variable(0x1005),
                              variable(0x1014),
                              variable(0x1017),
                              {.index = 0x1018, .entry_count = 2},
                              {.index = 0x1800, .entry_count = 3},
                              {.index = 0x1A00, .entry_count = 2},
                              variable(0x6000)}),
    std::to_array<EntryRow>(
        {{.type = DataType::unsigned32, .initial = 0x191},
         {.type = DataType::unsigned8},
         {.type = DataType::unsigned32, .access = Access::rw, .initial = 0x80},
         {.type = DataType::unsigned32,
          .access = Access::rw,
          .traits = EntryTraits::plus_node_id,
          .initial = 0x80},
         {.type = DataType::unsigned16, .access = Access::rw, .initial = 100},
         {.initial = 1},
         {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 1},
         {.access = Access::const_, .initial = 2},
         {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x185},
         {.sub_first = 2, .sub_last = 2, .initial = 255},
         {.access = Access::rw, .initial = 1},
         {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x6000'0008},
         {.access = Access::rw | Access::tpdo}}));

std::vector<std::string> frames_sent;
std::vector<std::uint16_t> wanted_ids;

bool send(void*, const Frame& frame) {
  frames_sent.push_back(wire_text(frame));
  return true;
}
void accept(void*, std::uint16_t can_id, bool is_wanted) {
  if (is_wanted) wanted_ids.push_back(can_id);
}
std::vector<std::string> take_sent() {
  return std::exchange(frames_sent, {});
}

struct Small {
  using Device = DeviceServices<layout, LssSlave::routes, false>;

  constexpr explicit Small(Device::Memory& memory)
      : device(memory, {nullptr, send, accept}, 5), lss(device.node()) {}

  Device device;
  LssSlave lss;
};

constinit Small::Device::Memory the_memory{};
constinit Small the_small(the_memory);

TEST(ConstantNode, BootsAnswersAndSendsAsOneThatWasConstructed) {
  Node& node = the_small.device.node();
  node.start(Time{});
  EXPECT_EQ(take_sent(), std::vector<std::string>({"705#00"}));
  // NMT, SYNC, remote frames that ask for the TPDO, LSS, SDO.
  EXPECT_THAT(wanted_ids, testing::UnorderedElementsAre(0x000, 0x080, 0x185, 0x7E5, 0x605));

  node.receive(wire_frame("605#40 14 10 00 00 00 00 00"), Time{});
  EXPECT_EQ(take_sent(), std::vector<std::string>({"585#43 14 10 00 85 00 00 00"}));

  node.advance(Time(100ms));
  EXPECT_EQ(take_sent(), std::vector<std::string>({"705#7F"}));

  node.receive(wire_frame("000#01 05"), Time(100ms));
  EXPECT_EQ(take_sent(), std::vector<std::string>({"185#00"}));

  node.raise({.code = 0x4210, .register_bits = error_register::temperature});
  EXPECT_EQ(take_sent(), std::vector<std::string>({"085#10 42 09 00 00 00 00 00"}));

  node.receive(wire_frame("7E5#04 01 00 00 00 00 00 00"), Time(100ms));
  EXPECT_EQ(the_small.lss.state(), LssState::configuration);
}

TEST(ConstantNode, HasNothingInItsMemoryThatIsNotZero) {
  Small::Device::Memory memory{};
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(&memory);
  for (std::size_t i = 0; i < sizeof memory; ++i) ASSERT_EQ(bytes[i], 0) << "at byte " << i;
}

}  // namespace
}  // namespace canvoy
