#include "canvoy/decoder/decoder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder::decoder_test {
namespace {

using testing::ElementsAre;

Decoded::Service service_of(Decoder& sut, std::string_view frame) {
  return sut.decode(parse_frame(frame).frame).service;
}
const Decoded& decode(Decoder& sut, std::string_view frame) {
  return sut.decode(parse_frame(frame).frame);
}
void feed(Decoder& sut, std::initializer_list<std::string_view> frames) {
  for (const std::string_view frame : frames) decode(sut, frame);
}
std::vector<unsigned> indices(const Decoded& decoded) {
  std::vector<unsigned> found;
  for (const DecodedValue& value : decoded.values) found.push_back(value.index);
  return found;
}
std::vector<unsigned> bytes_of(const DecodedValue& value) {
  return {value.bytes().begin(), value.bytes().end()};
}

TEST(Decoder, KnowsNothingOfAPdoBeforeAnythingWasHeardOfItsNode) {
  Decoder sut;
  EXPECT_EQ(service_of(sut, "18A#01"), Decoded::Service::other);
  EXPECT_EQ(sut.network().pdo(0x18A), nullptr);
}

TEST(Decoder, LearnsTheProfileOfANodeFromItsDeviceType) {
  Decoder sut;
  feed(sut, {"60A#4000100000000000", "58A#43001000A3010000"});
  EXPECT_EQ(sut.network().profile(10).number, 419);
  EXPECT_EQ(sut.network().profile(11).number, base_profile().number);
}

TEST(Decoder, TakesWhatAUserSaysForGiven) {
  Decoder sut;
  sut.network().set_profile(10, *find_profile("419"));
  feed(sut, {"58A#43001000A2010000"});
  EXPECT_EQ(sut.network().profile(10).number, 419);
}

TEST(Decoder, TakesThePdosOfTheProfileApart) {
  Decoder sut;
  sut.network().set_profile(10, *find_profile("419"));
  // TPDO2 is the charger status and the charge returned (CiA 419, 6.2.6.3).
  const Decoded& decoded = decode(sut, "28A#011002");
  EXPECT_EQ(decoded.service, Decoded::Service::pdo);
  EXPECT_EQ(decoded.node, 10);
  EXPECT_THAT(indices(decoded), ElementsAre(0x6001, 0x6052));
  EXPECT_THAT(bytes_of(decoded.values[1]), ElementsAre(0x10, 0x02));
  EXPECT_TRUE(decoded.marks.empty());
}

TEST(Decoder, FollowsAPdoToTheCanIdThatIsWritten) {
  Decoder sut;
  sut.network().set_profile(10, *find_profile("419"));
  feed(sut, {"60A#2301180133030000", "58A#6001180100000000"});
  EXPECT_EQ(service_of(sut, "28A#011002"), Decoded::Service::other);
  EXPECT_THAT(indices(decode(sut, "333#011002")), ElementsAre(0x6001, 0x6052));
}

TEST(Decoder, LearnsAMappingThatIsWritten) {
  Decoder sut;
  feed(sut, {"60A#2F001A0000000000", "58A#60001A0000000000", "60A#23001A0108000160",
             "58A#60001A0100000000", "60A#23001A0210005260", "58A#60001A0200000000"});
  EXPECT_EQ(service_of(sut, "18A#011002"), Decoded::Service::other);
  feed(sut, {"60A#2F001A0002000000", "58A#60001A0000000000"});
  const Decoded& decoded = decode(sut, "18A#011002");
  EXPECT_THAT(indices(decoded), ElementsAre(0x6001, 0x6052));
  EXPECT_EQ(decoded.values[0].object, nullptr) << "the profile is not known";
}

TEST(Decoder, BelievesNoWriteThatIsNotConfirmed) {
  Decoder sut;
  feed(sut, {"60A#2F001A0001000000", "58A#80001A0000000106", "60A#23001A0108000160",
             "58A#80001A0100000106"});
  EXPECT_EQ(service_of(sut, "18A#01"), Decoded::Service::other);
}

TEST(Decoder, SkipsDummiesAndUnpacksBits) {
  Decoder sut;
  // 0005h as a dummy of type UNSIGNED8, then 4 and 12 bits.
  feed(sut, {"60A#23001601"
             "08000500",
             "58A#6000160100000000",
             "60A#23001602"
             "04010020",
             "58A#6000160200000000",
             "60A#23001603"
             "0C020020",
             "58A#6000160300000000", "60A#2F00160003000000", "58A#6000160000000000"});
  const Decoded& decoded = decode(sut, "20A#AABCDE");
  ASSERT_EQ(decoded.values.size(), 2U);
  EXPECT_THAT(bytes_of(decoded.values[0]), ElementsAre(0x0C));
  EXPECT_THAT(bytes_of(decoded.values[1]), ElementsAre(0xEB, 0x0D));
}

TEST(Decoder, MarksAPdoOfAnotherLengthThanItsMapping) {
  Decoder sut;
  sut.network().set_profile(10, *find_profile("419"));
  EXPECT_TRUE(decode(sut, "28A#0110").marks.has(Mark::wrong_length));
  EXPECT_TRUE(decode(sut, "28A#01100200").marks.has(Mark::wrong_length));
  EXPECT_TRUE(decode(sut, "28A#").marks.has(Mark::wrong_length));
}

TEST(Decoder, MarksReservedValuesAndThoseOutOfRange) {
  Decoder sut;
  sut.network().set_profile(10, *find_profile("419"));
  // Bits 1 to 7 are reserved (CiA 419, 7.2.2); 0 to 100 % (CiA 419, 7.2.7).
  EXPECT_TRUE(decode(sut, "28A#031002").marks.has(Mark::reserved));
  feed(sut, {"60A#4080600000000000"});
  EXPECT_TRUE(decode(sut, "58A#4F806000C8000000").marks.has(Mark::out_of_range));
  feed(sut, {"60A#4080600000000000"});
  EXPECT_TRUE(decode(sut, "58A#4F80600064000000").marks.empty());
}

TEST(Decoder, MarksAWriteToWhatIsReadOnly) {
  Decoder sut;
  sut.network().set_profile(10, *find_profile("419"));
  feed(sut, {"60A#2F01600001000000"});
  EXPECT_TRUE(decode(sut, "58A#6001600000000000").marks.has(Mark::wrong_access));
}

TEST(Decoder, MarksAWriteThatIsNotAsLongAsTheType) {
  Decoder sut;
  sut.network().set_profile(10, *find_profile("419"));
  // 6010h is INTEGER16 (CiA 419, 7.2.3). One byte, two, four, and four without an indicated size.
  EXPECT_TRUE(decode(sut, "60A#2F10600001000000").marks.has(Mark::wrong_length));
  EXPECT_TRUE(decode(sut, "58A#8010600010000706").marks.empty()) << "the abort is as it should be";
  EXPECT_FALSE(decode(sut, "60A#2B106000A0000000").marks.has(Mark::wrong_length));
  EXPECT_TRUE(decode(sut, "60A#23106000A0000000").marks.has(Mark::wrong_length));
  EXPECT_FALSE(decode(sut, "60A#22106000A0000000").marks.has(Mark::wrong_length));
  // An undescribed object, and a text (1008h).
  EXPECT_FALSE(decode(sut, "60A#2F00200001000000").marks.has(Mark::wrong_length));
  EXPECT_FALSE(decode(sut, "60A#2F08100041000000").marks.has(Mark::wrong_length));
}

TEST(Decoder, PutsSegmentsTogether) {
  Decoder sut;
  feed(sut, {"60A#4008100000000000", "58A#410810000A000000", "60A#6000000000000000",
             "58A#0043616E766F7920", "60A#7000000000000000"});
  const Decoded& decoded = decode(sut, "58A#1942434400000000");
  ASSERT_NE(decoded.transfer, nullptr);
  EXPECT_FALSE(decoded.transfer->is_write);
  EXPECT_EQ(std::string(decoded.transfer->bytes.begin(), decoded.transfer->bytes.end()),
            "Canvoy BCD");
  ASSERT_EQ(decoded.values.size(), 1U);
  EXPECT_EQ(decoded.values[0].index, 0x1008);
}

TEST(Decoder, PutsBlocksTogetherThoughSegmentsAreSentAgain) {
  Decoder sut;
  feed(sut, {"60A#C250200110000000", "58A#A050200102000000", "60A#0141424344454647",
             "60A#0248494A4B4C4D4E",
             "58A#A2010200000000"
             "00",
             "60A#0148494A4B4C4D4E", "60A#824F500000000000",
             "58A#A2020200000000"
             "00",
             "60A#D500000000000000"});
  const Decoded& decoded = decode(sut, "58A#A100000000000000");
  ASSERT_NE(decoded.transfer, nullptr);
  EXPECT_TRUE(decoded.transfer->is_write);
  EXPECT_EQ(std::string(decoded.transfer->bytes.begin(), decoded.transfer->bytes.end()),
            "ABCDEFGHIJKLMNOP");
}

TEST(Decoder, PutsABlockUploadTogether) {
  Decoder sut;
  feed(sut, {"60A#A05020017F000000", "58A#C250200105000000", "60A#A300000000000000",
             "58A#8141424344450000", "60A#A2017F0000000000", "58A#C900000000000000"});
  const Decoded& decoded = decode(sut, "60A#A100000000000000");
  ASSERT_NE(decoded.transfer, nullptr);
  EXPECT_EQ(std::string(decoded.transfer->bytes.begin(), decoded.transfer->bytes.end()), "ABCDE");
}

/// A block download to node 10 in its middle.
void begin_block(Decoder& sut) {
  feed(sut, {"60A#C600201000000000", "58A#A40020107F000000", "60A#0141414141414141"});
}

TEST(Decoder, ABootUpMessageEndsWhatWasTransferredWithTheNode) {
  Decoder sut;
  begin_block(sut);
  feed(sut, {"70A#00"});
  EXPECT_EQ(decode(sut, "60A#4018100100000000").message, SdoMessage::read);
  const Decoded& answer = decode(sut, "58A#4318100101020304");
  EXPECT_THAT(indices(answer), ElementsAre(0x1018));
  EXPECT_TRUE(answer.marks.empty());
  // The rest of the block is out of place.
  begin_block(sut);
  feed(sut, {"70A#00"});
  EXPECT_TRUE(decode(sut, "60A#0241414141414141").marks.has(Mark::out_of_place));
}

TEST(Decoder, TransfersGoOnWhereAnotherNodeStartsOrTheStateIsTold) {
  for (const char* heard : {"70B#00", "70A#05", "70A#7F", "70A#0000", "70A#", "700#00", "70A#R1"}) {
    Decoder sut;
    begin_block(sut);
    feed(sut, {heard});
    EXPECT_EQ(decode(sut, "60A#0241414141414141").message, SdoMessage::block_segment) << heard;
  }
}

TEST(Decoder, ABootUpMessageEndsTransfersOfAllChannelsOfItsServer) {
  Decoder sut;
  // 1201h of node 10: requests on 621h, answers on 5A1h.
  feed(sut, {"60A#2301120121060000", "58A#6001120100000000", "60A#23011202A1050000",
             "58A#6001120200000000"});
  feed(sut, {"621#C600201000000000", "5A1#A40020107F000000", "70A#00"});
  EXPECT_EQ(decode(sut, "621#4018100100000000").message, SdoMessage::read);
}

TEST(Decoder, TheAnswerToARequestMayComeBehindTheBootUpMessage) {
  Decoder sut;
  feed(sut, {"60A#4018100100000000", "58A#4318100101020304", "60A#4018100200000000", "70A#00"});
  const Decoded& answer = decode(sut, "58A#4318100201020304");
  EXPECT_THAT(indices(answer), ElementsAre(0x1018));
  EXPECT_TRUE(answer.marks.empty());
}

TEST(Decoder, KeepsTheFirstBytesOfALongTransferAndCountsTheRest) {
  Decoder sut;
  feed(sut, {"60A#4050200100000000", "58A#4050200100000000"});
  for (unsigned i = 0; i < 999; ++i)
    decode(sut, i % 2 == 0 ? "58A#0001020304050607" : "58A#1001020304050607");
  const Decoded& decoded = decode(sut, "58A#1101020304050607");
  ASSERT_NE(decoded.transfer, nullptr);
  EXPECT_EQ(decoded.transfer->size, 7000U);
  EXPECT_EQ(decoded.transfer->bytes.size(), SdoFollower::bytes_max);
}

TEST(Decoder, FollowsTheSdoChannelsBetweenTheNodesOfACar) {
  Decoder sut;
  EXPECT_EQ(service_of(sut, "256#4000100000000000"), Decoded::Service::other);
  sut.network().set_profile(7, *find_profile("447-3"));
  const Decoded& asked = decode(sut, "256#4000100000000000");
  EXPECT_EQ(asked.service, Decoded::Service::sdo_request);
  EXPECT_EQ(asked.client, 2);
  EXPECT_EQ(asked.node, 7);
  const Decoded& answered = decode(sut, "1D6#43001000BF010000");
  EXPECT_EQ(answered.service, Decoded::Service::sdo_response);
  EXPECT_EQ(answered.client, 2);
  ASSERT_NE(answered.transfer, nullptr);
  EXPECT_EQ(answered.transfer->index, 0x1000);
}

TEST(Decoder, FollowsAChannelThatTheSdoParametersOfAServerSay) {
  Decoder sut;
  feed(sut, {"60A#2F01120305000000", "58A#6001120300000000", "60A#2301120283060040",
             "58A#6001120200000000"});
  EXPECT_EQ(service_of(sut, "682#4000100000000000"), Decoded::Service::other);
  feed(sut, {"60A#2301120182060040", "58A#6001120100000000"});
  const Decoded& asked = decode(sut, "682#4000100000000000");
  EXPECT_EQ(asked.service, Decoded::Service::sdo_request);
  EXPECT_EQ(asked.client, 5);
  EXPECT_EQ(asked.node, 10);
  ASSERT_NE(decode(sut, "683#43001000A2010000").transfer, nullptr);
  EXPECT_EQ(sut.network().profile(10).number, 418);
  feed(sut, {"60A#2301120182060080", "58A#6001120100000000"});
  EXPECT_EQ(service_of(sut, "682#4000100000000000"), Decoded::Service::other);
}

TEST(Decoder, FollowsAChannelThatTheSdoParametersOfAClientSay) {
  Decoder sut;
  feed(sut, {"605#2F80120301000000", "585#6080120300000000", "605#2380120180060040",
             "585#6080120100000000", "605#2380120281060040", "585#6080120200000000"});
  const Decoded& answered = decode(sut, "681#4300100000000000");
  EXPECT_EQ(answered.service, Decoded::Service::sdo_response);
  EXPECT_EQ(answered.client, 5);
  EXPECT_EQ(answered.node, 1);
}

TEST(Decoder, KnowsTheMessagesThatAProfileGivesACanId) {
  Decoder sut;
  sut.network().set_profile(1, *find_profile("407"));
  // The driver is on 201h (CiA 407, 8.1.4.3).
  const Decoded& decoded = decode(sut, "201#01000000");
  ASSERT_NE(decoded.pdo, nullptr);
  EXPECT_EQ(decoded.pdo->name, "driver");
  EXPECT_EQ(decoded.node, 0);
  ASSERT_EQ(decoded.values.size(), 1U);
  EXPECT_NE(decoded.values[0].entry, nullptr);
}

TEST(Decoder, LivesWithEveryCommandByteInEveryPlace) {
  Decoder sut;
  for (unsigned bytes = 0; bytes < 0x10000; ++bytes) {
    const auto first = static_cast<std::uint8_t>(bytes >> 8);
    const auto second = static_cast<std::uint8_t>(bytes);
    sut.decode(Frame::data_frame(0x60A, {first, 0x00, 0x1A, 1, 2, 3, 4, 5}));
    sut.decode(Frame::data_frame(0x58A, {second, 0x00, 0x1A, 1, 2, 3, 4, 5}));
  }
  EXPECT_EQ(service_of(sut, "60A#4000100000000000"), Decoded::Service::sdo_request);
}

TEST(Decoder, TakesEveryLengthOfEveryCanId) {
  Decoder sut;
  sut.network().set_profile(1, *find_profile("447-3"));
  sut.network().set_profile(2, *find_profile("417"));
  sut.network().set_profile(3, *find_profile("407"));
  sut.network().set_profile(4, *find_profile("852"));
  unsigned pdos = 0;
  for (std::uint32_t id = 0; id < 0x800; ++id) {
    for (std::uint8_t length = 0; length <= 8; ++length) {
      Frame frame = Frame::data_frame(id, {1, 2, 3, 4, 5, 6, 7, 8});
      frame.length = length;
      pdos += sut.decode(frame).pdo != nullptr ? 1U : 0U;
    }
  }
  EXPECT_GT(pdos, 9U * 100);
}

}  // namespace
}  // namespace canvoy::decoder::decoder_test
