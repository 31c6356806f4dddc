// Worlds with a fault of their own engine: the doctor identifies it by its effect.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "canvoy/text/doctor/doctor.hpp"
#include "canvoy/worlds/charger/charger_network.hpp"

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
  charger::ChargerOptions options;
  options.manager_id = 1;  // so that a node remains when the battery is gone
  options.faults.faults = {*parse_fault<charger::FaultKind>(GetParam().fault).fault};
  charger::ChargerNetwork network(options);
  text::Doctor doctor({.bit_rate = options.bit_rate});
  network.world().bus().observe(
      {.context = &doctor,
       .on_frame = [](void* context, Time now, ControllerId, const Frame& frame) {
         static_cast<text::Doctor*>(context)->hear(now, frame);
       }});
  network.run_until(Time(5min));
  Names alarms;
  for (const text::Finding& finding : doctor.findings(Time(5min))) {
    const text::FindingRow& row = text::finding_row(finding.kind);
    if (row.severity != text::Severity::note)
      alarms.insert(std::string(row.name) + ' ' + std::to_string(finding.node));
  }
  EXPECT_EQ(alarms, GetParam().alarms);
}

// Node 5 is the charger, 10 the battery; heartbeats and all other messages have periods of a
// second.
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
