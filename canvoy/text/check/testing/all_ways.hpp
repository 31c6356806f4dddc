// All broken devices of the tests of the conformance test, by the test that has them: a case that
// none of them is found by is listed (every_case_test.cpp).
//
//     for (const Way& way : communication_ways()) found.insert(way.found_by.begin(), ...);
#pragma once

#include <string>
#include <vector>

#include "canvoy/text/check/testing/broken_device.hpp"

namespace canvoy::conformance {

/// Of a device with all services of CiA 301 (broken_communication_test.cpp).
std::vector<Way> communication_ways();
/// Of a module of CiA 401 (broken_devices_test.cpp).
std::vector<Way> module_ways();
/// Of the LSS of that module (broken_lss_test.cpp).
std::vector<Way> lss_ways();
/// Of an NMT master (master_test.cpp).
std::vector<Way> master_ways();
/// Of a device with a program that is downloaded (program_test.cpp).
std::vector<Way> program_ways();
/// Of a device with non-volatile parameters (kept_test.cpp).
std::vector<Way> keeping_ways();
/// Of devices with behaviour (broken_behaviour_test.cpp).
std::vector<BrokenDevice> behaviour_ways();
/// Of cars, buses and panels of a lift (broken_transport_test.cpp).
std::vector<BrokenDevice> transport_ways();
/// Behaviour cases with a device that does other than they expect (behaviour_sweep_test.cpp).
std::vector<std::string> lied_cases();

}  // namespace canvoy::conformance
