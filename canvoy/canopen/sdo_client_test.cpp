#include "canvoy/canopen/sdo_client.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Node 1 asks node 5; the test is node 5.
class SdoClientTest : public testing::Test {
 protected:
  SdoClientTest() { wire.boot(); }

  void done(SdoClient::Outcome outcome) {
    ++calls;
    last = outcome;
  }
  AbortCode upload(std::span<std::uint8_t> destination, std::uint16_t index = 0x2008,
                   std::uint8_t sub = 0) {
    return sut.upload(5, index, sub, destination, on_done);
  }
  AbortCode download(std::span<const std::uint8_t> value, std::uint16_t index = 0x2008,
                     std::uint8_t sub = 0) {
    return sut.download(5, index, sub, value, on_done);
  }
  /// The server says one thing, and the client another, both as eight bytes.
  void answer(const std::string& response, const std::string& next_request) {
    SCOPED_TRACE(response);
    wire.receive("585#" + response);
    wire.expect({"605#" + next_request});
  }
  void answer(const std::string& response) {
    SCOPED_TRACE(response);
    wire.receive("585#" + response);
    wire.expect({});
  }
  void expect_request(const std::string& request) { wire.expect({"605#" + request}); }
  void expect_done(std::size_t size) {
    EXPECT_EQ(std::exchange(calls, 0), 1);
    EXPECT_EQ(last.abort(), AbortCode::none);
    EXPECT_EQ(*last, size);
    EXPECT_FALSE(sut.busy());
  }
  void expect_failed(AbortCode code) {
    EXPECT_EQ(std::exchange(calls, 0), 1);
    EXPECT_EQ(last.abort(), code);
    EXPECT_FALSE(sut.busy());
  }
  void expect_waiting() {
    EXPECT_EQ(calls, 0);
    EXPECT_TRUE(sut.busy());
  }

  WireNode wire{sdo_objects(), 1};
  SdoClient sut{wire.node};
  SdoClient::Done on_done = SdoClient::Done::to<&SdoClientTest::done>(*this);
  SdoClient::Outcome last = AbortCode::none;
  int calls = 0;
  std::array<std::uint8_t, 20> bytes{};
};

// Upload

TEST_F(SdoClientTest, AnExpeditedUploadTakesOneFrameEachWay) {
  EXPECT_EQ(upload(bytes, 0x1018, 4), AbortCode::none);
  expect_request("40 18 10 04 00 00 00 00");
  expect_waiting();
  answer("43 18 10 04 11 22 33 44");
  expect_done(4);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 5), (Bytes{0x11, 0x22, 0x33, 0x44, 0}));
}

TEST_F(SdoClientTest, AnExpeditedAnswerTellsHowManyBytesItHas) {
  const std::array<std::string, 4> answers{"4F 08 20 00 11 22 33 44", "4B 08 20 00 11 22 33 44",
                                           "47 08 20 00 11 22 33 44", "43 08 20 00 11 22 33 44"};
  for (std::size_t size = 1; size <= 4; ++size) {
    bytes.fill(0);
    EXPECT_EQ(upload(bytes), AbortCode::none);
    wire.sent.clear();
    answer(answers.at(size - 1));
    expect_done(size);
    const Bytes all{0x11, 0x22, 0x33, 0x44};
    EXPECT_TRUE(std::equal(bytes.begin(), bytes.begin() + static_cast<long>(size), all.begin()));
    EXPECT_EQ(bytes.at(size), 0);
  }
}

TEST_F(SdoClientTest, AnExpeditedAnswerWithoutSizeFillsTheDestination) {
  EXPECT_EQ(upload(std::span(bytes).first(2)), AbortCode::none);
  wire.sent.clear();
  answer("42 08 20 00 11 22 33 44");
  expect_done(2);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 3), (Bytes{0x11, 0x22, 0}));
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("4E 08 20 00 11 22 33 44");
  expect_done(4);
}

TEST_F(SdoClientTest, AnUploadInSegmentsAsksForOneAfterTheOther) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  expect_request("40 08 20 00 00 00 00 00");
  answer("41 08 20 00 10 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  EXPECT_EQ(sut.transferred(), 7U);
  EXPECT_EQ(sut.announced(), 16U);
  answer("10 08 09 0A 0B 0C 0D 0E", "60 00 00 00 00 00 00 00");
  expect_waiting();
  answer("0B 0F 10 EE EE EE EE EE");
  expect_done(16);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 17),
            (Bytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 0}));
}

