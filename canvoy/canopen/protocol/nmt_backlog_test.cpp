// Frames that wait for the controller when the NMT state changes: none leaves in a state that
// forbids it (CiA 301, 7.3.2.2.4).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::nmt_backlog_test {
namespace {

using enum AbortCode;

struct FullNode : PdoNode {
  FullNode() {
    map_tpdo(1, 0x185, 255, {0x2000'01'08});
    map_tpdo(2, 0x285, 1, {0x2000'02'08});
    map_rpdo(1, 0x205, 255, {0x2010'01'10});
    operate();
    full = true;
  }
  void send(std::string_view frame) { EXPECT_TRUE(node.transmitter().send(wire_frame(frame))); }
  /// Sends waiting frames.
  void make_room() {
    full = false;
    node.tx_ready(now);
    settle();
  }
};

TEST(NmtBacklog, HoldsNoPdoWhenTheNodeLeavesOperational) {
  for (const char* command : {"000#02 05", "000#80 05", "000#82 05", "000#81 05"}) {
    FullNode sut;
    sut.set(0x2000, 1, 1);
    sut.receive("080#");
    EXPECT_TRUE(sut.rpdos.request(1));
    sut.send("705#05");
    sut.receive(command);
    sut.make_room();
    const bool boots = std::string(command).substr(4, 2) > "80";
    sut.expect({boots ? "705#00" : "705#05"});
  }
}

TEST(NmtBacklog, HoldsInPreOperationalAllButPdos) {
  FullNode sut;
  sut.send("585#60 00 20 00 00 00 00 00");
  sut.set(0x2000, 1, 1);
  sut.send("085#00 10 01 00 00 00 00 00");
  sut.set(0x2000, 1, 2);
  sut.send("080#");
  sut.receive("000#80 05");
  sut.make_room();
  sut.expect({"585#60 00 20 00 00 00 00 00", "085#00 10 01 00 00 00 00 00", "080#"});
}

/// An emergency is sent once: a waiting one counts as sent.
TEST(NmtBacklog, HoldsInStoppedWhatNmtSaysErrorControlLssAndEmergenciesAlone) {
  FullNode sut;
  sut.send("000#01 07");
  sut.send("071#01 05");
  sut.send("080#");
  sut.send("085#00 10 01 00 00 00 00 00");
  sut.send("100#00 00 00 00 00 00");
  sut.send("585#60 00 20 00 00 00 00 00");
  sut.send("6E1#");
  sut.send("705#05");
  sut.send("7E4#44 00 00 00 00 00 00 00");
  sut.receive("000#02 05");
  sut.make_room();
  sut.expect({"000#01 07", "071#01 05", "085#00 10 01 00 00 00 00 00", "705#05",
              "7E4#44 00 00 00 00 00 00 00"});
}

TEST(NmtBacklog, HoldsNoPdoThatIsValidNoMore) {
  FullNode sut;
  sut.set(0x2000, 1, 1);
  ASSERT_EQ(sut.write(0x1800, 1, 0x8000'0185), none);
  sut.make_room();
  sut.expect({});
}

TEST(NmtBacklog, HoldsPdosWhileTheNodeStaysOperational) {
  FullNode sut;
  sut.set(0x2000, 1, 1);
  sut.receive("000#01 05");
  sut.make_room();
  sut.expect({"185#01"});
}

/// The backlog is a ring: here its oldest frame is at its end.
TEST(NmtBacklog, KeepsTheOrderOfWhatStays) {
  FullNode sut;
  for (int i = 0; i < 10; ++i) sut.send("705#05");
  sut.make_room();
  sut.sent.clear();
  sut.full = true;
  for (int i = 0; i < 5; ++i) {
    sut.send("585#0" + std::to_string(i) + " 00 00 00 00 00 00 00");
    sut.send("705#0" + std::to_string(i));
  }
  sut.receive("000#02 05");
  sut.send("705#04");
  sut.make_room();
  sut.expect({"705#00", "705#01", "705#02", "705#03", "705#04", "705#04"});
}

}  // namespace
}  // namespace canvoy::nmt_backlog_test
