// Each case that is drawn from the data of a profile, with a device that breaks its rule and no
// other: it is found by that case, and by no other. The devices are made of the profile's data; one
// row of their dictionary is changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "canvoy/can/testing/tries_all.hpp"
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

/// What a node does by itself, whatever its rows are, is changed on the line: the device takes what
/// is beyond a range, or has a reserved bit in its error register.
void break_on_line(PaperDevice& device, const CaseName& name) {
  device.from_device = [&device, name](Frame& frame) {
    const std::uint32_t answers = can_id::sdo_response + device.node();
    if (frame.id != answers || index_of(frame) != name.index) return true;
    for (const AbortCode code :
         {AbortCode::value_range, AbortCode::value_too_high, AbortCode::value_too_low}) {
      if (name.row == "range" && is_abort(frame, name.index, code)) say_written(frame);
    }
    const bool is_register = name.row == "fields" && name.index == object_index::error_register;
    if (is_register && (frame.data[0] & 0xE0) == 0x40) {
      const auto reserved = reserved_number(name.object->entry, {});
      frame.data[4] |= static_cast<std::uint8_t>(reserved.value_or(0));
    }
    return true;
  };
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
  /// A device with one defect; without a change, the one that is made on the line.
  std::vector<std::string> try_broken(const std::string& id, const PaperDevice::Change& change,
                                      std::string_view only) const {
    PaperDevice device(profile_, passed_.at(id), change);
    if (const auto name = parse_case(profile_, id); !change && name && name->object != nullptr) {
      break_on_line(device, *name);
    }
    return failures(try_profile(device, profile_, only));
  }
  /// The cases that find the first broken device that this one finds: this one, or all of them.
  std::vector<std::string> find_with(const std::string& id, bool with_all) const {
    Changes changes = ways_to_break(profile_, id);
    changes.push_back(nullptr);
    for (const PaperDevice::Change& change : changes) {
      std::vector<std::string> found = try_broken(id, change, id);
      if (found.empty()) continue;
      return with_all ? try_broken(id, change, "profile") : found;
    }
    return {};
  }
};

/// Each case, or a share of them; of a smaller share, whether all others pass, which takes a run of
/// all cases for each.
bool is_tried(std::size_t number) {
  constexpr std::size_t share = 3;
  return tries_all() || number % share == 0;
}
bool is_tried_with_all(std::size_t number) {
  constexpr std::size_t share = 42;
  return tries_all() || number % share == 0;
}

TEST_P(ProfileSweep, EachCaseFindsWhatBreaksItsRuleAndNoOtherDoes) {
  try_whole_devices();
  std::size_t number = 0;
  for (const TestCase& test : all_cases(&profile_)) {
    if (test.group != Group::profile) continue;
    if (!passed_.contains(test.id)) {
      EXPECT_TRUE(is_unbroken(test.id)) << test.id << ": no device passes it";
      continue;
    }
    EXPECT_FALSE(is_unbroken(test.id)) << test.id << " is found: it leaves the list";
    if (!is_tried(++number)) continue;
    std::vector<std::string> found = find_with(test.id, is_tried_with_all(number));
    std::erase_if(
        found, [&](const std::string& other) { return breaks_as_well(profile_, test.id, other); });
    EXPECT_THAT(found, ::testing::ElementsAre(test.id));
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
