// Writes dictionaries and messages as CSV: a line for each number of each entry, with its position
// in a message.
#pragma once

#include <string>

#include "canvoy/formats/signals/signal_table.hpp"

namespace canvoy::formats {

/// Returns the CSV in UTF-8.
std::string write_signal_csv(const SignalTable& table);

}  // namespace canvoy::formats
