// Compares devices with their data sheets (EDS, DCF, XDD, XDC), by the entries that are read from
// them, or refused.
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
#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/text/doctor/known_parameters.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

class SheetWatch {
 public:
  /// Sets the data sheet of a node. `sheet` must outlive this.
  void add(NodeId node, const formats::DataSheet& sheet) { sheets_[node] = &sheet; }
  /// Adds the communication parameters of the sheet that are not known from the bus.
  static void tell(NodeId node, const formats::DataSheet& sheet, KnownParameters& known);
  /// Takes a frame and its decoded content: SDO answers of nodes with a sheet are compared.
  void hear(Time at, const Frame& frame, const decoder::Decoded& decoded);

  /// An entry in which a device differs from its sheet.
  struct Difference {
    std::string text;  ///< description
    Tally tally;       ///< occurrences
  };
  /// By node, index and sub-index.
  using Differences = std::map<std::tuple<NodeId, std::uint16_t, std::uint8_t>, Difference>;
  /// Differences in the first 1024 entries; empty: none.
  const Differences& differences() const { return differences_; }

 private:
  void compare(Time at, NodeId node, const formats::DataSheet& sheet,
               const decoder::SdoTransfer& transfer);
  void refused(Time at, NodeId node, const formats::DataSheet& sheet, const Frame& frame);
  void differs(Time at, NodeId node, std::uint16_t index, std::uint8_t sub, std::string text);

  std::map<NodeId, const formats::DataSheet*> sheets_;
  Differences differences_;
};

}  // namespace canvoy::text
