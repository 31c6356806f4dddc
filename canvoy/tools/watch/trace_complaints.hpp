// Lines on standard error about errors in a log.
#pragma once

#include <cstdint>
#include <string>

#include "canvoy/formats/trace/trace_writer.hpp"
#include "canvoy/tools/watch/log_reader.hpp"

namespace canvoy::tools {

/// Maximum number of bad lines that are shown; further ones give no more information.
inline constexpr std::uint64_t bad_shown_max = 20;

/// Reports where and why the last item could not be read.
void show_bad(const std::string& log, const LogReader& trace);

/// Reports frames that were written with another time than theirs.
void show_shifted(const std::string& out, const formats::TraceWriter& writer);

/// The format in a sentence: `a candump log`, `an ASAM MDF 4`.
std::string format_in_words(const LogReader& trace);

/// Throws Failure if the log had no frame up to its end.
void refuse_log_without_frames(const std::string& log, const LogReader& trace);

/// True if `out` is the file that is read, under any name; `log` is `-` for the standard input.
bool is_log_itself(const std::string& log, const std::string& out);

}  // namespace canvoy::tools
