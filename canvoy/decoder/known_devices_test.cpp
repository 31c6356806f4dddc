#include "canvoy/decoder/known_devices.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder::known_devices_test {
namespace {

const Profile& battery = *find_profile("418");
const Profile& charger = *find_profile("419");

Identity product(std::uint32_t vendor, std::uint32_t code) {
  Identity identity;
  identity.set(LssAddress::vendor, vendor);
  identity.set(LssAddress::product, code);
  return identity;
}

TEST(KnownDevices, KeepWhatIsKnownBetterAndTakeWhatIsKnownAsWell) {
  constexpr KnownBy all[] = {KnownBy::assumed, KnownBy::product, KnownBy::device_type,
                             KnownBy::sheet, KnownBy::given};
  for (const KnownBy before : all) {
    for (const KnownBy later : all) {
      KnownDevices sut;
      EXPECT_TRUE(sut.use_profile(5, battery, before));
      EXPECT_EQ(sut.use_profile(5, charger, later), later >= before);
      EXPECT_EQ(&sut.profile(5), later >= before ? &charger : &battery);
      EXPECT_EQ(sut.known_by(5), std::max(before, later));
    }
  }
}

TEST(KnownDevices, WhoseProfileIsConfirmedAreNoNewsButKnownBetter) {
  KnownDevices sut;
  sut.use_profile(5, charger, KnownBy::assumed);
  EXPECT_FALSE(sut.use_profile(5, charger, KnownBy::device_type));
  EXPECT_FALSE(sut.use_profile(5, battery, KnownBy::product));
  EXPECT_EQ(&sut.profile(5), &charger);
}

TEST(KnownDevices, HaveNodeIdsUpTo127AndAnyOtherIsOfANodeOfWhichNothingIsKnown) {
  KnownDevices sut;
  sut.use_profile(127, charger, KnownBy::given);
  EXPECT_EQ(&sut.profile(127), &charger);
  EXPECT_EQ(&sut.profile(128), &base_profile());
  EXPECT_EQ(&sut.profile(255), &base_profile());
}

TEST(KnownDevices, ThatComeBackTellTheirIdentityAnewWhetherTheirProfileWasGivenOrHeard) {
  for (const KnownBy by : {KnownBy::given, KnownBy::device_type}) {
    KnownDevices sut;
    sut.use_profile(5, charger, by);
    EXPECT_TRUE(sut.add_identity(5, product(1, 2)));
    EXPECT_FALSE(sut.add_identity(5, product(1, 2)));
    sut.forget(5);
    EXPECT_TRUE(sut.identity(5).empty());
    EXPECT_TRUE(sut.add_identity(5, product(1, 2)));
  }
}

TEST(KnownDevices, TellOthersOfTheirKindAfterTheyHaveGone) {
  KnownDevices sut;
  sut.add_identity(9, product(1, 2));
  sut.use_profile(9, charger, KnownBy::device_type);
  sut.forget(9);
  for (const auto& [node, identity] :
       {std::pair(NodeId{5}, product(1, 2)), std::pair(NodeId{6}, product(1, 3)),
        std::pair(NodeId{7}, product(2, 2))}) {
    sut.add_identity(node, identity);
  }
  EXPECT_EQ(sut.product_of(5), &charger);
  EXPECT_EQ(sut.product_of(6), nullptr) << "another product code";
  EXPECT_EQ(sut.product_of(7), nullptr) << "another vendor-ID";
}

/// A product code of 0 is a normal one, not an unknown one.
TEST(KnownDevices, OfWhichTheProductCodeIsNotKnownTellNobody) {
  KnownDevices sut;
  Identity vendor_alone;
  vendor_alone.set(LssAddress::vendor, 1);
  sut.add_identity(9, vendor_alone);
  sut.use_profile(9, charger, KnownBy::device_type);
  sut.add_identity(5, product(1, 0));
  EXPECT_EQ(sut.product_of(5), nullptr);
}

/// Only a node that reports its profile counts, not one with an assumed profile: a wrong guess
/// would spread.
TEST(KnownDevices, OfWhichAProfileIsOnlyAssumedTellNobody) {
  KnownDevices sut;
  sut.add_identity(9, product(1, 2));
  sut.use_profile(9, charger, KnownBy::assumed);
  sut.add_identity(5, product(1, 2));
  EXPECT_EQ(sut.product_of(5), nullptr);
}

/// On a bus where garbage gives ever new products, memory is bounded.
TEST(KnownDevices, RememberTheFirst1024Products) {
  KnownDevices sut;
  for (std::uint32_t code = 0; code <= 1024; ++code) {
    sut.forget(9);
    sut.add_identity(9, product(1, code));
    sut.use_profile(9, charger, KnownBy::device_type);
  }
  const auto known = [&sut](std::uint32_t code) {
    sut.forget(5);
    sut.add_identity(5, product(1, code));
    return sut.product_of(5);
  };
  EXPECT_EQ(known(0), &charger);
  EXPECT_EQ(known(1023), &charger);
  EXPECT_EQ(known(1024), nullptr);
}

/// Setting it again would discard what was heard of the device since.
TEST(KnownDevices, GetTheirDataSheetOnce) {
  const DeviceSheet sheet{.identity = product(1, 2), .profile = &battery};
  KnownDevices sut;
  sut.add_sheet(sheet);
  sut.add_identity(5, product(1, 2));
  sut.use_profile(5, charger, KnownBy::device_type);
  EXPECT_EQ(sut.sheet_of(5), &sheet);
  sut.use_profile(5, battery, KnownBy::sheet);
  EXPECT_EQ(sut.sheet_of(5), nullptr);
  sut.forget(5);
  sut.add_identity(5, product(1, 3));
  EXPECT_EQ(sut.sheet_of(5), nullptr) << "another product code";
  sut.add_identity(5, product(1, 2));
  EXPECT_EQ(sut.sheet_of(5), &sheet) << "the device is back";
}

/// Another profile of a known product needs no further slot.
TEST(KnownDevices, OfAProductThatIsKnownAreToldAnewWhereThereAreNoMorePlaces) {
  KnownDevices sut;
  for (std::uint32_t code = 0; code < 1024; ++code) {
    sut.forget(9);
    sut.add_identity(9, product(1, code));
    sut.use_profile(9, charger, KnownBy::device_type);
  }
  sut.forget(9);
  sut.add_identity(9, product(1, 5));
  sut.use_profile(9, battery, KnownBy::device_type);
  sut.add_identity(5, product(1, 5));
  EXPECT_EQ(sut.product_of(5), &battery);
}

TEST(KnownDevices, OfWhichNothingIsKnownHaveNoDataSheetThatIsOfNoProduct) {
  const DeviceSheet sheet{.profile = &battery};
  KnownDevices sut;
  sut.add_sheet(sheet);
  EXPECT_EQ(sut.sheet_of(5), nullptr);
}

}  // namespace
}  // namespace canvoy::decoder::known_devices_test
