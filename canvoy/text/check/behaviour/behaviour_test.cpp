// The devices of the catalogue behave as the cases require, with a person at hand; and each case is
// run with at least one of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"
#include "canvoy/text/check/testing/checked_device.hpp"
#include "canvoy/text/check/testing/workshop.hpp"

namespace canvoy::conformance::behaviour_test {
namespace {

/// The cases of CiA 401 are also run with the profile that is built on it.
constexpr std::string_view profiles[] = {"401", "407", "417-4", "419", "447-3", "852"};

Report try_behaviour(const DeviceKind& kind, Workshop& workshop) {
  CheckedDevice device(kind, workshop.environment);
  workshop.drive.connect(device.device());
  Check check(device.line(), device.node(),
              {.moves = true, .profile = kind.profile, .hand = workshop.hands.answer()});
  return check.run({}, "behaviour");
}

/// No device of the catalogue fails a case, and each case can be run with some device.
TEST(Behaviour, OfTheCatalogueIsAsTheClausesSay) {
  std::map<std::string, std::string> untried;
  for (const std::string_view name : profiles) {
    for (const TestCase& each : all_cases(find_profile(name))) {
      if (each.group == Group::behaviour) untried.try_emplace(each.id, "no device of it");
    }
  }
  for (const DeviceKind* kind : every_device_kind()) {
    SCOPED_TRACE(kind->info.name);
    Workshop workshop;
    const Report report = try_behaviour(*kind, workshop);
    EXPECT_TRUE(report.is_whole);
    EXPECT_THAT(report.notes, ::testing::IsEmpty());
    EXPECT_THAT(workshop.hands.unknown, ::testing::IsEmpty());
    for (const TestResult& each : report.results) {
      EXPECT_NE(each.verdict.outcome, Outcome::failed) << each.test->id << ": " << each.verdict.why;
      if (each.verdict.outcome == Outcome::passed) untried.erase(each.test->id);
      if (untried.contains(each.test->id)) untried[each.test->id] = each.verdict.why;
    }
  }
  for (const auto& [id, why] : untried) ADD_FAILURE() << id << " is tried by none: " << why;
}

/// A charger with a pilot contact that cannot be closed gives no verdict.
TEST(Behaviour, OfAChargerNeedsItsPilotContact) {
  Workshop workshop;
  const DeviceKind& kind = *find_device_kind("charger");
  CheckedDevice device(kind, workshop.environment);
  Check check(device.line(), device.node(), {.profile = kind.profile});
  const Report report = check.run({}, "419-link-01");
  ASSERT_EQ(report.results.size(), 1U);
  EXPECT_EQ(report.results[0].verdict.outcome, Outcome::not_applicable);
}

/// A wrong state that a person sees is a failure; an impossible request gives no verdict.
TEST(Behaviour, IsJudgedByWhatIsSeen) {
  for (const HandAnswer answer : {HandAnswer::no, HandAnswer::cannot}) {
    Workshop workshop;
    const DeviceKind& kind = *find_device_kind("operator");
    CheckedDevice device(kind, workshop.environment);
    Check check(device.line(), device.node(),
                {.moves = true, .profile = kind.profile, .hand = [answer](const HandRequest&) {
                   return answer;
                 }});
    const Report report = check.run({}, "852-indicator-01");
    ASSERT_EQ(report.results.size(), 1U);
    EXPECT_EQ(report.results[0].verdict.outcome,
              answer == HandAnswer::no ? Outcome::failed : Outcome::not_applicable);
  }
}

/// Without --moves no object of the application is written, neither by SDO nor by PDO.
TEST(Behaviour, WritesNothingWhereNothingMayMove) {
  Workshop workshop;
  const DeviceKind& kind = *find_device_kind("lift-door");
  CheckedDevice device(kind, workshop.environment);
  bool has_written = false;
  device.to_device = [&](Frame& frame) {
    const bool is_rpdo = frame.id >= 0x180 && frame.id < 0x580;
    const bool is_write = frame.id == can_id::sdo_request + std::uint32_t{device.node()} &&
                          (frame.data[0] & 0xE0) == 0x20 && frame.data[2] >= 0x60;
    has_written = has_written || is_rpdo || is_write;
    return true;
  };
  Check check(device.line(), device.node(),
              {.profile = kind.profile, .hand = workshop.hands.answer()});
  const Report report = check.run({}, "behaviour");
  EXPECT_FALSE(has_written);
  EXPECT_TRUE(workshop.door.orders.empty() ||
              workshop.door.orders.back().motion == cia417::DoorDrive::Motion::none);
}

/// At least twenty for each profile, with unique ids, and each with complete texts.
TEST(BehaviourCases, AreTwentyOrMoreForEachProfile) {
  for (const std::string_view name : profiles) {
    std::set<std::string> ids;
    std::size_t behaviours = 0;
    for (const TestCase& each : all_cases(find_profile(name))) {
      EXPECT_TRUE(ids.insert(each.id).second) << each.id;
      if (each.group != Group::behaviour) continue;
      ++behaviours;
      EXPECT_FALSE(each.sends.empty()) << each.id;
      EXPECT_FALSE(each.expects.empty()) << each.id;
      EXPECT_TRUE(each.clause.starts_with("CiA ")) << each.id;
    }
    EXPECT_GE(behaviours, 20U) << name;
  }
}

}  // namespace
}  // namespace canvoy::conformance::behaviour_test
