// Behaviour of the devices of each profile as test cases: one table for each profile, and code
// where a partner is needed.
//
//     add_behaviour_cases(cases, cia419::profile);
#pragma once

#include <span>
#include <vector>

#include "canvoy/text/check/behaviour/step.hpp"
#include "canvoy/text/check/bench/test_case.hpp"

namespace canvoy::conformance {

/// Adds the cases of the profile and of its base.
void add_behaviour_cases(TestCases& cases, const Profile& profile);

/// Outputs of CiA 401, also used by CiA 852.
std::span<const BehaviourRow> rows_of_401_outputs();
/// Inputs of CiA 401, also used by CiA 852.
std::span<const BehaviourRow> rows_of_401_inputs();
/// Elements of an operator environment (CiA 852).
std::span<const BehaviourRow> rows_of_852();
/// Units of lift 1, one table each (CiA 417-4).
std::vector<std::span<const BehaviourRow>> rows_of_417();
/// Car door controller (CiA 417-4).
std::vector<std::span<const BehaviourRow>> rows_of_417_controllers();
/// Adds buttons and lamps of panels (CiA 417-4).
void add_panel_cases(TestCases& cases);
/// Virtual devices of a car, one table each (CiA 447-3).
std::vector<std::span<const BehaviourRow>> rows_of_447();
/// GPS, navigation, driver identification and sound of a roof bar (CiA 447-3).
std::vector<std::span<const BehaviourRow>> rows_of_447_travel();
/// Virtual devices of a bus, one table each (CiA 407).
std::vector<std::span<const BehaviourRow>> rows_of_407();
/// Tickets and passenger counts (CiA 407).
std::vector<std::span<const BehaviourRow>> rows_of_407_passengers();
/// Adds the sums of a passenger counting manager.
void add_counting_cases(TestCases& cases);
/// Adds the events that each device reports on request.
void add_event_cases(TestCases& cases);
/// Adds the cases of CiA 419, with a battery that the test plays.
void add_charger_cases(TestCases& cases);

}  // namespace canvoy::conformance
