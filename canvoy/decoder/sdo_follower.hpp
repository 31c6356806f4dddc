// Puts the messages of one SDO channel together into transfers (CiA 301, 7.2.4): expedited,
// segmented and block, both ways. It only listens, and may begin in the middle. What is against the
// protocol is marked, and then taken as it came.
//
//     SdoFollower channel;
//     const SdoStep step = channel.response(frame);
//     if (step.done != nullptr) show(step.done->index, step.done->bytes);
//
// A transfer with a device on a bus behind the server (canopen/remote/remote_access.hpp) is
// followed as well, where it is indicated by the number that is usual here. It tells nothing of the
// server.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/dictionary/abort_code.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/decoder/mark.hpp"

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

/// What a message of SDO is, of which the segments of blocks look like others.
enum class SdoMessage : std::uint8_t {
  unknown,
  abort,
  // Of the client:
  read,
  write,
  read_segment,
  write_segment,
  block_upload,
  block_upload_start,
  block_upload_got,
  block_upload_done,
  block_download,
  block_download_end,
  // Of the server:
  value,
  written,
  segment,
  segment_written,
  block_upload_ready,
  block_upload_end,
  block_download_ready,
  block_download_got,
  block_download_done,
  // Of either:
  block_segment,
  indication,  ///< the next transfer is with a device behind the server
};

/// A device on a bus behind a server.
struct SdoBehind {
  std::uint16_t network = 0;
  NodeId node = 0;  ///< 0: it is the server itself
};

/// A message, and the transfer with the server that it ends well, or null; until the next message.
struct SdoStep {
  SdoMessage message = SdoMessage::unknown;
  const SdoTransfer* done = nullptr;
  Marks marks = {};
  SdoBehind behind = {};  ///< whom the transfer is with, or is to be
  /// What the message names, or the transfer that it belongs to; nothing: that was not heard.
  std::optional<sdo::Multiplexer> entry = {};
};

class SdoFollower {
 public:
  /// What is kept of a long domain.
  static constexpr std::size_t bytes_max = 4096;
  /// Of so many requests that were overtaken by another one, late answers are no surprise.
  static constexpr unsigned overtaken_max = 8;

  /// Takes a message of eight bytes from the client, or from the server.
  SdoStep request(const Frame& frame);
  SdoStep response(const Frame& frame);
  /// The server has started anew: of what was transferred it knows nothing any more.
  void server_starts();

 private:
  enum class Phase : std::uint8_t { idle, asked, segments, block, block_end };

  SdoStep take_request(const sdo::Message& message);
  SdoStep take_response(const sdo::Message& message);
  void begin(bool is_write, SdoTransfer::Kind kind, sdo::Multiplexer multiplexer);
  const SdoTransfer* finish();
  SdoStep abort(const sdo::Message& message);
  std::optional<sdo::Multiplexer> transfer_entry() const;
  SdoBehind behind(SdoMessage kind, const sdo::Message& message) const;
  void take(std::span<const std::uint8_t> bytes);
  void initiate(const sdo::Message& message);
  SdoStep initiate_upload(const sdo::Message& message);
  SdoStep initiate_download_response(const sdo::Message& message);

  void take_segment(const sdo::Message& message);
  SdoStep download_segment(const sdo::Message& message);
  SdoStep download_segment_response(const sdo::Message& message);
  SdoStep upload_segment(const sdo::Message& message);
  SdoStep upload_segment_response(const sdo::Message& message);

  SdoStep take_block_segment(const sdo::Message& message);
  void acknowledge_block(const sdo::Message& message);
  void end_block(const sdo::Message& message);
  void check_checksum(const sdo::Message& message);
  void set_block_size(unsigned segments);
  void start_block_upload();
  SdoStep block_upload_request(const sdo::Message& message);
  SdoStep block_upload_response(const sdo::Message& message);
  SdoStep block_download_request(const sdo::Message& message);
  SdoStep block_download_response(const sdo::Message& message);

  /// Marks a message that nothing calls for. Who began to listen in the middle, or hears one side
  /// only, does not know.
  void expect(bool is_in_place);
  void expect_zero(const sdo::Message& message, unsigned reserved_bits);
  void expect_toggle(const sdo::Message& message);
  void expect_size(bool is_all);

  bool is_in(Phase phase, bool is_write) const {
    return phase_ == phase && transfer_.is_write == is_write;
  }
  bool is_asked(bool is_write, SdoTransfer::Kind kind) const {
    return is_in(Phase::asked, is_write) && transfer_.kind == kind;
  }
  bool is_of(const sdo::Message& message) const {
    return message.multiplexer() == sdo::Multiplexer(transfer_.index, transfer_.sub);
  }

  SdoTransfer transfer_;
  SdoBehind behind_;  ///< of the transfer
  SdoBehind next_;    ///< of that to come: it was confirmed
  Phase phase_ = Phase::idle;
  bool is_known_ = false;  ///< what is under way, or that nothing is
  bool hears_client_ = false;
  bool hears_server_ = false;
  bool is_answer_due_ = false;  ///< the client has spoken last
  bool is_named_ = false;       ///< its beginning was heard
  bool last_ = false;           ///< the segment that ends it was there
  bool has_crc_ = false;        ///< both sides can do checksums
  std::uint8_t toggle_ = 0;     ///< of the segment that is to come, or is to be answered
  std::uint8_t sequence_ = 0;   ///< of the last segment of this block that came in order
  std::uint8_t block_size_ = 0;
  /// Requests that came before the one before them was answered, as those of a client with a short
  /// time-out: each of them may still be.
  unsigned overtaken_ = 0;
  std::optional<std::uint32_t> announced_;  ///< how many bytes it is to have
  Marks marks_;                             ///< of this message
};

}  // namespace canvoy::decoder
