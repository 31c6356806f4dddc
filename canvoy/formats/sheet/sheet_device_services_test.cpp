// Services of CiA 301 in a device from a sheet, at the wire: each exists since the sheet lists its
// objects. Frames are typed from CiA 301.
#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/formats/sheet/sheet_device.hpp"

namespace canvoy::formats::sheet_device_services_test {
namespace {

using namespace std::chrono_literals;
using Frames = std::vector<std::string>;

constexpr std::string_view basics =
    "[1000]\nDataType=7\nAccessType=ro\nDefaultValue=0x191\n"
    "[1001]\nDataType=5\nAccessType=ro\n"
    "[1014]\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x80\n";

std::string entry(const char* place, unsigned type, const char* value, const char* access = "rw",
                  const char* more = "") {
  return std::string("[") + place + "]\nDataType=" + std::to_string(type) +
         "\nAccessType=" + access + "\nDefaultValue=" + value + "\n" + more;
}
std::string record(const char* index) {
  return std::string("[") + index + "]\nObjectType=9\n";
}

/// A device 5 on a wire.
class Wire {
 public:
  explicit Wire(const std::string& text, const SheetDevice::Options& options = {})
      : device_(read_eds(std::string(basics) + text, findings_), {this, send, nullptr}, 5,
                options) {
    device_.node().start(now_);
  }

  Frames hears(std::string_view text) {
    sent_.clear();
    device_.node().receive(parse_frame(text).frame, now_);
    return sent_;
  }
  Frames after(Duration time) {
    sent_.clear();
    const Time end = now_ + time;
    while (device_.node().deadline() <= end) {
      now_ = device_.node().deadline();
      device_.node().advance(now_);
    }
    now_ = end;
    device_.node().advance(now_);
    return sent_;
  }
  SheetDevice& device() { return device_; }

 private:
  static bool send(void* wire, const Frame& frame) {
    static_cast<Wire*>(wire)->sent_.emplace_back(FrameText(frame).view());
    return true;
  }

