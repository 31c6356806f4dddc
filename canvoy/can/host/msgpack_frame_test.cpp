#include "canvoy/can/host/msgpack_frame.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace canvoy::host::msgpack_frame_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes from_hex(std::string_view hex) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(
        static_cast<std::uint8_t>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
  }
  return bytes;
}

Bytes encoded(const Frame& frame, double timestamp) {
  const MsgpackFrame message(frame, timestamp);
  return {message.bytes().begin(), message.bytes().end()};
}

Bytes text(std::string_view characters) {
  return {characters.begin(), characters.end()};
}

Bytes key(std::string_view name) {
  Bytes bytes{static_cast<std::uint8_t>(0xA0 + name.size())};
  bytes.insert(bytes.end(), name.begin(), name.end());
  return bytes;
}

// A map of the given parts, each a key with its value.
Bytes map(std::initializer_list<std::pair<std::string_view, Bytes>> entries) {
  Bytes bytes{static_cast<std::uint8_t>(0x80 + entries.size())};
  for (const auto& [name, value] : entries) {
    const Bytes name_bytes = key(name);
    bytes.insert(bytes.end(), name_bytes.begin(), name_bytes.end());
    bytes.insert(bytes.end(), value.begin(), value.end());
  }
  return bytes;
}

const Bytes yes{0xC3};
const Bytes no{0xC2};

FrameKind kind_of(const Bytes& bytes) {
  return decode_msgpack_frame(bytes).kind;
}

// Results of pack_message() of python3-can 4.1.0 with python3-msgpack 1.0.3 for the frames in the
// names.
constexpr std::string_view peer_185_1e2f =
    "8ba974696d657374616d70cb41d954fc4000020cae6172626974726174696f6e5f6964cd0185ae69735f657874656e"
    "6465645f6964"
    "c2af69735f72656d6f74655f6672616d65c2ae69735f6572726f725f6672616d65c2a76368616e6e656cc0a3646c63"
    "02a464617461"
    "c4021e2fa569735f6664c2ae626974726174655f737769746368c2b56572726f725f73746174655f696e6469636174"
    "6f72c2";
constexpr std::string_view peer_18ff1234 =
    "8ba974696d657374616d70cb3ff8000000000000ae6172626974726174696f6e5f6964ce18ff1234ae69735f657874"
    "656e6465645f"
    "6964c3af69735f72656d6f74655f6672616d65c2ae69735f6572726f725f6672616d65c2a76368616e6e656cc0a364"
    "6c6308a46461"
    "7461c4080102030405060708a569735f6664c2ae626974726174655f737769746368c2b56572726f725f7374617465"
    "5f696e646963"
    "61746f72c2";
constexpr std::string_view peer_701_remote =
    "8ba974696d657374616d70cb0000000000000000ae6172626974726174696f6e5f6964cd0701ae69735f657874656e"
    "6465645f6964"
    "c2af69735f72656d6f74655f6672616d65c3ae69735f6572726f725f6672616d65c2a76368616e6e656cc0a3646c63"
    "08a464617461"
    "c400a569735f6664c2ae626974726174655f737769746368c2b56572726f725f73746174655f696e64696361746f72"
    "c2";
constexpr std::string_view peer_error =
    "8ba974696d657374616d70cb0000000000000000ae6172626974726174696f6e5f696404ae69735f657874656e6465"
    "645f6964c3af"
    "69735f72656d6f74655f6672616d65c2ae69735f6572726f725f6672616d65c3a76368616e6e656cc0a3646c6308a4"
    "64617461c408"
    "0004000000000000a569735f6664c2ae626974726174655f737769746368c2b56572726f725f73746174655f696e64"
    "696361746f72"
    "c2";
constexpr std::string_view peer_fd =
    "8ba974696d657374616d70cb0000000000000000ae6172626974726174696f6e5f6964cd0123ae69735f657874656e"
    "6465645f6964"
    "c2af69735f72656d6f74655f6672616d65c2ae69735f6572726f725f6672616d65c2a76368616e6e656cc0a3646c63"
    "0ca464617461"
    "c40c000000000000000000000000a569735f6664c3ae626974726174655f737769746368c2b56572726f725f737461"
    "74655f696e64"
    "696361746f72c2";

TEST(MsgpackFrame, IsByteForByteWhatPythonCanSends) {
  EXPECT_EQ(encoded(Frame::data_frame(0x185, {0x1E, 0x2F}), 1700000000.000125),
            from_hex(peer_185_1e2f));
  EXPECT_EQ(encoded(Frame::data_frame(0x18FF1234, {1, 2, 3, 4, 5, 6, 7, 8}), 1.5),
            from_hex(peer_18ff1234));
  EXPECT_EQ(encoded(Frame::remote_frame(0x701, 8), 0.0), from_hex(peer_701_remote));
}

