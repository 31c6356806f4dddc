// Dictionaries and messages as a page of its own, to read and to print.
#pragma once

#include <string>

#include "canvoy/formats/signals/signal_table.hpp"

namespace canvoy::formats {

/// UTF-8.
std::string write_signal_html(const SignalTable& table, const std::string& title);

}  // namespace canvoy::formats
