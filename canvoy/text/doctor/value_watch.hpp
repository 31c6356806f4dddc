// Reserved values, values that report a fault, and frames that violate the protocol, by the marks
// of the decoder.
//
//     ValueWatch values;
//     values.hear(time, decoder.decode(frame));
#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <tuple>

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

/// Observation on one entry of a node.
struct HeardValue {
  std::string_view name = {};     ///< of the object
  decoder::Mark mark = {};        ///< kind of deviation
  std::string_view meaning = {};  ///< name of a sentinel value
  Tally tally = {};               ///< occurrences
};

class ValueWatch {
 public:
  /// Takes the decoded content of one frame; ignores a PDO of a wrong length.
  void hear(Time at, const decoder::Decoded& decoded);

  /// By node, index and sub-index.
  using ByEntry = std::map<std::tuple<NodeId, std::uint16_t, std::uint8_t>, HeardValue>;
  /// Values that are reserved or out of range: of the first 1024 entries.
  const ByEntry& wrong() const { return wrong_; }
  /// Values that report a fault, such as of a sensor.
  const ByEntry& failed() const { return failed_; }
  /// Violations by messages instead of values, by node and mark.
  const std::map<std::pair<NodeId, decoder::Mark>, Tally>& messages() const { return messages_; }

 private:
  void hear_value(Time at, NodeId node, const decoder::DecodedValue& value);
  static HeardValue* place(ByEntry& entries, NodeId node, const decoder::DecodedValue& value);

  ByEntry wrong_;
  ByEntry failed_;
  std::map<std::pair<NodeId, decoder::Mark>, Tally> messages_;
};

}  // namespace canvoy::text
