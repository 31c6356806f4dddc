// Devices on a second bus behind a node: a host accesses their dictionaries by SDO through the
// node, and receives their emergencies (multi-level networking, CiA 302-7; CiA 852, 5.2).
//
//     std::array<RemoteChannel, 1> channels;
//     RemoteAccess access(node, embedded_port, channels, {.network = 2});
//     access.receive(frame, now);            // of the host's bus, in place of node.receive()
//     access.receive_embedded(frame, now);   // of the bus behind it
//
// The text of CiA 302-7 is not available. The implementation follows its known behaviour; the
// numbers are settings. Interpretation of the services:
//
// A client selects, on its channel to the node, the device of its next transfer: a frame of eight
// bytes with the command `indication`, the number of the network (two bytes), the node-ID, and
// zeros. The node answers with the same frame, or aborts. Only the next transfer on this channel is
// with this device: each of its frames is passed on to the device's default SDO server and back, so
// that segments and blocks work without memory here. If no transfer begins within the time-out, the
// next request is refused (time_out) instead of being served by the node itself.
//
// An emergency of a device is sent with the COB-ID `emergency_cob_id`: error code, error register,
// network (its low byte), node-ID, and the first three manufacturer-specific bytes.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/canopen/sdo/sdo_channel.hpp"

namespace canvoy {

/// Numbers that both ends of the access must agree on, and times of the node between them.
struct RemoteSettings {
  std::uint16_t network = 2;       ///< of the bus behind the node
  std::uint8_t indication = 0xE0;  ///< a command that SDO does not use: E0h to FFh
  /// Of devices' emergencies; invalid: none is sent.
  std::uint32_t emergency_cob_id = invalid_cob_id;
  /// Limit of the silence of device or client in a transfer: shorter than the time-out of clients.
  Duration time_out = std::chrono::milliseconds(800);
  /// Least time between two emergencies.
  Duration emergency_inhibit = std::chrono::milliseconds(10);

  static constexpr std::uint32_t invalid_cob_id = 0x8000'0000;  ///< bit 31 set
};

class RemoteAccess;

/// A channel of the node for clients, and its present transfer.
class RemoteChannel {
 public:
  RemoteChannel() = default;
  /// Makes a channel other than the default one.
  explicit RemoteChannel(SdoChannel ids) : ids_(ids) {}
  RemoteChannel(const RemoteChannel&) = delete;
  RemoteChannel& operator=(const RemoteChannel&) = delete;

 private:
  friend class RemoteAccess;

  enum class Phase : std::uint8_t {
    idle,
    indicated,  ///< the next transfer is with `target_`
    expired,    ///< the selection has expired without a transfer
    download,
    upload,
    block_upload,
    block_upload_data,  ///< the device sends segments without a command
    block_download,
    block_download_data,  ///< the client sends segments without a command
  };

  bool is_busy() const { return phase_ >= Phase::download; }
  void expired(Time now);

  SdoChannel ids_;
  RemoteAccess* access_ = nullptr;
  Phase phase_ = Phase::idle;
  NodeId target_ = 0;
  bool answer_ends_ = false;  ///< the request that was passed on is the last of a download
  sdo::Multiplexer multiplexer_;
  Timer timer_{callback<&RemoteChannel::expired>(*this)};
};

/// The node's part of multi-level networking. Its channels replace the node's SDO servers on their
/// COB-IDs only while a device is selected.
class RemoteAccess {
 public:
  /// Counts since construction; they wrap at 2^32.
  struct Counters {
    std::uint32_t transfers = 0;         ///< begun with devices behind the node
    std::uint32_t emergencies = 0;       ///< sent
    std::uint32_t emergencies_lost = 0;  ///< faster than they may be sent, or in NMT stopped
  };

  /// Makes the service, before the node starts. Its arguments must outlive it. The first channel is
  /// the default one if it has no COB-IDs.
  RemoteAccess(Node& node, const Port& embedded, std::span<RemoteChannel> channels,
               const RemoteSettings& settings);
  RemoteAccess(const RemoteAccess&) = delete;
  RemoteAccess& operator=(const RemoteAccess&) = delete;

  /// Takes a frame of the host's bus: the node gets it unless it is for a device behind.
  void receive(const Frame& frame, Time now);
  /// Takes a frame of the bus behind.
  void receive_embedded(const Frame& frame, Time now);

  // Like those of the node.
  /// See Node::start().
  void start(Time now) { node_.start(now); }
  /// See Node::overrun(); for the host's bus.
  void overrun(Time now) { node_.overrun(now); }
  /// See Node::advance().
  void advance(Time now) { node_.advance(now); }
  /// See Node::deadline().
  Time deadline() const { return node_.deadline(); }
  /// See Node::mapping_reads().
  std::uint32_t mapping_reads() const { return node_.mapping_reads(); }
  /// See Node::bus_state(); for the host's bus.
  void bus_state(BusState state, Time now) { node_.bus_state(state, now); }
  /// See Node::tx_ready(); for the host's bus.
  void tx_ready(Time now) { node_.tx_ready(now); }

  /// What was passed on, and what was lost.
  const Counters& counters() const { return counters_; }

 private:
  friend class RemoteChannel;
  using Phase = RemoteChannel::Phase;

  static constexpr std::size_t waiting_max = 16;

  SdoChannel ids_of(const RemoteChannel& channel) const;
  RemoteChannel* channel_of(const Frame& frame);
  bool take(RemoteChannel& channel, sdo::Message request);
  void indicate(RemoteChannel& channel, sdo::Message request);
  void give_up(RemoteChannel& channel);
  bool begin(RemoteChannel& channel, sdo::Message request);
  void pass_on(RemoteChannel& channel, sdo::Message request);
  void answered(RemoteChannel& channel, sdo::Message answer);
  static bool is_end(RemoteChannel& channel, sdo::Message answer);
  void expired(RemoteChannel& channel);
  void lost(NodeId device);
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void drop_all();

  bool send_behind(NodeId device, sdo::Message message);
  void answer(const RemoteChannel& channel, sdo::Message message);
  void refuse(const RemoteChannel& channel, AbortCode code);
  void abort_both(RemoteChannel& channel, AbortCode code);
  void end(RemoteChannel& channel);

  void emergency(NodeId device, const Frame& frame);
  void notify(const Frame& frame);
  void may_tell(Time now);

  Node& node_;
  Port embedded_;
  std::span<RemoteChannel> channels_;
  RemoteSettings settings_;
  Counters counters_;
  std::array<Frame, waiting_max> waiting_{};  ///< emergencies, from `first_` on
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  Timer inhibit_{callback<&RemoteAccess::may_tell>(*this)};
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// The frame by which a client selects, on its channel to a node, the device of its next transfer;
/// the node confirms it with the same bytes.
sdo::Message remote_indication(const RemoteSettings& settings, std::uint16_t network,
                               NodeId device);

}  // namespace canvoy
