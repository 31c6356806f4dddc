#include "canvoy/tools/play/run_depot.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::run_depot_test {
namespace {

/// Its destination does not change when the second journey begins.
DepotOptions frozen() {
  DepotOptions options{.vehicles = 2, .threads = 2};
  options.vehicle.faults.seed = 7;
  options.vehicle.length = 30min;
  options.vehicle.sabotage.freezes_destination = true;
  return options;
}

TEST(RunDepot, AVehicleThatFailsIsNamedWithWhatPlaysItAlone) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_depot(frozen()), exit_failed);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(
      text.starts_with("vehicle 1 (--seed 7 --block 1)\n"
                       "  FAIL  a display said what is not so for at most "))
      << text;
  EXPECT_NE(text.find("\nvehicle 2 (--seed 8 --block 1)\n  FAIL"), std::string::npos) << text;
  EXPECT_NE(text.find("\n2 vehicles, 30min at most: 4 journeys, "), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("\n2 of 2 vehicles failed: 1, 2\n")) << text;
}

TEST(RunDepot, JsonHasAnObjectForEachVehicleAndTheSummary) {
  DepotOptions options = frozen();
  options.json = true;
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_depot(options), exit_failed);
  const std::string text = testing::internal::GetCapturedStdout();
  const auto summary = nlohmann::json::parse(text.substr(text.rfind('\n', text.size() - 2)));
  EXPECT_EQ(summary.at("failed"), nlohmann::json({1, 2}));
  EXPECT_EQ(summary.at("played"), 2);
  EXPECT_EQ(summary.at("all_held"), false);
  EXPECT_EQ(summary.at("time"), 1800.0);
}

TEST(RunDepot, WhatHoldsIsDone) {
  DepotOptions options = frozen();
  options.vehicle.sabotage = {};
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_depot(options), exit_done);
  EXPECT_TRUE(testing::internal::GetCapturedStdout().starts_with("2 vehicles, 30min at most: "));
}

}  // namespace
}  // namespace canvoy::tools::run_depot_test
