// Each case that is drawn from the data of a profile, with a device that breaks its rule and no
// other: it is found by that case, and by no other. The devices are made of the profile's data; one
// row of their dictionary is changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "canvoy/profiles/cia302.hpp"
#include "canvoy/text/check/testing/broken_paper.hpp"
#include "canvoy/text/check/testing/middle.hpp"
#include "canvoy/text/check/testing/unbroken_cases.hpp"

namespace canvoy::conformance::profile_sweep_test {
namespace {

/// The virtual devices of a profile; without any, one device.
std::vector<const VirtualDeviceInfo*> devices_of(const Profile& profile) {
  std::vector<const VirtualDeviceInfo*> all;
  for (const VirtualDeviceInfo& each : profile.virtual_devices) all.push_back(&each);
  if (all.empty()) all.push_back(nullptr);
  return all;
}

Report try_profile(PaperDevice& device, const Profile& profile, std::string_view only) {
  Check check(device.line(), device.node(), {.moves = true, .profile = &profile});
  return check.run({}, only);
}

class ProfileSweep : public ::testing::TestWithParam<std::string_view> {
 protected:
  const Profile& profile_ = *find_profile(GetParam());
  /// Of each case, a device that passes it.
  std::map<std::string, const VirtualDeviceInfo*> passed_;

  void try_whole_devices() {
    for (const VirtualDeviceInfo* each : devices_of(profile_)) {
      PaperDevice device(profile_, each);
      const Report report = try_profile(device, profile_, "profile");
      EXPECT_TRUE(report.is_whole);
      for (const TestResult& result : report.results) {
        EXPECT_NE(result.verdict.outcome, Outcome::failed)
            << (each != nullptr ? each->name : "") << " " << result.test->id << ": "
            << result.verdict.why;
        if (result.verdict.outcome == Outcome::passed) passed_.try_emplace(result.test->id, each);
      }
    }
  }
};

TEST_P(ProfileSweep, EachCaseFindsWhatBreaksItsRuleAndNoOtherDoes) {
  try_whole_devices();
  std::set<std::string> without;
  for (const TestCase& test : all_cases(&profile_)) {
    if (test.group != Group::profile) continue;
    if (!passed_.contains(test.id)) {
      without.insert(test.id);
      continue;
    }
    std::vector<std::string> found;
    for (const PaperDevice::Change& change : ways_to_break(profile_, test.id)) {
      PaperDevice device(profile_, passed_.at(test.id), change);
      found = failures(try_profile(device, profile_, "profile"));
      if (std::ranges::find(found, test.id) != found.end()) break;
    }
    EXPECT_THAT(found, ::testing::ElementsAre(test.id));
    EXPECT_FALSE(is_unbroken(test.id)) << test.id << " is found: it leaves the list";
  }
  for (const std::string& id : without) {
    EXPECT_TRUE(is_unbroken(id)) << id << ": no device passes it";
  }
}

/// The objects of CiA 302 are judged in devices of any profile, each by one case for all rules.
TEST(ManagerSweep, EachCaseFindsWhatBreaksItsRuleAndNoOtherDoes) {
  const auto try_all = [](PaperDevice& device) {
    Check check(device.line(), device.node(), {.moves = true});
    return check.run({}, "302-1");
  };
  PaperDevice whole(cia302::profile, nullptr);
  std::size_t tried = 0;
  for (const TestResult& each : try_all(whole).results) {
    ASSERT_NE(each.verdict.outcome, Outcome::failed) << each.test->id << ": " << each.verdict.why;
    const auto index = static_cast<std::uint16_t>(std::stoul(each.test->id.substr(4), nullptr, 16));
    if (each.verdict.outcome != Outcome::passed) {
      EXPECT_TRUE(is_unbroken(each.test->id)) << each.test->id << ": " << each.verdict.why;
      continue;
    }
    const ObjectInfo& object = *find_object(cia302::profile, index);
    Changes changes = other_types(object, index);
    for (const auto& change : other_accesses(object, index)) changes.push_back(change);
    std::vector<std::string> found;
    for (const PaperDevice::Change& change : changes) {
      PaperDevice broken(cia302::profile, nullptr, change);
      found = failures(try_all(broken));
      if (!found.empty()) break;
    }
    EXPECT_THAT(found, ::testing::ElementsAre(each.test->id));
    ++tried;
  }
  EXPECT_GE(tried, 20U);
}

INSTANTIATE_TEST_SUITE_P(Profiles, ProfileSweep,
                         ::testing::Values("401", "407", "417-4", "418", "419", "447-3", "852"),
                         [](const auto& each) {
                           std::string name = "CiA" + std::string(each.param);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace canvoy::conformance::profile_sweep_test
