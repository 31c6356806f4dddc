#include "canvoy/canopen/emergency/collision_watch.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/device/heap_node.hpp"
#include "canvoy/canopen/testing/cable.hpp"

namespace canvoy::collision_watch_test {
namespace {

constexpr ObjectRow object(std::uint16_t index, std::uint16_t entries = 1) {
  return {.index = index, .entry_count = entries};
}
constexpr EntryRow entry(std::uint8_t sub, std::int64_t initial,
                         DataType type = DataType::unsigned32) {
  return {
      .sub_first = sub, .sub_last = sub, .type = type, .access = Access::rw, .initial = initial};
}

// Emergencies have 085h, TPDO 3 has 1A7h, and TPDO 4 is off. RPDO 1 receives 205h.
constexpr auto layout =
    partial(lay_out(std::to_array<ObjectRow>({object(0x1000), object(0x1001), object(0x1014),
                                              object(0x1400, 2), object(0x1600), object(0x1802, 2),
                                              object(0x1803, 2), object(0x1A02), object(0x1A03)}),
                    std::to_array<EntryRow>(
                        {entry(0, 0), entry(0, 0, DataType::unsigned8), entry(0, 0x85),
                         entry(0, 2, DataType::unsigned8), entry(1, 0x205),
                         entry(0, 0, DataType::unsigned8), entry(0, 2, DataType::unsigned8),
                         entry(1, 0x1A7), entry(0, 2, DataType::unsigned8), entry(1, 0x8000'0285),
                         entry(0, 0, DataType::unsigned8), entry(0, 0, DataType::unsigned8)})));

/// In memory laid out at compile time, and in memory from the heap.
struct StaticNode : DeviceNode<layout> {
  explicit StaticNode(const Port& port) : DeviceNode(port, 5) {}
};
struct NodeOnHeap : HeapNode {
  explicit NodeOnHeap(const Port& port) : HeapNode(layout.tables(), port, 5) {}
};

/// Node 5, in pre-operational.
template <class DeviceType>
struct Collision : testing::Test {
  Collision() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.clear();
  }
  /// The emergency that a frame brought about, or nothing.
  std::string told_of(std::string_view frame) {
    cable.clear();
    cable.send(frame);
    return cable.last(0x085);
  }

  Cable cable;
  DeviceType device{cable.port(0)};
};
using Devices = testing::Types<StaticNode, NodeOnHeap>;
TYPED_TEST_SUITE(Collision, Devices);

/// CiA 301, emergency error codes: 8150h; 11h in 1001h are generic and communication.
TYPED_TEST(Collision, AForeignFrameWithACanIdOfTheNodeIsTold) {
  EXPECT_EQ(this->told_of("705#05"), "085#50 81 11 05 07 00 00 00");
  this->cable.run_for(4s);
  EXPECT_EQ(this->cable.last(0x085), "085#00 00 00 00 00 00 00 00");
  EXPECT_EQ(this->told_of("585#60 00 00 00 00 00 00 00"), "085#50 81 11 85 05 00 00 00");
  this->cable.run_for(4s);
  EXPECT_EQ(this->told_of("1A7#00"), "085#50 81 11 A7 01 00 00 00");
  this->cable.run_for(4s);
  EXPECT_EQ(this->told_of("085#00 00 00 00 00 00 00 00").substr(0, 21), "085#50 81 11 85 00 00");
}

TYPED_TEST(Collision, OfOthersAndOfWhatTheNodeReceivesNothingIsTold) {
  for (const char* const frame : {"706#05", "586#60 00 00 00 00 00 00 00",
                                  "605#40 00 10 00 00 00 00 00", "086#00 00 00 00 00 00 00 00",
                                  "000#01 05", "080#", "185#00", "285#00", "705#R1", "1A7#R"}) {
    EXPECT_EQ(this->told_of(frame).substr(0, 9) == "085#50 81", false) << frame;
  }
}

TYPED_TEST(Collision, ATpdoIsWatchedWhileItIsValid) {
  EXPECT_EQ(this->told_of("285#00"), "");
  this->cable.send("605#23 03 18 01 85 02 00 00");
  EXPECT_EQ(this->told_of("285#00"), "085#50 81 11 85 02 00 00 00");
  this->cable.run_for(4s);
  this->cable.send("605#23 03 18 01 85 02 00 80");
  EXPECT_EQ(this->told_of("285#00"), "");
  this->cable.send("605#23 03 18 01 85 02 00 00");
  this->cable.send("000#82 05");  // its configured COB-IDs are discarded
  EXPECT_EQ(this->told_of("285#00"), "");
}

/// 1014h: the emergencies get 086h, and 085h is another node's from now on.
TYPED_TEST(Collision, EmergenciesAreWatchedByTheirCobId) {
  this->cable.send("605#23 14 10 00 85 00 00 80");  // a new CAN-ID only while it is invalid
  this->cable.send("605#23 14 10 00 86 00 00 00");
  this->told_of("085#00 00 00 00 00 00 00 00");
  EXPECT_EQ(this->cable.last(0x086), "");
  this->told_of("086#00 00 00 00 00 00 00 00");
  EXPECT_EQ(this->cable.last(0x086).substr(0, 21), "086#50 81 11 86 00 00");
}

/// Shared on purpose: what the node sends, others send to it as well.
TYPED_TEST(Collision, ACanIdThatAnRpdoReceivesIsNone) {
  this->cable.send("605#23 03 18 01 05 02 00 00");
  EXPECT_EQ(this->told_of("205#00").substr(0, 9) == "085#50 81", false);
}

/// It is so by the COB-IDs as they are at present, whichever of the two was written last.
TYPED_TEST(Collision, ACanIdIsSharedWhileAnRpdoReceivesIt) {
  this->cable.send("605#23 03 18 01 05 02 00 00");
  this->cable.send("605#23 00 14 01 05 02 00 80");  // RPDO 1 is off
  EXPECT_EQ(this->told_of("205#00"), "085#50 81 11 05 02 00 00 00");
  this->cable.run_for(4s);
  this->cable.send("605#23 00 14 01 A7 01 00 00");  // it receives what TPDO 3 is sent with
  EXPECT_EQ(this->told_of("1A7#00").substr(0, 9) == "085#50 81", false);
  EXPECT_EQ(this->told_of("205#00"), "085#50 81 11 05 02 00 00 00");
  this->cable.run_for(4s);
  this->cable.send("000#82 05");  // RPDO 1 receives 205h again, and TPDO 4 is off
  EXPECT_EQ(this->told_of("205#00").substr(0, 9) == "085#50 81", false);
  EXPECT_EQ(this->told_of("1A7#00"), "085#50 81 11 A7 01 00 00 00");
}

TYPED_TEST(Collision, ItIsToldOnceUntilItHasBeenQuietForThreeSeconds) {
  this->told_of("705#05");
  for (int i = 0; i < 5; ++i) {
    this->cable.run_for(2999ms);
    EXPECT_EQ(this->told_of("705#05"), "");
  }
  this->cable.run_for(2999ms);
  EXPECT_EQ(this->cable.count(0x085), 0u);
  this->cable.run_for(1ms);
  EXPECT_EQ(this->cable.last(0x085).substr(0, 9), "085#00 00");
  EXPECT_EQ(this->told_of("705#05").substr(0, 9), "085#50 81");
}

/// Until it is over, whichever CAN-ID it is.
TYPED_TEST(Collision, ASecondCanIdIsNotToldWhileTheFirstIs) {
  EXPECT_EQ(this->told_of("705#05"), "085#50 81 11 05 07 00 00 00");
  EXPECT_EQ(this->told_of("585#60 00 00 00 00 00 00 00"), "");
  this->cable.clear();
  this->cable.run_for(3s);
  EXPECT_EQ(this->cable.last(0x085), "085#00 00 00 00 00 00 00 00");
  EXPECT_EQ(this->cable.count(0x085), 1u);
}

/// With the node-ID, SDO answers and heartbeats change: those of node 5 are another's.
TYPED_TEST(Collision, OfTheNodeIdThatItHadNothingIsTold) {
  this->device.node().set_pending_id(6);
  this->cable.send("000#82 05");
  ASSERT_EQ(this->device.node().id(), 6);
  EXPECT_EQ(this->told_of("585#60 00 00 00 00 00 00 00"), "");
  EXPECT_EQ(this->told_of("705#05"), "");
  EXPECT_EQ(this->told_of("706#05"), "085#50 81 11 06 07 00 00 00");
}

TYPED_TEST(Collision, ItIsWatchedHoweverOftenCobIdsAreWritten) {
  for (int i = 0; i < 100; ++i) this->cable.send("605#23 02 18 01 A7 01 00 80");
  this->cable.send("605#23 02 18 01 A7 01 00 00");
  EXPECT_EQ(this->told_of("1A7#00"), "085#50 81 11 A7 01 00 00 00");
}

/// Both nodes of one node-ID report it, and go on doing so while both are there.
TYPED_TEST(Collision, TwoNodesOfOneNodeIdBothReportIt) {
  TypeParam second{this->cable.port(1)};
  this->cable.connect(1, second.node());
  second.node().start(this->cable.now);
  this->cable.run_for(1s);
  EXPECT_EQ(this->device.node().dictionary().number(0x1001, 0), 0x11u);
  EXPECT_EQ(second.node().dictionary().number(0x1001, 0), 0x11u);
}

}  // namespace
}  // namespace canvoy::collision_watch_test
