#include "canvoy/tools/session/node_profile.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

/// The profile that describes an object.
const Profile& profile_of(const ObjectInfo& object) {
  const auto describes = [&object](const Profile* profile) {
    return find_object(*profile, object.index) == &object;
  };
  const auto found = std::ranges::find_if(all_profiles(), describes);
  return found == all_profiles().end() ? base_profile() : **found;
}

/// The whole device type: CiA 852 has the number of CiA 401, and a bit of its own.
std::uint32_t device_type_of(std::vector<std::uint8_t> bytes) {
  bytes.resize(sizeof(std::uint32_t));
  return load<std::uint32_t>(bytes.data());
}

}  // namespace

unsigned profile_of_node(Session& session, NodeId node) {
  const Result<std::vector<std::uint8_t>> answer =
      session.try_read(node, object_index::device_type, 0);
  if (!answer) return 0;
  const std::uint32_t device_type = device_type_of(*answer);
  return find_profile(device_type) == nullptr ? 0 : device_type;
}

ObjectAddress find_object_of(Session& session, NodeId node, std::string_view object,
                             const ProfileChoice& profile) {
  const HasObject has = [&session, node](std::uint16_t index, std::uint8_t sub) {
    const Result<std::vector<std::uint8_t>> answer = session.try_read(node, index, sub);
    return answer ||
           (answer.abort() != AbortCode::no_object && answer.abort() != AbortCode::no_sub_index);
  };
  const bool is_known = profile.sheet != nullptr || profile.number != 0;
  if (is_known || !needs_profile(object)) return parse_object(object, profile, has);
  const Result<std::vector<std::uint8_t>> answer =
      session.try_read(node, object_index::device_type, 0);
  if (!answer) {
    // An index is sufficient for a node without a device type.
    if (const auto address = find_address(base_profile(), object)) return *address;
    throw Failure(fmt::format(
        "{}, {}: {}; say its profile with --profile, or give the index", text::node_text(node),
        text::object_text(object_index::device_type, 0), text::abort_text(answer.abort())));
  }
  const std::uint32_t device_type = device_type_of(*answer);
  // Also for an unknown profile.
  return parse_object(object, find_profile(device_type) == nullptr ? 0 : device_type, has);
}

std::string printed_name(const ObjectAddress& object) {
  decoder::DecodedValue value{.index = object.index, .sub = object.sub};
  if (object.object != nullptr) {
    value.profile = &profile_of(*object.object);
    value.object = object.object;
    value.entry = object.entry;
  }
  return text::object_name_text(value);
}

NodeEntry::NodeEntry(Session& session, NodeId node, const ObjectAddress& object,
                     const ProfileChoice& profile)
    : entry_(object.entry) {
  if (entry_ == nullptr) return;
  const decoder::UnitSource teller =
      decoder::unit_source_of(*entry_, *object.object, object.index, object.sub);
  if (teller.index == 0) return;
  const Result<std::vector<std::uint8_t>> held = session.try_read(node, teller.index, teller.sub);
  if (!held || held->empty() || held->size() > sizeof(std::uint64_t)) return;
  told_ = std::make_unique<decoder::EntryWithUnit>(
      *entry_, decoder::measure_by_source(
                   profile.sheet == nullptr ? profile_of(*object.object) : *profile.sheet, *entry_,
                   load_unsigned(*held)));
}

}  // namespace canvoy::tools
