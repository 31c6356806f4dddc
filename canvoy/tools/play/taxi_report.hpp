// Report for the verification of a taximeter after a shift: each trip as driven and as metered,
// with errors and their limits (Directive 2014/32/EU, annex MI-007, as far as public text gives
// them), totals, tariff changes, power interruptions.
//
//     write_taxi_report(network, "shift.txt");    // or shift.json
#pragma once

#include <string>

#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::tools {

std::string taxi_report_text(taxi::TaxiNetwork& network);
std::string taxi_report_json(taxi::TaxiNetwork& network);
/// Writes JSON if the name ends with `.json`, else text. Throws Failure; no partial file is left.
void write_taxi_report(taxi::TaxiNetwork& network, const std::string& path);

}  // namespace canvoy::tools
