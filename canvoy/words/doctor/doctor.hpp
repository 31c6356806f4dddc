// Listens to one CANopen bus, and says what is wrong with it. It opens nothing, sends nothing, and
// knows no clock: it is handed frames, error frames among them, with their times.
//
//     Doctor doctor({.bit_rate = 125'000});
//     doctor.begin(begin);
//     for (const auto& [time, frame] : heard) doctor.hear(time, frame);
//     for (const Finding& finding : doctor.findings(end)) show(finding_row(finding.kind).title);
//
// Memory is bounded whatever comes: that of a decoder, and some hundred bytes for each node, CAN-ID
// and object.
#pragma once

#include <cstdint>

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/words/doctor/finding.hpp"
#include "canvoy/words/doctor/observed.hpp"

namespace canvoy::words {

/// What a doctor is told of the bus beforehand.
struct DoctorOptions {
  std::uint32_t bit_rate = 0;  ///< bit/s; 0: not known, and the load of the bus is not judged
};

class Doctor {
 public:
  /// Nothing is heard yet, and no sheet is known.
  explicit Doctor(const DoctorOptions& options = {}) : bus_(options.bit_rate) {}

  /// What is known of nodes beforehand may be told here.
  decoder::Network& network() { return decoder_.network(); }
  /// What the node is compared with. `sheet` has to outlive this.
  void add_sheet(NodeId node, const formats::DataSheet& sheet);

  /// When the listening began; else it begins with the first frame.
  void begin(Time at);
  /// Any frame: data, remote or error. A time before that of the frame before is taken as that.
  void hear(Time at, const Frame& frame);
  /// What is wrong, the worst first, up to `end`. What is but the consequence of something else on
  /// the list is left out. Once, when all was heard.
  Findings findings(Time end);

  /// All that was heard.
  const Observed& observed() const { return bus_; }

 private:
  NodeId sender_of(const Frame& frame, const decoder::Decoded& decoded) const;
  bool is_up(NodeId node) const;
  void hear_frame(Time at, const Frame& frame);
  void hear_nmt(Time at, const Frame& frame);
  void hear_error_control(Time at, const Frame& frame);
  void hear_boot_up(Time at, NodeId node);
  void learn(const decoder::Decoded& decoded);

  decoder::Decoder decoder_;
  Observed bus_;
  bool has_begun_ = false;
  Frame last_;                                   ///< that was heard
  Time last_at_ = never;                         ///< when; never: none was
  std::array<Time, node_id_max + 1> guarded_{};  ///< when a remote frame asked for its state
};

}  // namespace canvoy::words
