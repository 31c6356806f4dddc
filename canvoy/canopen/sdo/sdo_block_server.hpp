// SDO block transfers of a server: one acknowledgement for up to 127 segments, and a checksum over
// all data (CiA 301, 7.2.4.3.9 to 7.2.4.3.15).
//
// A server without it refuses such transfers with 0504 0001h, and clients then use segments.
//
//     SdoServer server(node, 0, buffer);
//     SdoBlockServer blocks(server);
#pragma once

#include <cstdint>

#include "canvoy/canopen/sdo/sdo_block.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"

namespace canvoy {

/// Adds block transfers to a server. Downloads use a checksum if the client supports one. After
/// lost segments, the block is acknowledged up to the first of them: at its end, or when the client
/// is silent for half of the time-out, since its last segments may be lost.
///
/// A copy of the last request is not a request, whatever it looks like.
///
/// Uploads are sent as fast as the controller takes frames, and no more than one waits in the node.
class SdoBlockServer {
 public:
  /// Makes the extension. Downloads are requested in blocks of `block_size` segments, 1 to 127: no
  /// more than the CAN controller can receive before the node is called. `server` must outlive this
  /// object, and must not be used after its end.
  constexpr SdoBlockServer(SdoServer& server, std::uint8_t block_size)
      : server_(server),
        extension_{Callback<void(const Frame&)>::to<&SdoBlockServer::receive>(*this),
                   Callback<bool()>::to<&SdoBlockServer::expired>(*this)},
        block_size_(is_block_size(block_size) ? block_size : sdo::block_size_max) {
    server_.extension_ = &extension_;
    server_.node_.attach(service_);
  }
  /// Like the above, with blocks of 127 segments: for a controller or a driver that buffers as many
  /// frames.
  constexpr explicit SdoBlockServer(SdoServer& server)
      : SdoBlockServer(server, sdo::block_size_max) {}
  SdoBlockServer(const SdoBlockServer&) = delete;
  SdoBlockServer& operator=(const SdoBlockServer&) = delete;

 private:
  /// The expected message.
  enum class Phase : std::uint8_t {
    download_segments,
    download_end,
    upload_start,
    upload_acknowledgement,  ///< segments are sent meanwhile
    upload_end,
  };

  void receive(const Frame& frame);
  bool expired();

  void receive_download(sdo::Message request);
  void initiate_download(sdo::Message request);
  void download_segment(sdo::Message segment);
  bool has_passed_on();
  void acknowledge();
  void take_copy_of_last_segment();
  void end_download(sdo::Message request);

  void receive_upload(sdo::Message request);
  void initiate_upload(sdo::Message request);
  void start_upload(sdo::Message request);
  void upload_acknowledged(sdo::Message request);
  void send_segments();
  bool can_send() const;
  void send_segment();
  [[gnu::noinline]] void send_any_segment();

  void refuse(sdo::Message request);
  bool in(Phase phase) const;
  void go_on(Phase phase);

  SdoServer& server_;
  SdoServer::Extension extension_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  std::uint8_t block_size_;
  Phase phase_ = Phase::download_segments;
  bool prodded_ = false;      ///< half of the time-out is over
  bool may_be_over_ = false;  ///< the last request is the end, or a copy of the last segment
  sdo::Message last_{0};      ///< last message taken, except plain segments
  SdoBlockReceiver receiver_;
  SdoBlockSender sender_;
};

}  // namespace canvoy