TEST_F(SdoClientTest, TheServerNeedNotTellTheSize) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("40 08 20 00 EE EE EE EE", "60 00 00 00 00 00 00 00");
  EXPECT_EQ(sut.announced(), std::nullopt);
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1D 08 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientTest, AnEmptyValueIsUploaded) {
  EXPECT_EQ(upload({}), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 00 00 00 00", "60 00 00 00 00 00 00 00");
  answer("0F 00 00 00 00 00 00 00");
  expect_done(0);
}

TEST_F(SdoClientTest, AServerMayEndWithAnEmptySegment) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 07 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1F 00 00 00 00 00 00 00");
  expect_done(7);
}

TEST_F(SdoClientTest, ADestinationThatIsTooShortEndsAnUpload) {
  EXPECT_EQ(upload(std::span(bytes).first(1)), AbortCode::none);
  wire.sent.clear();
  answer("4B 08 20 00 11 22 00 00", "80 08 20 00 05 00 04 05");
  expect_failed(AbortCode::out_of_memory);
  EXPECT_EQ(upload(std::span(bytes).first(7)), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "80 08 20 00 05 00 04 05");
  expect_failed(AbortCode::out_of_memory);
  EXPECT_EQ(upload(std::span(bytes).first(7)), AbortCode::none);
  wire.sent.clear();
  answer("40 08 20 00 00 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1D 08 00 00 00 00 00 00", "80 08 20 00 05 00 04 05");
  expect_failed(AbortCode::out_of_memory);
  EXPECT_EQ(bytes.at(7), 0);
}

TEST_F(SdoClientTest, ASizeThatIsNotKeptEndsAnUpload) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1B 08 09 00 00 00 00 00", "80 08 20 00 12 00 07 06");
  expect_failed(AbortCode::length_too_high);
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("01 01 02 03 04 05 06 07", "80 08 20 00 13 00 07 06");
  expect_failed(AbortCode::length_too_low);
}

// Download

TEST_F(SdoClientTest, AnExpeditedDownloadTakesOneFrameEachWay) {
  const std::array<std::string, 4> requests{"2F 08 20 00 11 00 00 00", "2B 08 20 00 11 22 00 00",
                                            "27 08 20 00 11 22 33 00", "23 08 20 00 11 22 33 44"};
  const Bytes value{0x11, 0x22, 0x33, 0x44};
  for (std::size_t size = 1; size <= 4; ++size) {
    EXPECT_EQ(download(std::span(value).first(size)), AbortCode::none);
    expect_request(requests.at(size - 1));
    expect_waiting();
    answer("60 08 20 00 00 00 00 00");
    expect_done(size);
  }
}

TEST_F(SdoClientTest, ADownloadInSegmentsTellsItsSizeAndSendsOneAfterTheOther) {
  const Bytes value = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  EXPECT_EQ(download(value), AbortCode::none);
  expect_request("21 08 20 00 10 00 00 00");
  answer("60 08 20 00 00 00 00 00", "00 01 02 03 04 05 06 07");
  answer("20 00 00 00 00 00 00 00", "10 08 09 0A 0B 0C 0D 0E");
  answer("30 00 00 00 00 00 00 00", "0B 0F 10 00 00 00 00 00");
  expect_waiting();
  answer("20 00 00 00 00 00 00 00");
  expect_done(16);
}

