// The cases by class: each list is in a source of its own. check.hpp puts them together.
#pragma once

#include "canvoy/words/check/test_case.hpp"

namespace canvoy {
struct Profile;
}

namespace canvoy::conformance {

/// CiA 306: whether the data sheet agrees with itself and with CiA 301.
void add_sheet_cases(TestCases& cases);
/// CiA 301, 7.2.4: transfers, expedited, in segments and in blocks, and their ends.
void add_sdo_cases(TestCases& cases);
/// The object dictionary against the data sheet.
void add_dictionary_cases(TestCases& cases);
/// CiA 301, 7.3.2: states and transitions.
void add_nmt_cases(TestCases& cases);
/// CiA 301, 7.2.8.3.2.2: heartbeats, produced and consumed.
void add_heartbeat_cases(TestCases& cases);
/// CiA 301, 7.2.7.
void add_emergency_cases(TestCases& cases);
/// CiA 301, 7.2.2: what PDOs are configured to.
void add_pdo_parameter_cases(TestCases& cases);
/// CiA 301, 7.2.2: when they are sent.
void add_pdo_sending_cases(TestCases& cases);
/// CiA 301, 7.2.5.
void add_sync_cases(TestCases& cases);
/// CiA 301, 7.2.8.3.2.1, alone and beside a heartbeat.
void add_guarding_cases(TestCases& cases);
/// 1010h, 1011h, and CAN-IDs that are restricted (CiA 301, 7.3.5).
void add_store_cases(TestCases& cases);
/// Each object of the profile.
void add_profile_cases(TestCases& cases, const Profile& profile);

}  // namespace canvoy::conformance
