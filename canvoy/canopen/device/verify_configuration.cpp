#include "canvoy/canopen/device/verify_configuration.hpp"

#include "canvoy/canopen/dictionary/action_objects.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/sdo/sdo_channel.hpp"

namespace canvoy {

namespace {

/// The node-ID at the other end changes together with the COB-IDs.
bool is_of_dynamic_channel(const Entry& entry) {
  return (is_sdo_parameter(entry.index) && entry.sub == sdo_sub_peer) ||
         is_dynamic_channel(entry.index, entry.bytes());
}

}  // namespace

constexpr AccessHandlers VerifyConfiguration::hook_calls = {
    .first = 0x0000, .last = 0xFFFF, .after_write = method<&VerifyConfiguration::after_write>};
constexpr ServiceHandlers VerifyConfiguration::service_calls = {.hooks = {&hook_calls, 1}};

VerifyConfiguration::VerifyConfiguration(Node& node) : node_(node) {
  node_.attach(service_);
}

bool VerifyConfiguration::is_configuration(const Entry& entry) {
  if (allows(entry.row->access, Access::rpdo)) return false;
  const bool is_verification = entry.index == object_index::verify_configuration;
  return !is_verification && !is_action_or_state(entry.index) && !is_of_dynamic_channel(entry);
}

void VerifyConfiguration::after_write(const Entry& entry, Source source) {
  if (source != Source::sdo || !is_configuration(entry)) return;
  node_.dictionary().set_number(object_index::verify_configuration, 1, 0);
  node_.dictionary().set_number(object_index::verify_configuration, 2, 0);
}

}  // namespace canvoy
