#include "canvoy/canopen/remote/identity.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

constexpr ServiceHandlers Identity::service_calls = {.reset = method<&Identity::reset>};

Identity::Identity(Node& node, const IdentityValues& values) : node_(node), values_(values) {
  node_.attach(service_);
}

void Identity::reset(ResetScope) {
  set_number(1, values_.vendor_id);
  set_number(2, values_.product_code);
  set_number(3, values_.revision);
  set_number(4, values_.serial_number);
  set_text(object_index::device_name, values_.device_name);
  set_text(object_index::hardware_version, values_.hardware_version);
  set_text(object_index::software_version, values_.software_version);
}

void Identity::set_number(std::uint8_t sub, const std::optional<std::uint32_t>& number) {
  if (number) node_.dictionary().set_number(object_index::identity, sub, *number);
}

void Identity::set_text(std::uint16_t index, std::string_view text) {
  const Result<Entry> entry = node_.dictionary().find(index, 0);
  if (text.empty() || !entry) return;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  node_.dictionary().set(*entry, {bytes, text.size()});
}

}  // namespace canvoy
