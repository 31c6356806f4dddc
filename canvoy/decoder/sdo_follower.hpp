// Assembles the messages of one SDO channel into transfers: expedited, segmented and block, in both
// directions (CiA 301, 7.2.4). It only listens, and may start in the middle of a transfer.
// Violations of the protocol are marked, and the message is then taken as it is.
//
//     SdoFollower channel;
//     const SdoStep step = channel.response(frame);
//     if (step.done != nullptr) show(step.done->index, step.done->bytes);
//
// A transfer with a device on a bus behind the server (canopen/remote/remote_access.hpp) is
// followed as well, if it is indicated by the number that is usual here. Such a transfer is not
// attributed to the server.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/decoder/mark.hpp"

namespace canvoy::decoder {

/// A completed transfer.
struct SdoTransfer {
  /// How the bytes were transferred.
  enum class Kind : std::uint8_t { expedited, segmented, block };
  bool is_write = false;            ///< download: from the client to the server
  Kind kind = Kind::expedited;      ///< see Kind
  std::uint16_t index = 0;          ///< of the object
  std::uint8_t sub = 0;             ///< sub-index
  std::vector<std::uint8_t> bytes;  ///< the first bytes, if there are more
  std::size_t size = 0;             ///< number of all bytes
};

/// Kind of an SDO message; segments of blocks look like other messages.
enum class SdoMessage : std::uint8_t {
  unknown,
  abort,
  // From the client:
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
  // From the server:
  value,
  written,
  segment,
  segment_written,
  block_upload_ready,
  block_upload_end,
  block_download_ready,
  block_download_got,
  block_download_done,
  // From either side:
  block_segment,
  indication,  ///< the next transfer is with a device behind the server
};

/// A device on a bus behind a server.
struct SdoBehind {
  std::uint16_t network = 0;  ///< number of the bus behind the server
  NodeId node = 0;            ///< 0: the server itself
};

/// Result of a message: the transfer with the server that it completes, or null. Valid until the
/// next message.
struct SdoStep {
  SdoMessage message = SdoMessage::unknown;  ///< what the message is
  const SdoTransfer* done = nullptr;  ///< null: the transfer goes on, or is with a device behind
  Marks marks = {};                   ///< violations in this message
  SdoBehind behind = {};              ///< peer of the current or the next transfer
  /// The entry that the message names, or that of its transfer; nothing: its start was not heard.
  std::optional<sdo::Multiplexer> entry = {};
};

class SdoFollower {
 public:
  /// Number of bytes kept of a long domain.
  static constexpr std::size_t bytes_max = 4096;
  /// Number of overtaken requests that may still be answered late.
  static constexpr unsigned overtaken_max = 8;

  /// Takes a message of eight bytes from the client (request) or the server (response).
  SdoStep request(const Frame& frame);
  /// Takes a message of eight bytes from the server.
  SdoStep response(const Frame& frame);
  /// The server has restarted: its transfers are void.
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

  /// Marks a message that no other message calls for. Not marked where listening started in the
  /// middle, or where only one side is heard.
  void expect(bool is_in_place);
  /// True if a message is the last one again: an error at the end of a frame makes its sender
  /// repeat what was received (ISO 11898-1).
  bool is_repeated(const sdo::Message& message) const { return heard_ == message; }
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
  SdoBehind behind_;  ///< of the current transfer
  SdoBehind next_;    ///< of the next transfer; it was confirmed
  Phase phase_ = Phase::idle;
  bool is_known_ = false;  ///< the state of the channel is known, idle or not
  bool hears_client_ = false;
  bool hears_server_ = false;
  bool is_answer_due_ = false;  ///< the client has sent the last message
  bool is_named_ = false;       ///< the start of the transfer was heard
  bool last_ = false;           ///< the last segment was heard
  bool has_crc_ = false;        ///< both sides support checksums
  std::uint8_t toggle_ = 0;     ///< of the segment that is expected or unanswered
  std::uint8_t sequence_ = 0;   ///< of the last segment of this block that arrived in order
  std::uint8_t block_size_ = 0;
  /// Number of requests sent before the previous one was answered, as by a client with a short
  /// time-out. Each of them may still be answered.
  unsigned overtaken_ = 0;
  std::optional<sdo::Message> heard_;       ///< the last message of either side
  std::optional<std::uint32_t> announced_;  ///< announced number of bytes
  Marks marks_;                             ///< of this message
};

}  // namespace canvoy::decoder
