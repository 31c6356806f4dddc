// SDO client: reads and writes the object dictionaries of other nodes, expedited and in segments
// (CiA 301, 7.2.4). It does not block: a callback tells the outcome. For block transfers see
// SdoBlockClient, for requests that queue SdoQueue.
//
//     SdoClient client(node);
//     AbortCode started = client.upload(5, 0x1000, 0, bytes,
//                                       SdoClient::Done::to<&Charger::device_type_came>(*this));
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/canopen/sdo/sdo_channel.hpp"
#include "canvoy/canopen/sdo/sdo_outcome.hpp"
#include "canvoy/canopen/sdo/sdo_watchdog.hpp"

namespace canvoy {

/// How a value travels that does not fit into one frame.
enum class SdoTransfer : std::uint8_t {
  automatic,  ///< as its size and the server ask for
  segmented,
  block,  ///< or not at all
};

/// It makes one request at a time; a node may have many clients. It works in NMT states
/// pre-operational and operational, and in a node without node-ID that only asks others.
///
/// Time is that of the node: from outside of its callbacks, call node.advance(now) before a
/// request. Each request that was started ends with one call of `done`, from where a new one may be
/// started at once: done, aborted by the server, without an answer, aborted here (toggle_bit,
/// command_specifier, length_too_high, length_too_low, out_of_memory where the destination is too
/// short), or cancelled (device_state where NMT ended it; no_sdo_connection where the channel was
/// changed).
/// Spans and objects that are handed in must live until then. A sink or supply may cancel its own
/// request.
class SdoClient {
 public:
  using Outcome = SdoOutcome;
  using Done = Callback<void(Outcome)>;
  /// Takes the next bytes of an upload, 1 to 7 of them; an abort code ends the transfer.
  using Sink = Callback<AbortCode(std::span<const std::uint8_t> bytes)>;
  /// Fills in the next bytes of a download, and says how many there are: fewer than asked for, and
  /// they are the last.
  using Supply = Callback<Result<std::size_t>(std::span<std::uint8_t> bytes)>;

  static constexpr Duration default_time_out = 1s;

  /// With `number` 0 to 127, and where the dictionary has object 1280h + number, it talks on the
  /// channel that this object describes, to the node that is named there. Otherwise on the default
  /// channel of each server, 600h and 580h + node-ID.
  explicit SdoClient(Node& node, std::optional<std::uint8_t> number = std::nullopt);
  SdoClient(const SdoClient&) = delete;
  SdoClient& operator=(const SdoClient&) = delete;

  /// From the next request on, as if made with `number`. Not while one is under way.
  void choose_channel(std::uint8_t number);
  /// For requests to come. Without a SdoBlockClient, automatic is segmented.
  void choose(SdoTransfer transfer) { transfer_ = transfer; }

  /// These answer none where the request was started. Otherwise `done` is not called, and they say
  /// why: device_state (a request is under way, or the NMT state forbids it), no_sdo_connection (no
  /// such node-ID, or the channel is not valid or to another node), out_of_memory (the node has no
  /// route left), unsupported_access (blocks were chosen, and there is nobody for them here).
  /// `time_out` is how long each single answer may take.
  AbortCode upload(NodeId server, std::uint16_t index, std::uint8_t sub,
                   std::span<std::uint8_t> destination, Done done,
                   Duration time_out = default_time_out);
  AbortCode upload(NodeId server, std::uint16_t index, std::uint8_t sub, Sink sink, Done done,
                   Duration time_out = default_time_out);
  AbortCode download(NodeId server, std::uint16_t index, std::uint8_t sub,
                     std::span<const std::uint8_t> value, Done done,
                     Duration time_out = default_time_out);
  /// `size` is announced to the server where it is known.
  AbortCode download(NodeId server, std::uint16_t index, std::uint8_t sub, Supply supply,
                     std::optional<std::uint32_t> size, Done done,
                     Duration time_out = default_time_out);

  /// Ends the request that is under way, if there is one: `reason` is sent to the server, and
  /// `done` is not called.
  void cancel(AbortCode reason = AbortCode::general);

  bool busy() const { return state_ != State::idle; }
  /// Whether the node's NMT state lets it ask: else a request, also the one that is under way, ends
  /// with device_state. A node without a node-ID, that of a tool, always may.
  bool may_speak() const;
  /// Of the present or last transfer: bytes until now, and in all where that is known.
  std::size_t transferred() const { return transferred_; }
  std::optional<std::uint32_t> announced() const { return announced_; }

 private:
  friend class SdoBlockClient;
  friend class SdoQueue;

  /// Who makes block transfers: a table, so that nothing of it is linked where there is none.
  struct Extension {
    /// Whether the transfer was begun in blocks.
    Callback<bool()> initiate_upload;
    Callback<bool()> initiate_download;
    /// Each answer while a block transfer is under way.
    Callback<void(const Frame&)> receive;
    /// A time-out: whether it is not the last one.
    Callback<bool()> expired;
  };

  /// What is waited for.
  enum class State : std::uint8_t {
    idle,
    upload_initiated,
    upload_segment,
    download_initiated,
    download_segment,
    block,   ///< what the extension waits for
    ending,  ///< while its last message is handed over
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
  /// Where a full segment that is not the last one is to be put, with a byte to spare behind it;
  /// null where there is no such room in memory.
  std::uint8_t* room_for_segment() {
    if (transferred_ + sdo::segment_max >= in_memory_) return nullptr;
    return destination_.data() + std::exchange(transferred_, transferred_ + sdo::segment_max);
  }
  void download_initiated(sdo::Message answer);
  void send_segment();
  [[gnu::noinline]] void give_segment();
  Result<std::span<const std::uint8_t>> give(std::span<std::uint8_t> memory);
  /// Of a value in memory: the next seven bytes, where more than those are left.
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
  std::uint16_t parameter_ = 0;     ///< index of the object that describes the channel, 0 without
  SdoChannel channel_;              ///< that we listen to
  unsigned connected_to_ = nobody;  ///< who is at its other end, where that need not be found out
  State state_ = State::idle;
  SdoTransfer transfer_ = SdoTransfer::automatic;
  std::uint8_t ended_ = 0;        ///< counts ends: a sink or supply may bring about that of its own
  std::uint8_t toggle_ = 0;       ///< of the segment that is waited for
  bool nothing_follows_ = false;  ///< all of a download is on its way
  sdo::Multiplexer multiplexer_;  ///< of the present request
  Duration time_out_{};
  Done done_;

  std::size_t transferred_ = 0;
  std::optional<std::uint32_t> announced_;
  std::size_t in_memory_ = 0;  ///< bytes for which there is room in `destination_`, or are `value_`
  std::span<std::uint8_t> destination_;
  std::span<const std::uint8_t> value_;
  Sink sink_;
  Supply supply_;

  const Extension* extension_ = nullptr;
  SdoWatchdog watchdog_;
  static const ServiceCalls service_calls;
  static const HookCalls hook_calls;
  ServiceLink service_{&service_calls, this};
};

}  // namespace canvoy
