#include "canvoy/sim/node_configuration.hpp"

namespace canvoy {

NodeConfiguration::NodeConfiguration(Node& node, std::span<const NodeValue> values)
    : node_(node), values_(values) {
  service_.state_entered = callback<&NodeConfiguration::state_entered>(*this);
  node.attach(service_);
}

void NodeConfiguration::state_entered(NmtState state) {
  const bool has_booted = boots_ && state == NmtState::pre_operational;
  boots_ = state == NmtState::initialisation;
  if (!has_booted) return;
  refusal_.reset();
  for (const NodeValue& value : values_) {
    const AbortCode answer =
        node_.dictionary().write(value.index, value.sub, value.bytes, Source::sdo);
    if (answer != AbortCode::none && !refusal_) refusal_ = {value, answer};
  }
}

}  // namespace canvoy
