// Writes messages and signals as DBC, in ISO 8859-1 as its readers expect.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/formats/signals/signal_table.hpp"

namespace canvoy::formats {

/// Writes a DBC. Names longer than 32 characters are also written in full, as
/// SystemSignalLongSymbol and similar attributes.
std::string write_dbc(const SignalTable& table);

/// Makes a name valid in C and DBC: `Input group 1, Virtual input 3` becomes
/// `Input_group_1_Virtual_input_3`.
std::string identifier_of(std::string_view name);

}  // namespace canvoy::formats
