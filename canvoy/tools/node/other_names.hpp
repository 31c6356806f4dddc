// Lines as other programs have them: their names of verbs, with the options of those programs, and
// an order with the bus in front. Where one line can be meant, it is made; else it is told.
//
//     use_bus_in_front(words);  // can0 10 read 1018 as read can0 10 1018
//     use_own_names(words);     // candump -ta can0 as monitor can0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// The verbs of the command line beside those of ask_verbs.hpp.
inline constexpr auto verb_names = std::to_array<std::string_view>(
    {"run",    "device",  "monitor", "view",    "report", "decode",  "convert-log",
     "record", "replay",  "stats",   "doctor",  "check",  "load",    "explain",
     "search", "program", "boot",    "gateway", "lss",    "profile", "eds",
     "export", "scan",    "clone",   "plot",    "browse", "script",  "completion"});

/// True for the name of a verb of the command line.
bool is_verb_name(std::string_view word);
/// True for a file name of a data sheet: EDS, DCF, XDD, XDC.
bool is_sheet_name(std::string_view word);
/// True for a file name of a log.
bool is_log_name(std::string_view word);

/// A line as one types it: the words behind `canvoy`.
std::string typed_line(const std::vector<std::string>& words);

/// The verb goes to the front; bus and node behind it, also those of `--bus can0` before the verb.
/// Throws UsageError for a bus alone.
void use_bus_in_front(std::vector<std::string>& words);

/// Our name of the verb, and our options. Throws UsageError with the intended line.
void use_own_names(std::vector<std::string>& words);

}  // namespace canvoy::tools