TEST_F(SdoClientTest, ALastSegmentMayBeFull) {
  const Bytes value = {1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(download(value), AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 00 00 00 00 00", "01 01 02 03 04 05 06 07");
  answer("20 00 00 00 00 00 00 00");
  expect_done(7);
}

TEST_F(SdoClientTest, AnEmptyValueIsDownloadedAsOneEmptySegment) {
  EXPECT_EQ(download({}), AbortCode::none);
  expect_request("21 08 20 00 00 00 00 00");
  answer("60 08 20 00 00 00 00 00", "0F 00 00 00 00 00 00 00");
  answer("20 00 00 00 00 00 00 00");
  expect_done(0);
}

TEST_F(SdoClientTest, ReservedBitsOfAnAnswerDoNotMatter) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("53 08 20 00 11 22 33 44");
  expect_done(4);
  const Bytes value = {1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(download(value), AbortCode::none);
  wire.sent.clear();
  answer("7F 08 20 00 FF FF FF FF", "00 01 02 03 04 05 06 07");
  answer("2F FF FF FF FF FF FF FF", "1D 08 00 00 00 00 00 00");
  answer("3F FF FF FF FF FF FF FF");
  expect_done(8);
}

// Streams

TEST_F(SdoClientTest, AnUploadMayGoToASink) {
  Bytes all;
  auto take = [&](std::span<const std::uint8_t> piece) {
    all.insert(all.end(), piece.begin(), piece.end());
    return AbortCode::none;
  };
  const auto sink = SdoClient::Sink::of(take);
  EXPECT_EQ(sut.upload(5, 0x2008, 0, sink, on_done), AbortCode::none);
  expect_request("40 08 20 00 00 00 00 00");
  answer("40 08 20 00 00 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  EXPECT_EQ(all.size(), 7U);
  answer("1D 08 00 00 00 00 00 00");
  expect_done(8);
  EXPECT_EQ(all, (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  all.clear();
  EXPECT_EQ(sut.upload(5, 0x2008, 0, sink, on_done), AbortCode::none);
  wire.sent.clear();
  answer("4B 08 20 00 11 22 00 00");
  expect_done(2);
  EXPECT_EQ(all, (Bytes{0x11, 0x22}));
}

TEST_F(SdoClientTest, ASinkMayEndAnUpload) {
  auto refuse = [&](std::span<const std::uint8_t>) { return AbortCode::cannot_store; };
  EXPECT_EQ(sut.upload(5, 0x2008, 0, SdoClient::Sink::of(refuse), on_done), AbortCode::none);
  wire.sent.clear();
  answer("40 08 20 00 00 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "80 08 20 00 20 00 00 08");
  expect_failed(AbortCode::cannot_store);
  EXPECT_EQ(sut.upload(5, 0x2008, 0, SdoClient::Sink::of(refuse), on_done), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 01 02 03 04", "80 08 20 00 20 00 00 08");
  expect_failed(AbortCode::cannot_store);
}

/// Gives `left` bytes, all 55h.
struct Stock {
  std::size_t left;
  Result<std::size_t> operator()(std::span<std::uint8_t> piece) {
    const std::size_t size = std::min(piece.size(), left);
    std::fill_n(piece.begin(), size, std::uint8_t{0x55});
    left -= size;
    return size;
  }
};

TEST_F(SdoClientTest, ADownloadMayComeFromASupplyOfUnknownSize) {
  Stock stock{10};
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(stock), std::nullopt, on_done),
            AbortCode::none);
  expect_request("20 08 20 00 00 00 00 00");
  answer("60 08 20 00 00 00 00 00", "00 55 55 55 55 55 55 55");
  answer("20 00 00 00 00 00 00 00", "19 55 55 55 00 00 00 00");
  answer("30 00 00 00 00 00 00 00");
  expect_done(10);
}

TEST_F(SdoClientTest, ASupplyThatEndsWithAFullSegmentIsFollowedByAnEmptyOne) {
  Stock stock{7};
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(stock), std::nullopt, on_done),
            AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 00 00 00 00 00", "00 55 55 55 55 55 55 55");
  answer("20 00 00 00 00 00 00 00", "1F 00 00 00 00 00 00 00");
  answer("30 00 00 00 00 00 00 00");
  expect_done(7);
}

TEST_F(SdoClientTest, ADownloadMayComeFromASupplyOfKnownSize) {
  Stock stock{100};
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(stock), 7, on_done), AbortCode::none);
  expect_request("21 08 20 00 07 00 00 00");
  answer("60 08 20 00 00 00 00 00", "01 55 55 55 55 55 55 55");
  answer("20 00 00 00 00 00 00 00");
  expect_done(7);
  EXPECT_EQ(stock.left, 93U);
}

TEST_F(SdoClientTest, ASupplyMayEndADownload) {
  auto fail = [&](std::span<std::uint8_t>) { return Result<std::size_t>(AbortCode::hardware); };
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(fail), std::nullopt, on_done),
            AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 00 00 00 00 00", "80 08 20 00 00 00 06 06");
  expect_failed(AbortCode::hardware);
}

TEST_F(SdoClientTest, ASupplyThatClaimsMoreThanItWasAskedForEndsADownload) {
  auto lie = [&](std::span<std::uint8_t>) { return Result<std::size_t>(8); };
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(lie), std::nullopt, on_done),
            AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 00 00 00 00 00", "80 08 20 00 47 00 04 06");
  expect_failed(AbortCode::internal_incompatible);
}

