// SDO block transfers for a client: up to 127 segments are acknowledged at once, and a checksum
// tells whether all is well (CiA 301, 7.2.4.3.9 to 7.2.4.3.15).
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

/// Which transfers go in blocks is the client's choice (SdoClient::choose). Where it chooses
/// itself, those do that are longer than a few segments, or of unknown length; and a server that
/// refuses is asked again without blocks, and in segments from then on.
///
/// A copy of the answer that was taken last is no answer, whatever it looks like.
///
/// Data goes out as fast as the controller takes frames, and not more than one waits in the node.
class SdoBlockClient {
 public:
  /// The data of one block of 127 segments.
  static constexpr std::size_t buffer_size = sdo::block_size_max * sdo::segment_max;
  /// Values of up to so many bytes go in segments, unless blocks are asked for.
  static constexpr std::size_t segmented_max = 63;

  /// What a Supply gave is kept in `buffer` until the server has it. With less than buffer_size
  /// bytes there, only downloads from memory go in blocks. Uploads are asked for in blocks of
  /// `block_size` segments, 1 to 127. `client` and `buffer` must outlive this,
  /// and `client` is not used without it any more.
  explicit SdoBlockClient(SdoClient& client, std::span<std::uint8_t> buffer = {},
                          std::uint8_t block_size = sdo::block_size_max);
  SdoBlockClient(const SdoBlockClient&) = delete;
  SdoBlockClient& operator=(const SdoBlockClient&) = delete;

 private:
  /// What is waited for.
  enum class Phase : std::uint8_t {
    upload_initiated,
    upload_segments,
    upload_end,
    download_initiated,
    download_acknowledgement,  ///< and segments are sent until then
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
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  std::span<std::uint8_t> buffer_;
  std::uint8_t block_size_;
  Phase phase_ = Phase::upload_initiated;
  bool prodded_ = false;           ///< half of the time-out has gone by
  bool may_be_over_ = false;       ///< the last answer is the end, or a copy of the last segment
  sdo::Message last_{0};           ///< that was taken, but for plain segments
  std::uint32_t block_begin_ = 0;  ///< offset of what is at the beginning of the buffer
  SdoBlockReceiver receiver_;
  SdoBlockSender sender_;
  std::bitset<node_id_max + 1> refused_;  ///< servers that know no block transfers
};

}  // namespace canvoy
