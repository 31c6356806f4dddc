// Messages and signals as DBC, in ISO 8859-1 as its readers expect it.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/formats/signals/signal_table.hpp"

namespace canvoy::formats {

/// Names that are longer than 32 characters are also there in full, as SystemSignalLongSymbol and
/// its like.
std::string write_dbc(const SignalTable& table);

/// A name as C and DBC allow it: `Input group 1, Virtual input 3` is
/// `Input_group_1_Virtual_input_3`.
std::string identifier_of(std::string_view name);

}  // namespace canvoy::formats
