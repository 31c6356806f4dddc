#include "canvoy/worlds/taxi/taxi_excuses.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::taxi::taxi_excuses_test {
namespace {

/// Names of the invariants that a fault at a place can break.
std::string caused_by(FaultKind kind, NodeId node) {
  const ScheduledFault fault{.kind = kind, .node = node};
  std::string names;
  for (std::size_t i = 0; i < invariant_kinds; ++i) {
    const auto of = static_cast<InvariantKind>(i);
    const bool is_of_each_device = of == InvariantKind::device_missing;
    if (!is_of_each_device && can_cause(fault, of)) {
      names += std::string(invariant_name(of).name) + " ";
    }
  }
  return names;
}

TEST(TaxiExcuses, ADeviceThatIsLostExcusesWhatItHasAPartIn) {
  for (const FaultKind kind : {FaultKind::lost_node, FaultKind::restart}) {
    EXPECT_EQ(caused_by(kind, alarm_id), "alarm silence ");
    EXPECT_EQ(caused_by(kind, printer_id), "receipts shift_slip silence ");
    EXPECT_EQ(caused_by(kind, driver_id), "terminal_place silence ")
        << "the meter goes on from what its clock has said";
    EXPECT_EQ(caused_by(kind, sign_id), "roof_sign alarm silence ");
    EXPECT_EQ(caused_by(kind, terminal_id), "terminal_fare terminal_place silence ");
    EXPECT_EQ(caused_by(kind, navigation_id), "terminal_place silence ");
    EXPECT_EQ(caused_by(kind, taximeter_id),
              "fare distance duration waiting receipts shift_slip roof_sign terminal_fare silence "
              "no_service "
              "carried ");
    EXPECT_EQ(
        caused_by(kind, cia447::gateway_node_id),
        "fare distance waiting receipts shift_slip roof_sign alarm terminal_fare terminal_place "
        "silence ");
  }
}

TEST(TaxiExcuses, ACutCableExcusesWhatGoesOverThatPlace) {
  EXPECT_EQ(caused_by(FaultKind::cable_cut, cia447::gateway_node_id),
            "fare distance waiting receipts shift_slip roof_sign alarm terminal_fare "
            "terminal_place silence ");
  EXPECT_EQ(caused_by(FaultKind::cable_cut, taximeter_id),
            "receipts shift_slip roof_sign alarm terminal_fare terminal_place silence ");
  EXPECT_EQ(caused_by(FaultKind::cable_cut, sign_id),
            "alarm terminal_fare terminal_place silence ");
  EXPECT_EQ(caused_by(FaultKind::cable_cut, navigation_id), "alarm silence ");
  EXPECT_EQ(caused_by(FaultKind::cable_cut, alarm_id), "") << "nobody is behind it";
}

TEST(TaxiExcuses, WhatADeviceLacksExcusesNoMore) {
  EXPECT_EQ(caused_by(FaultKind::wheel_signal, 0), "fare distance waiting ");
  EXPECT_EQ(caused_by(FaultKind::paper_out, 0), "receipts shift_slip ");
  EXPECT_EQ(caused_by(FaultKind::no_fix, 0), "");
  EXPECT_EQ(caused_by(FaultKind::corrupted_frames, 0), "");
  EXPECT_EQ(caused_by(FaultKind::babbling_node, 0),
            "fare distance waiting receipts shift_slip roof_sign alarm terminal_fare "
            "terminal_place silence ");
}

TEST(TaxiExcuses, WhoCheatsExcusesNothingThatIsPaid) {
  EXPECT_EQ(caused_by(FaultKind::stranger_writes, 0), "silence ") << "he does not sleep";
  EXPECT_EQ(caused_by(FaultKind::extra_pulses, 0), "");
  EXPECT_EQ(caused_by(FaultKind::seal_opened, 0), "no_service carried ");
  EXPECT_EQ(caused_by(FaultKind::wrong_k, 0), "");
  EXPECT_EQ(caused_by(FaultKind::clock_drift, 0), "");
}

TEST(TaxiExcuses, ItHoldsWhileTheFaultLastsAndUntilAllIsBack) {
  const ScheduledFault lost{.kind = FaultKind::lost_node, .node = printer_id};
  TaxiExcuses sut;
  EXPECT_FALSE(sut.is_excused(InvariantKind::receipts, Time{}));
  sut.begins(lost, Time(1min));
  EXPECT_TRUE(sut.is_excused(InvariantKind::receipts, Time(10min)));
  EXPECT_FALSE(sut.is_excused(InvariantKind::fare, Time(10min)));
  sut.ends(lost, Time(11min));
  EXPECT_TRUE(sut.is_excused(InvariantKind::receipts, Time(11min + 20s)));
  EXPECT_FALSE(sut.is_excused(InvariantKind::receipts, Time(11min + 20s + 1ms)));
}

TEST(TaxiExcuses, OneThatIsOverAtOnceHoldsForATimeAsWell) {
  TaxiExcuses sut;
  sut.begins({.kind = FaultKind::restart, .node = taximeter_id}, Time(1min));
  EXPECT_TRUE(sut.is_excused(InvariantKind::distance, Time(1min + 20s)));
  EXPECT_FALSE(sut.is_excused(InvariantKind::distance, Time(1min + 21s)));
}

TEST(TaxiExcuses, EachDeviceMayBeMissingByItsOwnFaultAndByTheGateways) {
  TaxiExcuses sut;
  sut.begins({.kind = FaultKind::lost_node, .node = alarm_id}, Time(1min));
  EXPECT_TRUE(sut.may_be_missing(alarm_id, Time(2min)));
  EXPECT_FALSE(sut.may_be_missing(printer_id, Time(2min)));
  sut.begins({.kind = FaultKind::lost_node, .node = cia447::gateway_node_id}, Time(3min));
  EXPECT_TRUE(sut.may_be_missing(printer_id, Time(4min)));
}

}  // namespace
}  // namespace canvoy::taxi::taxi_excuses_test
