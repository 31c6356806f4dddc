// The cases by group; each list has its own source file. check.hpp combines them.
#pragma once

#include "canvoy/text/check/bench/test_case.hpp"

namespace canvoy {
struct Profile;
}

namespace canvoy::conformance {

/// Consistency of the data sheet with itself and with CiA 301 (CiA 306).
void add_sheet_cases(TestCases& cases);
/// SDO transfers, expedited, in segments and in blocks, and their ends (CiA 301, 7.2.4).
void add_sdo_cases(TestCases& cases);
/// Comparison of the object dictionary with the data sheet.
void add_dictionary_cases(TestCases& cases);
/// NMT states and transitions (CiA 301, 7.3.2).
void add_nmt_cases(TestCases& cases);
/// Heartbeats, produced and consumed (CiA 301, 7.2.8.3.2.2).
void add_heartbeat_cases(TestCases& cases);
/// Emergencies (CiA 301, 7.2.7).
void add_emergency_cases(TestCases& cases);
/// Configuration of PDOs (CiA 301, 7.2.2).
void add_pdo_parameter_cases(TestCases& cases);
/// Transmission of PDOs (CiA 301, 7.2.2).
void add_pdo_sending_cases(TestCases& cases);
/// SYNC (CiA 301, 7.2.5).
void add_sync_cases(TestCases& cases);
/// Node guarding, alone and with a heartbeat (CiA 301, 7.2.8.3.2.1).
void add_guarding_cases(TestCases& cases);
/// 1010h, 1011h, and restricted CAN-IDs (CiA 301, 7.3.5).
void add_store_cases(TestCases& cases);
/// Non-volatile parameters: 1010h and 1011h.
void add_kept_cases(TestCases& cases);
/// LSS, for a device that answers to its LSS address in 1018h (CiA 305).
void add_lss_cases(TestCases& cases);
/// The objects of CiA 302 that the device has, and program download.
void add_manager_cases(TestCases& cases);
/// NMT master: a slave is booted, commanded and configured (CiA 302).
void add_master_cases(TestCases& cases);
/// The objects of the profile.
void add_profile_cases(TestCases& cases, const Profile& profile);
/// The PDOs that the profile predefines.
void add_profile_pdo_cases(TestCases& cases, const Profile& profile);

/// The defaults of a profile: these cases reset the device, which may lose what was set before.
void add_profile_reset_cases(TestCases& cases, const Profile& profile);

}  // namespace canvoy::conformance
