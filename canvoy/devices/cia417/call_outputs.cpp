#include "canvoy/devices/cia417/call_outputs.hpp"

namespace canvoy::cia417 {

constexpr ServiceCalls CallOutputs::service_calls = {.reset = method<&CallOutputs::reset>};

CallOutputs::CallOutputs(Node& node, std::span<const VirtualOutput> outputs)
    : node_(node),
      groups_(node.dictionary().tables(), output_group_object.index),
      outputs_(outputs) {
  node.attach(service_);
}

/// Panels know as little.
void CallOutputs::reset(ResetScope) {
  groups_.for_each([this](std::uint32_t output, IoPlace place) {
    if (output >= outputs_.size()) return;
    node_.dictionary().set_number(place.index, place.sub, encode(outputs_[output]));
  });
}

void CallOutputs::store(const VirtualOutput& record) {
  groups_.for_each([this, &record](std::uint32_t output, IoPlace place) {
    if (output >= outputs_.size() || !is_addressed(record, outputs_[output])) return;
    VirtualOutput shown = outputs_[output];
    const bool is_any =
        record.function != BasicFunction::special_indication || shown.sub_function == 0;
    if (shows_sub_function(record.function) && is_any) shown.sub_function = record.sub_function;
    shown.data = record.data;
    node_.dictionary().set_number(place.index, place.sub, encode(shown));
  });
}

}  // namespace canvoy::cia417
