// Expected values are typed from docs/decode.md and the named clauses of the profiles.
#include "canvoy/text/frame_json.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <random>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::text::frame_json_test {
namespace {

using namespace std::chrono_literals;

class FrameJsonTest : public testing::Test {
 protected:
  void be(NodeId node, std::string_view profile) {
    decoder.network().set_profile(node, *find_profile(profile));
  }
  std::string line(std::string_view frame, std::string_view bus = "can0") {
    const FrameWords& words = decoder.decode(parse_frame(frame).frame);
    std::string made;
    sut.append(made, 1'700'000'000'000'125us, bus, frame, words, words.text);
    return made;
  }

  FrameDecoder decoder;
  FrameJson sut;
};

TEST_F(FrameJsonTest, HasTheValuesOfAPdoInTheirUnits) {
  be(10, "418");
  // 6010h has 0.125 °C per step; ready is bit 0 of 6000h (CiA 418).
  const std::string_view warm =
      R"({"time":1700000000.000125,"bus":"can0","frame":"18A#A00001","service":"TPDO1","node":10,)"
      R"("text":"temperature = 20.000 °C; battery_status = ready","values":[)"
      R"({"index":"6010","sub":"00","name":"temperature","raw":"A000","value":20.0,"unit":"°C"},)"
      R"({"index":"6000","sub":"00","name":"battery_status","raw":"01","value":"ready"}]})";
  EXPECT_EQ(line("18A#A00001"), warm);
  EXPECT_EQ(line("18A#A00001"), warm) << "the same again";
  EXPECT_EQ(line("18A#A10001"),
            R"({"time":1700000000.000125,"bus":"can0","frame":"18A#A10001","service":"TPDO1",)"
            R"("node":10,"text":"temperature = 20.125 °C; battery_status = ready","values":[)"
            R"({"index":"6010","sub":"00","name":"temperature","raw":"A100","value":20.125,)"
            R"("unit":"°C"},)"
            R"({"index":"6000","sub":"00","name":"battery_status","raw":"01","value":"ready"}]})");
  EXPECT_EQ(line("18A#A000"),
            R"({"time":1700000000.000125,"bus":"can0","frame":"18A#A000","service":"TPDO1",)"
            R"("node":10,"text":"temperature = 20.000 °C","values":[)"
            R"({"index":"6010","sub":"00","name":"temperature","raw":"A000","value":20.0,)"
            R"("unit":"°C"}],"marks":["wrong length"]})");
}

TEST_F(FrameJsonTest, IsNullWhereAValueIsInvalid) {
  be(10, "418");
  // FFFFh means that the charge is unknown (CiA 419, 7.2.4).
  EXPECT_NE(line("30A#00FFFF").find(R"("raw":"FFFF","value":null)"), std::string::npos);
}

TEST_F(FrameJsonTest, MarksTheFrameAndTheValue) {
  be(10, "419");
  const std::string marked = line("18A#03");
  EXPECT_NE(marked.find(R"("marks":["reserved"]}],"marks":["reserved"]})"), std::string::npos)
      << marked;
}

TEST_F(FrameJsonTest, HasNoMoreThanThereIsToSay) {
  EXPECT_EQ(line("080#", "the \"bus\""),
            R"({"time":1700000000.000125,"bus":"the \"bus\"","frame":"080#","service":"SYNC"})");
  EXPECT_EQ(line("70A#R"), R"({"time":1700000000.000125,"bus":"can0","frame":"70A#R",)"
                           R"("service":"guarding request","node":10})");
}

TEST_F(FrameJsonTest, HasTheFieldsOfAValueByTheirNames) {
  be(7, "447-3");
  for (const std::string_view frame :
       {"607#2300180180040000", "587#6000180100000000", "607#23001A0110000D60",
        "587#60001A0100000000", "607#2F001A0001000000"}) {
    line(frame);
  }
  // The value of a transfer is in the message that ends it, and SDO messages include the client.
  EXPECT_NE(line("587#60001A0000000000").find(R"("index":"1A00","sub":"00")"), std::string::npos);
  // CiA 447-3, 4.2.2.8.
  EXPECT_NE(line("480#88F9")
                .find(R"("value":{"dd":"Open","dfp":"Closed","drl":"Reserved","drr":"Failure"})"),
            std::string::npos);
}

/// For each profile, typical traffic: SDO as often as PDOs, and repetitions.
TEST_F(FrameJsonTest, IsWhatTheLibraryWouldDump) {
  constexpr std::array<std::string_view, 6> names = {"407", "417-4", "418", "419", "447-3", "852"};
  for (NodeId node = 1; const std::string_view name : names) be(node++, name);
  std::mt19937 random(1);
  const auto draw = [&random](unsigned below) {
    return static_cast<std::uint32_t>(random() % below);
  };
  Frame frame;
  for (int i = 0; i < 20'000; ++i) {
    const bool again = draw(4) == 0;
    if (!again) {
      frame = {};
      frame.id = draw(2) == 0 ? draw(0x800) : draw(16) << 7 | draw(8);
      frame.length = static_cast<std::uint8_t>(draw(3) == 0 ? draw(9) : 8);
      for (std::uint8_t j = 0; j < frame.length; ++j) {
        frame.data.at(j) = static_cast<std::uint8_t>(draw(2) == 0 ? draw(4) : draw(256));
      }
    }
    FrameWords words = decoder.decode(frame);
    std::string made;
    std::string anew;
    sut.append(made, Duration{i}, "can0", FrameText(frame).view(), words, words.text);
    words.kept = nullptr;
    sut.append(anew, Duration{i}, "can0", FrameText(frame).view(), words, words.text);
    ASSERT_EQ(made, anew);
    ASSERT_EQ(made, nlohmann::ordered_json::parse(made).dump());
  }
}

}  // namespace
}  // namespace canvoy::text::frame_json_test
