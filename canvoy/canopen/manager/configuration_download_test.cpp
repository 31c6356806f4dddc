// A concise DCF on its way into slave 5, frame by frame (CiA 302-3; CiA 301, 7.2.4.3).
#include "canvoy/canopen/manager/configuration_download.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/concise_dcf_bytes.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::configuration_download_test {
namespace {

struct Manager : WireNode {
  explicit Manager(std::vector<std::uint8_t> content)
      : WireNode({}, 1), bytes(std::move(content)), source(bytes) {
    boot();
  }
  AbortCode start(Duration time_out = 1s) {
    return sut.start(client, 5, source.source(),
                     ConfigurationDownload::Done::to<&Manager::done>(*this), time_out);
  }
  void done(const ConfigurationDownload::Outcome& result) {
    ++ends;
    outcome = result;
  }

  std::vector<std::uint8_t> bytes;
  BytesSource source;
  SdoClient client{node};
  ConfigurationDownload sut;
  ConfigurationDownload::Outcome outcome;
  int ends = 0;
};

const std::vector<std::uint8_t> three = concise_dcf(
    {{0x1017, 0, {0xF4, 0x01}}, {0x1800, 1, {0x85, 0x01, 0x00, 0x00}}, {0x2000, 3, {0x07}}});

TEST(ConfigurationDownload, WritesOneEntryAfterTheOther) {
  Manager manager(three);
  ASSERT_EQ(manager.start(), AbortCode::none);
  EXPECT_EQ(manager.sut.entries(), 3u);
  manager.expect({"605#2B 17 10 00 F4 01 00 00"});
  manager.receive("585#60 17 10 00 00 00 00 00");
  EXPECT_EQ(manager.sut.entries_written(), 1u);
  manager.expect({"605#23 00 18 01 85 01 00 00"});
  manager.receive("585#60 00 18 01 00 00 00 00");
  manager.expect({"605#2F 00 20 03 07 00 00 00"});
  EXPECT_EQ(manager.ends, 0);
  manager.receive("585#60 00 20 03 00 00 00 00");
  manager.expect({});
  EXPECT_EQ(manager.ends, 1);
  EXPECT_TRUE(manager.outcome.end);
  EXPECT_EQ(manager.outcome.written, 3u);
  EXPECT_FALSE(manager.sut.busy());
}

TEST(ConfigurationDownload, AValueOfMoreThanFourBytesGoesInSegments) {
  Manager manager(concise_dcf({{0x2010, 1, {1, 2, 3, 4, 5, 6, 7, 8, 9}}, {0x2000, 3, {0x07}}}));
  ASSERT_EQ(manager.start(), AbortCode::none);
  manager.expect({"605#21 10 20 01 09 00 00 00"});
  manager.receive("585#60 10 20 01 00 00 00 00");
  manager.expect({"605#00 01 02 03 04 05 06 07"});
  manager.receive("585#20 00 00 00 00 00 00 00");
  manager.expect({"605#1B 08 09 00 00 00 00 00"});
  manager.receive("585#30 00 00 00 00 00 00 00");
  manager.expect({"605#2F 00 20 03 07 00 00 00"});
  manager.receive("585#60 00 20 03 00 00 00 00");
  EXPECT_EQ(manager.outcome.written, 2u);
}

TEST(ConfigurationDownload, StopsAtTheFirstEntryThatIsRefusedAndNamesIt) {
  Manager manager(three);
  ASSERT_EQ(manager.start(), AbortCode::none);
  manager.receive("585#60 17 10 00 00 00 00 00");
  manager.sent.clear();
  manager.receive("585#80 00 18 01 30 00 09 06");
  manager.expect({});
  EXPECT_EQ(manager.ends, 1);
  EXPECT_EQ(manager.outcome.end, SdoEnd::by_server(AbortCode::value_range));
  EXPECT_EQ(manager.outcome.index, 0x1800);
  EXPECT_EQ(manager.outcome.sub, 1);
  EXPECT_EQ(manager.outcome.written, 1u);
  manager.run_for(1min);
  manager.expect({});
}

TEST(ConfigurationDownload, ASlaveThatDoesNotAnswerEndsItAfterTheTimeOut) {
  Manager manager(three);
  ASSERT_EQ(manager.start(200ms), AbortCode::none);
  manager.sent.clear();
  manager.run_for(199ms);
  EXPECT_EQ(manager.ends, 0);
  manager.run_for(1ms);
  EXPECT_EQ(manager.ends, 1);
  EXPECT_EQ(manager.outcome.end, SdoEnd::no_answer());
  EXPECT_EQ(manager.outcome.index, 0x1017);
  manager.expect({"@200000 605#80 17 10 00 00 00 04 05"});
}

TEST(ConfigurationDownload, AMalformedConciseDcfIsRefusedBeforeAFrameIsSent) {
  for (std::size_t length = 0; length < three.size(); ++length) {
    Manager manager({three.begin(), three.begin() + static_cast<std::ptrdiff_t>(length)});
    EXPECT_EQ(manager.start(), AbortCode::length_too_low) << length;
    manager.expect({});
    EXPECT_FALSE(manager.sut.busy());
    EXPECT_EQ(manager.ends, 0);
  }
}

TEST(ConfigurationDownload, AnEmptyOneHasNoData) {
  Manager manager({0, 0, 0, 0});
  EXPECT_EQ(manager.start(), AbortCode::no_data);
  manager.expect({});
}

TEST(ConfigurationDownload, AConciseDcfThatShrinksUnderWayEndsIt) {
  Manager manager(three);
  ASSERT_EQ(manager.start(), AbortCode::none);
  manager.sent.clear();
  manager.bytes[13] = 0x40;  // the second index
  manager.bytes[16] = 0x40;  // the second size
  manager.receive("585#60 17 10 00 00 00 00 00");
  manager.expect({});
  EXPECT_EQ(manager.ends, 1);
  EXPECT_EQ(manager.outcome.end.abort(), AbortCode::length_too_low);
  EXPECT_EQ(manager.outcome.index, 0);
  EXPECT_EQ(manager.outcome.written, 1u);
}

TEST(ConfigurationDownload, OneAtATime) {
  Manager manager(three);
  ASSERT_EQ(manager.start(), AbortCode::none);
  EXPECT_EQ(manager.start(), AbortCode::device_state);
  EXPECT_TRUE(manager.sut.busy());
}

TEST(ConfigurationDownload, NeedsAnNmtStateWithSdo) {
  Manager manager(three);
  manager.receive("000#02 01");
  EXPECT_EQ(manager.start(), AbortCode::device_state);
  EXPECT_FALSE(manager.sut.busy());
  manager.receive("000#80 01");
  EXPECT_EQ(manager.start(), AbortCode::none);
  manager.receive("000#02 01");
  EXPECT_EQ(manager.outcome.end, SdoEnd::cancelled(AbortCode::device_state));
  EXPECT_EQ(manager.ends, 1);
}

TEST(ConfigurationDownload, ThatIsOverLeavesItsClientToOthers) {
  Manager manager(concise_dcf({{0x2000, 3, {0x07}}}));
  manager.sut.cancel();  // nor is there one before
  ASSERT_EQ(manager.start(), AbortCode::none);
  manager.receive("585#60 00 20 03 00 00 00 00");
  ASSERT_EQ(manager.ends, 1);
  manager.sent.clear();
  const std::uint8_t time[] = {0x11, 0x22, 0x33, 0x44};
  ASSERT_EQ(manager.client.download(5, 0x1020, 2, time, {}), AbortCode::none);
  manager.sut.cancel();
  manager.expect({"605#23 20 10 02 11 22 33 44"});
  EXPECT_TRUE(manager.client.busy());
}

TEST(ConfigurationDownload, IsCancelledWithoutAWordToTheOwner) {
  Manager manager(three);
  ASSERT_EQ(manager.start(), AbortCode::none);
  manager.sent.clear();
  manager.sut.cancel();
  manager.expect({"605#80 17 10 00 00 00 00 08"});
  EXPECT_FALSE(manager.sut.busy());
  manager.receive("585#60 17 10 00 00 00 00 00");
  EXPECT_EQ(manager.ends, 0);
  EXPECT_EQ(manager.start(), AbortCode::none) << "and it may begin anew";
}

}  // namespace
}  // namespace canvoy::configuration_download_test
