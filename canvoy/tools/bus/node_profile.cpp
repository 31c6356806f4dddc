#include "canvoy/tools/bus/node_profile.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/tools/bus/object_argument.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

/// The one that describes an object.
const Profile& profile_of(const ObjectInfo& object) {
  const auto describes = [&object](const Profile* profile) {
    return find_object(*profile, object.index) == &object;
  };
  const auto found = std::ranges::find_if(all_profiles(), describes);
  return found == all_profiles().end() ? base_profile() : **found;
}

}  // namespace

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
    throw Failure(fmt::format(
        "{}, {}: {}; say its profile with --profile, or give the index", words::node_text(node),
        words::object_text(object_index::device_type, 0), words::abort_text(answer.abort())));
  }
  std::vector<std::uint8_t> bytes = *answer;
  bytes.resize(sizeof(std::uint32_t));
  // All of it: CiA 852 has the number of CiA 401, and a bit of its own.
  const auto device_type = load<std::uint32_t>(bytes.data());
  // The same where nobody here knows the profile.
  return parse_object(object, find_profile(device_type) == nullptr ? 0 : device_type);
}

NodeEntry::NodeEntry(Session& session, NodeId node, const ObjectAddress& object)
    : entry_(object.entry) {
  if (entry_ == nullptr) return;
  const decoder::Teller teller =
      decoder::teller_of(*entry_, *object.object, object.index, object.sub);
  if (teller.index == 0) return;
  const Result<std::vector<std::uint8_t>> held = session.try_read(node, teller.index, teller.sub);
  if (!held || held->empty() || held->size() > sizeof(std::uint64_t)) return;
  told_ = std::make_unique<decoder::ToldEntry>(
      *entry_, decoder::told_measure(profile_of(*object.object), *entry_, load_unsigned(*held)));
}

}  // namespace canvoy::tools
