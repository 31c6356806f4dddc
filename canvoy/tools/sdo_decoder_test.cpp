#include "canvoy/tools/sdo_decoder.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"

namespace canvoy::tools {
namespace {

/// A frame as candump writes it, from the client (60Ah) or the server (58Ah), and its words.
struct Example {
  std::string_view frame;
  std::string_view text;
};

void expect_words(std::initializer_list<Example> examples) {
  const decoder::Network network;
  SdoDecoder decoder(network);
  for (const Example& example : examples) {
    const ParsedFrame parsed = parse_frame(example.frame);
    ASSERT_TRUE(parsed) << example.frame;
    const bool from_client = parsed.frame.id >= can_id::sdo_request;
    EXPECT_EQ(from_client ? decoder.request(parsed.frame, 10) : decoder.response(parsed.frame, 10),
              example.text)
        << example.frame;
  }
}

TEST(SdoDecoder, FollowsABlockDownload) {
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

TEST(SdoDecoder, FollowsABlockDownloadWithoutSizeAndCrc) {
  expect_words({
      {"60A#C050200100000000", "block download 2050h:01h"},
      {"58A#A050200101000000", "block download 2050h:01h, 1 segments a block"},
  });
}

TEST(SdoDecoder, FollowsABlockUpload) {
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

TEST(SdoDecoder, FollowsSegmentsThatAreSentAgain) {
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

TEST(SdoDecoder, TakesNoSegmentForAMessageWhateverItsFirstByteIs) {
  for (unsigned byte = 0; byte < 256; ++byte) {
    if (byte == 0x80) continue;
    const decoder::Network network;
    SdoDecoder decoder(network);
    decoder.response(parse_frame("58A#A450200102000000").frame, 10);
    Frame frame = parse_frame("60A#0041424344454647").frame;
    frame.data[0] = static_cast<std::uint8_t>(byte);
    const std::string expected = "block segment " + std::to_string(byte % 128);
    EXPECT_EQ(decoder.request(frame, 10).substr(0, expected.size()), expected);
  }
}

TEST(SdoDecoder, EndsABlockTransferByAnAbortOfEitherSide) {
  expect_words({
      {"58A#A450200102000000", "block download 2050h:01h, 2 segments a block, with CRC"},
      {"60A#8050200100000405", "abort 2050h:01h, 05040000h: no answer within the SDO time-out"},
      {"60A#4000200000000000", "read 2000h:00h"},
      {"58A#A450200102000000", "block download 2050h:01h, 2 segments a block, with CRC"},
      {"58A#8050200100000405", "abort 2050h:01h, 05040000h: no answer within the SDO time-out"},
      {"60A#4000200000000000", "read 2000h:00h"},
      {"60A#A300000000000000", "block upload start"},
      {"58A#8050200100000405", "abort 2050h:01h, 05040000h: no answer within the SDO time-out"},
      {"58A#6000200000000000", "2000h:00h written"},
  });
}

TEST(SdoDecoder, BeginsAnewWithANewInitiate) {
  expect_words({
      {"60A#A300000000000000", "block upload start"},
      {"58A#0141424344454647", "block segment 1"},
      {"60A#4000200000000000", "read 2000h:00h"},
      {"58A#4F00200007000000", "2000h:00h = 07"},
  });
}

TEST(SdoDecoder, FollowsTheChannelOfEachNodeApart) {
  const decoder::Network network;
  SdoDecoder decoder(network);
  decoder.request(parse_frame("60A#A300000000000000").frame, 10);
  EXPECT_EQ(decoder.response(parse_frame("58B#6000200000000000").frame, 11), "2000h:00h written");
  EXPECT_EQ(decoder.response(parse_frame("58A#6000200000000000").frame, 10), "block segment 96");
}

}  // namespace
}  // namespace canvoy::tools
