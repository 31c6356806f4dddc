// The elements of an operator environment (CiA 852) as users say them: a list, or a file of TOML
// with the same words.
//
//     parse_operator_elements("joysticks=2,wheels=1,configuration=yes")
//     parse_operator_elements("seat.toml")
#pragma once

#include <string>
#include <string_view>

#include "canvoy/profiles/cia852/operator_environment.hpp"

namespace canvoy::tools {

/// Empty: those of the catalogue. Throws UsageError for what is not known or more than the most,
/// Failure where the file cannot be read.
cia852::OperatorEnvironment parse_operator_elements(const std::string& text);

/// What --elements takes, for the help.
extern const char* const operator_elements_help;

}  // namespace canvoy::tools
