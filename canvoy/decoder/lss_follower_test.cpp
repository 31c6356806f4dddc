// Expected values are typed from CiA 305: which messages select a device, and what they assign to
// it.
#include "canvoy/decoder/lss_follower.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder::lss_follower_test {
namespace {

constexpr std::uint32_t vendor = 0x2F0;
constexpr std::uint32_t product = 0x1A3;
constexpr std::uint32_t revision = 0x10000;
constexpr std::uint32_t serial = 77;

using Frames = std::vector<std::string_view>;

Identity whole() {
  Identity identity;
  identity.set(LssAddress::vendor, vendor);
  identity.set(LssAddress::product, product);
  identity.set(LssAddress::revision, revision);
  identity.set(LssAddress::serial, serial);
  return identity;
}

const Frames selective = {"7E5#40F0020000000000", "7E5#41A3010000000000", "7E5#4200000100000000",
                          "7E5#434D000000000000", "7E4#4400000000000000"};
/// The last request of each part: bit checked 0, LSSSub and then LSSNext.
const Frames fastscan = {"7E5#5100000000800000", "7E4#4F00000000000000", "7E5#51F0020000000001",
                         "7E4#4F00000000000000", "7E5#51A3010000000102", "7E4#4F00000000000000",
                         "7E5#5100000100000203", "7E4#4F00000000000000", "7E5#514D000000000300",
                         "7E4#4F00000000000000"};
const Frames set_5 = {"7E5#1105000000000000", "7E4#1100000000000000"};

class LssFollowerTest : public testing::Test {
 protected:
  /// The result of the last frame.
  const LssFollower::Device* feed(const Frames& frames) {
    const LssFollower::Device* told = nullptr;
    for (const std::string_view text : frames) told = sut_.take(parse_frame(text).frame);
    return told;
  }
  LssFollower sut_;
};

TEST_F(LssFollowerTest, KnowsTheDeviceThatIsSelectedByItsFourNumbers) {
  const LssFollower::Device* device = feed(selective);
  ASSERT_NE(device, nullptr);
  EXPECT_EQ(device->identity, whole());
  EXPECT_EQ(device->node, 0);
}

TEST_F(LssFollowerTest, KnowsTheDeviceThatFastscanFinds) {
  const LssFollower::Device* device = feed(fastscan);
  ASSERT_NE(device, nullptr);
  EXPECT_EQ(device->identity, whole());
}

TEST_F(LssFollowerTest, TakesNoNumberOfFastscanThatNobodyConfirms) {
  feed({"7E5#5100000000800000", "7E4#4F00000000000000", "7E5#51F0020000000001",
        "7E5#51F1020000000001", "7E4#4F00000000000000", "7E5#514D000000000300"});
  const LssFollower::Device* device = feed({"7E4#4F00000000000000"});
  ASSERT_NE(device, nullptr);
  EXPECT_EQ(device->identity.part(LssAddress::vendor), 0x2F1U);
  EXPECT_FALSE(device->identity.has(LssAddress::product));
}

TEST_F(LssFollowerTest, BeginsAnewWithEachScan) {
  feed(fastscan);
  feed({"7E5#5100000000800000", "7E4#4F00000000000000"});
  const LssFollower::Device* device = feed({"7E5#514E000000000300", "7E4#4F00000000000000"});
  ASSERT_NE(device, nullptr);
  EXPECT_FALSE(device->identity.has(LssAddress::vendor));
}

TEST_F(LssFollowerTest, BelievesANodeIdThatIsConfirmed) {
  feed(selective);
  EXPECT_EQ(feed({"7E5#1105000000000000"}), nullptr);
  EXPECT_EQ(feed({"7E4#1101000000000000"}), nullptr) << "refused";
  const LssFollower::Device* device = feed(set_5);
  ASSERT_NE(device, nullptr);
  EXPECT_EQ(device->node, 5);
  EXPECT_EQ(device->identity, whole());
  EXPECT_EQ(feed({"7E5#1700000000000000", "7E4#1700000000000000"}), device) << "stored";
}

TEST_F(LssFollowerTest, TakesANodeIdAwayByFFh) {
  feed(selective);
  feed(set_5);
  const LssFollower::Device* device = feed({"7E5#11FF000000000000", "7E4#1100000000000000"});
  ASSERT_NE(device, nullptr);
  EXPECT_EQ(device->node, 0);
}

TEST_F(LssFollowerTest, PutsTogetherWhatIsInquired) {
  feed({"7E5#0401000000000000", "7E5#5A00000000000000", "7E4#5AF0020000000000",
        "7E5#5D00000000000000", "7E4#5D4D000000000000"});
  const LssFollower::Device* device = feed({"7E5#5E00000000000000", "7E4#5E07000000000000"});
  ASSERT_NE(device, nullptr);
  EXPECT_EQ(device->node, 7);
  EXPECT_EQ(device->identity.part(LssAddress::serial), serial);
  EXPECT_FALSE(device->identity.has(LssAddress::product));
}

TEST_F(LssFollowerTest, KnowsNoNumberThatSeveralDevicesAnswer) {
  feed({"7E5#0401000000000000", "7E5#5A00000000000000", "7E4#5AF0020000000000"});
  EXPECT_EQ(feed({"7E4#5AF1020000000000"}), nullptr);
  const LssFollower::Device* device = feed({"7E5#5E00000000000000", "7E4#5E07000000000000"});
  ASSERT_NE(device, nullptr);
  EXPECT_TRUE(device->identity.empty());
}

TEST_F(LssFollowerTest, ForgetsTheDeviceWhenAllAreSwitched) {
  feed(selective);
  feed({"7E5#0400000000000000", "7E5#0401000000000000"});
  const LssFollower::Device* device = feed(set_5);
  ASSERT_NE(device, nullptr);
  EXPECT_TRUE(device->identity.empty());
}

TEST_F(LssFollowerTest, LivesWithEveryPairOfCommands) {
  for (unsigned first = 0; first < 0x100; ++first) {
    for (unsigned second = 0; second < 0x100; ++second) {
      const auto byte = static_cast<std::uint8_t>(second);
      sut_.take(Frame::data_frame(
          0x7E5, {static_cast<std::uint8_t>(first), byte, 1, 2, 3, byte, byte, byte}));
      const LssFollower::Device* device =
          sut_.take(Frame::data_frame(0x7E4, {byte, byte, 1, 2, 3, 4, 5, 6}));
      ASSERT_TRUE(device == nullptr || device->node <= 127);
    }
  }
}

class DeviceTest : public testing::Test {
 protected:
  const Decoded& feed(const Frames& frames) {
    const Decoded* last = nullptr;
    for (const std::string_view text : frames) last = &sut_.decode(parse_frame(text).frame);
    return *last;
  }
  /// 1000h, then vendor-ID and product code as other nodes read them from node 9.
  void report_product_of_node_9() {
    feed({"589#43001000A3010000", "589#43181001F0020000", "589#43181002A3010000"});
  }
  Decoder sut_;
};

TEST_F(DeviceTest, HasTheIdentityThatLssSelectedBefore) {
  feed(selective);
  const Decoded& decoded = feed(set_5);
  ASSERT_NE(decoded.news, nullptr);
  EXPECT_EQ(decoded.news->node, 5);
  EXPECT_TRUE(decoded.news->has_identity);
  EXPECT_EQ(sut_.network().identity(5), whole());
}

TEST_F(DeviceTest, HasTheIdentityThatOthersRead) {
  feed({"585#43181001F0020000", "585#431810044D000000"});
  EXPECT_EQ(sut_.network().identity(5).part(LssAddress::serial), serial);
  EXPECT_FALSE(sut_.network().identity(5).is_product());
}

TEST_F(DeviceTest, HasTheProfileThatAnotherOneOfItsProductHas) {
  report_product_of_node_9();
  feed(selective);
  const Decoded& decoded = feed(set_5);
  EXPECT_EQ(sut_.network().profile(5).number, 419);
  ASSERT_NE(decoded.news, nullptr);
  EXPECT_EQ(decoded.news->profile_by, KnownBy::product);
}

TEST_F(DeviceTest, KeepsWhatItTellsItselfRatherThanWhatOthersOfItsProductTold) {
  report_product_of_node_9();
  feed({"585#43001000A2010000", "585#43181001F0020000", "585#43181002A3010000"});
  EXPECT_EQ(sut_.network().profile(5).number, 418);
}

TEST_F(DeviceTest, HasTheDataSheetOfItsProduct) {
  Profile profile = *find_profile("418");
  DeviceSheet sheet{.identity = whole(), .profile = &profile};
  // 1800h:01h = 333h + node-ID, 1A00h: one entry, 6010h:00h with 16 bits.
  sheet.parameters = {{0x1800, 1, 0x333, true}, {0x1A00, 1, 0x60100010}, {0x1A00, 0, 1}};
  sut_.network().add_sheet(sheet);
  feed({"585#43001000A3010000", "585#43181001F0020000"});
  EXPECT_EQ(sut_.network().profile(5).number, 419);
  const Decoded& decoded = feed({"585#43181002A3010000"});
  ASSERT_NE(decoded.news, nullptr);
  EXPECT_EQ(decoded.news->profile_by, KnownBy::sheet);
  EXPECT_EQ(&sut_.network().profile(5), &profile);
  ASSERT_EQ(feed({"338#A000"}).values.size(), 1U);
}

TEST_F(DeviceTest, ThatReplacesAnotherOneIsNotTakenForIt) {
  feed({"585#43001000A2010000", "585#431810044D000000", "605#2301180133030000",
        "585#6001180100000000"});
  EXPECT_EQ(sut_.network().profile(5).number, 418);
  feed({"585#431810044E000000"});
  EXPECT_EQ(sut_.network().profile(5).number, base_profile().number);
  EXPECT_EQ(sut_.network().pdo(0x333), nullptr);
  EXPECT_EQ(sut_.network().pdo(0x185), nullptr);
}

TEST_F(DeviceTest, ThatSomebodyGaveAProfileKeepsItWhoeverItIs) {
  sut_.network().set_profile(5, *find_profile("419"));
  feed({"585#43001000A2010000", "585#431810044D000000", "585#431810044E000000"});
  EXPECT_EQ(sut_.network().profile(5).number, 419);
}

TEST_F(DeviceTest, HasTheProfileOfTheNetworkUntilItTellsItsOwn) {
  sut_.network().assume_profile(*find_profile("419"));
  EXPECT_EQ(feed({"285#011002"}).values.size(), 2U);
  feed({"585#43001000A2010000"});
  EXPECT_EQ(sut_.network().profile(5).number, 418);
  // TPDO1 is temperature and status (CiA 418).
  EXPECT_EQ(feed({"185#A00001"}).values.size(), 2U);
  EXPECT_EQ(sut_.network().profile(6).number, 419);
}

TEST_F(DeviceTest, IsReadByTheReadingThatIsChosen) {
  Profile reading = *find_profile("419");
  sut_.network().replace_profile(*find_profile("419"), reading);
  feed({"585#43001000A3010000"});
  EXPECT_EQ(&sut_.network().profile(5), &reading);
}

}  // namespace
}  // namespace canvoy::decoder::lss_follower_test
