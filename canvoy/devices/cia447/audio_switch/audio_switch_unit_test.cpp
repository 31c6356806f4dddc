// The audio switch at the wire (CiA 447-3, 4.2.19): input, output, gain (errata Z04).
#include "canvoy/devices/cia447/audio_switch/audio_switch_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::audio_switch_unit_test {
namespace {

class AudioSwitch : public testing::Test {
 protected:
  std::string connect(const std::string& bytes) {
    return bench.ask("27 20 61 00 " + bytes + " 00");
  }
  /// The gain that client 1 receives.
  std::string gain(const std::string& channels) {
    bench.ask("2B 21 61 00 " + channels + " 00 00");
    return answer_to(1);
  }
  std::string answer_to(unsigned client) {
    return bench.ask_as(client, "40 22 61 00 00 00 00 00").substr(12, 2);
  }
  AudioSwitchHardware hardware() {
    using Connect = Callback<void(unsigned, unsigned, std::uint8_t)>;
    return {.connect = Connect::to<&AudioSwitch::connected>(*this)};
  }
  void connected(unsigned input, unsigned output, std::uint8_t gain) {
    heard +=
        std::to_string(input) + ">" + std::to_string(output) + ":" + std::to_string(gain) + " ";
    ++changes;
  }

  std::string heard;
  int changes = 0;
  AudioSwitchUnit* unit_ = nullptr;
  CarBench bench{only_unit<AudioSwitchKind>, [this](Environment& environment) {
                   environment.watch(unit_);
                   environment.provide(callback<&AudioSwitch::hardware>(*this));
                 }};
};

TEST_F(AudioSwitch, NothingIsConnectedAndNothingAskedAtFirst) {
  EXPECT_EQ(answer_to(1), "FF");
  EXPECT_EQ(gain("07 03"), "00");
}

TEST_F(AudioSwitch, AnInputIsConnectedWithAnOutput) {
  EXPECT_EQ(connect("07 03 50"), "60 20 61 00 00 00 00 00");
  EXPECT_EQ(heard, "7>3:80 ");
  EXPECT_EQ(gain("07 03"), "50");
  EXPECT_EQ(gain("03 07"), "00") << "one way only";
  connect("07 03 FD");
  EXPECT_EQ(gain("07 03"), "FD");
  connect("07 03 00");
  EXPECT_EQ(heard, "7>3:80 7>3:253 7>3:0 ");
  EXPECT_EQ(gain("07 03"), "00") << "disconnected";
}

TEST_F(AudioSwitch, ZeroIsAllChannelsOfASide) {
  connect("00 10 20");  // all inputs to output 16
  EXPECT_EQ(changes, 16);
  EXPECT_EQ(gain("01 10"), "20");
  EXPECT_EQ(gain("10 10"), "20");
  EXPECT_EQ(gain("10 01"), "00");
  EXPECT_EQ(gain("00 10"), "20") << "all have it";
  connect("10 00 30");  // input 16 to all outputs
  EXPECT_EQ(changes, 32);
  EXPECT_EQ(gain("00 10"), "FF") << "they differ (errata Z32)";
  EXPECT_EQ(gain("10 00"), "30");
  connect("00 00 00");
  EXPECT_EQ(changes, 63) << "15 and 16 were connected";
  EXPECT_EQ(gain("00 00"), "00");
}

TEST_F(AudioSwitch, ACommandWithAHoleDoesNothing) {
  for (const char* bytes : {"FF 03 50", "07 FF 50", "07 03 FF", "FF FF FF"}) {
    EXPECT_EQ(connect(bytes), "60 20 61 00 00 00 00 00") << bytes;
  }
  EXPECT_EQ(heard, "");
}

TEST_F(AudioSwitch, ReservedChannelsAreRefused) {
  for (const char* bytes :
       {"11 03 50", "FD 03 50", "FE 03 50", "07 11 50", "07 FE 50", "07 03 FE"}) {
    EXPECT_EQ(connect(bytes), "80 20 61 00 30 00 09 06") << bytes;
  }
  EXPECT_EQ(bench.ask("2B 21 61 00 11 03 00 00"), "80 21 61 00 30 00 09 06");
  EXPECT_EQ(bench.ask("2B 21 61 00 03 FE 00 00"), "80 21 61 00 30 00 09 06") << "errata Z35";
  EXPECT_EQ(heard, "");
}

TEST_F(AudioSwitch, ARequestWithAHoleLeavesTheAnswer) {
  connect("07 03 50");
  EXPECT_EQ(gain("07 03"), "50");
  EXPECT_EQ(gain("FF 03"), "50");
}

TEST_F(AudioSwitch, EachClientIsAnsweredItsOwnQuestion) {
  connect("07 03 50");
  bench.ask_as(2, "2B 21 61 00 07 03 00 00");
  bench.ask_as(9, "2B 21 61 00 01 02 00 00");
  EXPECT_EQ(answer_to(2), "50");
  EXPECT_EQ(answer_to(9), "00");
  EXPECT_EQ(answer_to(16), "FF");
  connect("07 03 51");
  EXPECT_EQ(answer_to(2), "51") << "the gain of now";
}

TEST_F(AudioSwitch, AFailureIsTold) {
  connect("07 03 50");
  EXPECT_EQ(gain("07 03"), "50");
  unit_->report_failure(true);
  EXPECT_EQ(answer_to(1), "FE");
  unit_->report_failure(false);
  EXPECT_EQ(answer_to(1), "50");
}

TEST_F(AudioSwitch, AnNmtResetLeavesConnectionsAndForgetsQuestions) {
  connect("07 03 50");
  gain("07 03");
  bench.cable.send("000#81 05");
  bench.cable.send("000#01 05");
  EXPECT_EQ(answer_to(1), "FF");
  EXPECT_EQ(gain("07 03"), "50");
}

}  // namespace
}  // namespace canvoy::cia447::audio_switch_unit_test
