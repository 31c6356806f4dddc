#include "canvoy/text/check/profile_rule.hpp"

#include <fmt/format.h>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

/// The virtual device in 1000h; null if it names none, or several.
const VirtualDeviceInfo* virtual_device_of(Bench& bench, const Profile& profile) {
  const auto type = bench.number(object_index::device_type, 0);
  if (!type || profile.device_type_of == nullptr) return nullptr;
  const VirtualDeviceInfo* found = nullptr;
  for (const VirtualDeviceInfo& each : profile.virtual_devices) {
    if (profile.device_type_of(each) != *type) continue;
    if (found != nullptr) return nullptr;
    found = &each;
  }
  return found;
}

/// An optional object may exist because the device receives it from another: it is then writable.
bool may_consume(const Claim& claim, const ObjectInfo& object, const EntryInfo& entry) {
  if (claim.is_mandatory) return false;
  const Part part = detail::part_of(object, object.index, {}, {}).consumed();
  return allows(detail::access_of(part, entry), Access::sdo_write);
}

/// True if the access depends on the device, and the device is unknown.
bool is_access_open(const Claim& claim, const EntryInfo& entry) {
  return claim.as == nullptr && has_access_by_device(entry);
}

/// Verdict for the answer to a read, if it is wrong.
std::optional<Verdict> judge_reading(const std::string& place, const Reply& value, bool may_read) {
  if (value.kind == Reply::Kind::silent || value.kind == Reply::Kind::malformed) {
    return failed(fmt::format("{}: {}", place, value.text()));
  }
  const bool is_closed = value.has_aborted(AbortCode::write_only) ||
                         (may_read && value.has_aborted(AbortCode::unsupported_access));
  if (may_read != is_closed) return std::nullopt;
  return failed(
      fmt::format("{} is to be {}: {}", place, may_read ? "read" : "write only", value.text()));
}

}  // namespace

bool has_access_rule(const EntryInfo& entry) {
  return !entry.or_const && entry.type != DataType::domain;
}

bool has_access_by_device(const EntryInfo& entry) {
  return entry.access_by_device || entry.consumer_access != Access::none;
}

bool Ruled::is_communication() const {
  return object->index >= object_index::communication_first &&
         object->index <= object_index::communication_last;
}

Claim claim_of(Bench& bench, const Ruled& ruled) {
  Claim claim;
  const bool is_by_itself = ruled.profile->virtual_devices.empty() || ruled.is_communication();
  claim.device = virtual_device_of(bench, *ruled.profile);
  if (claim.device != nullptr) {
    claim.as = detail::find_device_object(*claim.device, ruled.object->index);
  }
  claim.is_mandatory = is_by_itself
                           ? ruled.object->category == Category::mandatory
                           : claim.as != nullptr && claim.as->category == Category::mandatory;
  return claim;
}

Access access_of_claim(const Claim& claim, const ObjectInfo& object, const EntryInfo& entry) {
  constexpr DeviceObject by_itself{};
  const DeviceObject& as = claim.as != nullptr ? *claim.as : by_itself;
  return detail::access_of(detail::part_of(object, object.index, as, {}), entry);
}

Verdict judge_there(Bench& bench, const Ruled& ruled) {
  const Claim claim = claim_of(bench, ruled);
  const std::uint16_t index = ruled.index();
  if (!claim.is_mandatory) {
    const bool is_by_device = !ruled.is_communication() && !ruled.profile->virtual_devices.empty();
    if (claim.device == nullptr && is_by_device) {
      return not_applicable("1000h names no single virtual device");
    }
    return not_applicable("it need not be there");
  }
  for (const EntryInfo& entry : ruled.object->entries()) {
    const bool must_be = entry.category == Category::mandatory && entry.sub_first <= 1;
    if (!must_be) continue;
    const Reply reply = bench.read(index, entry.sub_first);
    if (reply.is_absent() || reply.kind == Reply::Kind::silent) {
      return failed(fmt::format("{}: {}", text::object_text(index, entry.sub_first), reply.text()));
    }
  }
  return passed();
}

Verdict judge_type(Bench& bench, const Ruled& ruled) {
  const std::uint16_t index = ruled.index();
  std::size_t tried = 0;
  for (const EntryInfo& entry : ruled.object->entries()) {
    const unsigned length = byte_length(entry.type);
    if (length == 0) continue;
    const Reply reply = bench.read(index, entry.sub_first);
    if (reply.is_absent() && entry.sub_first <= 1) return not_applicable("it is not there");
    if (!reply) continue;
    ++tried;
    if (reply.value.size() == length) continue;
    return failed(fmt::format("{} has {} bytes in place of {}",
                              text::object_text(index, entry.sub_first), reply.value.size(),
                              length));
  }
  return tried == 0 ? not_applicable("it has no value of one length that can be read") : passed();
}

Verdict judge_access(Bench& bench, const Ruled& ruled) {
  const Claim claim = claim_of(bench, ruled);
  const std::uint16_t index = ruled.index();
  std::size_t tried = 0;
  for (const EntryInfo& entry : ruled.object->entries()) {
    if (!has_access_rule(entry) || is_access_open(claim, entry)) continue;
    const Access access = access_of_claim(claim, *ruled.object, entry);
    const std::string place = text::object_text(index, entry.sub_first);
    const Reply value = bench.read(index, entry.sub_first);
    if (value.is_absent()) continue;
    ++tried;
    const bool may_read = allows(access, Access::sdo_read);
    if (auto wrong = judge_reading(place, value, may_read)) return *wrong;
    if (!may_read || allows(access, Access::sdo_write) || !value || value.value.empty()) continue;
    if (may_consume(claim, *ruled.object, entry)) continue;
    const Reply written = bench.write(index, entry.sub_first, value.value);
    if (!written.has_aborted(AbortCode::read_only)) {
      return failed(fmt::format("{} is read only, and is written: {}", place, written.text()));
    }
  }
  return tried == 0 ? not_applicable("it is not there, or its access is the device's choice")
                    : passed();
}

}  // namespace canvoy::conformance
