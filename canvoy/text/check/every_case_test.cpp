// Every case has a device that it finds, or stands in the list of those without one. The devices
// are those of the other tests, which prove that each is found; cases from the data of a profile
// are judged by profile_sweep_test.cpp, which lists those that it has no device for itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/check/testing/all_ways.hpp"
#include "canvoy/text/check/testing/unbroken_cases.hpp"

namespace canvoy::conformance::every_case_test {
namespace {

constexpr std::string_view profiles[] = {"401", "407", "417-4", "418", "419", "447-3", "852"};

/// Cases that a broken device of a table is found by, or a sheet that is none.
std::set<std::string, std::less<>> found_cases() {
  std::set<std::string, std::less<>> found = {"eds-01"};
  for (auto&& ways : {module_ways(), lss_ways(), communication_ways(), master_ways(),
                      program_ways(), keeping_ways()}) {
    for (const Way& way : ways) found.insert(way.found_by.begin(), way.found_by.end());
  }
  for (auto&& broken : {behaviour_ways(), transport_ways()}) {
    for (const BrokenDevice& each : broken) {
      found.insert(each.way.found_by.begin(), each.way.found_by.end());
    }
  }
  for (const std::string& id : lied_cases()) found.insert(id);
  return found;
}

bool is_swept(const TestCase& test) {
  return test.group == Group::profile || test.id.starts_with("302-1");
}

TEST(EveryCase, IsFoundOrListed) {
  const auto found = found_cases();
  std::set<std::string, std::less<>> ids;
  for (const std::string_view profile : profiles) {
    for (const TestCase& test : all_cases(find_profile(profile))) {
      ids.insert(test.id);
      if (is_swept(test) || found.contains(test.id)) continue;
      EXPECT_TRUE(is_unbroken(test.id)) << test.id << ": no broken device is found by it";
    }
  }
  for (const std::string& id : found) EXPECT_TRUE(ids.contains(id)) << id << " is no case";
  for (const UnbrokenCase& each : unbroken_cases) {
    EXPECT_TRUE(ids.contains(each.id)) << each.id << " is no case";
    EXPECT_FALSE(found.contains(each.id)) << each.id << " is found: it leaves the list";
  }
}

}  // namespace
}  // namespace canvoy::conformance::every_case_test
