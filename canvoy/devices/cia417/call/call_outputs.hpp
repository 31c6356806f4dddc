// The output groups of a call controller (6200h to 621Fh; CiA 417-4, 4.4.1): the last record for
// each output of its panels, so that a device that comes later can read the state of a lift by SDO.
//
//     constexpr VirtualOutput lamps[] = {{.function = BasicFunction::standard_hall_call, ...}};
//     CallOutputs outputs(node, lamps);        // 6200h:01h is the first lamp
//     calls.on_record(outputs.told());
//
// An output is an assignment of a panel. A record is stored in all outputs that it addresses, as in
// the panels. An output without a lift belongs to the lift of the controller (6001h).
#pragma once

#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia417/virtual_io/io_groups.hpp"
#include "canvoy/devices/cia417/virtual_io/output_address.hpp"

namespace canvoy::cia417 {

class CallOutputs {
 public:
  /// `outputs` are those of the groups that `node` has, in their order; others are left out. All
  /// arguments must outlive this.
  CallOutputs(Node& node, std::span<const VirtualOutput> outputs);

  /// For CallController::on_record(). Linear in the number of outputs.
  Callback<void(const VirtualOutput&)> told() { return callback<&CallOutputs::store>(*this); }

 private:
  void reset(ResetScope scope);
  void store(const VirtualOutput& record);
  VirtualOutput assigned(std::uint32_t number) const;

  static const ServiceHandlers service_calls;

  Node& node_;
  IoGroups groups_;
  std::span<const VirtualOutput> outputs_;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia417
