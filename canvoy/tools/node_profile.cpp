#include "canvoy/tools/node_profile.hpp"

#include <fmt/format.h>

#include "canvoy/canopen/object_index.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/object_argument.hpp"
#include "canvoy/tools/text.hpp"

namespace canvoy::tools {

void check_object(std::string_view object, unsigned profile) {
  if (profile != 0 && find_profile(profile) == nullptr) {
    throw UsageError(fmt::format("CiA {} is no profile that is known here", profile));
  }
  parse_object(object, profile);
}

ObjectAddress find_object_of(Session& session, NodeId node, std::string_view object,
                             unsigned profile) {
  if (profile != 0 || !needs_profile(object)) return parse_object(object, profile);
  const Result<std::vector<std::uint8_t>> answer =
      session.try_read(node, object_index::device_type, 0);
  if (!answer) {
    // An index is good enough for a node that does not say what it is.
    if (const auto address = find_address(base_profile(), object)) return *address;
    throw Failure(fmt::format("{}, {}: {}; say its profile with --profile, or give the index",
                              node_text(node), object_text(object_index::device_type, 0),
                              abort_text(answer.abort())));
  }
  std::vector<std::uint8_t> device_type = *answer;
  device_type.resize(sizeof(std::uint32_t));
  profile = load<std::uint32_t>(device_type.data()) & 0xFFFF;
  // The same where nobody here knows the profile.
  return parse_object(object, find_profile(profile) == nullptr ? 0 : profile);
}

}  // namespace canvoy::tools
