// SDO cases as data: what is sent, and what has to come, in bytes.
//
//     judge_script(bench, "40 00 10 00 > 43/42 00 10 00 ?? ?? ?? ??", {});
#pragma once

#include <string_view>

#include "canvoy/words/check/bench.hpp"
#include "canvoy/words/check/test_case.hpp"

namespace canvoy::conformance {

/// Steps stand with `;` between them, each as a request, `>`, and the answer. Bytes that are not
/// written are 0 in a request, and anything in an answer, as `??` is; `43/42` is one of both.
/// `nothing` is no answer. `VL VH` stand for `value`, and `NL NH` for another one.
Verdict judge_script(Bench& bench, std::string_view script, std::uint16_t value);

/// What a script sends, or expects, for a list of cases.
std::string sent_of(std::string_view script);
/// The answers of it.
std::string expected_of(std::string_view script);

}  // namespace canvoy::conformance
