// What a doctor has found, for people on a terminal of 80 columns, and as JSON.
//
//     fmt::print("{}", report_text("can0", doctor.observed(), findings));
#pragma once

#include <string>
#include <string_view>

#include "canvoy/words/doctor/finding.hpp"
#include "canvoy/words/doctor/observed.hpp"

namespace canvoy::words {

/// A head with what was heard, and a paragraph for each finding, with its words. No line is longer
/// than `columns`, but for words that are.
std::string report_text(std::string_view bus, const Observed& observed, const Findings& findings,
                        std::size_t columns = 80);
/// One JSON object a line: `{"bus":...,"kind":...}` for each finding, and one with `findings` for
/// the bus.
std::string report_json(std::string_view bus, const Observed& observed, const Findings& findings);

/// Nothing: not one finding.
std::optional<Severity> worst_of(const Findings& findings);

}  // namespace canvoy::words
