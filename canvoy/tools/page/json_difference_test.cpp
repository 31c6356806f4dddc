#include "canvoy/tools/page/json_difference.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace canvoy::tools::json_difference_test {
namespace {

using Json = nlohmann::ordered_json;

/// The merge of the library is the reference.
void expect_merges(const char* before, const char* after, const char* patch) {
  const Json found = json_difference(Json::parse(before), Json::parse(after));
  EXPECT_EQ(found, Json::parse(patch));
  Json merged = Json::parse(before);
  merged.merge_patch(found);
  EXPECT_EQ(nlohmann::json::parse(merged.dump()), nlohmann::json::parse(after));
}

TEST(JsonDifference, IsWhatMergingTakes) {
  expect_merges(R"({"a":1,"b":2})", R"({"a":1,"b":2})", R"({})");
  expect_merges(R"({"a":1,"b":2})", R"({"a":1,"b":3})", R"({"b":3})");
  expect_merges(R"({"a":1,"b":2})", R"({"b":2})", R"({"a":null})");
  expect_merges(R"({"a":{"b":1,"c":2}})", R"({"a":{"b":1,"c":3,"d":4}})", R"({"a":{"c":3,"d":4}})");
  expect_merges(R"({"a":[1,2]})", R"({"a":[1,3]})", R"({"a":[1,3]})");
  expect_merges(R"({"a":1})", R"({"a":{"b":1}})", R"({"a":{"b":1}})");
}

}  // namespace
}  // namespace canvoy::tools::json_difference_test
