// The numbers in an entry as signals: each with its bits, scale, unit and states.
//
//     entry_signals("battery_temperature", object.entry);  // one, of 16 bits, 0.125 °C each
#pragma once

#include <string>
#include <vector>

#include "canvoy/formats/signals/signal_table.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::text {

/// Lists the signals in the order of their bits, without overlaps. An entry with fields has a
/// signal for each field except reserved bits; bits with a conditional meaning are plain numbers.
/// Texts and other non-numbers give none.
std::vector<formats::Signal> entry_signals(const std::string& name, const EntryInfo& entry);

}  // namespace canvoy::text
