#include "canvoy/text/frame_decoder.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/object_words.hpp"

namespace canvoy::text::frame_decoder_test {
namespace {

/// A frame in the format of candump, and its words: service, node, text.
struct Example {
  std::string_view frame;
  std::string_view service;
  NodeId node;
  std::string_view text;
};

void expect_words(FrameDecoder& decoder, const Example& example) {
  const ParsedFrame parsed = parse_frame(example.frame);
  ASSERT_TRUE(parsed) << example.frame;
  const FrameWords& words = decoder.decode(parsed.frame);
  EXPECT_EQ(words.service, example.service) << example.frame;
  EXPECT_EQ(words.node, example.node) << example.frame;
  EXPECT_EQ(words.text, example.text) << example.frame;
}

void expect_words(std::initializer_list<Example> examples) {
  FrameDecoder decoder;
  for (const Example& example : examples) expect_words(decoder, example);
}

TEST(FrameDecoder, NamesTheServicesOfThePredefinedConnectionSet) {
  expect_words({
      {"000#010A", "NMT", 0, "start node 10 (0Ah)"},
      {"000#8200", "NMT", 0, "reset communication of all nodes"},
      {"000#420A", "NMT", 0, "unknown command 42h"},
      {"080#", "SYNC", 0, ""},
      {"080#07", "SYNC", 0, "counter 7"},
      {"100#000000000000", "TIME", 0, "1984-01-01 00:00:00.000"},
      {"100#002E9302313D", "TIME", 0, "2026-11-21 12:00:00.000"},
      {"100#FF5B2605FFFF", "TIME", 0, "2163-06-06 23:59:59.999"},
      {"18A#01", "TPDO1", 10, "01"},
      {"205#01", "RPDO1", 5, "01"},
      {"4FF#", "TPDO4", 127, ""},
      {"57F#02", "RPDO4", 127, "02"},
      {"70A#00", "boot-up", 10, ""},
      {"70A#05", "heartbeat", 10, "operational"},
      {"70A#84", "heartbeat", 10, "stopped"},
      {"70A#R1", "guarding request", 10, ""},
      {"7E5#5E00000000000000", "LSS", 0, "inquire node-ID"},
      {"6E0#", "SDO manager", 0, "dynamic SDO request"},
      {"071#", "flying master", 0, "active NMT master"},
      {"071#0205", "flying master", 0, "the active NMT master is node 5 (05h), priority 2"},
      {"072#0105", "flying master", 0, "negotiation of the NMT master: 01 05"},
      {"076#", "flying master", 0, "force a negotiation"},
      {"070#", "other", 0, ""},
      {"077#", "other", 0, ""},
  });
}

TEST(FrameDecoder, TellsAnAnswerToAGuardingRequestFromAHeartbeat) {
  expect_words({
      {"70A#7F", "heartbeat", 10, "pre-operational"},
      {"70A#R1", "guarding request", 10, ""},
      {"70B#7F", "heartbeat", 11, "pre-operational"},
      {"70A#7F", "guarding answer", 10, "pre-operational, toggle bit 0"},
      {"70A#R", "guarding request", 10, ""},
      {"70A#85", "guarding answer", 10, "operational, toggle bit 1"},
      {"70A#05", "heartbeat", 10, "operational"},
      {"70A#R1", "guarding request", 10, ""},
      {"70A#00", "boot-up", 10, ""},
  });
}

TEST(FrameDecoder, MarksAToggleBitOfNodeGuardingThatDoesNotAlternate) {
  // 0 in the first answer after boot-up, then 1, 0, 1 ... (CiA 301, 7.2.8.3.2.1).
  FrameDecoder decoder;
  const auto marks = [&decoder](std::string_view answer) {
    decoder.decode(parse_frame("70A#R1").frame);
    return marks_text(decoder.decode(parse_frame(answer).frame).marks);
  };
  EXPECT_EQ(marks("70A#85"), "") << "what was before is not known";
  EXPECT_EQ(marks("70A#05"), "");
  EXPECT_EQ(marks("70A#85"), "");
  EXPECT_EQ(marks("70A#85"), "wrong toggle bit");
  EXPECT_EQ(marks("70A#05"), "") << "it counts from the answer that came";
  EXPECT_EQ(marks("70B#05"), "") << "each node has its own";
  decoder.decode(parse_frame("70A#00").frame);
  EXPECT_EQ(marks("70A#FF"), "wrong toggle bit") << "the first after boot-up";
  EXPECT_EQ(marks("70A#7F"), "");
  EXPECT_EQ(marks_text(decoder.decode(parse_frame("70A#05").frame).marks), "") << "a heartbeat";
}

TEST(FrameDecoder, NamesWhatASegmentOfAnSdoBelongsTo) {
  expect_words({
      {"60A#6000000000000000", "SDO request", 10, "read a segment"},
      {"58A#0043616E766F7920", "SDO response", 10, "segment"},
      {"60A#0043616E766F7920", "SDO request", 10, "write a segment"},
      {"58A#2000000000000000", "SDO response", 10, "segment written"},
      {"60A#E000000000000000", "SDO request", 10, "unknown command"},
  });
}

TEST(FrameDecoder, MarksWhatIsAgainstTheProtocolOfSdo) {
  FrameDecoder decoder;
  const auto marks = [&decoder](std::string_view frame) {
    return marks_text(decoder.decode(parse_frame(frame).frame).marks);
  };
  EXPECT_EQ(marks("60A#E000000000000000"), "unknown command");
  EXPECT_EQ(marks("60A#4008100000000000"), "");
  EXPECT_EQ(marks("58A#4108100008000000"), "");
  EXPECT_EQ(marks("60A#7000000000000000"), "wrong toggle bit");
  EXPECT_EQ(marks("58A#1143616E766F7921"), "wrong length") << "7 bytes of 8";
  EXPECT_EQ(marks("58A#1143616E766F7921"), "out of place") << "nobody has asked";
}

TEST(FrameDecoder, KnowsTheObjectsOfANodeOfWhichTheDeviceTypeWasRead) {
  FrameDecoder decoder;
  expect_words(decoder, {"60A#4010600000000000", "SDO request", 10, "read 6010h:00h"});
  decoder.decode(parse_frame("58A#43001000A2010000").frame);
  expect_words(decoder, {"60A#4010600000000000", "SDO request", 10, "read 6010h:00h temperature"});
  expect_words(decoder,
               {"58A#4B106000A0000000", "SDO response", 10, "6010h:00h temperature = 20.000 °C"});
  expect_words(decoder, {"605#4010600000000000", "SDO request", 5, "read 6010h:00h"});
}

TEST(FrameDecoder, TellsFramesOfAWrongLength) {
  expect_words({
      {"000#01", "NMT", 0, "malformed: 01"},
      {"60A#40", "SDO request", 10, "malformed: 40"},
      {"58A#40", "SDO response", 10, "malformed: 40"},
      {"08A#1082", "EMCY", 10, "malformed: 10 82"},
      {"100#0000", "TIME", 0, "malformed: 00 00"},
      {"100#005C26050000", "TIME", 0, "malformed: 00 5C 26 05 00 00"},
      {"7E5#04", "LSS", 0, "malformed: 04"},
      {"7E4#", "LSS", 0, "malformed: "},
      {"70A#0505", "error control", 10, "malformed: 05 05"},
  });
}

TEST(FrameDecoder, TakesNoCommandFromARemoteFrame) {
  expect_words({
      {"000#R2", "NMT", 0, "remote request"},
      {"60A#R8", "SDO request", 10, "remote request"},
      {"28A#R7", "TPDO2", 10, "remote request"},
  });
}

TEST(FrameDecoder, HasANameForEveryFrameThereIs) {
  FrameDecoder decoder;
  for (const int byte : {0x00, 0xA3}) {
    const auto fill = static_cast<std::uint8_t>(byte);
    for (std::uint32_t what = 0; what < 0x800 * 9 * 2; ++what) {
      Frame frame = Frame::data_frame(
          what / 18, std::array<std::uint8_t, 8>{fill, fill, fill, fill, fill, fill, fill, fill});
      frame.length = static_cast<std::uint8_t>(what % 9);
      if (what / 9 % 2 != 0) frame = Frame::remote_frame(frame.id, frame.length);
      ASSERT_FALSE(decoder.decode(frame).service.empty()) << what;
    }
  }
}

TEST(FrameDecoder, FollowsAnySequenceOfSdoAndLssMessages) {
  FrameDecoder decoder;
  for (const std::uint32_t id : {0x60AU, 0x58AU, 0x7E4U, 0x7E5U}) {
    for (const std::uint32_t next : {0x60AU, 0x58AU}) {
      for (unsigned bytes = 0; bytes < 0x10000; bytes += 61) {
        Frame frame =
            Frame::data_frame(id, {static_cast<std::uint8_t>(bytes >> 8), 1, 2, 3, 4, 5, 6, 7});
        EXPECT_FALSE(decoder.decode(frame).text.empty());
        frame = Frame::data_frame(next, {static_cast<std::uint8_t>(bytes), 1, 2, 3, 4, 5, 6, 7});
        EXPECT_FALSE(decoder.decode(frame).text.empty());
      }
    }
  }
}

TEST(FrameDecoder, NamesTheSleepMessagesOfACar) {
  FrameDecoder decoder;
  expect_words(decoder, {"691#01FE000000000000", "other", 0, "01 FE 00 00 00 00 00 00"});
  decoder.network().set_profile(2, *find_profile("447-3"));
  for (const Example& example : std::initializer_list<Example>{
           {"691#01FE000000000000", "sleep", 1, "does anybody object to sleep?"},
           {"692#8105000000000000", "sleep", 2, "objection to sleep, reason 05h"},
           {"6A0#81FE000000000000", "sleep", 16, "objection to sleep, no reason"},
           {"691#0200000000000000", "sleep", 1, "go to sleep"},
           {"692#0300000000000000", "sleep", 2, "request for sleep"},
           {"691#8200000000000000", "sleep", 1, "wake-up"},
           {"690#8200000000000000", "sleep", 0, "wake-up"},
           {"690#8100000000000000", "sleep", 0, "wake-up by a device without a node-ID"},
           {"692#7700000000000000", "sleep", 2, "unknown command 77h"},
           {"692#81", "sleep", 2, "malformed: 81"},
           {"6A1#8200000000000000", "other", 0, "82 00 00 00 00 00 00 00"},
           {"68F#8200000000000000", "other", 0, "82 00 00 00 00 00 00 00"},
       }) {
    expect_words(decoder, example);
  }
}

TEST(FrameDecoder, NamesTheDiagnosisOfACar) {
  FrameDecoder decoder;
  decoder.network().set_profile(2, *find_profile("447-3"));
  // 251h is the CAN-ID of an SDO of node 2 with itself, 57Fh that of node 16 (CiA 447-4); ISO
  // 15765-2 defines the first byte.
  for (const Example& example : std::initializer_list<Example>{
           {"251#021003", "ISO-TP", 2, "single frame, 2 bytes: 10 03"},
           {"57F#1014620102030405", "ISO-TP", 16, "first frame of 20 bytes: 62 01 02 03 04 05"},
           {"57F#2106070809", "ISO-TP", 16, "consecutive frame 1: 06 07 08 09"},
           {"344#300000", "ISO-TP", 5, "flow control, continue"},
           {"344#3F", "ISO-TP", 5, "flow control, unknown"},
           {"344#", "ISO-TP", 5, "empty"},
           {"344#10", "ISO-TP", 5, "unknown: 10"},
           {"344#0F01", "ISO-TP", 5, "single frame, 15 bytes: 01"},
       }) {
    expect_words(decoder, example);
  }
}

TEST(FrameDecoder, MarksWhatNoServiceAllows) {
  FrameDecoder decoder;
  decoder.network().set_profile(2, *find_profile("447-3"));
  const auto marks = [&decoder](std::string_view text) {
    return marks_text(decoder.decode(parse_frame(text).frame).marks);
  };
  EXPECT_EQ(marks("080#01"), "");
  EXPECT_EQ(marks("080#F0"), "");
  // 1 to 240 (CiA 301, 7.2.5).
  EXPECT_EQ(marks("080#00"), "out of range");
  EXPECT_EQ(marks("080#F1"), "out of range");
  EXPECT_EQ(marks("080#0102"), "wrong length");
  EXPECT_EQ(marks("000#010A00"), "wrong length");
  EXPECT_EQ(marks("100#005C26050000"), "out of range");
  EXPECT_EQ(marks("100#0000"), "wrong length");
  EXPECT_EQ(marks("08A#1082"), "wrong length");
  // Bit 6 of the error register is reserved (CiA 301, 7.5.2.2).
  EXPECT_EQ(marks("08A#1082400000000000"), "reserved");
  EXPECT_EQ(marks("08A#1082BF0000000000"), "");
  EXPECT_EQ(marks("70A#05"), "");
  EXPECT_EQ(marks("70A#06"), "reserved");
  EXPECT_EQ(marks("70A#0505"), "wrong length");
  EXPECT_EQ(marks("7E5#04"), "wrong length");
  EXPECT_EQ(marks("60A#40"), "wrong length");
  EXPECT_EQ(marks("691#0100000000000000"), "");
  EXPECT_EQ(marks("691#0100000100000000"), "reserved");
}

TEST(FrameDecoder, SaysWhichBitsOfTheErrorRegisterAreSet) {
  expect_words({
      {"08A#0000000000000000", "EMCY", 10,
       "0000h error reset or no error, error register 00h, 00 00 00 00 00"},
      {"08A#1082110000000000", "EMCY", 10,
       "8210h PDO not processed: too short, error register 11h (generic, communication), 00 00 00 "
       "00 00"},
  });
}

TEST(FrameDecoder, FollowsEachChannelOfSdoApart) {
  FrameDecoder decoder;
  decoder.decode(parse_frame("60A#A300000000000000").frame);
  expect_words(decoder, {"58B#6000200000000000", "SDO response", 11, "2000h:00h written"});
  expect_words(decoder, {"58A#6000200000000000", "SDO response", 10, "block segment 96"});
}

TEST(FrameDecoder, SaysOfWhichProfileANodeIsWhenItIsLearned) {
  FrameDecoder decoder;
  EXPECT_EQ(decoder.decode(parse_frame("58A#43001000A2010000").frame).news,
            "node 10 (0Ah) is of CiA 418");
  EXPECT_EQ(decoder.decode(parse_frame("58A#43001000A2010000").frame).news, "");
}

TEST(FrameDecoder, NamesNothingThatIsOfNoService) {
  expect_words({
      {"0000060A#4000100000000000", "29-bit frame", 0, ""},
      {"001#01", "other", 0, "01"},
      {"123#0102", "other", 0, "01 02"},
      {"180#01", "other", 0, "01"},
      {"6FF#01", "other", 0, "01"},
      {"7FF#01", "other", 0, "01"},
  });
}

}  // namespace
}  // namespace canvoy::text::frame_decoder_test
