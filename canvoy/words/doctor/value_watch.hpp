// Values that nobody may send, those that say that something is broken, and frames that are against
// the protocol, as the decoder marks them.
//
//     ValueWatch values;
//     values.hear(time, decoder.decode(frame));
#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <tuple>

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/words/doctor/tally.hpp"

namespace canvoy::words {

/// What was heard of one entry of a node.
struct HeardValue {
  std::string_view name = {};     ///< of the object
  decoder::Mark mark = {};        ///< of what is wrong
  std::string_view meaning = {};  ///< of a sentinel, its name
  Tally tally = {};               ///< when it was seen
};

class ValueWatch {
 public:
  /// What the decoder says of one frame; a PDO of a wrong length is passed over.
  void hear(Time at, const decoder::Decoded& decoded);

  /// By node, index and sub-index. Reserved, or out of range.
  using ByEntry = std::map<std::tuple<NodeId, std::uint16_t, std::uint8_t>, HeardValue>;
  /// Values that are reserved or out of range: of the first 1024 entries.
  const ByEntry& wrong() const { return wrong_; }
  /// They say that a sensor or the like is broken.
  const ByEntry& failed() const { return failed_; }
  /// By node and mark: what is wrong with messages, not with values.
  const std::map<std::pair<NodeId, decoder::Mark>, Tally>& messages() const { return messages_; }

 private:
  void hear_value(Time at, NodeId node, const decoder::DecodedValue& value);
  static HeardValue* place(ByEntry& entries, NodeId node, const decoder::DecodedValue& value);

  ByEntry wrong_;
  ByEntry failed_;
  std::map<std::pair<NodeId, decoder::Mark>, Tally> messages_;
};

}  // namespace canvoy::words
