// Consumer of multiplexed PDOs (CiA 301, 7.2.3, and the object dispatching lists 1FD0h to 1FFFh).
//
//     MpdoConsumer mpdo_consumer(node, rpdos);
//     // 1601h:00h = FFh: the second RPDO takes what is addressed to this node
//     // 1602h:00h = FEh: the third takes what 1FD0h:01h and up pick from other nodes
#pragma once

#include "canvoy/canopen/pdo/mpdo.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"

namespace canvoy {

/// Gives RPDOs the two modes of multiplexed PDOs. A value goes to an object that an RPDO may map
/// and that has at most four bytes, by the same checks as an RPDO's: ranges and hooks.
///
/// DAM: taken if it is for this node or for all (node 0). An object that is not there, that no RPDO
/// may write, or that is longer is told with 8230h, until a good one comes.
/// SAM: the first entry of the dispatching lists that names the producer's object says which object
/// gets the value; what no entry names is ignored. The lists follow one another without a gap from
/// 1FD0h. An entry is refused while its first own object cannot take a value. Linear in the number
/// of entries.
///
/// Frames of the other mode, SAM frames of node 0, and those for which a block reaches beyond the
/// own object are ignored and counted as malformed.
class MpdoConsumer {
 public:
  /// All must outlive this.
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
  static const HookCalls hook_calls[2];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
};

}  // namespace canvoy