  Time now_{};
  Frames sent_;
  Findings findings_;
  SheetDevice device_;
};

std::string heartbeat() {
  return entry("1017", 6, "0");
}
std::string storage_objects() {
  return record("1010") + entry("1010sub0", 5, "1", "const") + entry("1010sub1", 7, "") +
         record("1011") + entry("1011sub0", 5, "1", "const") + entry("1011sub1", 7, "1");
}

TEST(SheetDeviceStorage, WhatWasStoredOutlivesAResetAndIsRestored) {
  Wire wire(heartbeat() + storage_objects());
  EXPECT_EQ(wire.hears("605#4010100100000000"), (Frames{"585#4310100101000000"}))
      << "it stores on command";
  wire.hears("605#2B171000F4010000");
  wire.hears("000#8105");
  EXPECT_EQ(wire.hears("605#4017100000000000"), (Frames{"585#4B17100000000000"})) << "not stored";
  wire.hears("605#2B171000F4010000");
  wire.hears("605#2310100173617665");
  EXPECT_EQ(wire.after(100ms), (Frames{"585#6010100100000000"}))
      << "save, answered when it is done";
  wire.hears("000#8105");
  EXPECT_EQ(wire.hears("605#4017100000000000"), (Frames{"585#4B171000F4010000"}));
  wire.hears("605#231110016C6F6164");
  wire.after(100ms);
  wire.hears("000#8105");
  EXPECT_EQ(wire.hears("605#4017100000000000"), (Frames{"585#4B17100000000000"})) << "load";
}

TEST(SheetDeviceStorage, AnotherSignatureIsRefused) {
  Wire wire(storage_objects());
  EXPECT_EQ(wire.hears("605#2310100173617666"), (Frames{"585#8010100120000008"}));
  EXPECT_EQ(wire.hears("605#231110010000006C"), (Frames{"585#8011100120000008"}));
}

TEST(SheetDeviceStorage, ProcessDataIsNotStored) {
  Wire wire(storage_objects() + entry("6200", 5, "0", "rww", "PDOMapping=1\n"));
  wire.hears("605#2F00620007000000");
  wire.hears("605#2310100173617665");
  wire.after(100ms);
  wire.hears("000#8105");
  EXPECT_EQ(wire.hears("605#4000620000000000"), (Frames{"585#4F00620000000000"}));
}

TEST(SheetDeviceStorage, TheOwnerMayStoreElsewhere) {
  Wire wire(storage_objects() + heartbeat(), {.stores_in_memory = false});
  wire.hears("605#2B171000F4010000");
  wire.hears("605#2310100173617665");
  wire.hears("000#8105");
  EXPECT_EQ(wire.hears("605#4017100000000000"), (Frames{"585#4B17100000000000"}));
}

TEST(SheetDeviceVerification, AChangeOfTheConfigurationClearsItsDate) {
  Wire wire(heartbeat() + record("1020") + entry("1020sub0", 5, "2", "const") +
            entry("1020sub1", 7, "0") + entry("1020sub2", 7, "0") +
            entry("6200", 5, "0", "rww", "PDOMapping=1\n"));
  wire.hears("605#2320100111000000");
  wire.hears("605#2320100222000000");
  wire.hears("605#2F00620007000000");
  EXPECT_EQ(wire.hears("605#4020100100000000"), (Frames{"585#4320100111000000"}))
      << "process data is no configuration";
  wire.hears("605#2B171000F4010000");
  EXPECT_EQ(wire.hears("605#4020100100000000"), (Frames{"585#4320100100000000"}));
  EXPECT_EQ(wire.hears("605#4020100200000000"), (Frames{"585#4320100200000000"}));
}

std::string pdo(const char* parameter, const char* mapping, const char* cob_id, const char* count) {
  const std::string p = parameter;
  const std::string m = mapping;
  return record(parameter) + entry((p + "sub0").c_str(), 5, "2", "const") +
         entry((p + "sub1").c_str(), 7, cob_id) + entry((p + "sub2").c_str(), 5, "254") +
         record(mapping) + entry((m + "sub0").c_str(), 5, count) +
         entry((m + "sub1").c_str(), 7, "0");
}

TEST(SheetDeviceMpdo, ATpdoInSourceModeSendsWhatTheScannerListNames) {
  Wire wire(pdo("1800", "1A00", "0x385", "0xFE") + record("1FA0") + entry("1FA0sub0", 5, "1") +
            entry("1FA0sub1", 7, "0x01600000") +
            entry("6000", 6, "0x1234", "rwr", "PDOMapping=1\n"));
  EXPECT_EQ(wire.hears("000#0105"), (Frames{"385#0500600034120000"}));
  EXPECT_EQ(wire.hears("605#2B00600078560000"),
            (Frames{"585#6000600000000000", "385#0500600078560000"}));
}

TEST(SheetDeviceMpdo, AnRpdoInDestinationModeWritesWhatIsAddressedToTheNode) {
  Wire wire(pdo("1400", "1600", "0x305", "0xFF") + entry("6200", 5, "0", "rww", "PDOMapping=1\n"));
  wire.hears("000#0105");
  wire.hears("305#850062002A000000");
  EXPECT_EQ(wire.hears("605#4000620000000000"), (Frames{"585#4F0062002A000000"}));
  wire.hears("305#8600620007000000");
  EXPECT_EQ(wire.hears("605#4000620000000000"), (Frames{"585#4F0062002A000000"})) << "of node 6";
}

TEST(SheetDeviceMpdo, AnRpdoInSourceModeWritesWhatTheDispatchingListNames) {
  // From 6000h:01h of node 10 to 6200h:00h, one entry: block size 1 in the most significant byte.
  Wire wire(pdo("1400", "1600", "0x305", "0xFE") + record("1FD0") + entry("1FD0sub0", 5, "1") +
            entry("1FD0sub1", 0x1B, "0x016200006000010A") +
            entry("6200", 5, "0", "rww", "PDOMapping=1\n"));
  wire.hears("000#0105");
  wire.hears("305#0A0060012A000000");
  EXPECT_EQ(wire.hears("605#4000620000000000"), (Frames{"585#4F0062002A000000"}));
}

TEST(SheetDeviceSync, ProducesSyncWithItsCounter) {
  Wire wire(entry("1005", 7, "0x40000080") + entry("1006", 7, "100000") + entry("1019", 5, "3"));
  EXPECT_EQ(wire.after(310ms), (Frames{"080#01", "080#02", "080#03"}));
}

TEST(SheetDeviceSync, ASynchronousTpdoIsSentAtTheSync) {
  std::string text = pdo("1800", "1A00", "0x185", "1");
  text.replace(text.find("DefaultValue=254"), 16, "DefaultValue=1");
  text.replace(text.rfind("DefaultValue=0"), 14, "DefaultValue=0x60000008");
  Wire wire(text + entry("1005", 7, "0x80") + entry("6000", 5, "7", "ro", "PDOMapping=1\n"));
  EXPECT_EQ(wire.hears("000#0105"), (Frames{}));
  EXPECT_EQ(wire.hears("080#"), (Frames{"185#07"}));
}

TEST(SheetDeviceTime, TheHighResolutionTimeStampIsTheClock) {
  Wire wire(entry("1013", 7, "0"));
  wire.after(0x123456us);
  EXPECT_EQ(wire.hears("605#4013100000000000"), (Frames{"585#4313100056341200"}));
}

TEST(SheetDeviceErrors, AMissingHeartbeatIsAnEmergencyWithItsHistory) {
  Wire wire(record("1016") + entry("1016sub0", 5, "1", "const") +
            entry("1016sub1", 7, "0x000A0064") + record("1003") + entry("1003sub0", 5, "0") +
            entry("1003sub1", 7, "0", "ro"));
  wire.hears("70A#05");
  const Frames sent = wire.after(150ms);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].substr(0, 10), "085#308111") << "8130h, generic and communication error";
  EXPECT_EQ(wire.hears("605#4003100100000000")[0].substr(0, 16), "585#430310013081");
}

