// Time-outs for answers of a node: `--timeout 500ms`, $CANVOY_TIMEOUT, or the usual ones.
//
//     Session session("can0", parse_answer_time(options.time_out));
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

/// What `--timeout` says of itself in help.
inline constexpr const char* answer_time_text =
    "for one answer: 500ms, 2s (default $CANVOY_TIMEOUT, or 1s, and 10s to store)";

/// What `--timeout` may be: it is refused before anything is done.
inline constexpr Rules answer_time_rules = checked_by(wrong_duration);

struct AnswerTime {
  Duration usual = Duration(1s);
  /// Before the answer, the node writes its memory.
  Duration storing = Duration(10s);
};

/// Reads a time-out; without one, that of the environment. Throws UsageError if it is none.
inline AnswerTime parse_answer_time(std::string_view text) {
  const char* const environment = std::getenv("CANVOY_TIMEOUT");
  if (text.empty() && environment != nullptr) {
    text = environment;
    const std::string wrong = text.empty() ? "" : wrong_duration(environment);
    if (!wrong.empty()) throw UsageError("CANVOY_TIMEOUT: " + wrong);
  }
  if (text.empty()) return {};
  const Duration said = parse_duration_argument(text);
  return {said, said};
}

}  // namespace canvoy::tools
