// What is wrong with a log that is read, in lines on the standard error.
#pragma once

#include <cstdint>
#include <string>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/formats/trace/trace_writer.hpp"

namespace canvoy::tools {

/// Of a log with more bad lines none is shown: they say no more of it.
inline constexpr std::uint64_t bad_shown_max = 20;

/// Where what was read last could not be understood, and why.
void show_bad(const std::string& log, const formats::TraceReader& trace);

/// Where frames of what was written have another time than they had.
void show_shifted(const std::string& out, const formats::TraceWriter& writer);

/// Throws Failure where not one frame stood in the log that was read to its end.
void refuse_log_without_frames(const std::string& log, const formats::TraceReader& trace);

/// Whether `out` is the file that is read, by whatever names; `log` is `-` for the standard input.
bool is_log_itself(const std::string& log, const std::string& out);

}  // namespace canvoy::tools