// What servers say against it

TEST_F(SdoClientTest, AnAbortFromTheServerEndsTheRequest) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 00 00 02 06");
  expect_failed(AbortCode::no_object);
  EXPECT_EQ(download(Bytes{1}), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 78 56 34 12");
  expect_failed(static_cast<AbortCode>(0x1234'5678));
}

TEST_F(SdoClientTest, AnAbortWithoutAReasonIsNoSuccess) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 00 00 00 00");
  expect_failed(AbortCode::general);
}

TEST_F(SdoClientTest, AnAbortFromTheServerEndsATransferInSegments) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("80 08 20 00 22 00 00 08");
  expect_failed(AbortCode::device_state);
}

TEST_F(SdoClientTest, AServerThatHasForgottenATransferNeedNotNameItInItsAbort) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("80 00 00 00 01 00 04 05");
  expect_waiting();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("80 00 00 00 01 00 04 05");
  expect_failed(AbortCode::command_specifier);
}

TEST_F(SdoClientTest, LateAnswersToOtherRequestsAreNotTakenForThePresentOne) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 01 11 22 33 44");
  answer("43 07 20 00 11 22 33 44");
  answer("60 08 20 00 00 00 00 00");
  answer("80 08 20 01 00 00 02 06");
  answer("1D 08 00 00 00 00 00 00");
  answer("20 00 00 00 00 00 00 00");
  expect_waiting();
  answer("43 08 20 00 11 22 33 44");
  expect_done(4);
  EXPECT_EQ(download(Bytes{1}), AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 01 00 00 00 00");
  answer("43 08 20 00 11 22 33 44");
  expect_waiting();
  answer("60 08 20 00 00 00 00 00");
  expect_done(1);
}

TEST_F(SdoClientTest, AnInitiateAnswerThatComesTwiceDoesNoHarm) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("41 08 20 00 08 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1D 08 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientTest, AnswersWithoutARequestAreIgnored) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 11 22 33 44");
  expect_done(4);
  answer("43 08 20 00 55 66 77 88");
  answer("80 08 20 00 00 00 02 06");
  answer("00 01 02 03 04 05 06 07");
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(bytes.at(0), 0x11);
}

TEST_F(SdoClientTest, ASegmentWithTheWrongToggleBitEndsTheTransfer) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("10 01 02 03 04 05 06 07", "80 08 20 00 00 00 03 05");
  expect_failed(AbortCode::toggle_bit);
  const Bytes value(8);
  EXPECT_EQ(download(value), AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 00 00 00 00 00", "00 00 00 00 00 00 00 00");
  answer("30 00 00 00 00 00 00 00", "80 08 20 00 00 00 03 05");
  expect_failed(AbortCode::toggle_bit);
}

TEST_F(SdoClientTest, AnUnknownCommandSpecifierBetweenSegmentsEndsTheTransfer) {
  for (const char* response : {"20 00 00 00 00 00 00 00", "A0 00 00 00 00 00 00 00",
                               "C0 00 00 00 00 00 00 00", "E0 00 00 00 00 00 00 00"}) {
    EXPECT_EQ(upload(bytes), AbortCode::none);
    wire.sent.clear();
    answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
    answer(response, "80 08 20 00 01 00 04 05");
    expect_failed(AbortCode::command_specifier);
  }
}

TEST_F(SdoClientTest, FramesOfAnotherLengthAreIgnoredAndCounted) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 11 22 33");
  answer("");
  expect_waiting();
  EXPECT_EQ(wire.node.counters().malformed, 2U);
}

// Time

TEST_F(SdoClientTest, AServerThatDoesNotAnswerIsGivenOneSecond) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.run_until(Time(999'999us));
  expect_waiting();
  wire.run_until(Time(5s));
  wire.expect({"@1000000 605#80 08 20 00 00 00 04 05"});
  expect_failed(AbortCode::time_out);
}

TEST_F(SdoClientTest, EachAnswerStartsTheTimeOutAnew) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.run_until(Time(900ms));
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  wire.run_until(Time(1800ms));
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  wire.run_until(Time(2799ms));
  expect_waiting();
  wire.run_until(Time(5s));
  wire.expect({"@2800000 605#80 08 20 00 00 00 04 05"});
  expect_failed(AbortCode::time_out);
}

