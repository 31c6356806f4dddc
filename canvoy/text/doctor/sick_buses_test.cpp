// Buses with faults: each kind of finding in at least three ways, on the simulated bus. Each
// diagnosis is exact: one alarm, of this kind, at this node and CAN-ID, and no others.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/text/doctor/testing/sick_buses.hpp"

namespace canvoy::sick_buses_test {
namespace {

using text::Finding;
using text::finding_row;
using text::FindingKind;
using text::Findings;

std::string text_of(const Findings& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += std::string(finding_row(finding.kind).name) + ": " + finding.what + "\n";
  }
  return text;
}

class SickBus : public testing::TestWithParam<SickBusRow> {};

TEST_P(SickBus, IsDiagnosedRightAndNothingBeside) {
  const SickBusRow& row = GetParam();
  const std::unique_ptr<Clinic> clinic = row.make();
  const Findings findings = clinic->examine(row.time);
  std::vector<Finding> alarms;
  for (const Finding& finding : findings) {
    if (finding_row(finding.kind).severity != text::Severity::note) alarms.push_back(finding);
  }
  ASSERT_EQ(alarms.size(), 1U) << text_of(findings);
  EXPECT_EQ(finding_row(alarms.front().kind).name, finding_row(row.kind).name) << text_of(findings);
  EXPECT_EQ(alarms.front().node, row.node) << text_of(findings);
  EXPECT_EQ(alarms.front().can_id.value_or(0), row.can_id) << text_of(findings);
}

INSTANTIATE_TEST_SUITE_P(Each, SickBus, testing::ValuesIn(sick_buses()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(SickBuses, AreSixtyAndThreeOfEachKindThatAlarms) {
  EXPECT_GE(sick_buses().size(), 60U);
  for (const text::FindingRow& row : text::finding_rows()) {
    if (row.severity == text::Severity::note) continue;
    const auto count = std::count_if(sick_buses().begin(), sick_buses().end(),
                                     [&](const SickBusRow& sick) { return sick.kind == row.kind; });
    EXPECT_GE(count, 3) << row.name;
  }
}

TEST(SickBuses, AreHealthyWithoutTheirSickness) {
  Clinic clinic;
  for (NodeId node = 1; node <= 5; ++node) clinic.add_healthy(node);
  EXPECT_EQ(text_of(clinic.examine(60s)), "");
}

}  // namespace
}  // namespace canvoy::sick_buses_test
