#include "canvoy/devices/cia852/collision_watch.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia852/kinds.hpp"

namespace canvoy::cia852::collision_watch_test {
namespace {

/// Node 5 of the catalogue, in pre-operational.
struct Collision : testing::Test {
  Collision() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.clear();
  }
  /// The emergency that a frame brought about, or nothing.
  std::string reported_of(std::string_view frame) {
    cable.clear();
    cable.send(frame);
    return cable.last(0x085);
  }

  Cable cable;
  Environment environment;
  CatalogueDevice device{operator_kind, cable.port(0), NodeId{5}, environment};
};

/// Table 37 and CiA 301: 8150h; 11h in 1001h are generic and communication.
TEST_F(Collision, AForeignFrameWithACobIdOfTheNodeIsTold) {
  EXPECT_EQ(reported_of("705#05"), "085#50 81 11 05 07 00 00 00");
  cable.run_for(2s);
  EXPECT_EQ(cable.last(0x085), "085#00 00 00 00 00 00 00 00");
  EXPECT_EQ(reported_of("585#60 00 00 00 00 00 00 00"), "085#50 81 11 85 05 00 00 00");
  cable.run_for(2s);
  EXPECT_EQ(reported_of("085#00 00 00 00 00 00 00 00").substr(0, 9), "085#50 81");
}

TEST_F(Collision, OfOthersAndOfWhatTheNodeReceivesNothingIsTold) {
  for (const char* const frame :
       {"706#05", "586#60 00 00 00 00 00 00 00", "605#40 00 10 00 00 00 00 00",
        "086#00 00 00 00 00 00 00 00", "000#01 05", "080#", "185#00"}) {
    EXPECT_EQ(reported_of(frame).substr(0, 9) == "085#50 81", false) << frame;
  }
}

TEST_F(Collision, ATpdoIsWatchedWhileItIsValid) {
  EXPECT_EQ(reported_of("1A7#00"), "");
  cable.send("605#23 00 18 01 A7 01 00 00");
  EXPECT_EQ(reported_of("1A7#00"), "085#50 81 11 A7 01 00 00 00");
  cable.run_for(2s);
  cable.send("605#23 00 18 01 A7 01 00 80");
  EXPECT_EQ(reported_of("1A7#00"), "");
  cable.send("605#23 00 18 01 A7 01 00 00");
  cable.send("000#82 05");  // its configured COB-IDs are discarded
  EXPECT_EQ(reported_of("1A7#00"), "");
}

TEST_F(Collision, ItIsToldOnceUntilItHasBeenQuietForASecond) {
  reported_of("705#05");
  for (int i = 0; i < 5; ++i) {
    cable.run_for(999ms);
    EXPECT_EQ(reported_of("705#05"), "");
  }
  cable.run_for(999ms);
  EXPECT_EQ(cable.count(0x085), 0u);
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x085).substr(0, 9), "085#00 00");
  EXPECT_EQ(reported_of("705#05").substr(0, 9), "085#50 81");
}

/// Until it is over, whichever COB-ID it is.
TEST_F(Collision, ASecondCobIdIsNotToldWhileTheFirstIs) {
  EXPECT_EQ(reported_of("705#05"), "085#50 81 11 05 07 00 00 00");
  EXPECT_EQ(reported_of("585#60 00 00 00 00 00 00 00"), "");
  cable.clear();
  cable.run_for(1s);
  EXPECT_EQ(cable.last(0x085), "085#00 00 00 00 00 00 00 00");
  EXPECT_EQ(cable.count(0x085), 1u);
}

/// With the node-ID, the COB-IDs change: none of node 5 belongs to it any more.
TEST_F(Collision, OfTheNodeIdThatItHadNothingIsTold) {
  device.node().set_pending_id(6);
  cable.send("000#82 05");
  ASSERT_EQ(device.node().id(), 6);
  for (const char* const frame :
       {"085#00 00 00 00 00 00 00 00", "585#60 00 00 00 00 00 00 00", "705#05"}) {
    cable.clear();
    cable.send(frame);
    EXPECT_EQ(cable.count(0x086), 0u) << frame;
  }
  cable.clear();
  cable.send("706#05");
  EXPECT_EQ(cable.last(0x086), "086#50 81 11 06 07 00 00 00");
}

TEST_F(Collision, ItIsWatchedHoweverOftenCobIdsAreWritten) {
  for (int i = 0; i < 100; ++i) cable.send("605#23 00 18 01 A7 01 00 80");
  cable.send("605#23 00 18 01 A7 01 00 00");
  EXPECT_EQ(reported_of("1A7#00"), "085#50 81 11 A7 01 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia852::collision_watch_test