TEST_F(SdoClientTest, ARequestMayHaveAShorterTimeOutThanTheOneBefore) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 11 22 33 44");
  expect_done(4);
  EXPECT_EQ(sut.upload(5, 0x2008, 0, bytes, on_done, 100ms), AbortCode::none);
  wire.sent.clear();
  wire.run_until(Time(5s));
  wire.expect({"@100000 605#80 08 20 00 00 00 04 05"});
  expect_failed(AbortCode::time_out);
}

TEST_F(SdoClientTest, LateAnswersDoNotPutTheTimeOutOff) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.run_until(Time(900ms));
  answer("43 08 20 01 11 22 33 44");
  wire.run_until(Time(5s));
  wire.expect({"@1000000 605#80 08 20 00 00 00 04 05"});
}

TEST_F(SdoClientTest, ADoneRequestHasNoTimeOut) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 11 22 33 44");
  expect_done(4);
  wire.run_until(Time(5s));
  wire.expect({});
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(wire.node.deadline(), never);
}

// The owner's side

TEST_F(SdoClientTest, OneRequestAtATime) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  EXPECT_EQ(upload(bytes), AbortCode::device_state);
  EXPECT_EQ(download(bytes), AbortCode::device_state);
  expect_request("40 08 20 00 00 00 00 00");
}

TEST_F(SdoClientTest, ACancelledRequestIsAbortedAndNotToldOf) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  sut.cancel();
  expect_request("80 08 20 00 00 00 00 08");
  EXPECT_FALSE(sut.busy());
  sut.cancel();
  wire.expect({});
  answer("43 08 20 00 11 22 33 44");
  wire.run_until(Time(5s));
  wire.expect({});
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(upload(bytes), AbortCode::none);
  expect_request("40 08 20 00 00 00 00 00");
  sut.cancel(AbortCode::local_control);
  expect_request("80 08 20 00 21 00 00 08");
}

TEST_F(SdoClientTest, TheNextRequestMayBeStartedFromTheOutcomeOfTheLast) {
  std::vector<AbortCode> outcomes;
  SdoClient::Done ask_next;
  std::uint8_t sub = 0;
  auto again = [&](SdoClient::Outcome outcome) {
    outcomes.push_back(outcome.abort());
    if (++sub > 3) return;
    EXPECT_EQ(sut.upload(5, 0x2009, sub, bytes, ask_next), AbortCode::none);
  };
  ask_next = SdoClient::Done::of(again);
  EXPECT_EQ(sut.upload(5, 0x2009, 0, bytes, ask_next), AbortCode::none);
  expect_request("40 09 20 00 00 00 00 00");
  answer("4F 09 20 00 03 00 00 00", "40 09 20 01 00 00 00 00");  // after a success
  answer("80 09 20 01 11 00 09 06", "40 09 20 02 00 00 00 00");  // after an abort
  wire.run_for(1s);                                              // after a time-out
  wire.expect({"605#80 09 20 02 00 00 04 05", "605#40 09 20 03 00 00 00 00"});
  wire.receive("000#02 01");  // a stop ends it
  EXPECT_EQ(outcomes, (std::vector{AbortCode::none, AbortCode::no_sub_index, AbortCode::time_out,
                                   AbortCode::device_state}));
}

TEST_F(SdoClientTest, SeveralClientsAskSeveralServersAtOnce) {
  SdoClient other(wire.node);
  std::array<std::uint8_t, 4> others{};
  EXPECT_EQ(upload(bytes), AbortCode::none);
  EXPECT_EQ(other.upload(6, 0x2008, 0, others, on_done), AbortCode::none);
  wire.expect({"605#40 08 20 00 00 00 00 00", "606#40 08 20 00 00 00 00 00"});
  wire.receive("586#4F 08 20 00 66 00 00 00");
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(others.at(0), 0x66);
  EXPECT_TRUE(sut.busy());
  answer("4F 08 20 00 55 00 00 00");
  EXPECT_EQ(bytes.at(0), 0x55);
}

TEST_F(SdoClientTest, OneClientAsksOneServerAfterTheOther) {
  for (unsigned server = 1; server <= 127; ++server) {
    const auto id = static_cast<NodeId>(server);
    EXPECT_EQ(sut.upload(id, 0x1000, 0, bytes, on_done), AbortCode::none);
    wire.expect({wire_text(Frame::data_frame(0x600 + server, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}))});
    wire.receive(wire_text(Frame::data_frame(0x580 + server, {0x43, 0x00, 0x10, 0, id, 0, 0, 0})));
    expect_done(4);
    EXPECT_EQ(bytes.at(0), id);
  }
}

