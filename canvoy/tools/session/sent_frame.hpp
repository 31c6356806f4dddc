// A frame that a verb has sent, as JSON with the keys of `canvoy decode --json`.
#pragma once

#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

/// Prints one line: `time` (since 1970), `bus` and `frame`.
void print_sent(Session& session, const Frame& frame);

}  // namespace canvoy::tools
