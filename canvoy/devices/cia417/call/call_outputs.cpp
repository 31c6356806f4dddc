#include "canvoy/devices/cia417/call/call_outputs.hpp"

#include <algorithm>

#include "canvoy/profiles/cia417/physical.hpp"

namespace canvoy::cia417 {

constexpr ServiceHandlers CallOutputs::service_calls = {.reset = method<&CallOutputs::reset>};

CallOutputs::CallOutputs(Node& node, std::span<const VirtualOutput> outputs)
    : node_(node),
      groups_(node.dictionary().tables(), output_group_object.index),
      outputs_(outputs) {
  node.attach(service_);
}

/// Panels have lost their state as well.
void CallOutputs::reset(ResetScope) {
  groups_.for_each([this](std::uint32_t number, IoPlace place) {
    if (number >= outputs_.size()) return;
    node_.dictionary().set_number(place.index, place.sub, encode(assigned(number)));
  });
}

VirtualOutput CallOutputs::assigned(std::uint32_t number) const {
  VirtualOutput shown = outputs_[number];
  if (shown.lifts == 0) {
    shown.lifts = static_cast<std::uint8_t>(node_.dictionary().number(lift_number_object.index, 0));
  }
  return shown;
}

void CallOutputs::store(const VirtualOutput& record) {
  const std::size_t count = std::min<std::size_t>(outputs_.size(), groups_.size());
  for (std::uint32_t number = 0; number < count; ++number) {
    // Most of the hundreds of outputs of a tall building have another function.
    if (outputs_[number].function != record.function) continue;
    VirtualOutput shown = assigned(number);
    if (!is_addressed(record, shown)) continue;
    const bool is_any =
        record.function != BasicFunction::special_indication || shown.sub_function == 0;
    if (shows_sub_function(record.function) && is_any) shown.sub_function = record.sub_function;
    shown.data = record.data;
    const IoPlace place = groups_.place(number);
    node_.dictionary().set_number(place.index, place.sub, encode(shown));
  }
}

}  // namespace canvoy::cia417