TEST(SheetDeviceGuarding, AnswersNodeGuarding) {
  Wire wire(entry("100C", 6, "100") + entry("100D", 5, "3"));
  EXPECT_EQ(wire.hears("705#R"), (Frames{"705#7F"}));
  EXPECT_EQ(wire.hears("705#R"), (Frames{"705#FF"})) << "the toggle bit";
}

/// The default channel, 605h, and a second one, 6A5h and 5A5h.
std::string domain_on_two_channels() {
  return record("1201") + entry("1201sub0", 5, "2", "const") + entry("1201sub1", 7, "0x6A5") +
         entry("1201sub2", 7, "0x5A5") + entry("2000", 15, "");
}

TEST(SheetDeviceDomain, TwoChannelsDoNotWriteItAtTheSameTime) {
  Wire wire(domain_on_two_channels());
  EXPECT_EQ(wire.hears("605#210020000A000000"), (Frames{"585#6000200000000000"}));
  EXPECT_EQ(wire.hears("605#0041414141414141"), (Frames{"585#2000000000000000"}));
  EXPECT_EQ(wire.hears("6A5#210020000A000000"), (Frames{"5A5#8000200022000008"}))
      << "0800 0022h: the device state forbids it";
  EXPECT_EQ(wire.hears("605#1941414100000000"), (Frames{"585#3000000000000000"}));
  EXPECT_EQ(wire.hears("6A5#210020000A000000"), (Frames{"5A5#6000200000000000"})) << "now";
  EXPECT_EQ(wire.hears("6A5#8000200000000008").size(), 0U);
  EXPECT_EQ(wire.hears("605#2100200001000000"), (Frames{"585#6000200000000000"}))
      << "what was aborted holds nobody up";
}

