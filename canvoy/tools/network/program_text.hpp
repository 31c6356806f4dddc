// Text of the reason why a program download failed (CiA 302-3).
//
//     fmt::print("{}", program_failure_text(outcome));  // the download failed: 08000021h: ...
#pragma once

#include <string>

#include "canvoy/canopen/manager/program_download.hpp"

namespace canvoy::tools {

/// The step, and the abort code or flash error of the node.
std::string program_failure_text(const ProgramOutcome& outcome);

}  // namespace canvoy::tools
