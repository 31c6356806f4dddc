// The tariff in the file of a taxi: currency, levels, hours and holidays, supplements, agreed
// prices, and the business on papers. All amounts are whole coins of the currency.
#pragma once

#include <vector>

#include "canvoy/tools/play/taxi_run.hpp"

namespace canvoy::tools {

/// `holidays = ["12-25", "2026-04-03"]`
Setting<TaxiRun> holidays_setting();
/// `taxi_identifier = "M-TX 447"`
Setting<TaxiRun> taxi_identifier_setting();
/// Uses the tariff of the file for the meter and the town, and the licence of the taxi for a
/// meter without one. Throws Failure with file and line for
/// hours of holidays without holidays, and for a currency without coins for the tariff.
void take_tariff(const TomlTable& file, TaxiRun& run);
/// Adds `[currency]`, `[[tariff]]`, `[[tariff_hours]]`, `[[supplement]]`, `[agreed_price]` and
/// `[business]`.
void add_tariff_settings(std::vector<FilePart<TaxiRun>>& parts);

}  // namespace canvoy::tools
