// Writes dictionaries and messages as a self-contained HTML page, to read and to print.
#pragma once

#include <string>

#include "canvoy/formats/signals/signal_table.hpp"

namespace canvoy::formats {

/// Returns the page in UTF-8.
std::string write_signal_html(const SignalTable& table, const std::string& title);

}  // namespace canvoy::formats
