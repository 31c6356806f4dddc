// SDO server: lets clients read and write the object dictionary, with expedited and segmented
// transfers (CiA 301, 7.2.4). For block transfers see SdoBlockServer.
//
//     std::array<std::uint8_t, 64> buffer;
//     SdoServer sdo_server(node, 0, buffer);
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/canopen/sdo/sdo_channel.hpp"
#include "canvoy/canopen/sdo/sdo_entry.hpp"
#include "canvoy/canopen/sdo/sdo_watchdog.hpp"

namespace canvoy {

/// Serves one channel, in NMT states pre-operational and operational. Values of up to 4 bytes take
/// one frame each way. Longer ones are collected in the buffer and written completely; a read
/// returns the value as it was at its beginning. Domains are streamed, and never complete in
/// memory.
///
/// A request for a new transfer ends one that is under way, without an answer to the old one.
class SdoServer : private NodeService {
 public:
  static constexpr Duration default_time_out = 1s;  ///< silence of a client

  /// Makes a server. Channel `number`, 0 to 127, is described by object 1200h + number. Number 0 is
  /// the default channel, on 600h and 580h + node-ID, with or without the object; others are
  /// disabled without it, and follow it at run time: a COB-ID is refused there (out_of_memory) if
  /// the node has no free route for it. `buffer` must outlive the server, and limits the length of
  /// values (see sdo_buffer_size); except on a small machine, 8 bytes are always available. A
  /// client that is silent for `time_out` during a transfer loses it (an hour at most).
  ///
  /// Makes a server for channel 0 only: code that follows an object is not linked.
  constexpr SdoServer(Node& node, std::uint8_t number, std::span<std::uint8_t> buffer,
                      Duration time_out = default_time_out)
      : NodeService(
            number == 0 ? Listener{on_event} : Listener{on_object_event, first_object, last_object},
            EventMask::none),
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

  /// True if a transfer is under way, in segments or in blocks, or an answer that takes time.
  bool busy() const { return state_ != State::idle; }

 private:
  friend class SdoBlockServer;

  enum class State : std::uint8_t {
    idle,
    opening,  ///< the application is asked; if it stops the node, the request has no effect
    download,
    upload,
    deferred,
    block,
  };

  /// The extension for block transfers: a table, so that a program without one links none of it.
  struct Extension {
    /// Takes each request during a block transfer, and each that may begin one.
    Callback<void(const Frame&)> receive;
    /// Handles half of the time-out; false if the transfer ends.
    Callback<bool()> expired;
  };

  static constexpr std::uint16_t first_object = sdo_server_parameter + 1;
  static constexpr std::uint16_t last_object = sdo_server_parameter + sdo_channels_max - 1;

  static void on_event(NodeService& service, ServiceEvent& event);
  static void on_object_event(NodeService& service, ServiceEvent& event);
  void follow_default_channel(NmtState state);
  void follow_object_in(NmtState state);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value) const;
  /// Listens on a channel. NodeService::can_id_ is its other half.
  void listen(SdoChannel wanted);

  void receive(const Frame& frame, Time now);
  void serve(const Frame& frame);
  void serve_further(const Frame& frame);
  void end();
  bool find(sdo::Message request);
  bool begin_with(sdo::Message request);
  bool find_here(sdo::Message request);
  bool opened(AbortCode answer);
  bool goes_on(AbortCode answer);
  void initiate_upload(sdo::Message request);
  void begin_upload();
  void upload_segment(sdo::Message request);
  [[gnu::noinline]] void send_segment();
  void send_streamed_segment();
  void initiate_download(sdo::Message request);
  std::optional<std::uint32_t> size_to_come(sdo::Message request) const;
  void download_segment(sdo::Message request);
  [[gnu::noinline]] void take_segment(sdo::Message request);
  [[gnu::noinline]] void pass_segment_on(sdo::Message request);
  void write_at_once(sdo::Message request);
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
  /// Answers if no other code was called since the request.
  void reply(sdo::Message message) { node_.transmitter().send(message.frame(answering_on_)); }

  // Small members come first: a Cortex-M0+ reaches them with shorter instructions.
  std::uint8_t number_ = 0;  ///< of the channel
  State state_ = State::idle;
  std::uint8_t toggle_ = 0;         ///< of the next segment
  std::uint8_t confirmation_ = 0;   ///< first byte of the confirmation of a deferred write
  std::uint16_t answering_on_ = 0;  ///< outlives a channel that the present request closes
  sdo::Multiplexer multiplexer_;    ///< of the present transfer
  Node& node_;
  std::uint32_t time_out_;  ///< in microseconds
  [[no_unique_address]] HostOnly<std::array<std::uint8_t, 8>> small_buffer_;

  const Extension* extension_ = nullptr;
  SdoEntry entry_;
  SdoWatchdog watchdog_;
};

}  // namespace canvoy
