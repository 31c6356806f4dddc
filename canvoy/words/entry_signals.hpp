// The numbers in an entry as signals: each with its bits, its scale, its unit and its states.
//
//     entry_signals("battery_temperature", object.entry);  // one, of 16 bits, 0.125 °C each
#pragma once

#include <string>
#include <vector>

#include "canvoy/formats/signals/signal_table.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::words {

/// In the order of their bits, none over another one. An entry with fields has a signal for each of
/// them, but for reserved bits; bits of which the meaning depends on others are a number without
/// one. Nothing of texts, and what else is no number.
std::vector<formats::Signal> entry_signals(const std::string& name, const EntryInfo& entry);

}  // namespace canvoy::words
