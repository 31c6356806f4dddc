#include "canvoy/devices/cia417/kit/object_creation.hpp"

#include <algorithm>

#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

namespace {

using Read = Callback<AbortCode(const Entry&)>;
using Write = Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)>;

}  // namespace

constexpr AccessHandlers ObjectCreation::hook_calls[] = {
    before_write<&ObjectCreation::before_request, object_creation_object>,
    after_write<&ObjectCreation::requested, object_creation_object>};
constexpr ServiceHandlers ObjectCreation::service_calls = {.reset = method<&ObjectCreation::reset>,
                                                           .hooks = hook_calls};

ObjectCreation::ObjectCreation(Node& node, std::span<const CreatableObjects> creatable,
                               std::span<CreatedObject> memory)
    : node_(node), creatable_(creatable), memory_(memory) {
  node.attach(service_);
  if (creatable.empty()) return;
  const auto first = std::ranges::min_element(creatable, {}, &CreatableObjects::first);
  const auto last = std::ranges::max_element(creatable, {}, &CreatableObjects::last);
  object_hook_.first = first->first;
  object_hook_.last = last->last;
  object_hook_.before_read = Read::to<&ObjectCreation::read_created>(*this);
  object_hook_.before_write = Write::to<&ObjectCreation::write_created>(*this);
  node.dictionary().attach(object_hook_);
}

void ObjectCreation::reset(ResetScope scope) {
  if (scope == ResetScope::communication) return;
  std::ranges::fill(memory_, CreatedObject{});
  last_created_ = 0;
}

// Requests

AbortCode ObjectCreation::before_request(const Entry&, std::span<const std::uint8_t> value) {
  const CreationRequest request = decode_creation(load<std::uint32_t>(value.data()));
  const CreatableObjects* creatable = find_creatable(request.index);
  if (creatable == nullptr || request.sub == 0 || request.sub > creatable->highest_sub) {
    return AbortCode::value_range;
  }
  const bool is_there = find(request.index, request.sub) != nullptr;
  switch (request.action) {
    case static_cast<std::uint8_t>(Creation::create):
      return is_there || find_free() != nullptr ? AbortCode::none : AbortCode::out_of_memory;
    case static_cast<std::uint8_t>(Creation::destroy):
      return is_there ? AbortCode::none : AbortCode::no_object;
    default:
      return AbortCode::value_range;
  }
}

/// The value read is the last one that was created.
void ObjectCreation::requested(const Entry& entry, Source) {
  const auto written = static_cast<std::uint32_t>(node_.dictionary().number(entry.index, 0));
  const CreationRequest request = decode_creation(written);
  if (request.action == static_cast<std::uint8_t>(Creation::create)) {
    create(request);
    last_created_ = written;
  } else {
    destroy(request);
  }
  node_.dictionary().set_number(entry.index, 0, last_created_);
}

void ObjectCreation::create(const CreationRequest& request) {
  CreatedObject* object = find(request.index, request.sub);
  if (object == nullptr) object = find_free();
  if (object != nullptr) *object = {request.index, request.sub, request.access};
}

/// When it is created again, it has its default.
void ObjectCreation::destroy(const CreationRequest& request) {
  CreatedObject* object = find(request.index, request.sub);
  if (object != nullptr) *object = {};
  const Result<Entry> entry = node_.dictionary().find(request.index, request.sub);
  if (!entry) return;
  node_.dictionary().set_number(request.index, request.sub,
                                node_.dictionary().default_number(*entry));
}

// Accesses

AbortCode ObjectCreation::read_created(const Entry& entry) {
  const CreatableObjects* creatable = find_creatable(entry.index);
  if (creatable == nullptr || entry.sub > creatable->highest_sub) return AbortCode::none;
  const AbortCode answer = check_there(entry);
  if (answer != AbortCode::none) return answer;
  if (entry.sub == 0) {
    node_.dictionary().set_number(entry.index, 0, highest_sub(entry.index));
    return AbortCode::none;
  }
  const CreatedAccess access = access_of(entry, *creatable);
  return access == CreatedAccess::wo ? AbortCode::write_only : AbortCode::none;
}

AbortCode ObjectCreation::write_created(const Entry& entry, std::span<const std::uint8_t>) {
  const CreatableObjects* creatable = find_creatable(entry.index);
  if (creatable == nullptr || entry.sub > creatable->highest_sub) return AbortCode::none;
  const AbortCode answer = check_there(entry);
  if (answer != AbortCode::none) return answer;
  const CreatedAccess access = access_of(entry, *creatable);
  return access == CreatedAccess::ro ? AbortCode::read_only : AbortCode::none;
}

const CreatableObjects* ObjectCreation::find_creatable(std::uint16_t index) const {
  const auto found = std::ranges::find_if(creatable_, [index](const CreatableObjects& objects) {
    return index >= objects.first && index <= objects.last;
  });
  return found == creatable_.end() ? nullptr : &*found;
}

CreatedObject* ObjectCreation::find(std::uint16_t index, std::uint8_t sub) const {
  const auto found = std::ranges::find_if(memory_, [index, sub](const CreatedObject& object) {
    return object.index == index && object.sub == sub;
  });
  return found == memory_.end() ? nullptr : &*found;
}

CreatedObject* ObjectCreation::find_free() const {
  return find(0, 0);
}

std::uint8_t ObjectCreation::highest_sub(std::uint16_t index) const {
  std::uint8_t highest = 0;
  for (const CreatedObject& object : memory_) {
    if (object.index == index) highest = std::max(highest, object.sub);
  }
  return highest;
}

AbortCode ObjectCreation::check_there(const Entry& entry) const {
  if (highest_sub(entry.index) == 0) return AbortCode::no_object;
  const bool is_there = entry.sub == 0 || find(entry.index, entry.sub) != nullptr;
  return is_there ? AbortCode::none : AbortCode::no_sub_index;
}

CreatedAccess ObjectCreation::access_of(const Entry& entry,
                                        const CreatableObjects& specified) const {
  const CreatedObject* object = find(entry.index, entry.sub);
  if (object == nullptr || object->access != CreatedAccess::as_specified) {
    return object == nullptr ? CreatedAccess::ro : object->access;
  }
  if (!allows(specified.specified, Access::sdo_write)) return CreatedAccess::ro;
  return allows(specified.specified, Access::sdo_read) ? CreatedAccess::rw : CreatedAccess::wo;
}

}  // namespace canvoy::cia417
