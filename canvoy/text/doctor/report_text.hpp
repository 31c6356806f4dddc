// Findings as text for terminals of 80 columns, and as JSON.
//
//     fmt::print("{}", report_text("can0", doctor.observed(), findings));
#pragma once

#include <string>
#include <string_view>

#include "canvoy/text/doctor/finding.hpp"
#include "canvoy/text/doctor/observed.hpp"

namespace canvoy::text {

/// Text with a summary of what was heard, and a paragraph for each finding. No line is longer than
/// `columns`, except for longer words.
std::string report_text(std::string_view bus, const Observed& observed, const Findings& findings,
                        std::size_t columns = 80);
/// JSON Lines: `{"bus":...,"kind":...}` for each finding, and one object with `findings` for the
/// bus.
std::string report_json(std::string_view bus, const Observed& observed, const Findings& findings);

/// The worst severity; nothing: no findings.
std::optional<Severity> worst_of(const Findings& findings);

}  // namespace canvoy::text
