// The elements of an operator environment (CiA 852) as given by the user: a list, or a TOML file
// with the same words.
//
//     parse_operator_elements("joysticks=2,wheels=1,configuration=yes")
//     parse_operator_elements("seat.toml")
#pragma once

#include <string>
#include <string_view>

#include "canvoy/profiles/cia852/operator_environment.hpp"

namespace canvoy::tools {

/// Reads the elements; empty: those of the catalogue. Throws UsageError for an unknown element or
/// too many of them, Failure if the file cannot be read.
cia852::OperatorEnvironment parse_operator_elements(const std::string& text);

/// Help for --elements.
extern const char* const operator_elements_help;

}  // namespace canvoy::tools
