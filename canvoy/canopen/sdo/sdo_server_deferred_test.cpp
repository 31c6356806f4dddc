// SDO server, downloads that a device confirms only when their action is done (CiA 301, 7.5.2.13:
// the confirmation follows the storing).
#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::sdo_server_deferred_test {
namespace {

/// Writes to 2004h take time; the test determines when they are done.
class SdoServerDeferred : public testing::Test {
 protected:
  SdoServerDeferred() {
    hook.first = hook.last = 0x2004;
    hook.before_write = {
        [](void*, const Entry&, std::span<const std::uint8_t>) { return AbortCode::deferred; },
        nullptr};
    wire.node.dictionary().attach(hook);
    wire.boot();
  }
  void ask(const std::string& request, const std::string& answer) {
    SCOPED_TRACE(request);
    wire.receive("605#" + request);
    wire.expect({"585#" + answer});
  }
  void ask_in_vain(const std::string& request) {
    SCOPED_TRACE(request);
    wire.receive("605#" + request);
    wire.expect({});
  }
  void begin() {
    ask_in_vain("23 04 20 00 01 02 03 04");
    EXPECT_TRUE(sut.busy());
    EXPECT_TRUE(wire.node.is_deferred());
  }

  WireNode wire{sdo_objects(), 5};
  std::array<std::uint8_t, 64> buffer{};
  SdoServer sut{wire.node, 0, buffer};
  Hook hook;
};

TEST_F(SdoServerDeferred, TheConfirmationComesWhenTheWriteIsDone) {
  begin();
  wire.run_for(10s);
  wire.expect({});
  wire.node.finish_deferred(AbortCode::none);
  wire.expect({"585#60 04 20 00 00 00 00 00"});
  EXPECT_FALSE(sut.busy());
  EXPECT_FALSE(wire.node.is_deferred());
  EXPECT_EQ(value_of(wire.node, 0x2004), std::vector<std::uint8_t>(4)) << "the hook keeps it";
}

TEST_F(SdoServerDeferred, TheAbortComesWhenTheWriteHasFailed) {
  begin();
  wire.node.finish_deferred(AbortCode::hardware);
  wire.expect({"585#80 04 20 00 00 00 06 06"});
}

TEST_F(SdoServerDeferred, ASegmentedDownloadWaitsWithTheConfirmationOfItsLastSegment) {
  ask("21 04 20 00 04 00 00 00", "60 04 20 00 00 00 00 00");
  ask_in_vain("07 01 02 03 04 00 00 00");
  wire.node.finish_deferred(AbortCode::none);
  wire.expect({"585#20 00 00 00 00 00 00 00"});
}

TEST_F(SdoServerDeferred, ASegmentedDownloadThatHasFailedIsAbortedByItsName) {
  ask("21 04 20 00 04 00 00 00", "60 04 20 00 00 00 00 00");
  ask_in_vain("07 01 02 03 04 00 00 00");
  wire.node.finish_deferred(AbortCode::cannot_store);
  wire.expect({"585#80 04 20 00 20 00 00 08"});
}

TEST_F(SdoServerDeferred, AClientThatAsksForSomethingElseMeanwhileIsAnsweredAndWaitsNoMore) {
  begin();
  ask("40 00 10 00 00 00 00 00", "43 00 10 00 A2 01 02 00");
  wire.node.finish_deferred(AbortCode::none);
  wire.expect({});
}

TEST_F(SdoServerDeferred, AClientThatAbortsWaitsNoMore) {
  begin();
  ask_in_vain("80 04 20 00 00 00 04 05");
  wire.node.finish_deferred(AbortCode::none);
  wire.expect({});
}

TEST_F(SdoServerDeferred, ANodeThatWasStoppedMeanwhileDoesNotAnswer) {
  begin();
  wire.receive("000#02 05");
  wire.node.finish_deferred(AbortCode::none);
  wire.expect({});
}

TEST_F(SdoServerDeferred, TheWatchdogOfAnEarlierTransferDoesNotEndTheWaiting) {
  ask("21 04 20 00 04 00 00 00", "60 04 20 00 00 00 00 00");
  ask_in_vain("07 01 02 03 04 00 00 00");
  wire.run_for(5s);
  wire.expect({});
  wire.node.finish_deferred(AbortCode::none);
  wire.expect({"585#20 00 00 00 00 00 00 00"});
}

// Each command byte, and each other length, while the answer is pending: it is answered as usual,
// or not at all, and the late answer comes once at most.
TEST_F(SdoServerDeferred, WhateverComesMeanwhileTheNodeLivesOn) {
  for (unsigned command = 0; command < 256; ++command) {
    for (unsigned length = 0; length <= 8; ++length) {
      begin();
      Frame frame = wire_frame("605#00 00 10 00 00 00 00 00");
      frame.data[0] = static_cast<std::uint8_t>(command);
      frame.length = static_cast<std::uint8_t>(length);
      wire.receive(wire_text(frame));
      const std::size_t answers = wire.sent.size();
      ASSERT_LE(answers, 1U) << command;
      ASSERT_TRUE(length == 8 || answers == 0) << command;
      wire.node.finish_deferred(AbortCode::none);
      const bool waits = length < 8;
      ASSERT_EQ(wire.sent.size() - answers, waits ? 1U : 0U) << command << ", " << length;
      wire.receive("605#80 00 10 00 00 00 04 05");
      wire.sent.clear();
      ask("40 00 10 00 00 00 00 00", "43 00 10 00 A2 01 02 00");
    }
  }
}

TEST_F(SdoServerDeferred, NothingHappensWhereNobodyWaits) {
  wire.node.finish_deferred(AbortCode::none);
  wire.expect({});
}

}  // namespace
}  // namespace canvoy::sdo_server_deferred_test
