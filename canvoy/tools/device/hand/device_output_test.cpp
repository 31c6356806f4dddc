#include "canvoy/tools/device/hand/device_output.hpp"

#include <gtest/gtest.h>

#include <set>

#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::tools::device_output_test {
namespace {

TEST(DeviceOutput, HasWordsForEachIndication) {
  std::set<std::string_view> texts;
  for (unsigned number = 0; number <= static_cast<unsigned>(Indication::quadruple_flash);
       ++number) {
    EXPECT_TRUE(texts.insert(indication_text(static_cast<Indication>(number))).second);
  }
  EXPECT_EQ(indication_text(Indication::quadruple_flash), "quadruple flash");
}

TEST(DeviceOutput, IsALineForPeopleOrAnObject) {
  testing::internal::CaptureStdout();
  DeviceOutput(false).say("charger", "linked to node 10 (0Ah)");
  DeviceOutput(true).say("charger", "linked to \"10\"");
  DeviceOutput(false).lights("charger", Indication::on, Indication::double_flash);
  DeviceOutput(true).lights("charger", Indication::on, Indication::double_flash);
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "charger: linked to node 10 (0Ah)\n"
            R"({"device":"charger","event":"text","text":"linked to \"10\""})"
            "\n"
            "charger: lights: run on, error double flash\n"
            R"({"device":"charger","event":"lights","run":"on","error":"double flash"})"
            "\n");
}

TEST(LightsTeller, SpeaksWhenALightChanges) {
  constexpr DictionaryTables no_objects{};
  WireNode wire(no_objects, 5);
  const Indicators indicators(wire.node);
  const DeviceOutput output;
  LightsTeller sut(output, "lamp", indicators);
  testing::internal::CaptureStdout();
  sut.look();
  wire.boot();
  sut.look();
  sut.look();
  wire.receive("000#01 00");
  sut.look();
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "lamp: lights: run blinking, error off\nlamp: lights: run on, error off\n");
}

}  // namespace
}  // namespace canvoy::tools::device_output_test
