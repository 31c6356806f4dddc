#include "canvoy/tools/page/object_list.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools::object_list_test {
namespace {

std::vector<std::string> found(std::string_view profile, std::string_view search) {
  std::vector<std::string> indices;
  for (const auto& each : object_list_json(*find_profile(profile), search)) {
    indices.push_back(each["object"].get<std::string>());
  }
  return indices;
}

TEST(ObjectList, RanksAnObjectOfTheNameBeforeMappingsOfIt) {
  // 6060h is the battery voltage; TPDO mappings have an entry with a similar name (CiA 418).
  const auto indices = found("418", "battery voltage");
  ASSERT_GT(indices.size(), 1U);
  EXPECT_EQ(indices.front(), "6060");
  EXPECT_LT(indices.back(), "2000");
}

TEST(ObjectList, RanksByIndexNameBeginningWordsAndParts) {
  EXPECT_EQ(found("418", "6010").front(), "6010");
  EXPECT_EQ(found("418", "temperature").front(), "6010");
  EXPECT_EQ(found("418", "voltage battery").front(), "6060");
  EXPECT_EQ(found("418", "BATTERY_VOLTAGE").front(), "6060");
  EXPECT_EQ(found("418", "no such thing"), std::vector<std::string>());
}

TEST(ObjectList, ListsProcessValuesBeforeParametersOfCommunication) {
  const auto indices = found("418", "");
  ASSERT_FALSE(indices.empty());
  const auto plumbing =
      std::ranges::find_if(indices, [](const auto& each) { return each < "2000"; });
  ASSERT_NE(plumbing, indices.begin());
  EXPECT_TRUE(std::all_of(plumbing, indices.end(), [](const auto& each) { return each < "2000"; }));
}

}  // namespace
}  // namespace canvoy::tools::object_list_test
