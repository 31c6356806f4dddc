#include "canvoy/text/sdo_words.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::text::sdo_words_test {
namespace {

/// A frame in the format of candump, from the client (60Ah) or the server (58Ah), and its words.
struct Example {
  std::string_view frame;
  std::string_view text;
};

std::string words(decoder::SdoFollower& channel, const Frame& frame) {
  const bool from_client = frame.id >= can_id::sdo_request;
  const decoder::SdoStep step = from_client ? channel.request(frame) : channel.response(frame);
  std::string text;
  decoder::Network network;
  network.set_profile(10, *find_profile("852"));
  SdoWords().append(text, step.message, frame, network, 10, step.behind);
  return text;
}

void expect_words(std::initializer_list<Example> examples) {
  decoder::SdoFollower channel;
  for (const Example& example : examples) {
    const ParsedFrame parsed = parse_frame(example.frame);
    ASSERT_TRUE(parsed) << example.frame;
    EXPECT_EQ(words(channel, parsed.frame), example.text) << example.frame;
  }
}

TEST(SdoWords, PutNumbersIntoTheNamesOfObjectsAndEntries) {
  // 6762h has input_group_1 to input_group_4 (CiA 407, 9.2.28.3); 6100h to 611Fh are the groups 1
  // to 32, 0800h higher for the second lift (CiA 417-4, 4.3.1).
  SdoWords sut;
  decoder::Network network;
  network.set_profile(10, *find_profile("407"));
  network.set_profile(11, *find_profile("417-4"));
  std::string text;
  sut.append(text, decoder::SdoMessage::read, parse_frame("60A#4062670300000000").frame, network,
             10);
  EXPECT_EQ(text, "read 6762h:03h analogue_input, input_group_3");
  text.clear();
  sut.append(text, decoder::SdoMessage::written, parse_frame("58B#6004690500000000").frame, network,
             11);
  EXPECT_EQ(text, "6904h:05h Input group 5, Virtual input 5 written");
}

// canopen/remote/remote_access.hpp: the indication, and the transfer after it.
TEST(SdoWords, SayWhichDeviceBehindTheServerATransferIsWith) {
  expect_words({
      {"60A#E002000700000000", "node 7 (07h) of network 2: the next transfer"},
      {"58A#E002000700000000", "node 7 (07h) of network 2: the next transfer"},
      {"60A#4000600100000000", "node 7 (07h) of network 2: read 6000h:01h"},
      {"58A#4F00600101000000", "node 7 (07h) of network 2: 6000h:01h = 01"},
      {"60A#4000600100000000", "read 6000h:01h Read input 8-bit, Joystick 1: Memory function"},
  });
}

TEST(SdoWords, FollowsABlockDownload) {
  expect_words({
      {"60A#C650200113000000", "block download 2050h:01h, 19 bytes, with CRC"},
      {"58A#A450200102000000", "block download 2050h:01h, 2 segments a block, with CRC"},
      {"60A#0141424344454647", "block segment 1"},
      {"60A#0248494A4B4C4D4E", "block segment 2"},
      {"58A#A2027F0000000000", "block download, got segments up to 2, then 127 segments a block"},
      {"60A#814F505152530000", "block segment 1, the last"},
      {"58A#A2017F0000000000", "block download, got segments up to 1, then 127 segments a block"},
      {"60A#C934120000000000", "block download end, CRC 1234h, last segment of 5 bytes"},
      {"58A#A100000000000000", "block download done"},
      {"60A#4000100000000000", "read 1000h:00h Device type"},
  });
}

TEST(SdoWords, FollowsABlockDownloadWithoutSizeAndCrc) {
  expect_words({
      {"60A#C050200100000000", "block download 2050h:01h"},
      {"58A#A050200101000000", "block download 2050h:01h, 1 segments a block"},
  });
}

TEST(SdoWords, FollowsABlockUpload) {
  expect_words({
      {"60A#A45020017F150000",
       "block upload 2050h:01h, 127 segments a block, segmented up to 21 bytes, with CRC"},
      {"58A#C650200113000000", "block upload 2050h:01h, 19 bytes, with CRC"},
      {"60A#A300000000000000", "block upload start"},
      {"58A#0141424344454647", "block segment 1"},
      {"58A#0248494A4B4C4D4E", "block segment 2"},
      {"58A#834F505152530000", "block segment 3, the last"},
      {"60A#A2037F0000000000", "block upload, got segments up to 3, then 127 segments a block"},
      {"58A#C934120000000000", "block upload end, CRC 1234h, last segment of 5 bytes"},
      {"60A#A100000000000000", "block upload done"},
      {"58A#6000200000000000", "2000h:00h written"},
  });
}

TEST(SdoWords, FollowsSegmentsThatAreSentAgain) {
  expect_words({
      {"60A#A300000000000000", "block upload start"},
      {"58A#0141424344454647", "block segment 1"},
      {"58A#8248494A4B4C4D4E", "block segment 2, the last"},
      {"60A#A2017F0000000000", "block upload, got segments up to 1, then 127 segments a block"},
      {"58A#8148494A4B4C4D4E", "block segment 1, the last"},
      {"60A#A2017F0000000000", "block upload, got segments up to 1, then 127 segments a block"},
      {"58A#C134120000000000", "block upload end, CRC 1234h, last segment of 7 bytes"},
  });
}

TEST(SdoWords, TakesNoSegmentForAMessageWhateverItsFirstByteIs) {
  for (unsigned byte = 0; byte < 256; ++byte) {
    if (byte == 0x80) continue;
    decoder::SdoFollower channel;
    channel.response(parse_frame("58A#A450200102000000").frame);
    Frame frame = parse_frame("60A#0041424344454647").frame;
    frame.data[0] = static_cast<std::uint8_t>(byte);
    const std::string expected = "block segment " + std::to_string(byte % 128);
    EXPECT_EQ(words(channel, frame).substr(0, expected.size()), expected);
  }
}

TEST(SdoWords, EndsABlockTransferByAnAbortOfEitherSide) {
  expect_words({
      {"58A#A450200102000000", "block download 2050h:01h, 2 segments a block, with CRC"},
      {"60A#8050200100000405", "abort 2050h:01h, 05040000h: SDO time-out"},
      {"60A#4000200000000000", "read 2000h:00h"},
      {"58A#A450200102000000", "block download 2050h:01h, 2 segments a block, with CRC"},
      {"58A#8050200100000405", "abort 2050h:01h, 05040000h: SDO time-out"},
      {"60A#4000200000000000", "read 2000h:00h"},
      {"60A#A300000000000000", "block upload start"},
      {"58A#8050200100000405", "abort 2050h:01h, 05040000h: SDO time-out"},
      {"58A#6000200000000000", "2000h:00h written"},
  });
}

TEST(SdoWords, BeginsAnewWithANewInitiate) {
  expect_words({
      {"60A#A300000000000000", "block upload start"},
      {"58A#0141424344454647", "block segment 1"},
      {"60A#4000200000000000", "read 2000h:00h"},
      {"58A#4F00200007000000", "2000h:00h = 07"},
  });
}

}  // namespace
}  // namespace canvoy::text::sdo_words_test
