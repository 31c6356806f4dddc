#include "canvoy/tools/node_profile.hpp"

#include <fmt/format.h>

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/object_argument.hpp"

namespace canvoy::tools {

namespace {

constexpr std::uint16_t device_type_index = 0x1000;

}  // namespace

void check_object(std::string_view object, unsigned profile) {
  if (profile != 0 && find_profile(profile) == nullptr) {
    throw UsageError(fmt::format("CiA {} is no profile that is known here", profile));
  }
  parse_object(object, profile);
}

ObjectAddress find_object_of(Session& session, NodeId node, std::string_view object,
                             unsigned profile) {
  if (profile == 0 && needs_profile(object)) {
    std::vector<std::uint8_t> device_type = session.read(node, device_type_index, 0);
    device_type.resize(sizeof(std::uint32_t));
    profile = load<std::uint32_t>(device_type.data()) & 0xFFFF;
    // An index is good enough for a node of a profile that nobody here knows.
    if (find_profile(profile) == nullptr) profile = 0;
  }
  return parse_object(object, profile);
}

}  // namespace canvoy::tools
