// Describes a frame on one CANopen bus: its service, its node, and its content.
//
//     FrameDecoder decoder;
//     const FrameWords& words = decoder.decode(frame);
//     words.service;  // "SDO response"
//     words.text;     // "6010h:00h battery_temperature = 21.5 °C"
//
// Covers the pre-defined connection set (CiA 301, 7.3.3), the additions of CiA 302, 305 and 447,
// and the objects of the profiles. It follows the state of earlier frames: transfers, LSS, and node
// guarding.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/decoder/by_can_id.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/text/sdo_words.hpp"
#include "canvoy/text/service_marks.hpp"
#include "canvoy/text/value_words.hpp"

namespace canvoy::text {

/// Text of PDOs. Most frames of a bus are PDOs, and most of their values repeat: texts of values
/// are cached, for a rate of millions of frames per second.
///
///     PdoWords words(values);
///     words.text(frame.id, decoded, network.generation());  // "temperature = 20.000 °C; ..."
class PdoWords {
 public:
  /// `values` must outlive this; several buses may share it.
  explicit PdoWords(ValueWords& values) : values_(&values) {}

  /// Words for a PDO.
  struct Words {
    std::string_view service;  ///< `TPDO1`, or `PDO` if the number is unknown
    std::string_view text;     ///< its values, or why there are none
    /// Buffer for text that the caller makes of the text and the values; emptied when they change.
    std::string* kept = nullptr;
  };
  /// Returns the text, valid until the next PDO. `generation` is that of the network.
  Words words(std::uint32_t can_id, const decoder::Decoded& decoded, std::uint32_t generation);

 private:
  struct Value {
    std::uint64_t version = 0;  ///< DecodedValue::version of the text; 0: none
    std::string name;           ///< `temperature = `
    std::string text;           ///< `20.000 °C`
  };
  struct Pdo {
    std::uint32_t generation = 0;  ///< of the network, when the names were made; 0: never
    std::size_t count = 0;         ///< number of values in `text`
    std::string service;
    std::string start;  ///< `driver: ` if the message has a name
    std::string text;
    std::string kept;
    std::vector<Value> values;
  };

  static void name(Pdo& pdo, const decoder::PdoPlan& plan);
  bool take_values(Pdo& pdo, std::span<const decoder::DecodedValue> values);

  decoder::ByCanId<Pdo> pdos_;
  ValueWords* values_;
};

/// Description of a frame; valid until the next frame.
struct FrameWords {
  /// `NMT`, `SYNC`, `EMCY`, `TIME`, `TPDO1`, `SDO request`, `heartbeat`, `LSS` ...
  std::string_view service = {};
  NodeId node = 0;             ///< 0: none, or all nodes
  std::string_view text = {};  ///< content; empty if the service says it all
  NodeId client = 0;           ///< of SDO, if the client is known
  bool is_answer = false;      ///< of SDO: from the server
  bool is_middle = false;      ///< of an SDO transfer that continues
  bool is_end = false;         ///< of an SDO transfer that FrameDecoder::transfer_text() describes
  bool is_unknown_pdo =
      false;  ///< a CAN-ID of PDOs (180h to 57Fh), and nothing says what it carries
  std::string_view news = {};                          ///< what this frame reveals about a node
  std::span<const decoder::DecodedValue> values = {};  ///< values of objects
  /// For SDO: the entry, without a value; null: unknown, since its start was not heard.
  const decoder::DecodedValue* about = nullptr;
  decoder::Marks marks = {};  ///< violations in the frame
  /// For a PDO: a buffer for text that the caller makes of `text` and `values`; emptied when they
  /// change.
  std::string* kept = nullptr;
};

class FrameDecoder {
 public:
  /// Texts that are kept, equal for all buses.
  struct Said {
    ValueWords pdo_values;  ///< of PDOs
    SdoWords sdos;          ///< of SDO transfers
  };
  FrameDecoder() : FrameDecoder(std::make_shared<Said>()) {}
  /// Decoders of several buses may share `said`.
  explicit FrameDecoder(std::shared_ptr<Said> said) : said_(std::move(said)) {}
  FrameDecoder(const FrameDecoder&) = delete;
  FrameDecoder& operator=(const FrameDecoder&) = delete;

  /// Describes the next frame of the bus.
  const FrameWords& decode(const Frame& frame);
  /// Text of the SDO transfer that the last frame has completed.
  std::string_view transfer_text();

  /// Properties of the nodes, given or learned.
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
  void say_transfer(const decoder::SdoTransfer& transfer);
  void add_news(const decoder::NodeNews& news);
  void say(std::string text);
  void say_malformed(const Frame& frame);

  decoder::Decoder objects_;
  std::shared_ptr<Said> said_;
  PdoWords pdos_{said_->pdo_values};
  ServiceMarks services_;
  FrameWords words_;
  std::string text_;
  const decoder::SdoTransfer* transfer_ = nullptr;  ///< completed by the last frame
  std::string transfer_text_;
  std::string news_;
};

}  // namespace canvoy::text
