// Violations of the SDO protocol, as the listener marks them (CiA 301, 7.2.4.3).
#include "canvoy/decoder/sdo_follower.hpp"

#include <gtest/gtest.h>

#include <string>

#include "canvoy/can/frame_text.hpp"

namespace canvoy::decoder::sdo_follower_test {
namespace {

/// A frame in the format of candump, from the client (60Ah) or the server (58Ah), and its marks.
struct Example {
  std::string_view frame;
  std::string_view marks = "";
};

SdoStep take(SdoFollower& sut, const Frame& frame) {
  return frame.id >= can_id::sdo_request ? sut.request(frame) : sut.response(frame);
}

std::string text_of(Marks marks) {
  std::string text;
  for (const Mark mark : all_marks) {
    if (!marks.has(mark)) continue;
    if (!text.empty()) text += ", ";
    text += mark_name(mark);
  }
  return text;
}

void expect_marks(SdoFollower& sut, std::initializer_list<Example> examples) {
  for (const Example& example : examples) {
    const SdoStep step = take(sut, parse_frame(example.frame).frame);
    EXPECT_EQ(text_of(step.marks), example.marks) << example.frame;
  }
}
void expect_marks(std::initializer_list<Example> examples) {
  SdoFollower sut;
  expect_marks(sut, examples);
}

TEST(SdoFollower, MarksNothingInTransfersAsTheyShouldBe) {
  expect_marks({
      // An expedited download of two bytes, and an upload without a size.
      {"60A#2B17100032000000"},
      {"58A#6017100000000000"},
      {"60A#4017100000000000"},
      {"58A#4217100032000000"},
      // Ten bytes in segments, up and down.
      {"60A#4008100000000000"},
      {"58A#410810000A000000"},
      {"60A#6000000000000000"},
      {"58A#0043616E766F7920"},
      {"60A#7000000000000000"},
      {"58A#1942434400000000"},
      {"60A#210820000A000000"},
      {"58A#6008200000000000"},
      {"60A#0043616E766F7920"},
      {"58A#2000000000000000"},
      {"60A#1942434400000000"},
      {"58A#3000000000000000"},
      // The size is optional.
      {"60A#4008100000000000"},
      {"58A#4008100000000000"},
      {"60A#6000000000000000"},
      {"58A#0D41000000000000"},
      {"60A#4008100000000000"},
      {"58A#8008100000000206"},
  });
}

TEST(SdoFollower, MarksNothingInBlockTransfersAsTheyShouldBe) {
  // The checksum of "123456789" is 31C3h, the common check value of this CRC (CiA 301, 7.2.4.3.16).
  expect_marks({
      {"60A#C650200109000000"},
      {"58A#A45020017F000000"},
      {"60A#0131323334353637"},
      {"60A#8238390000000000"},
      {"58A#A202000000000000"},
      {"60A#D5C3310000000000"},
      {"58A#A100000000000000"},
      {"60A#A45020017F000000"},
      {"58A#C650200109000000"},
      {"60A#A300000000000000"},
      {"58A#0131323334353637"},
      {"58A#8238390000000000"},
      {"60A#A2027F0000000000"},
      {"58A#D5C3310000000000"},
      {"60A#A100000000000000"},
      // With few bytes, the server continues in segments (protocol switch).
      {"60A#A45020017F150000"},
      {"58A#4F50200107000000"},
  });
}

TEST(SdoFollower, MarksAToggleBitOfAnUploadThatDoesNotAlternate) {
  expect_marks({
      {"60A#4008100000000000"},
      {"58A#4108100015000000"},
      {"60A#7000000000000000", "wrong toggle bit"},  // 0 in the first segment
      {"58A#0043616E766F7920", "wrong toggle bit"},  // the answer repeats that of the request
      {"60A#7000000000000000"},                      // the last one is the reference
      {"58A#1043616E766F7920"},
      {"60A#7000000000000000", "wrong toggle bit"},
      {"58A#1143616E766F7920"},
  });
}

TEST(SdoFollower, MarksAToggleBitOfADownloadThatDoesNotAlternate) {
  expect_marks({
      {"60A#210820000E000000"},
      {"58A#6008200000000000"},
      {"60A#0043616E766F7920"},
      {"58A#3000000000000000", "wrong toggle bit"},
      {"60A#0143616E766F7920"},
      {"58A#3000000000000000", "wrong toggle bit"},
  });
}

TEST(SdoFollower, MarksATransferThatEndsWithMoreOrFewerBytesThanItsBeginningTold) {
  expect_marks({
      {"60A#4008100000000000"},
      {"58A#4108100008000000"},
      {"60A#6000000000000000"},
      {"58A#0143616E766F7920", "wrong length"},  // 7 of 8
      {"60A#4008100000000000"},
      {"58A#4108100008000000"},
      {"60A#6000000000000000"},
      {"58A#0043616E766F7920"},
      {"60A#7000000000000000"},
      {"58A#1B41420000000000", "wrong length"},  // 9 of 8
      {"60A#2108200006000000"},
      {"58A#6008200000000000"},
      {"60A#0043616E766F7920", "wrong length"},  // too many, though it is not the last one
      {"58A#2000000000000000"},
      {"60A#1F00000000000000", "wrong length"},
      {"58A#3000000000000000"},
  });
}

TEST(SdoFollower, MarksABlockTransferOfAnotherSizeOrChecksum) {
  expect_marks({
      {"60A#C65020010A000000"},
      {"58A#A45020017F000000"},
      {"60A#0131323334353637"},
      {"60A#8238390000000000"},
      {"58A#A2027F0000000000"},
      {"60A#D5C2310000000000", "wrong length, wrong checksum"},
      {"58A#A100000000000000"},
      // One side does not support checksums.
      {"60A#A45020017F000000"},
      {"58A#C250200109000000"},
      {"60A#A300000000000000"},
      {"58A#0131323334353637"},
      {"58A#8238390000000000"},
      {"60A#A2027F0000000000"},
      {"58A#D900000000000000", "wrong length"},  // six unused bytes leave 8 of 9
  });
}

TEST(SdoFollower, MarksBlockSizesAndSequenceNumbersThatThereAreNot) {
  // 1 to 127 segments per block, each with a number from 1 on (CiA 301, 7.2.4.3.9).
  expect_marks({
      {"60A#C250200120000000"},
      {"58A#A050200100000000", "out of range"},
      {"60A#8050200100000405"},
      {"60A#C250200120000000"},
      {"58A#A050200102000000"},
      {"60A#0041424344454647", "out of range"},
      {"60A#0141424344454647"},
      {"60A#0241424344454647"},
      {"60A#0341424344454647", "out of range"},
      {"58A#A204030000000000", "out of range"},
      {"60A#8050200100000405"},
      {"60A#A450200180000000", "out of range"},
  });
}

TEST(SdoFollower, MarksCommandsThatStandForNothing) {
  expect_marks({
      {"60A#E000000000000000", "unknown command"},
      {"60A#4000100000000000"},
      {"58A#E000000000000000", "unknown command"},
      {"60A#C250200120000000"},
      {"58A#A350200102000000", "unknown command"},
  });
}

TEST(SdoFollower, MarksBitsOfTheCommandThatAreAlwaysZero) {
  expect_marks({
      {"60A#5017100000000000", "reserved"},
      {"58A#5B17100032000000", "reserved"},
      {"60A#2E17100032000000", "reserved"},  // unused bytes without a size
      {"58A#6117100000000000", "reserved"},
      {"60A#4008100000000000"},
      {"58A#4108100007000000"},
      {"60A#6100000000000000", "reserved"},
      {"58A#0143616E766F7920"},
      {"60A#8108100000000405", "reserved"},
      {"60A#D050200100000000", "reserved"},
      {"58A#B050200102000000", "reserved"},
      {"60A#8141424344454647"},
      {"58A#A6017F0000000000", "reserved"},
      {"60A#C300000000000000", "reserved"},
      {"58A#A500000000000000", "reserved"},
  });
}

TEST(SdoFollower, MarksWhatNothingCallsFor) {
  expect_marks({
      {"60A#4000100000000000"},
      {"58A#4300100000000000"},
      {"58A#4300100000000000", "out of place"},  // answered twice
      {"60A#6000000000000000", "out of place"},  // no segments are expected
      {"58A#0043616E766F7920", "out of place"},
      {"60A#0043616E766F7920", "out of place"},
      {"58A#2000000000000000", "out of place"},
      {"60A#4000100000000000"},
      {"58A#4301100000000000", "out of place"},  // of another object
      {"60A#2B17100032000000"},
      {"58A#6018100000000000", "out of place"},
      {"60A#2B17100032000000"},
      {"58A#4B17100032000000", "out of place"},  // a value in answer to a write
      {"60A#A300000000000000", "out of place"},
      {"60A#8000000000000405"},
      {"60A#A27F7F0000000000", "out of place"},
      {"60A#C100000000000000", "out of place"},
      {"58A#A100000000000000", "out of place"},
      {"60A#A100000000000000", "out of place"},
      {"58A#C100000000000000", "out of place"},
  });
}

TEST(SdoFollower, MarksNoAnswerToARequestThatWasOvertaken) {
  expect_marks({
      {"60A#4000100000000000"},
      {"60A#4000100000000000"},
      {"60A#4000100000000000"},
      {"58A#4300100000000000"},
      {"58A#4300100000000000"},
      {"58A#4300100000000000"},
      {"58A#4300100000000000", "out of place"},  // the fourth answer
      {"60A#E002000700000000"},                  // the next transfer is with node 7 of network 2
      {"60A#E002000700000000"},
      {"58A#E002000700000000"},
      {"58A#E002000700000000"},
      {"58A#E002000700000000", "out of place"},
      {"60A#E002000700000000"},
      {"60A#E002000700000000"},
      {"60A#2B171000C8000000"},  // of another object; none is answered yet
      {"58A#E002000700000000"},
      {"58A#E002000700000000"},
      {"58A#6017100000000000"},
      {"58A#6017100000000000", "out of place"},
      {"60A#4000100000000000"},
      {"60A#4000100000000000"},
      {"58A#4300100000000000"},
      {"58A#0143616E766F7920", "out of place"},  // not an answer to an initiate request
  });
}

TEST(SdoFollower, MarksASegmentThatDoesNotWaitForTheConfirmation) {
  SdoFollower sut;
  expect_marks(sut, {{"60A#4000100000000000"},
                     {"58A#4300100000000000"},
                     {"60A#2108200007000000"},
                     {"60A#0143616E766F7920", "out of place"}});
  EXPECT_NE(take(sut, parse_frame("58A#2000000000000000").frame).done, nullptr);
}

/// An error in the last bit but one of a frame makes its sender repeat what all have received.
TEST(SdoFollower, TakesASegmentThatTheBusRepeatsOnce) {
  SdoFollower upload;
  expect_marks(upload, {{"60A#4008100000000000"},
                        {"58A#410810000A000000"},
                        {"60A#6000000000000000"},
                        {"58A#0043616E766F7920"},
                        {"58A#0043616E766F7920", "out of place"},
                        {"60A#7000000000000000"}});
  const SdoStep read = take(upload, parse_frame("58A#1942434400000000").frame);
  EXPECT_EQ(text_of(read.marks), "");
  ASSERT_NE(read.done, nullptr);
  EXPECT_EQ(std::string(read.done->bytes.begin(), read.done->bytes.end()), "Canvoy BCD");

  SdoFollower download;
  expect_marks(download, {{"60A#210820000A000000"},
                          {"58A#6008200000000000"},
                          {"60A#0043616E766F7920"},
                          {"60A#0043616E766F7920", "out of place"},
                          {"58A#2000000000000000"},
                          {"60A#1942434400000000"}});
  const SdoStep written = take(download, parse_frame("58A#3000000000000000").frame);
  ASSERT_NE(written.done, nullptr);
  EXPECT_EQ(std::string(written.done->bytes.begin(), written.done->bytes.end()), "Canvoy BCD");
}

TEST(SdoFollower, MarksNothingOfWhatItDidNotHearBegin) {
  for (const std::string_view frame :
       {"60A#7000000000000000", "58A#1043616E766F7920", "60A#1043616E766F7920",
        "58A#3000000000000000", "58A#4300100000000000", "58A#6017100000000000",
        "60A#A300000000000000", "58A#C900000000000000", "60A#A27F7F0000000000",
        "60A#C100000000000000", "58A#A100000000000000", "60A#A100000000000000"}) {
    expect_marks({{frame}});
  }
}

TEST(SdoFollower, DoesNotMissWhatALogOfOneSideLeavesOut) {
  expect_marks({{"58A#4300100000000000"}, {"58A#4300100000000000"}, {"58A#0043616E766F7920"}});
  expect_marks({{"60A#4008100000000000"}, {"60A#6000000000000000"}, {"60A#7000000000000000"}});
}

TEST(SdoFollower, MarksNothingOfANewRequestInTheMiddleOfATransfer) {
  // A client may start again, as it does after a time-out (CiA 301).
  expect_marks({
      {"60A#4008100000000000"},
      {"58A#4108100015000000"},
      {"60A#6000000000000000"},
      {"60A#4000100000000000"},
      {"58A#4300100000000000"},
  });
}

// canopen/remote/remote_access.hpp
TEST(SdoFollower, TellsNothingOfTheServerByWhatADeviceBehindItSays) {
  SdoFollower sut;
  expect_marks(sut, {{"60A#E002000700000000"}, {"58A#E002000700000000"}, {"60A#4000100000000000"}});
  const SdoStep step = take(sut, parse_frame("58A#4300100091010F00").frame);
  EXPECT_EQ(step.done, nullptr);
  EXPECT_EQ(step.behind.network, 2);
  EXPECT_EQ(step.behind.node, 7);
  expect_marks(sut, {{"60A#4000100000000000"}});
  EXPECT_NE(take(sut, parse_frame("58A#4300100091010F00").frame).done, nullptr)
      << "the next one is with the server again";
}

TEST(SdoFollower, WithoutAConfirmationTheTransferIsWithTheServer) {
  SdoFollower sut;
  expect_marks(sut, {{"60A#E002000700000000"}, {"58A#8002000701000405"}, {"60A#4000100000000000"}});
  EXPECT_EQ(take(sut, parse_frame("58A#4300100091010F00").frame).behind.node, 0);
}

TEST(SdoFollower, MarksACommandThatIsNoIndication) {
  for (const std::string_view frame :
       {"60A#E102000700000000", "60A#E002000701000000", "60A#E002008000000000"}) {
    SdoFollower sut;
    expect_marks(sut, {{frame, "unknown command"}});
  }
}

}  // namespace
}  // namespace canvoy::decoder::sdo_follower_test
