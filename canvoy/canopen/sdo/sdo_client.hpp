// SDO client: reads and writes the object dictionaries of other nodes, with expedited and segmented
// transfers, without blocking; a callback reports the outcome (CiA 301, 7.2.4). For block transfers
// see SdoBlockClient, for queued requests SdoQueue.
//
//     SdoClient client(node);
//     AbortCode started = client.upload(5, 0x1000, 0, bytes,
//                                       SdoClient::Done::to<&Charger::device_type_came>(*this));
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/canopen/sdo/sdo_channel.hpp"
#include "canvoy/canopen/sdo/sdo_outcome.hpp"
#include "canvoy/canopen/sdo/sdo_watchdog.hpp"

namespace canvoy {

/// Transfer of a value that does not fit into one frame.
enum class SdoTransfer : std::uint8_t {
  automatic,  ///< as the size and the server require
  segmented,
  block,  ///< block transfer only
};

/// A client. It makes one request at a time; a node may have many clients. It works in NMT states
/// pre-operational and operational, and in a node without node-ID that only acts as a client.
///
/// Time is that of the node: outside of its callbacks, call node.advance(now) before a request.
/// Each request that was started ends with one call of `done`, which may start a new one: done,
/// aborted by the server, without an answer, aborted by the client (toggle_bit, command_specifier,
/// length_too_high, length_too_low, out_of_memory if the destination is too short), or cancelled
/// (device_state if NMT ended it; no_sdo_connection if the channel changed). Spans and objects that
/// are passed must live until then. A sink or supply may cancel its own request.
class SdoClient {
 public:
  /// How a request ended, and how many bytes it has transferred.
  using Outcome = SdoOutcome;
  /// Called once, at the end of a request that was started.
  using Done = Callback<void(Outcome)>;
  /// Takes the next bytes of an upload, 1 to 7 of them; an abort code ends the transfer.
  using Sink = Callback<AbortCode(std::span<const std::uint8_t> bytes)>;
  /// Fills in the next bytes of a download, and returns their number: fewer than requested mark the
  /// end.
  using Supply = Callback<Result<std::size_t>(std::span<std::uint8_t> bytes)>;

  static constexpr Duration default_time_out = 1s;  ///< for each single answer

  /// Makes a client. With `number` 0 to 127, and if the dictionary has object 1280h + number, it
  /// uses the channel in this object, to the node that is named there. Otherwise it uses the
  /// default channel of each server, 600h and 580h + node-ID.
  explicit SdoClient(Node& node, std::optional<std::uint8_t> number = std::nullopt);
  SdoClient(const SdoClient&) = delete;
  SdoClient& operator=(const SdoClient&) = delete;

  /// Changes the channel from the next request on, as if made with `number`. Not during a request.
  void choose_channel(std::uint8_t number);
  /// Selects the transfer of later requests. Without a SdoBlockClient, automatic is segmented.
  void choose(SdoTransfer transfer) { transfer_ = transfer; }

  /// Starts a request. Returns none if it was started; otherwise `done` is not called, and the
  /// result is the reason: device_state (a request is under way, or the NMT state forbids it),
  /// no_sdo_connection (no such node-ID, or the channel is not valid or to another node),
  /// out_of_memory (the node has no free route), unsupported_access (blocks were chosen without an
  /// extension for them). `time_out` limits each single answer.
  AbortCode upload(NodeId server, std::uint16_t index, std::uint8_t sub,
                   std::span<std::uint8_t> destination, Done done,
                   Duration time_out = default_time_out);
  /// Like the above, but without a limit of the size: `sink` takes the bytes as they come, in
  /// order.
  AbortCode upload(NodeId server, std::uint16_t index, std::uint8_t sub, Sink sink, Done done,
                   Duration time_out = default_time_out);
  /// Starts a download of a whole value, expedited if it has 1 to 4 bytes. `value` must live until
  /// `done`.
  AbortCode download(NodeId server, std::uint16_t index, std::uint8_t sub,
                     std::span<const std::uint8_t> value, Done done,
                     Duration time_out = default_time_out);
  /// Starts a download; `size` is announced to the server if it is known.
  AbortCode download(NodeId server, std::uint16_t index, std::uint8_t sub, Supply supply,
                     std::optional<std::uint32_t> size, Done done,
                     Duration time_out = default_time_out);

  /// Ends the request that is under way, if there is one: `reason` is sent to the server, and
  /// `done` is not called.
  void cancel(AbortCode reason = AbortCode::general);

