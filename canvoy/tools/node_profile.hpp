// Which object of which node a user means, when its profile has to be asked for first.
#pragma once

#include <string_view>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/session.hpp"

namespace canvoy::tools {

/// Throws UsageError where no profile that may be meant has the object; before anything is opened.
void check_object(std::string_view object, unsigned profile);

/// The object in the profile with this number; where that is 0, in the one that the node's device
/// type (1000h) names. Where the node refuses to tell it, an index will do, without its type; a
/// name is refused with a Failure. Throws UsageError where there is no such object.
ObjectAddress find_object_of(Session& session, NodeId node, std::string_view object,
                             unsigned profile);

}  // namespace canvoy::tools
