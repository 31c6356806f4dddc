// Each device of the catalogue passes all cases, and defects are found.
#include "canvoy/text/check/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/formats/sheet/sheet_export.hpp"
#include "canvoy/text/check/testing/checked_device.hpp"

namespace canvoy::conformance::check_test {
namespace {

formats::DataSheet sheet_of(const DeviceKind& kind) {
  formats::SheetMaker maker(*kind.profile, {.product_name = kind.info.product});
  Environment environment;
  for (const Part& part : kind.form(environment).parts()) maker.add(part);
  return maker.take();
}

/// A known finding in a device of the catalogue.
struct KnownFinding {
  unsigned profile;
  std::string_view device;  ///< a part of its name; empty: all devices
  std::string_view test;
  std::string_view reason;
};
constexpr KnownFinding known_findings[] = {
    {417, "lift-group", "417-4-6001-there", "on the bus of a group no object has a lift number"},
};
bool is_known(const DeviceKind& kind, std::string_view test) {
  return std::ranges::any_of(known_findings, [&](const KnownFinding& each) {
    return each.profile == kind.profile->number && each.test == test &&
           kind.info.name.find(each.device) != std::string_view::npos;
  });
}

class CheckOf : public ::testing::TestWithParam<const DeviceKind*> {};

TEST_P(CheckOf, TheCataloguePassesEachCase) {
  const DeviceKind& kind = *GetParam();
  CheckedDevice device(kind);
  const formats::DataSheet sheet = sheet_of(kind);
  Check check(device.line(), device.node(), {.sheet = &sheet, .profile = kind.profile});
  const Report report = check.run();
  ASSERT_TRUE(report.has_answered);
  EXPECT_TRUE(report.is_whole);
  EXPECT_THAT(report.notes, ::testing::IsEmpty());
  for (const TestResult& each : report.results) {
    if (is_known(kind, each.test->id)) continue;
    EXPECT_NE(each.verdict.outcome, Outcome::failed) << each.test->id << ": " << each.verdict.why;
  }
  EXPECT_GT(report.count(Outcome::passed), 60U);
}

INSTANTIATE_TEST_SUITE_P(Devices, CheckOf, ::testing::ValuesIn(every_device_kind()),
                         [](const auto& each) { return test_name(*each.param); });

/// 1017h and 1800h were configured before, and are not stored: the resets of some cases undo them.
TEST(CheckDevice, IsAfterwardsAsItWas) {
  const DeviceKind& kind = *find_device_kind("io-401");
  CheckedDevice device(kind);
  Bench bench(device.line(), device.node(), {});
  ASSERT_TRUE(bench.write(0x1017, 0, 777, 2));
  const std::uint32_t cob_id = bench.number(0x1800, 1).value_or(0);
  ASSERT_TRUE(bench.write(0x1800, 1, cob_id | CobId::bit31, 4));
  ASSERT_TRUE(bench.write(0x1800, 2, 7, 1));
  ASSERT_TRUE(bench.write(0x1800, 1, 0x0000'06A5, 4));
  bench.command(NmtCommand::start);
  Check check(device.line(), device.node(), {});
  const Report report = check.run();
  EXPECT_THAT(report.notes, ::testing::IsEmpty());
  EXPECT_EQ(bench.number(0x1017, 0), 777U);
  EXPECT_EQ(bench.number(0x1800, 1), 0x0000'06A5U);
  EXPECT_EQ(bench.number(0x1800, 2), 7U);
  EXPECT_EQ(device.device().state(), NmtState::operational);
}

}  // namespace
}  // namespace canvoy::conformance::check_test
