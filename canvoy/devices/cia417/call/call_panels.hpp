// The panels of a controller with a call controller: by the RPDOs for 6010h (virtual_input_rpdos),
// by multiplexed PDOs (multiplexed_panels), and by the list of the records sent to their outputs
// (6200h; CiA 417-4, 4.2.3 and 4.4.1). Features that the layout does not have take no memory.
//
//     CallPanels<layout> panels(node, calls, outputs);
//     panels.use(127);   // when power-on defaults have been restored
#pragma once

#include <span>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/devices/cia417/call/call_controller.hpp"
#include "canvoy/devices/cia417/call/call_outputs.hpp"
#include "canvoy/devices/cia417/virtual_io/multiplexed_panels.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_input_rpdos.hpp"

namespace canvoy::cia417 {

template <const auto& layout>
class CallPanels {
 public:
  /// `outputs` are those of the panels that 6200h lists. All arguments must outlive this.
  CallPanels(Node& node, CallController& calls, std::span<const VirtualOutput> outputs)
      : node_(node), outputs_(node, outputs), mpdos_(node) {
    if constexpr (lists_outputs) calls.on_record(outputs_.service.told());
  }

  /// Receives panels with node-IDs 1 to `count`.
  void use(unsigned count) {
    use_panels(node_.dictionary(), count, node_.id());
    if constexpr (hears_mpdos) use_multiplexed_panels(node_.dictionary(), count, node_.id());
  }

 private:
  static constexpr bool hears_mpdos = hears_multiplexed(layout.tables());
  static constexpr bool lists_outputs =
      count_in_groups(layout.tables(), output_group_object.index) != 0;

  Node& node_;
  [[no_unique_address]] canvoy::detail::Optional<CallOutputs, lists_outputs> outputs_;
  [[no_unique_address]] canvoy::detail::Optional<VirtualMpdoConsumer, hears_mpdos> mpdos_;
};

}  // namespace canvoy::cia417
