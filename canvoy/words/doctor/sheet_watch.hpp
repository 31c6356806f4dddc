// Whether a device is what its data sheet says (EDS, DCF, XDD, XDC): by the entries that are read
// from it, or refused.
//
//     SheetWatch sheets;
//     sheets.add(5, sheet);
//     sheets.hear(time, frame, decoder.decode(frame));
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "canvoy/can/frame.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"
#include "canvoy/words/doctor/known_parameters.hpp"
#include "canvoy/words/doctor/tally.hpp"

namespace canvoy::words {

class SheetWatch {
 public:
  /// `sheet` has to outlive this.
  void add(NodeId node, const formats::DataSheet& sheet) { sheets_[node] = &sheet; }
  /// What the sheet says of communication, where nobody has told it otherwise.
  static void tell(NodeId node, const formats::DataSheet& sheet, KnownParameters& known);
  /// A frame, and what the decoder says of it: SDO answers of nodes that have a sheet are compared.
  void hear(Time at, const Frame& frame, const decoder::Decoded& decoded);

  /// One entry in which a device and its sheet differ.
  struct Difference {
    std::string text;  ///< in what it differs
    Tally tally;       ///< when it was seen
  };
  /// By node, index and sub-index.
  using Differences = std::map<std::tuple<NodeId, std::uint16_t, std::uint8_t>, Difference>;
  /// The first 1024 entries; empty: all that was read is as the sheets say.
  const Differences& differences() const { return differences_; }

 private:
  void compare(Time at, NodeId node, const formats::DataSheet& sheet,
               const decoder::SdoTransfer& transfer);
  void refused(Time at, NodeId node, const formats::DataSheet& sheet, const Frame& frame);
  void differs(Time at, NodeId node, std::uint16_t index, std::uint8_t sub, std::string text);

  std::map<NodeId, const formats::DataSheet*> sheets_;
  Differences differences_;
};

}  // namespace canvoy::words