  /// True from the start of a request until its end.
  bool busy() const { return state_ != State::idle; }
  /// True if the node's NMT state allows requests; otherwise a request, also one that is under way,
  /// ends with device_state. A node without a node-ID, that of a tool, always may.
  bool may_speak() const;
  /// Bytes of the present or last transfer so far, and in all if known.
  std::size_t transferred() const { return transferred_; }
  /// Size in bytes of the present or last transfer, if either side has announced it.
  std::optional<std::uint32_t> announced() const { return announced_; }

 private:
  friend class SdoBlockClient;
  friend class SdoQueue;

  /// The extension for block transfers: a table, so that a program without one links none of it.
  struct Extension {
    /// Begins a transfer in blocks; false if it does not.
    Callback<bool()> initiate_upload;
    Callback<bool()> initiate_download;
    /// Takes each answer during a block transfer.
    Callback<void(const Frame&)> receive;
    /// Handles a time-out; false if it is the last one.
    Callback<bool()> expired;
  };

  /// The expected message.
  enum class State : std::uint8_t {
    idle,
    upload_initiated,
    upload_segment,
    download_initiated,
    download_segment,
    block,   ///< an answer for the extension
    ending,  ///< the last message is being handed over
  };

  void state_entered(NmtState state);
  AbortCode before_write(const Entry& entry, std::span<const std::uint8_t> value);
  void after_write(const Entry& entry, Source source);

  SdoChannel channel_to(NodeId server) const;
  AbortCode find_connection(NodeId server);
  AbortCode connect(NodeId server);
  void note(sdo::Multiplexer multiplexer, Done done, Duration time_out);
  AbortCode initiate_upload(NodeId server);
  AbortCode initiate_download(NodeId server);
  void begin_upload();
  void begin_download();

  void receive(const Frame& frame, Time now);
  void take_answer(const Frame& frame);
  void upload_initiated(sdo::Message answer);
  Outcome take_expedited(sdo::Message answer);
  void expect_bytes();
  void ask_for_segment();
  void upload_segment(sdo::Message answer);
  [[gnu::noinline]] void take_segment(sdo::Message answer);
  AbortCode take(std::span<const std::uint8_t> bytes);
  /// Memory for a full segment that is not the last one, with one more byte behind it; null if
  /// there is no such room in memory.
  std::uint8_t* room_for_segment() {
    if (transferred_ + sdo::segment_max >= in_memory_) return nullptr;
    return destination_.data() + std::exchange(transferred_, transferred_ + sdo::segment_max);
  }
  void download_initiated(sdo::Message answer);
  void send_segment();
  [[gnu::noinline]] void give_segment();
  Result<std::span<const std::uint8_t>> give(std::span<std::uint8_t> memory);
  /// Next seven bytes of a value in memory, if more than those are left.
  const std::uint8_t* next_full_segment() {
    if (transferred_ + sdo::segment_max >= in_memory_) return nullptr;
    return value_.data() + std::exchange(transferred_, transferred_ + sdo::segment_max);
  }
  void download_segment(sdo::Message answer);
  void aborted_by_server(sdo::Message answer);
  void unexpected();

  void give_up(Time now);
  void fail(AbortCode code) { end_with(code); }
  void end_with(SdoEnd end);
  void finish_with(sdo::Message last, Outcome outcome);
  void finish(Outcome outcome);
  void ask(sdo::Message message);
  void send(sdo::Message message) { node_.transmitter().send(message.frame(channel_.request)); }

  static constexpr unsigned nobody = 0x100;  ///< no NodeId

  Node& node_;
  std::uint16_t parameter_ = 0;     ///< index of the object that describes the channel, 0 if none
  SdoChannel channel_;              ///< that the client listens to
  unsigned connected_to_ = nobody;  ///< node at the other end, if known without a search
  State state_ = State::idle;
  SdoTransfer transfer_ = SdoTransfer::automatic;
  std::uint8_t ended_ = 0;        ///< counts ends: a sink or supply may end its own request
  std::uint8_t toggle_ = 0;       ///< of the expected segment
  bool nothing_follows_ = false;  ///< all data of a download is sent
  sdo::Multiplexer multiplexer_;  ///< of the present request
  Duration time_out_{};
  Done done_;

  std::size_t transferred_ = 0;
  std::optional<std::uint32_t> announced_;
  std::size_t in_memory_ = 0;  ///< bytes with room in `destination_`, or in `value_`
  std::span<std::uint8_t> destination_;
  std::span<const std::uint8_t> value_;
  Sink sink_;
  Supply supply_;

  const Extension* extension_ = nullptr;
  SdoWatchdog watchdog_;
  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