TEST(DecodeMsgpackFrame, ReadsWhatPythonCanSends) {
  EXPECT_EQ(decode_msgpack_frame(from_hex(peer_185_1e2f)).frame,
            Frame::data_frame(0x185, {0x1E, 0x2F}));
  EXPECT_EQ(decode_msgpack_frame(from_hex(peer_18ff1234)).frame,
            Frame::data_frame(0x18FF1234, {1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(decode_msgpack_frame(from_hex(peer_701_remote)).frame, Frame::remote_frame(0x701, 8));
}

TEST(DecodeMsgpackFrame, AnErrorFrameKeepsItsClass) {
  const DecodedFrame decoded = decode_msgpack_frame(from_hex(peer_error));
  EXPECT_EQ(decoded.kind, FrameKind::classic);
  EXPECT_TRUE(decoded.frame.is_error());
  EXPECT_EQ(decoded.frame.id, 4U);
}

TEST(DecodeMsgpackFrame, ACanFdFrameIsKnownAsSuch) {
  EXPECT_EQ(kind_of(from_hex(peer_fd)), FrameKind::fd);
}

TEST(DecodeMsgpackFrame, IdentifierAndItsWidthAreEnoughAndTheOrderIsFree) {
  const DecodedFrame decoded =
      decode_msgpack_frame(map({{"is_extended_id", no}, {"arbitration_id", {0x10}}}));
  EXPECT_EQ(decoded.kind, FrameKind::classic);
  EXPECT_EQ(decoded.frame, Frame::data_frame(0x10, {}));
}

TEST(DecodeMsgpackFrame, NumbersMayBeLongerThanTheyNeedToBe) {
  for (const Bytes& number : {Bytes{0xCC, 0x10}, Bytes{0xCD, 0, 0x10}, Bytes{0xCE, 0, 0, 0, 0x10},
                              Bytes{0xCF, 0, 0, 0, 0, 0, 0, 0, 0x10}}) {
    EXPECT_EQ(decode_msgpack_frame(map({{"is_extended_id", no}, {"arbitration_id", number}})).frame,
              Frame::data_frame(0x10, {}));
  }
}

TEST(DecodeMsgpackFrame, TimeStampAndChannelMayHaveAnyOfTheirTypes) {
  const std::initializer_list<Bytes> channels{{0xC0}, {0x05}, {0xA1, 'x'}, {0xD9, 1, 'x'}};
  for (const Bytes& channel : channels) {
    EXPECT_EQ(kind_of(map({{"is_extended_id", no}, {"arbitration_id", {1}}, {"channel", channel}})),
              FrameKind::classic);
  }
  const std::initializer_list<Bytes> stamps{
      {0xCA, 0, 0, 0, 0}, {0xCB, 0, 0, 0, 0, 0, 0, 0, 0}, {0x07}};
  for (const Bytes& stamp : stamps) {
    EXPECT_EQ(kind_of(map({{"is_extended_id", no}, {"arbitration_id", {1}}, {"timestamp", stamp}})),
              FrameKind::classic);
  }
}

TEST(DecodeMsgpackFrame, WithoutIdentifierOrWidthItIsMalformed) {
  EXPECT_EQ(kind_of(map({{"arbitration_id", {1}}})), FrameKind::malformed);
  EXPECT_EQ(kind_of(map({{"is_extended_id", no}})), FrameKind::malformed);
}

TEST(DecodeMsgpackFrame, AnIdentifierOutOfRangeIsMalformed) {
  EXPECT_EQ(kind_of(map({{"is_extended_id", no}, {"arbitration_id", {0xCD, 0x08, 0x00}}})),
            FrameKind::malformed);
  EXPECT_EQ(kind_of(map({{"is_extended_id", yes}, {"arbitration_id", {0xCE, 0x20, 0, 0, 0}}})),
            FrameKind::malformed);
  EXPECT_EQ(kind_of(map({{"is_extended_id", no}, {"arbitration_id", {0xFF}}})),
            FrameKind::malformed);
}

TEST(DecodeMsgpackFrame, ALengthThatDisagreesWithTheDataIsMalformed) {
  const Bytes two_bytes{0xC4, 2, 0xAA, 0xBB};
  EXPECT_EQ(
      kind_of(map(
          {{"is_extended_id", no}, {"arbitration_id", {1}}, {"dlc", {2}}, {"data", two_bytes}})),
      FrameKind::classic);
  EXPECT_EQ(
      kind_of(map(
          {{"is_extended_id", no}, {"arbitration_id", {1}}, {"dlc", {3}}, {"data", two_bytes}})),
      FrameKind::malformed);
}

TEST(DecodeMsgpackFrame, NineBytesAreTooManyForAClassicFrameAndSixtyFiveForFd) {
  Bytes nine{0xC4, 9};
  nine.resize(2 + 9);
  EXPECT_EQ(kind_of(map({{"is_extended_id", no}, {"arbitration_id", {1}}, {"data", nine}})),
            FrameKind::malformed);
  Bytes many{0xC4, 65};
  many.resize(2 + 65);
  EXPECT_EQ(kind_of(map(
                {{"is_extended_id", no}, {"arbitration_id", {1}}, {"data", many}, {"is_fd", yes}})),
            FrameKind::malformed);
}

TEST(DecodeMsgpackFrame, ARemoteFrameWithDataOrAboveEightIsMalformed) {
  const Bytes one_byte{0xC4, 1, 0xAA};
  EXPECT_EQ(kind_of(map({{"is_extended_id", no},
                         {"arbitration_id", {1}},
                         {"is_remote_frame", yes},
                         {"dlc", {1}},
                         {"data", one_byte}})),
            FrameKind::malformed);
  EXPECT_EQ(kind_of(map({{"is_extended_id", no},
                         {"arbitration_id", {1}},
                         {"is_remote_frame", yes},
                         {"dlc", {9}}})),
            FrameKind::malformed);
}

TEST(DecodeMsgpackFrame, AnUnknownKeyADoubleOneAndOneThatIsNoTextAreMalformed) {
  EXPECT_EQ(kind_of(map({{"is_extended_id", no}, {"arbitration_id", {1}}, {"colour", {1}}})),
            FrameKind::malformed);
  EXPECT_EQ(
      kind_of(map({{"is_extended_id", no}, {"arbitration_id", {1}}, {"arbitration_id", {1}}})),
      FrameKind::malformed);
  EXPECT_EQ(kind_of({0x81, 0x01, 0x01}), FrameKind::malformed);
}

TEST(DecodeMsgpackFrame, AValueOfAnotherTypeIsMalformed) {
  EXPECT_EQ(kind_of(map({{"is_extended_id", {0x00}}, {"arbitration_id", {1}}})),
            FrameKind::malformed);
  EXPECT_EQ(kind_of(map({{"is_extended_id", no}, {"arbitration_id", {0xA1, '1'}}})),
            FrameKind::malformed);
  EXPECT_EQ(kind_of(map({{"is_extended_id", no}, {"arbitration_id", {1}}, {"data", {0xA1, '1'}}})),
            FrameKind::malformed);
  EXPECT_EQ(kind_of(map({{"is_extended_id", no}, {"arbitration_id", {1}}, {"timestamp", {0xC0}}})),
            FrameKind::malformed);
  EXPECT_EQ(kind_of(map({{"is_extended_id", no}, {"arbitration_id", {1}}, {"channel", {0xC3}}})),
            FrameKind::malformed);
}

TEST(DecodeMsgpackFrame, WhatIsNoMapIsMalformed) {
  EXPECT_EQ(kind_of({}), FrameKind::malformed);
  EXPECT_EQ(kind_of({0xC0}), FrameKind::malformed);
  EXPECT_EQ(kind_of({0x91, 0x80}), FrameKind::malformed);
  EXPECT_EQ(kind_of(text("hello")), FrameKind::malformed);
}

TEST(DecodeMsgpackFrame, CutOffAnywhereOrWithSomethingBehindItIsMalformed) {
  Bytes whole = from_hex(peer_185_1e2f);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_EQ(kind_of(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))),
              FrameKind::malformed);
  }
  whole.push_back(0xC0);
  EXPECT_EQ(kind_of(whole), FrameKind::malformed);
}

RC_GTEST_PROP(MsgpackFrame, AnyFrameIsReadBackAsItWasWritten, ()) {
  const auto wide = *rc::gen::arbitrary<bool>();
  const auto id = *rc::gen::inRange<std::uint32_t>(0, wide ? 0x2000'0000 : 0x800);
  const auto data = *rc::gen::container<Bytes>(*rc::gen::inRange<std::size_t>(0, 9),
                                               rc::gen::arbitrary<std::uint8_t>());
  Frame frame = Frame::data_frame(id, data);
  if (*rc::gen::arbitrary<bool>()) frame = Frame::remote_frame(id, frame.length);
  if (wide) frame.flags = frame.flags | FrameFlags::extended;
  const DecodedFrame decoded = decode_msgpack_frame(encoded(frame, *rc::gen::arbitrary<double>()));
  RC_ASSERT(decoded.kind == FrameKind::classic);
  RC_ASSERT(decoded.frame == frame);
}

}  // namespace
}  // namespace canvoy::host::msgpack_frame_test
