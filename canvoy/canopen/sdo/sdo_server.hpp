// SDO server: lets clients read and write the object dictionary, expedited and in segments (CiA
// 301, 7.2.4). For block transfers see SdoBlockServer.
//
//     std::array<std::uint8_t, 64> buffer;
//     SdoServer sdo_server(node, 0, buffer);
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/canopen/sdo/sdo_channel.hpp"
#include "canvoy/canopen/sdo/sdo_entry.hpp"
#include "canvoy/canopen/sdo/sdo_watchdog.hpp"

namespace canvoy {

/// It serves one channel, in NMT states pre-operational and operational. Values of up to 4 bytes
/// take one frame each way. Longer ones are gathered in the buffer and written whole; a read gives
/// the value as it was at its beginning. Domains are streamed, and never in memory whole.
///
/// A request for a new transfer ends one that is under way, without an answer to the old one.
class SdoServer : private NodeService {
 public:
  static constexpr Duration default_time_out = 1s;

  /// Channel `number`, 0 to 127, is described by object 1200h + number. Number 0 is the default
  /// channel, on 600h and 580h + node-ID, with or without the object; others are off without it,
  /// and follow it at run time: a COB-ID is refused there (out_of_memory) where the node has no
  /// route left for it. `buffer` must outlive the server, and bounds the length of values
  /// (see sdo_buffer_size); 8 bytes there always are, but on a small machine. A client that is
  /// silent for `time_out` in the middle of a transfer has lost it (an hour at most).
  ///
  /// Where there is no other than number 0, what follows an object is not linked.
  constexpr SdoServer(Node& node, std::uint8_t number, std::span<std::uint8_t> buffer,
                      Duration time_out = default_time_out)
      : NodeService(
            number == 0 ? Listener{told} : Listener{told_of_object, first_object, last_object},
            Cares::for_nothing_frequent),
        number_(number),
        node_(node),
        time_out_(static_cast<std::uint32_t>(time_out.count())),
        entry_(node.dictionary(), is_small_machine || buffer.size() >= small_buffer_.value.size()
                                      ? buffer
                                      : std::span<std::uint8_t>(small_buffer_.value)),
        watchdog_(node.timers(), Callback<void(Time)>(&SdoServer::give_up, this)) {
    node_.attach(*this);
  }
  SdoServer(const SdoServer&) = delete;
  SdoServer& operator=(const SdoServer&) = delete;

  /// A transfer is under way, in segments or in blocks, or an answer that takes time.
  bool busy() const { return state_ != State::idle; }

 private:
  friend class SdoBlockServer;

  enum class State : std::uint8_t {
    idle,
    opening,  ///< the application is asked; where it stops the node, nothing comes of it
    download,
    upload,
    deferred,
    block,
  };

  /// Who serves block transfers: a table, so that nothing of it is linked where there is none.
  struct Extension {
    /// Each request while a block transfer is under way, and each that may begin one.
    Callback<void(const Frame&)> receive;
    /// Half of the time-out has gone by: whether that is not the end.
    Callback<bool()> expired;
  };

  static constexpr std::uint16_t first_object = sdo_server_parameter + 1;
  static constexpr std::uint16_t last_object = sdo_server_parameter + sdo_channels_max - 1;

  static void told(NodeService& service, ServiceEvent& event);
  static void told_of_object(NodeService& service, ServiceEvent& event);
  void follow_default_channel(NmtState state);
  void follow_object_in(NmtState state);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value) const;
  /// NodeService::can_id_ is the other half of the channel.
  void listen(SdoChannel wanted);

  void receive(const Frame& frame, Time now);
  void serve(const Frame& frame);
  bool find(sdo::Message request);
  bool opened(AbortCode answer);
  void initiate_upload(sdo::Message request);
  void begin_upload();
  void upload_segment(sdo::Message request);
  [[gnu::noinline]] void send_segment();
  void initiate_download(sdo::Message request);
  std::optional<std::uint32_t> size_to_come(sdo::Message request) const;
  void download_segment(sdo::Message request);
  [[gnu::noinline]] void take_segment(sdo::Message request);
  void write(std::span<const std::uint8_t> bytes, bool last, std::uint8_t confirmation);
  void refuse_service(sdo::Message request);

  void confirm(AbortCode answer, std::uint8_t confirmation);
  void finish_deferred(AbortCode answer);

  void begin(State state);
  void expect_next_segment();
  void await_client(std::uint32_t microseconds) { watchdog_.restart_in(microseconds); }
  void drop();
  static void give_up(void* server, Time now);
  void give_up(Time now);
  void abort(AbortCode code);
  void send(sdo::Message message);
  /// Where nobody else was called since the request.
  void reply(sdo::Message message) { node_.transmitter().send(message.frame(answering_on_)); }

  // What is small comes first: a Cortex-M0+ reaches it with shorter instructions.
  std::uint8_t number_ = 0;  ///< of the channel
  State state_ = State::idle;
  std::uint8_t toggle_ = 0;         ///< of the next segment
  std::uint8_t confirmation_ = 0;   ///< that a deferred write waits for: its first byte
  std::uint16_t answering_on_ = 0;  ///< outlives a channel that is closed by the present request
  sdo::Multiplexer multiplexer_;    ///< of the present transfer
  Node& node_;
  std::uint32_t time_out_;  ///< in microseconds
  [[no_unique_address]] HostOnly<std::array<std::uint8_t, 8>> small_buffer_;

  const Extension* extension_ = nullptr;
  SdoEntry entry_;
  SdoWatchdog watchdog_;
};

}  // namespace canvoy
