// SDO block transfers for a server: up to 127 segments are acknowledged at once, and a checksum
// tells whether all is well (CiA 301, 7.2.4.3.9 to 7.2.4.3.15).
//
// A server without it refuses such transfers with 0504 0001h, and clients take segments.
//
//     SdoServer server(node, 0, buffer);
//     SdoBlockServer blocks(server);
#pragma once

#include <cstdint>

#include "canvoy/canopen/sdo/sdo_block.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"

namespace canvoy {

/// Downloads are taken with a checksum if the client has one. Where segments were lost, the block
/// is acknowledged up to the first of them: at its end, or where the client is silent for half of
/// the time-out, since its last segments may be those that were lost.
///
/// A copy of the request that was taken last is no request, whatever it looks like.
///
/// Uploads go out as fast as the controller takes frames, and not more than one waits in the node.
class SdoBlockServer {
 public:
  /// Downloads are asked for in blocks of `block_size` segments, 1 to 127: no more than the CAN
  /// controller can receive before the node is called. `server` must outlive this,
  /// and is not used without it any more.
  constexpr SdoBlockServer(SdoServer& server, std::uint8_t block_size)
      : server_(server),
        extension_{Callback<void(const Frame&)>::to<&SdoBlockServer::receive>(*this),
                   Callback<bool()>::to<&SdoBlockServer::expired>(*this)},
        block_size_(is_block_size(block_size) ? block_size : sdo::block_size_max) {
    server_.extension_ = &extension_;
    server_.node_.attach(service_);
  }
  constexpr explicit SdoBlockServer(SdoServer& server)
      : SdoBlockServer(server, sdo::block_size_max) {}
  SdoBlockServer(const SdoBlockServer&) = delete;
  SdoBlockServer& operator=(const SdoBlockServer&) = delete;

 private:
  /// What is waited for.
  enum class Phase : std::uint8_t {
    download_segments,
    download_end,
    upload_start,
    upload_acknowledgement,  ///< and segments are sent until then
    upload_end,
  };

  void receive(const Frame& frame);
  bool expired();

  void receive_download(sdo::Message request);
  void initiate_download(sdo::Message request);
  void download_segment(sdo::Message segment);
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

  void refuse(sdo::Message request);
  bool in(Phase phase) const;
  void go_on(Phase phase);

  SdoServer& server_;
  SdoServer::Extension extension_;
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  std::uint8_t block_size_;
  Phase phase_ = Phase::download_segments;
  bool prodded_ = false;      ///< half of the time-out has gone by
  bool may_be_over_ = false;  ///< the last request is the end, or a copy of the last segment
  sdo::Message last_{0};      ///< that was taken, but for plain segments
  SdoBlockReceiver receiver_;
  SdoBlockSender sender_;
};

}  // namespace canvoy