TEST(SheetDeviceDomain, AnUploadDoesNotGoOnInWhatCameMeanwhile) {
  Wire wire(domain_on_two_channels());
  wire.hears("605#210020000A000000");
  wire.hears("605#0041414141414141");
  wire.hears("605#1941414100000000");
  EXPECT_EQ(wire.hears("605#4000200000000000"), (Frames{"585#410020000A000000"}));
  EXPECT_EQ(wire.hears("605#6000000000000000"), (Frames{"585#0041414141414141"}));
  wire.hears("6A5#210020000A000000");
  wire.hears("6A5#0042424242424242");
  EXPECT_EQ(wire.hears("6A5#1942424200000000"), (Frames{"5A5#3000000000000000"}));
  EXPECT_EQ(wire.hears("605#7000000000000000"), (Frames{"585#8000200022000008"}))
      << "no mixture of the old and the new";
  EXPECT_EQ(wire.hears("605#4000200000000000"), (Frames{"585#410020000A000000"}));
  EXPECT_EQ(wire.hears("605#6000000000000000"), (Frames{"585#0042424242424242"}));
  EXPECT_EQ(wire.hears("605#7000000000000000"), (Frames{"585#1942424200000000"}));
}

TEST(SheetDevice, ADefaultThatTheNodeIdCarriesBeyondItsTypeIsLeftOut) {
  Wire wire(entry("2001", 5, "$NODEID+0x180") + entry("2002", 27, "$NODEID+0x7FFFFFFFFFFFFFFF") +
            entry("2003", 5, "$NODEID+0x80"));
  EXPECT_EQ(wire.device().left_out().size(), 2U);
  EXPECT_EQ(wire.hears("605#4001200000000000"), (Frames{"585#8001200000000206"}));
  EXPECT_EQ(wire.hears("605#4003200000000000"), (Frames{"585#4F03200085000000"}));
}

TEST(SheetDeviceOwnSheet, A1021hHoldsTheEdsOfTheDevice) {
  Wire wire(entry("1021", 0xF, "", "ro", "ObjectType=2\n") + entry("1022", 5, "0", "ro"));
  const Frames answer = wire.hears("605#4021100000000000");
  ASSERT_EQ(answer.size(), 1U);
  EXPECT_EQ(answer[0].substr(0, 12), "585#41211000") << "in segments, with its size";
  EXPECT_EQ(wire.hears("605#6000000000000000"), (Frames{"585#005B4D616E646174"})) << "[Mandat";
}

TEST(SheetDeviceOwnSheet, AnotherFormatIsNotOurs) {
  Wire wire(entry("1021", 0xF, "", "ro", "ObjectType=2\n") + entry("1022", 5, "1", "ro"));
  EXPECT_EQ(wire.hears("605#4021100000000000"), (Frames{"585#4121100000000000"})) << "empty";
}

TEST(SheetDevice, SaysWhichObjectsAreValuesOnly) {
  Wire wire(heartbeat() + entry("1023", 5, "0") + entry("1F80", 7, "0") + entry("1F89", 7, "0") +
            entry("1F8A", 7, "0") + entry("102A", 6, "0"));
  const auto ranges = wire.device().without_behaviour();
  std::vector<std::pair<unsigned, unsigned>> found;
  for (const auto& range : ranges) found.emplace_back(range.first, range.last);
  EXPECT_EQ(found, (std::vector<std::pair<unsigned, unsigned>>{
                       {0x1023, 0x1023}, {0x102A, 0x102A}, {0x1F80, 0x1F80}, {0x1F89, 0x1F8A}}));
}

}  // namespace
}  // namespace canvoy::formats::sheet_device_services_test
