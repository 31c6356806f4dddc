// Puts the messages of one SDO channel together into transfers (CiA 301, 7.2.4): expedited,
// segmented and block, both ways. It only listens, and may begin in the middle.
//
//     SdoFollower channel;
//     if (const SdoTransfer* done = channel.response(frame)) show(done->index, done->bytes);
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/abort_code.hpp"
#include "canvoy/canopen/sdo.hpp"

namespace canvoy::decoder {

/// One that has come to its end.
struct SdoTransfer {
  enum class Kind : std::uint8_t { expedited, segmented, block };
  bool is_write = false;
  Kind kind = Kind::expedited;
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::vector<std::uint8_t> bytes;  ///< the first of them, where there were more
  std::size_t size = 0;             ///< of all bytes
};

class SdoFollower {
 public:
  /// What is kept of a long domain.
  static constexpr std::size_t bytes_max = 4096;

  /// Takes a message of eight bytes from the client, or from the server. Returns the transfer that
  /// it ends well, until the next message; or null.
  const SdoTransfer* request(const Frame& frame);
  const SdoTransfer* response(const Frame& frame);

 private:
  enum class Phase : std::uint8_t { idle, asked, segments, block, block_end };

  void begin(bool is_write, SdoTransfer::Kind kind, sdo::Multiplexer multiplexer);
  const SdoTransfer* finish();
  void take(std::span<const std::uint8_t> bytes);
  void take_segment(const sdo::Message& message);
  void take_block_segment(const sdo::Message& message);
  void acknowledge_block(const sdo::Message& message);
  void end_block(const sdo::Message& message);
  void initiate_download(const sdo::Message& message);
  const SdoTransfer* initiate_upload(const sdo::Message& message);
  const SdoTransfer* block_upload_request(const sdo::Message& message);
  void block_download_request(const sdo::Message& message);
  const SdoTransfer* block_download_response(const sdo::Message& message);

  bool is_in(Phase phase, bool is_write) const {
    return phase_ == phase && transfer_.is_write == is_write;
  }

  SdoTransfer transfer_;
  Phase phase_ = Phase::idle;
  bool last_ = false;          ///< the segment that ends it was there
  std::uint8_t sequence_ = 0;  ///< of the last segment of this block that came in order
};

}  // namespace canvoy::decoder
