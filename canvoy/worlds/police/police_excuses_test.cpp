#include "canvoy/worlds/police/police_excuses.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::police::police_excuses_test {
namespace {

/// Names of the invariants that a fault at a place can break.
std::string caused_by(FaultKind kind, NodeId node = 0) {
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

TEST(PoliceExcuses, ADeviceThatIsLostExcusesWhatItHasAPartIn) {
  for (const FaultKind kind : {FaultKind::lost_node, FaultKind::restart}) {
    EXPECT_EQ(caused_by(kind, terminal_id),
              "keypad terminal_wait blue_light siren siren_alone work_light display locks silence "
              "emergency ");
    EXPECT_EQ(caused_by(kind, roof_light_id), "blue_light siren_alone work_light display silence ");
    EXPECT_EQ(caused_by(kind, roof_sound_id),
              "keypad terminal_wait blue_light siren siren_alone work_light display locks silence ")
        << "it has the keys of all signals";
    EXPECT_EQ(caused_by(kind, blue_light_id), "blue_light siren_alone display silence ");
    EXPECT_EQ(caused_by(kind, radio_id),
              "keypad terminal_wait speech carrier silence calls emergency ");
    EXPECT_EQ(caused_by(kind, audio_switch_id), "speech carrier silence calls ");
    EXPECT_EQ(caused_by(kind, hands_free_id), "speech carrier silence calls ");
    EXPECT_EQ(caused_by(kind, power_supply_id),
              "terminal_wait speech carrier power silence calls emergency ");
    EXPECT_EQ(caused_by(kind, inputs_id), "speech carrier silence calls ");
    EXPECT_EQ(caused_by(kind, navigation_id), "keypad terminal_wait silence ");
    EXPECT_EQ(caused_by(kind, fire_extinguishing_id), "silence ");
    EXPECT_EQ(caused_by(kind, fresh_air_id), "silence ");
  }
}

TEST(PoliceExcuses, ACutCableExcusesWhatGoesOverThatPlace) {
  EXPECT_EQ(caused_by(FaultKind::cable_cut, cia447::gateway_node_id),
            "keypad terminal_wait blue_light siren siren_alone work_light speech carrier display "
            "locks power silence calls emergency ");
  EXPECT_EQ(caused_by(FaultKind::cable_cut, inputs_id), "keypad terminal_wait silence ");
  EXPECT_EQ(caused_by(FaultKind::cable_cut, navigation_id), "silence ")
      << "in an armoured car two are behind it";
  EXPECT_EQ(caused_by(FaultKind::cable_cut, fresh_air_id), "") << "nobody is behind it";
}

TEST(PoliceExcuses, WhatADeviceLacksExcusesNoMore) {
  EXPECT_EQ(caused_by(FaultKind::burnt_lamp), "");
  EXPECT_EQ(caused_by(FaultKind::corrupted_frames), "");
  EXPECT_EQ(caused_by(FaultKind::overload), "terminal_wait speech power calls emergency ");
}

TEST(PoliceExcuses, AClientThatDiesIsAnyOfThem) {
  const ScheduledFault fault{.kind = FaultKind::dead_client};
  for (const NodeId client : {radio_id, roof_sound_id, navigation_id}) {
    EXPECT_TRUE(can_cost(fault, client));
  }
  EXPECT_FALSE(can_cost(fault, inputs_id));
  EXPECT_FALSE(can_cause(fault, InvariantKind::power));
}

}  // namespace
}  // namespace canvoy::police::police_excuses_test
