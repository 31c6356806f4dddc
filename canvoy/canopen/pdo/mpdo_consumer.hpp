// Consumer of multiplexed PDOs (CiA 301, 7.2.3, and the object dispatching lists 1FD0h to 1FFFh).
//
//     MpdoConsumer mpdo_consumer(node, rpdos);
//     // 1601h:00h = FFh: the second RPDO takes what is addressed to this node
//     // 1602h:00h = FEh: the third takes what 1FD0h:01h and up pick from other nodes
#pragma once

#include "canvoy/canopen/pdo/mpdo.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"

namespace canvoy {

/// Adds the two modes of multiplexed PDOs to RPDOs. A value goes to an object that an RPDO may map
/// and that has at most four bytes, with the checks of an RPDO: ranges and hooks.
///
/// DAM: a frame for this node or for all (node 0) is accepted. An object that is missing, that no
/// RPDO may write, or that is longer raises 8230h, until a valid frame arrives. SAM: the first
/// entry of the dispatching lists with the producer's object selects the object for the value; a
/// frame without an entry is ignored. The lists start at 1FD0h and have no gaps. An entry is
/// refused if its first destination cannot take a value. Linear in the number of entries.
///
/// Frames of the other mode, SAM frames of node 0, and frames with a block that reaches beyond the
/// destination object are ignored and counted as malformed.
class MpdoConsumer {
 public:
  /// Makes the consumer. Both arguments must outlive it.
  MpdoConsumer(Node& node, Rpdos& rpdos);
  MpdoConsumer(const MpdoConsumer&) = delete;
  MpdoConsumer& operator=(const MpdoConsumer&) = delete;

 private:
  AbortCode before_list_write(const Entry& entry, std::span<const std::uint8_t> value);
  AbortCode before_parameter_write(const Entry& entry, std::span<const std::uint8_t> value);
  void receive(std::uint16_t number, MpdoMode mode, const std::uint8_t* data);
  MpdoAnswer take(MpdoMode mode, const Mpdo& mpdo);
  MpdoAnswer take_destination(const Mpdo& mpdo);
  MpdoAnswer take_source(const Mpdo& mpdo);
  MpdoAnswer put(std::uint16_t index, unsigned sub, const Mpdo& mpdo);

  Node& node_;
  Rpdos& rpdos_;
  MpdoReceiver receiver_ = MpdoReceiver::to<&MpdoConsumer::receive>(*this);
  static const AccessHandlers hook_calls[2];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
