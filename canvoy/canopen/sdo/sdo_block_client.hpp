// SDO block transfers of a client: one acknowledgement for up to 127 segments, and a checksum over
// all data (CiA 301, 7.2.4.3.9 to 7.2.4.3.15).
//
//     SdoClient client(node);
//     std::array<std::uint8_t, SdoBlockClient::buffer_size> buffer;
//     SdoBlockClient blocks(client, buffer);   // from now on, what is long goes in blocks
//     client.download(5, 0x1F50, 1, supply, size, done);
#pragma once

#include <bitset>
#include <cstdint>
#include <span>

#include "canvoy/canopen/sdo/sdo_block.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// Adds block transfers to a client, which selects them by SdoClient::choose. With automatic,
/// transfers longer than a few segments, or of unknown length, use blocks; if a server refuses, the
/// request is repeated in segments, which that server gets from then on.
///
/// A copy of the last answer is not an answer, whatever it looks like.
///
/// Data is sent as fast as the controller takes frames, and no more than one waits in the node.
class SdoBlockClient {
 public:
  /// Size of one block of 127 segments.
  static constexpr std::size_t buffer_size = sdo::block_size_max * sdo::segment_max;
  /// Values of up to so many bytes use segments, unless blocks are requested.
  static constexpr std::size_t segmented_max = 63;

  /// Makes the extension. Data of a Supply is kept in `buffer` until the server has it. With less
  /// than buffer_size bytes there, only downloads from memory use blocks. Uploads are requested in
  /// blocks of `block_size` segments, 1 to 127. `client` and `buffer` must outlive this object, and
  /// `client` must not be used after its end.
  explicit SdoBlockClient(SdoClient& client, std::span<std::uint8_t> buffer = {},
                          std::uint8_t block_size = sdo::block_size_max);
  SdoBlockClient(const SdoBlockClient&) = delete;
  SdoBlockClient& operator=(const SdoBlockClient&) = delete;

 private:
  /// The expected message.
  enum class Phase : std::uint8_t {
    upload_initiated,
    upload_segments,
    upload_end,
    download_initiated,
    download_acknowledgement,  ///< segments are sent meanwhile
    download_end,
  };

  bool initiate_upload();
  bool initiate_download();
  bool wanted(bool is_long) const;
  void receive(const Frame& frame);
  bool expired();

  void upload_initiated(sdo::Message answer);
  void upload_segment(sdo::Message segment);
  void acknowledge();
  void take_copy_of_last_segment();
  void end_upload(sdo::Message answer);

  void download_initiated(sdo::Message answer);
  void download_acknowledged(sdo::Message answer);
  void send_segments();
  bool can_send() const;
  void send_segment();
  Result<std::span<const std::uint8_t>> fetch(std::span<std::uint8_t> memory);
  void go_back(std::uint32_t block);

  void receive_message(sdo::Message answer);
  void aborted_by_server(sdo::Message answer);
  bool in(Phase phase) const;
  void ask(Phase phase, sdo::Message message);
  void go_on(Phase phase);

  SdoClient& client_;
  SdoClient::Extension extension_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  std::span<std::uint8_t> buffer_;
  std::uint8_t block_size_;
  Phase phase_ = Phase::upload_initiated;
  bool prodded_ = false;           ///< half of the time-out is over
  bool may_be_over_ = false;       ///< the last answer is the end, or a copy of the last segment
  sdo::Message last_{0};           ///< last message taken, except plain segments
  std::uint32_t block_begin_ = 0;  ///< offset of the data at the beginning of the buffer
  SdoBlockReceiver receiver_;
  SdoBlockSender sender_;
  std::bitset<node_id_max + 1> refused_;  ///< servers without block transfers
};

}  // namespace canvoy
