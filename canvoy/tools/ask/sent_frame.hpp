// A frame that a verb has sent, as JSON in the keys of `canvoy decode --json`.
#pragma once

#include "canvoy/tools/bus/session.hpp"

namespace canvoy::tools {

/// One line: `time` (since 1970), `bus` and `frame`.
void print_sent(Session& session, const Frame& frame);

}  // namespace canvoy::tools