TEST_F(SdoClientTest, AClientKeepsARouteToItsLastServerOnly) {
  for (unsigned request = 0; request < 1500; ++request) {  // the node has 1200 routes
    const auto server = static_cast<NodeId>(2 + request % 100);
    ASSERT_EQ(sut.upload(server, 0x1000, 0, bytes, on_done), AbortCode::none) << request;
    sut.cancel();
  }
}

TEST_F(SdoClientTest, WithoutARouteLeftARequestIsNotStarted) {
  std::vector<std::unique_ptr<SdoClient>> many;
  AbortCode answer = AbortCode::none;
  while (answer == AbortCode::none) {
    ASSERT_LT(many.size(), 1300U);
    many.push_back(std::make_unique<SdoClient>(wire.node));
    answer = many.back()->upload(5, 0x1000, 0, bytes, on_done);
  }
  EXPECT_EQ(answer, AbortCode::out_of_memory);
  EXPECT_FALSE(many.back()->busy());
}

TEST_F(SdoClientTest, ThereIsNoServerOutsideOfTheNodeIds) {
  EXPECT_EQ(sut.upload(0, 0x1000, 0, bytes, on_done), AbortCode::no_sdo_connection);
  EXPECT_EQ(sut.upload(128, 0x1000, 0, bytes, on_done), AbortCode::no_sdo_connection);
  EXPECT_EQ(sut.download(255, 0x1000, 0, bytes, on_done), AbortCode::no_sdo_connection);
  wire.expect({});
  wire.run_until(Time(5s));
  EXPECT_EQ(calls, 0);
}

// NMT

TEST_F(SdoClientTest, StoppedEndsARequestAndAllowsNone) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.receive("000#02 01");
  wire.expect({});
  expect_failed(AbortCode::device_state);
  EXPECT_EQ(upload(bytes), AbortCode::device_state);
  wire.receive("000#01 01");
  EXPECT_EQ(upload(bytes), AbortCode::none);
  expect_request("40 08 20 00 00 00 00 00");
}

TEST(SdoClientCancel, StoppedIsSilentForOneWhoCancelsJustThen) {
  WireNode node(sdo_objects(), 1);
  std::unique_ptr<SdoClient> client;
  auto cancel = [&](NmtState state) {
    if (state == NmtState::stopped) client->cancel();
  };
  Service earlier;
  earlier.state_entered = decltype(earlier.state_entered)::of(cancel);
  node.node.attach(earlier);
  client = std::make_unique<SdoClient>(node.node);
  node.boot();
  std::array<std::uint8_t, 4> bytes{};
  EXPECT_EQ(client->upload(5, 0x1000, 0, bytes, {}), AbortCode::none);
  node.sent.clear();
  node.receive("000#02 01");
  node.expect({});
}

TEST_F(SdoClientTest, ResetEndsARequest) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.receive("000#81 01");
  wire.expect({"701#00"});
  expect_failed(AbortCode::device_state);
  wire.run_until(Time(5s));
  wire.expect({});
}

TEST_F(SdoClientTest, ARequestGoesOnFromPreOperationalToOperational) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.receive("000#01 01");
  answer("43 08 20 00 11 22 33 44");
  expect_done(4);
}

TEST_F(SdoClientTest, ANodeWithoutNodeIdMayAskToo) {
  WireNode tool(sdo_objects(), node_id_unconfigured);
  SdoClient client(tool.node);
  tool.start();
  EXPECT_EQ(client.upload(5, 0x1000, 0, bytes, on_done), AbortCode::none);
  tool.expect({"605#40 00 10 00 00 00 00 00"});
  tool.receive("585#43 00 10 00 A2 01 00 00");
  expect_done(4);
}

TEST_F(SdoClientTest, WhatTheBacklogCannotHoldEndsWithATimeOut) {
  wire.full = true;
  std::vector<std::unique_ptr<SdoClient>> many;
  for (int i = 0; i < 17; ++i) many.push_back(std::make_unique<SdoClient>(wire.node));
  for (auto& client : many) {
    EXPECT_EQ(client->upload(5, 0x2008, 0, bytes, on_done), AbortCode::none);
  }
  wire.run_until(Time(1s));
  EXPECT_EQ(calls, 17);
  EXPECT_EQ(last.abort(), AbortCode::time_out);
}

}  // namespace
}  // namespace canvoy
