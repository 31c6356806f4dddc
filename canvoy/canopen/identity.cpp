#include "canvoy/canopen/identity.hpp"

namespace canvoy {

namespace {

constexpr std::uint16_t device_name_object = 0x1008;
constexpr std::uint16_t hardware_version_object = 0x1009;
constexpr std::uint16_t software_version_object = 0x100A;
constexpr std::uint16_t identity_object = 0x1018;

}  // namespace

constexpr ServiceCalls Identity::service_calls = {.reset = method<&Identity::reset>};

Identity::Identity(Node& node, const IdentityValues& values) : node_(node), values_(values) {
  node_.attach(service_);
}

void Identity::reset(ResetScope) {
  set_number(1, values_.vendor_id);
  set_number(2, values_.product_code);
  set_number(3, values_.revision);
  set_number(4, values_.serial_number);
  set_text(device_name_object, values_.device_name);
  set_text(hardware_version_object, values_.hardware_version);
  set_text(software_version_object, values_.software_version);
}

void Identity::set_number(std::uint8_t sub, const std::optional<std::uint32_t>& number) {
  if (number) node_.dictionary().set_number(identity_object, sub, *number);
}

void Identity::set_text(std::uint16_t index, std::string_view text) {
  const Result<Entry> entry = node_.dictionary().find(index, 0);
  if (text.empty() || !entry) return;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  node_.dictionary().set(*entry, {bytes, text.size()});
}

}  // namespace canvoy
