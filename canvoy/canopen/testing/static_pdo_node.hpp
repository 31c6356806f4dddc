// A device with PDOs, SYNC and emergency fixed by its maker, and a variant in which masters can
// write all of that, for tests that both behave alike on the bus.
//
//     StaticPdoNode<static_pdo_layout> node;
//     node.operate();
//     node.receive("205#34 12 FF 78 56");
//     node.expect({...});
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

namespace testing_detail {

constexpr ObjectRow object_of(std::uint16_t index, std::uint16_t entries) {
  return {.index = index, .entry_count = entries};
}
constexpr EntryRow number_at(std::uint8_t sub, DataType type, Access access,
                             std::int64_t initial = 0) {
  return {.sub_first = sub, .sub_last = sub, .type = type, .access = access, .initial = initial};
}
constexpr EntryRow plus_node_id(EntryRow row) {
  row.traits = row.traits | EntryTraits::plus_node_id;
  return row;
}
constexpr EntryRow limited(EntryRow row, std::int64_t low, std::int64_t high) {
  row.traits = row.traits | EntryTraits::limited;
  row.low = low;
  row.high = high;
  return row;
}

}  // namespace testing_detail

/// Three RPDOs: at once with a deadline of 100 ms and a gap of 8 bits, at SYNC, three bits. Five
/// TPDOs: at events (10 ms apart, all 50 ms at least), at each second SYNC from the third on, at
/// the SYNC after an event, on request (253 and 252). SYNC has a counter and a window of 5 ms.
template <Access access>
constexpr auto lay_out_pdos() {
  using namespace testing_detail;
  using enum DataType;
  constexpr Access value = Access::rw | Access::rpdo | Access::tpdo;
  return partial(lay_out(
      std::to_array<ObjectRow>(
          {object_of(0x1001, 1), object_of(0x1005, 1), object_of(0x1007, 1), object_of(0x1014, 1),
           object_of(0x1015, 1), object_of(0x1019, 1), object_of(0x1400, 4), object_of(0x1401, 3),
           object_of(0x1402, 3), object_of(0x1600, 4), object_of(0x1601, 2), object_of(0x1602, 4),
           object_of(0x1800, 5), object_of(0x1801, 4), object_of(0x1802, 3), object_of(0x1803, 3),
           object_of(0x1804, 3), object_of(0x1A00, 2), object_of(0x1A01, 2), object_of(0x1A02, 2),
           object_of(0x1A03, 2), object_of(0x1A04, 3), object_of(0x2000, 2), object_of(0x2001, 2),
           object_of(0x2002, 1), object_of(0x2003, 2)}),
      std::to_array<EntryRow>({
          {.type = unsigned8},
          number_at(0, unsigned32, access, 0x80),
          number_at(0, unsigned32, access, 5000),
          plus_node_id(number_at(0, unsigned32, access, 0x80)),
          number_at(0, unsigned16, access, 0),
          number_at(0, unsigned8, access, 10),
          // 1400h to 1402h
          {.access = Access::const_, .initial = 5},
          plus_node_id(number_at(1, unsigned32, access, 0x200)),
          number_at(2, unsigned8, access, 255),
          number_at(5, unsigned16, access, 100),
          {.access = Access::const_, .initial = 2},
          plus_node_id(number_at(1, unsigned32, access, 0x300)),
          number_at(2, unsigned8, access, 1),
          {.access = Access::const_, .initial = 2},
          plus_node_id(number_at(1, unsigned32, access, 0x400)),
          number_at(2, unsigned8, access, 254),
          // 1600h to 1602h
          number_at(0, unsigned8, access, 3),
          number_at(1, unsigned32, access, 0x2001'01'10),
          number_at(2, unsigned32, access, 0x0005'00'08),
          number_at(3, unsigned32, access, 0x2001'02'10),
          number_at(0, unsigned8, access, 1),
          number_at(1, unsigned32, access, 0x2002'00'08),
          number_at(0, unsigned8, access, 3),
          number_at(1, unsigned32, access, 0x2003'01'01),
          number_at(2, unsigned32, access, 0x2003'02'01),
          number_at(3, unsigned32, access, 0x2003'03'01),
          // 1800h to 1804h
          {.access = Access::const_, .initial = 5},
          plus_node_id(number_at(1, unsigned32, access, 0x180)),
          number_at(2, unsigned8, access, 255),
          number_at(3, unsigned16, access, 100),
          number_at(5, unsigned16, access, 50),
          {.access = Access::const_, .initial = 6},
          plus_node_id(number_at(1, unsigned32, access, 0x280)),
          number_at(2, unsigned8, access, 2),
          number_at(6, unsigned8, access, 3),
          {.access = Access::const_, .initial = 2},
          plus_node_id(number_at(1, unsigned32, access, 0x4000'0380)),
          number_at(2, unsigned8, access, 0),
          {.access = Access::const_, .initial = 2},
          plus_node_id(number_at(1, unsigned32, access, 0x480)),
          number_at(2, unsigned8, access, 253),
          {.access = Access::const_, .initial = 2},
          number_at(1, unsigned32, access, 0x1F0),
          number_at(2, unsigned8, access, 252),
          // 1A00h to 1A04h
          number_at(0, unsigned8, access, 1),
          number_at(1, unsigned32, access, 0x2000'01'10),
          number_at(0, unsigned8, access, 1),
          number_at(1, unsigned32, access, 0x2000'02'10),
          number_at(0, unsigned8, access, 1),
          number_at(1, unsigned32, access, 0x2000'03'10),
          number_at(0, unsigned8, access, 1),
          number_at(1, unsigned32, access, 0x2000'04'10),
          number_at(0, unsigned8, access, 2),
          number_at(1, unsigned32, access, 0x2003'01'01),
          number_at(2, unsigned32, access, 0x2000'05'10),
          // 2000h to 2003h
          {.access = Access::const_, .initial = 5},
          {.sub_first = 1, .sub_last = 5, .type = unsigned16, .access = value},
          {.access = Access::const_, .initial = 2},
          {.sub_first = 1, .sub_last = 2, .type = unsigned16, .access = value},
          limited(number_at(0, unsigned8, value, 15), 10, 20),
          {.access = Access::const_, .initial = 3},
          {.sub_first = 1, .sub_last = 3, .type = boolean, .access = value},
      })));
}

inline constexpr auto static_pdo_layout = lay_out_pdos<Access::const_>();
inline constexpr auto writable_pdo_layout = lay_out_pdos<Access::rw>();

/// Node 5; the test is its bus.
template <const auto& layout>
class StaticPdoNode {
 public:
  StaticPdoNode() {
    device.node().start(now);
    sent.clear();
  }

  void operate() { receive("000#01 00"); }
  void receive(std::string_view frame) { receive(wire_frame(frame)); }
  void receive(const Frame& frame) {
    device.node().receive(frame, now);
    settle();
  }
  /// Sets a value like the application.
  void set(std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
    device.node().advance(now);
    ASSERT_TRUE(device.dictionary().set_number(index, sub, number));
    settle();
  }
  std::uint64_t number(std::uint16_t index, std::uint8_t sub) {
    return device.dictionary().number(index, sub);
  }
  void run_for(Duration duration) {
    const Time until = now + duration;
    while (device.node().deadline() <= until) {
      now = std::max(now, device.node().deadline());
      settle();
    }
    now = until;
  }
  void make_room() {
    full = false;
    device.node().tx_ready(now);
    settle();
  }
  /// "@time frame" of all frames sent since the last call.
  std::vector<std::string> take_sent() { return std::exchange(sent, {}); }
  /// Compares the frames sent since the last call, without times.
  void expect(std::vector<std::string> frames) {
    for (std::string& frame : sent) frame.erase(0, frame.find(' ') + 1);
    EXPECT_EQ(take_sent(), frames);
  }

  Time now{};
  bool full = false;
  std::vector<std::string> sent;
  DeviceNode<layout> device{{this, &StaticPdoNode::take, nullptr}, 5};

 private:
  static bool take(void* context, const Frame& frame) {
    StaticPdoNode& self = *static_cast<StaticPdoNode*>(context);
    if (self.full) return false;
    self.sent.push_back("@" + std::to_string(self.now.time_since_epoch().count()) + " " +
                        wire_text(frame));
    return true;
  }
  void settle() {
    for (int i = 0; device.node().deadline() <= now; ++i) {
      ASSERT_LT(i, 10'000) << "the node wants to be called again and again";
      device.node().advance(now);
    }
  }
};

}  // namespace canvoy
