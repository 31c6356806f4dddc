// A device from a sheet, at the wire. Frames are typed from CiA 301.
#include "canvoy/formats/sheet/sheet_device.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"

namespace canvoy::formats::sheet_device_test {
namespace {

constexpr std::string_view sheet_text =
    "[1000]\nParameterName=Device type\nDataType=7\nAccessType=ro\nDefaultValue=0x191\n"
    "[1001]\nParameterName=Error register\nDataType=5\nAccessType=ro\n"
    "[1014]\nParameterName=COB-ID EMCY\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x80\n"
    "[1017]\nParameterName=Heartbeat\nDataType=6\nAccessType=rw\nDefaultValue=100\n"
    "[1400]\nObjectType=9\n[1400sub0]\nDataType=5\nAccessType=const\nDefaultValue=2\n"
    "[1400sub1]\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x200\n"
    "[1400sub2]\nDataType=5\nAccessType=rw\nDefaultValue=255\n"
    "[1600]\nObjectType=9\n[1600sub0]\nDataType=5\nAccessType=rw\nDefaultValue=1\n"
    "[1600sub1]\nDataType=7\nAccessType=rw\nDefaultValue=0x62000108\n"
    "[1800]\nObjectType=9\n[1800sub0]\nDataType=5\nAccessType=const\nDefaultValue=2\n"
    "[1800sub1]\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x180\n"
    "[1800sub2]\nDataType=5\nAccessType=rw\nDefaultValue=255\n"
    "[1A00]\nObjectType=9\n[1A00sub0]\nDataType=5\nAccessType=rw\nDefaultValue=1\n"
    "[1A00sub1]\nDataType=7\nAccessType=rw\nDefaultValue=0x60000010\n"
    "[2000]\nParameterName=File\nObjectType=2\nDataType=0xF\nAccessType=rw\n"
    "[2001]\nParameterName=Odd\nDataType=0x4711\nAccessType=rw\n"
    "[2002]\nParameterName=Text\nDataType=9\nAccessType=rw\nDefaultValue=hello\n"
    "[6000]\nParameterName=Angle\nDataType=3\nAccessType=rwr\nDefaultValue=-2\nLowLimit=-100\n"
    "HighLimit=100\nPDOMapping=1\n"
    "[6200]\nObjectType=8\n[6200sub0]\nDataType=5\nAccessType=const\nDefaultValue=1\n"
    "[6200sub1]\nDataType=5\nAccessType=rww\nPDOMapping=1\n";

class SheetDeviceTest : public testing::Test {
 protected:
  explicit SheetDeviceTest(NodeId id = 5)
      : device_(read_eds(sheet_text, findings_), {this, send, nullptr}, id) {
    device_.node().start(now_);
  }

  static bool send(void* test, const Frame& frame) {
    static_cast<SheetDeviceTest*>(test)->sent_.emplace_back(FrameText(frame).view());
    return true;
  }
  /// The answers of the device to this frame.
  std::vector<std::string> hears(std::string_view text) {
    sent_.clear();
    device_.node().receive(parse_frame(text).frame, now_);
    return sent_;
  }
  std::vector<std::string> after(Duration time) {
    sent_.clear();
    for (const Time end = now_ + time; device_.node().deadline() <= end;) {
      now_ = device_.node().deadline();
      device_.node().advance(now_);
    }
    return sent_;
  }

  using Frames = std::vector<std::string>;
  Time now_{};
  Frames sent_;
  Findings findings_;
  SheetDevice device_;
};

TEST_F(SheetDeviceTest, BootsAndSendsItsHeartbeat) {
  EXPECT_EQ(sent_, (Frames{"705#00"}));
  EXPECT_EQ(after(std::chrono::milliseconds(200)), (Frames{"705#7F", "705#7F"}));
}

TEST_F(SheetDeviceTest, AnswersWithTheDefaultsOfTheSheet) {
  EXPECT_EQ(hears("605#4000100000000000"), (Frames{"585#4300100091010000"}));
  EXPECT_EQ(hears("605#4014100000000000"), (Frames{"585#4314100085000000"})) << "with its node-ID";
  EXPECT_EQ(hears("605#4000600000000000"), (Frames{"585#4B006000FEFF0000"}));
  EXPECT_EQ(hears("605#4002200000000000"), (Frames{"585#4102200005000000"})) << "in segments";
}

TEST_F(SheetDeviceTest, KeepsTheAccessAndTheLimitsOfTheSheet) {
  EXPECT_EQ(hears("605#2300100001000000"), (Frames{"585#8000100002000106"})) << "read-only";
  EXPECT_EQ(hears("605#2B00600065000000"), (Frames{"585#8000600031000906"})) << "above its limit";
  EXPECT_EQ(hears("605#2B0060009CFF0000"), (Frames{"585#6000600000000000"})) << "-100";
}

TEST_F(SheetDeviceTest, SendsAndTakesItsPdos) {
  EXPECT_EQ(hears("000#0105"), (Frames{"185#FEFF"}));
  EXPECT_EQ(hears("605#2B00600007000000"), (Frames{"585#6000600000000000", "185#0700"}));
  hears("205#2A");
  EXPECT_EQ(hears("605#4000620100000000"), (Frames{"585#4F0062012A000000"}));
}

TEST_F(SheetDeviceTest, KeepsWhatADomainIsGiven) {
  EXPECT_EQ(hears("605#2300200011223344"), (Frames{"585#6000200000000000"}));
  EXPECT_EQ(hears("605#4000200000000000"), (Frames{"585#4100200004000000"}));
  EXPECT_EQ(hears("605#6000000000000000"), (Frames{"585#0711223344000000"}));
}

TEST_F(SheetDeviceTest, LeavesOutWhatNoDictionaryCanHave) {
  EXPECT_EQ(hears("605#4001200000000000"), (Frames{"585#8001200000000206"}));
  ASSERT_EQ(device_.left_out().size(), 1U);
  EXPECT_EQ(device_.left_out()[0].section, "2001sub0");
}

TEST(SheetDevice, AValueOfADcfGoesBeforeTheDefault) {
  Findings findings;
  const DataSheet sheet =
      read_eds("[1000]\nDataType=7\nDefaultValue=$NODEID+1\nParameterValue=0x191\nAccessType=ro\n",
               findings);
  SheetDevice device(sheet, {nullptr, [](void*, const Frame&) { return true; }, nullptr}, 5);
  device.node().start(Time{});
  EXPECT_EQ(device.node().dictionary().number(0x1000, 0), 0x191U);
}

/// Like 6001h:01h of an on-board computer: SDO writes it, a TPDO sends it (CiA 407, 6.2 and
/// 8.1.4.3).
TEST_F(SheetDeviceTest, AValueThatIsWriteOnlyIsSentWhereATpdoOfTheSheetCarriesIt) {
  std::string text(sheet_text);
  text.replace(text.find("AccessType=rwr"), std::string_view("AccessType=rwr").size(),
               "AccessType=wo");
  SheetDevice device(read_eds(text, findings_), {this, send, nullptr}, 5);
  device.node().start(now_);
  const auto hears = [&](std::string_view frame) {
    sent_.clear();
    device.node().receive(parse_frame(frame).frame, now_);
    return sent_;
  };
  EXPECT_EQ(hears("000#0105"), (Frames{"185#FEFF"}));
  EXPECT_EQ(hears("605#2B00600007000000"), (Frames{"585#6000600000000000", "185#0700"}));
  EXPECT_EQ(hears("605#4000600000000000"), (Frames{"585#8000600001000106"}));
}

}  // namespace
}  // namespace canvoy::formats::sheet_device_test
