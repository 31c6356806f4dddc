// SDO cases as data: the bytes to send, and the expected bytes.
//
//     judge_script(bench, "40 00 10 00 > 43/42 00 10 00 ?? ?? ?? ??", {});
#pragma once

#include <string_view>

#include "canvoy/text/check/bench/bench.hpp"
#include "canvoy/text/check/bench/test_case.hpp"

namespace canvoy::conformance {

/// Judges a script of steps separated by `;`, each a request, `>`, and the answer. Omitted bytes
/// are 0 in a request; in an answer they match any value, like `??`. `43/42` matches either.
/// `nothing` is no answer. `VL VH` stand for `value`, `NL NH` for a different one.
Verdict judge_script(Bench& bench, std::string_view script, std::uint16_t value);

/// The requests of a script, for a list of cases.
std::string sent_of(std::string_view script);
/// The expected answers of a script.
std::string expected_of(std::string_view script);

}  // namespace canvoy::conformance
