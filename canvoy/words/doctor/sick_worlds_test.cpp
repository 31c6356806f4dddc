// A world with a fault, as its own engine makes it: the doctor says what it is by what it does.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "canvoy/sim/charging/charging_network.hpp"
#include "canvoy/words/doctor/doctor.hpp"

namespace canvoy::sick_worlds_test {
namespace {

using Names = std::set<std::string>;

struct FaultRow {
  const char* name;
  const char* fault;
  Names alarms;  ///< `kind node`
};

class FaultOfACharger : public testing::TestWithParam<FaultRow> {};

TEST_P(FaultOfACharger, IsToldByWhatItDoes) {
  charging::ChargingOptions options;
  options.manager_id = 1;  // so that nobody is alone when the battery is gone
  options.faults.faults = {*parse_fault<charging::FaultKind>(GetParam().fault).fault};
  charging::ChargingNetwork network(options);
  words::Doctor doctor({.bit_rate = options.bit_rate});
  network.world().bus().observe(
      {.context = &doctor,
       .on_frame = [](void* context, Time now, ControllerId, const Frame& frame) {
         static_cast<words::Doctor*>(context)->hear(now, frame);
       }});
  network.run_until(Time(5min));
  Names alarms;
  for (const words::Finding& finding : doctor.findings(Time(5min))) {
    const words::FindingRow& row = words::finding_row(finding.kind);
    if (row.severity != words::Severity::note)
      alarms.insert(std::string(row.name) + ' ' + std::to_string(finding.node));
  }
  EXPECT_EQ(alarms, GetParam().alarms);
}

// Node 5 is the charger, 10 the battery, of which heartbeats and all else have periods of a second.
INSTANTIATE_TEST_SUITE_P(Each, FaultOfACharger,
                         testing::ValuesIn(std::vector<FaultRow>{
                             {"None", "clock-drift@1min", {}},
                             {"SecondDevice", "duplicate-node-id@2min+1min", {"node-id-twice 10"}},
                             {"Restart", "battery-restart@2min", {"unexpected-boot-up 10"}},
                             {"NoPowerForAWhile",
                              "battery-silent@2min+30s",
                              {"heartbeat-missing 10", "unexpected-boot-up 10"}},
                             {"NoPowerForTheRest", "battery-silent@3min", {"heartbeat-missing 10"}},
                             {"NoHeartbeat", "heartbeat-loss@2min+10s", {"heartbeat-missing 10"}},
                         }),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace canvoy::sick_worlds_test
