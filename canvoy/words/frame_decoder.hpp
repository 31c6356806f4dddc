// What a frame on one CANopen bus is, in words: its service, the node, and what it says.
//
//     FrameDecoder decoder;
//     const FrameWords& words = decoder.decode(frame);
//     words.service;  // "SDO response"
//     words.text;     // "6010h:00h battery_temperature = 21.5 °C"
//
// It knows the pre-defined connection set (CiA 301, 7.3.3), what CiA 302, 305 and 447 add to it,
// and what the profiles say of objects. It remembers what the frames before have begun: transfers,
// LSS, and node guarding.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/words/pdo_words.hpp"
#include "canvoy/words/sdo_words.hpp"

namespace canvoy::words {

/// Until the next frame.
struct FrameWords {
  /// `NMT`, `SYNC`, `EMCY`, `TIME`, `TPDO1`, `SDO request`, `heartbeat`, `LSS` ...
  std::string_view service = {};
  NodeId node = 0;             ///< 0: none, or all
  std::string_view text = {};  ///< what it says; empty where the service says it all
  NodeId client = 0;           ///< of SDO, where it is known who asks
  bool is_answer = false;      ///< of SDO: from the server
  bool is_middle = false;      ///< of an SDO transfer that goes on
  bool is_end = false;         ///< of an SDO transfer: FrameDecoder::transfer_text() tells it
  std::string_view news = {};  ///< what is known of a node since this frame
  std::span<const decoder::DecodedValue> values = {};  ///< of objects
  /// Of SDO: the entry that it is about, without a value; null: that was not heard.
  const decoder::DecodedValue* about = nullptr;
  decoder::Marks marks = {};
  /// Of a PDO: room for what is made of `text` and `values`; it is empty where they have changed.
  std::string* kept = nullptr;
};

class FrameDecoder {
 public:
  /// What was said before, which is the same on each bus.
  struct Said {
    ValueWords pdo_values;
    SdoWords sdos;
  };
  FrameDecoder() : FrameDecoder(std::make_shared<Said>()) {}
  /// Decoders of several buses may share it.
  explicit FrameDecoder(std::shared_ptr<Said> said) : said_(std::move(said)) {}
  FrameDecoder(const FrameDecoder&) = delete;
  FrameDecoder& operator=(const FrameDecoder&) = delete;

  const FrameWords& decode(const Frame& frame);
  /// The whole of the SDO transfer that the last frame has ended.
  std::string_view transfer_text();

  /// What is known of the nodes: given here, or learned.
  decoder::Network& network() { return objects_.network(); }

 private:
  using Decoded = decoder::Decoded;

  void decode_pdo(const Frame& frame, const Decoded& decoded);
  void decode_sdo(const Frame& frame, const Decoded& decoded);
  void decode_other(const Frame& frame, const Decoded& decoded);
  bool decode_of_car(const Frame& frame);
  void decode_nmt(const Frame& frame);
  void decode_sync(const Frame& frame);
  void decode_time(const Frame& frame);
  void decode_emergency(const Frame& frame);
  void decode_lss(const Frame& frame, const Decoded& decoded);
  void decode_error_control(const Frame& frame);
  void decode_toggle(unsigned answer);
  void say_transfer(const decoder::SdoTransfer& transfer);
  void add_news(const decoder::NodeNews& news);
  void say(std::string text);
  void say_malformed(const Frame& frame);

  decoder::Decoder objects_;
  std::shared_ptr<Said> said_;
  PdoWords pdos_{said_->pdo_values};
  std::bitset<node_id_max + 1> asked_;  ///< nodes to which a guarding request went last
  /// Of each node, the toggle bit that its next answer to a guarding request has.
  std::array<std::optional<bool>, node_id_max + 1> toggles_;
  FrameWords words_;
  std::string text_;
  const decoder::SdoTransfer* transfer_ = nullptr;  ///< that the last frame has ended
  std::string transfer_text_;
  std::string news_;
};

}  // namespace canvoy::words
