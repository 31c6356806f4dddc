// Dictionaries and messages as CSV: a line for each number of each entry, and where in a message it
// is.
#pragma once

#include <string>

#include "canvoy/formats/signals/signal_table.hpp"

namespace canvoy::formats {

/// UTF-8.
std::string write_signal_csv(const SignalTable& table);

}  // namespace canvoy::formats
