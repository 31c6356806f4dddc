// Expected values are typed from the named clauses of the profiles.
#include "canvoy/text/object_words.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/frame_decoder.hpp"

namespace canvoy::text::object_words_test {
namespace {

const FrameWords& words_of(FrameDecoder& decoder, std::string_view frame) {
  return decoder.decode(parse_frame(frame).frame);
}
std::string text_of(FrameDecoder& decoder, std::string_view frame) {
  return std::string(words_of(decoder, frame).text);
}

TEST(ObjectWords, SayWhatABatteryAndAChargerSend) {
  FrameDecoder decoder;
  decoder.network().set_profile(10, *find_profile("418"));
  // 6010h has 0.125 °C per step; ready is bit 0 of 6000h (CiA 418).
  EXPECT_EQ(text_of(decoder, "18A#A00001"), "temperature = 20.000 °C; battery_status = ready");
  EXPECT_EQ(words_of(decoder, "18A#A00001").service, "TPDO1");
  // FFFFh means that the charge is unknown (CiA 419, 7.2.4).
  EXPECT_EQ(text_of(decoder, "30A#00FFFF"),
            "charger_status = not ready; ah_returned_during_last_charge = invalid");
}

TEST(ObjectWords, NameAPdoWithoutAProfileByItsBytes) {
  FrameDecoder decoder;
  EXPECT_EQ(text_of(decoder, "18A#A00001"), "A0 00 01");
}

TEST(ObjectWords, NameTheMessagesOfABusBySpecifiedCanIds) {
  FrameDecoder decoder;
  decoder.network().set_profile(1, *find_profile("407"));
  // 201h is the driver (CiA 407, 8.1.4.3).
  const FrameWords& words = words_of(decoder, "201#2A000000");
  EXPECT_EQ(words.service, "PDO");
  EXPECT_EQ(words.node, 0);
  EXPECT_EQ(words.text.substr(0, 8), "driver: ");
}

TEST(ObjectWords, ShowTheVariantOfAFieldThatHolds) {
  FrameDecoder decoder;
  decoder.network().set_profile(1, *find_profile("417-4"));
  // 480h + node-ID is the virtual input of an input panel; 01h is a generic input (CiA 417-4).
  const std::string text = text_of(decoder, "481#0102040105060708");
  EXPECT_NE(text.find("Virtual input: "), std::string::npos) << text;
  EXPECT_NE(text.find("Basic function: Generic input"), std::string::npos) << text;
  EXPECT_NE(text.find("Source lift 3: request"), std::string::npos) << text;
  EXPECT_EQ(text.find('#'), std::string::npos) << "numbers are put in place: " << text;
}

TEST(ObjectWords, TellTheWholeOfATransferInItsLastMessage) {
  FrameDecoder decoder;
  for (const std::string_view frame :
       {"60A#4008100000000000", "58A#4108100007000000", "60A#6000000000000000"}) {
    EXPECT_TRUE(words_of(decoder, frame).is_middle) << frame;
  }
  const FrameWords& words = words_of(decoder, "58A#0143616E766F7921");
  EXPECT_EQ(decoder.transfer_text(), "read 1008h:00h Manufacturer device name = \"Canvoy!\"");
  EXPECT_EQ(words.text, "segment: " + std::string(decoder.transfer_text()));
  EXPECT_FALSE(words.is_middle);
}

TEST(ObjectWords, TellAnExpeditedWriteWhenItIsConfirmed) {
  FrameDecoder decoder;
  decoder.network().set_profile(10, *find_profile("419"));
  words_of(decoder, "60A#2B106000A0000000");
  const FrameWords& words = words_of(decoder, "58A#6010600000000000");
  EXPECT_EQ(decoder.transfer_text(), "written 6010h:00h battery_temperature = 20.000 °C");
  EXPECT_EQ(words.text, "6010h:00h battery_temperature written");
}

TEST(ObjectWords, TellWhoAsksInACar) {
  FrameDecoder decoder;
  decoder.network().set_profile(7, *find_profile("447-3"));
  const FrameWords& words = words_of(decoder, "256#4000100000000000");
  EXPECT_EQ(words.service, "SDO request");
  EXPECT_EQ(words.client, 2);
  EXPECT_EQ(words.node, 7);
  EXPECT_EQ(words.text, "read 1000h:00h Device type");
}

TEST(ObjectWords, ShowTheDoorsOfACarByAMappingThatWasWritten) {
  FrameDecoder decoder;
  decoder.network().set_profile(7, *find_profile("447-3"));
  // 1800h:01h = 480h, one of its 32 own CAN-IDs; 1A00h:01h = 600Dh, 16 bits, 1A00h:00h = 1.
  for (const std::string_view frame :
       {"607#2300180180040000", "587#6000180100000000", "607#23001A0110000D60",
        "587#60001A0100000000", "607#2F001A0001000000", "587#60001A0000000000"}) {
    words_of(decoder, frame);
  }
  // Driver 0 (open), front passenger 1 (closed), rear right 6 (failure), rear left 4 (reserved)
  // (CiA 447-3, 4.2.2.8).
  const FrameWords& words = words_of(decoder, "480#88F9");
  EXPECT_EQ(words.service, "TPDO1");
  EXPECT_EQ(words.node, 7);
  EXPECT_EQ(words.text, "Door status = dd: Open, dfp: Closed, drr: Failure, drl: Reserved");
  EXPECT_EQ(marks_text(words.marks), "reserved");
}

TEST(ObjectWords, ShowTheValueInAMultiplexedPdoByWhereItGoes) {
  FrameDecoder decoder;
  decoder.network().set_profile(1, *find_profile("417-4"));
  decoder.network().set_profile(10, *find_profile("418"));
  // To node 10 (8Ah), 6010h:00h; the value is in the last four bytes (CiA 301, 7.2.2.5).
  const FrameWords& words = words_of(decoder, "501#8A106000A0000000");
  EXPECT_EQ(words.text, "Multiplexed PDO: temperature = 20.000 °C");
  EXPECT_EQ(words.node, 1);
  EXPECT_EQ(marks_text(words_of(decoder, "501#8A106000A00000").marks), "wrong length");
}

TEST(ObjectWords, ShowAnEmergencyByTheProfileOfItsNode) {
  FrameDecoder decoder;
  decoder.network().set_profile(5, *find_profile("417-4"));
  // 3111h (CiA 417-1, 8.4).
  EXPECT_EQ(text_of(decoder, "085#1131040000000000"),
            "3111h mains over-voltage, error register 04h (voltage), 00 00 00 00 00");
  EXPECT_EQ(text_of(decoder, "086#1131040000000000").find("mains over-voltage"), std::string::npos);
}

TEST(ObjectWords, MarkWhatIsAgainstTheProfile) {
  FrameDecoder decoder;
  decoder.network().set_profile(10, *find_profile("419"));
  EXPECT_EQ(marks_text(words_of(decoder, "18A#03").marks), "reserved");
  EXPECT_EQ(marks_text(words_of(decoder, "18A#0100").marks), "wrong length");
  EXPECT_EQ(marks_text(words_of(decoder, "18A#01").marks), "");
}

}  // namespace
}  // namespace canvoy::text::object_words_test
