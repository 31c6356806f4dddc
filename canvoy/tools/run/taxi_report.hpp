// What a verification of a taximeter asks for, after a shift: each trip as it was and as it was
// metered, with its errors and their limits (Directive 2014/32/EU, annex MI-007, as far as public
// text has them), totals, tariff changes, interruptions of power.
//
//     write_taxi_report(network, "shift.txt");    // or shift.json
#pragma once

#include <string>

#include "canvoy/sim/taxi/taxi_network.hpp"

namespace canvoy::tools {

std::string taxi_report_text(taxi::TaxiNetwork& network);
std::string taxi_report_json(taxi::TaxiNetwork& network);
/// As JSON where the name ends with `.json`, else as text. Throws Failure; nothing is half written.
void write_taxi_report(taxi::TaxiNetwork& network, const std::string& path);

}  // namespace canvoy::tools
