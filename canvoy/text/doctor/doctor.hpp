// Listens to one CANopen bus and finds its faults. It opens nothing, sends nothing and has no
// clock: it takes frames and error frames with their times.
//
//     Doctor doctor({.bit_rate = 125'000});
//     doctor.begin(begin);
//     for (const auto& [time, frame] : heard) doctor.hear(time, frame);
//     for (const Finding& finding : doctor.findings(end)) show(finding_row(finding.kind).title);
//
// Memory is bounded for any input: that of a decoder, and some hundred bytes for each node, CAN-ID
// and object.
#pragma once

#include <cstdint>
#include <string_view>

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/text/doctor/finding.hpp"
#include "canvoy/text/doctor/observed.hpp"
#include "canvoy/text/service_marks.hpp"

namespace canvoy::text {

/// Properties of the bus that are known beforehand.
struct DoctorOptions {
  std::uint32_t bit_rate = 0;  ///< bit/s; 0: unknown, the bus load is not judged
};

class Doctor {
 public:
  /// Starts without frames and without data sheets.
  explicit Doctor(const DoctorOptions& options = {}) : bus_(options.bit_rate) {}

  /// Takes what is known about nodes beforehand.
  decoder::Network& network() { return decoder_.network(); }
  /// Sets the data sheet that a node is compared with. `sheet` must outlive this.
  void add_sheet(NodeId node, const formats::DataSheet& sheet);

  /// Sets the time at which listening began; by default that of the first frame.
  void begin(Time at);
  /// Takes any frame: data, remote or error. A time before that of the previous frame is taken as
  /// that time.
  void hear(Time at, const Frame& frame);
  /// Takes that the connection to the bus was lost, and why. What follows from it, as silence, is
  /// no finding of its own.
  void lose(Time at, std::string_view why);
  /// Findings up to `end`, the worst first. Omits findings that only follow from others on the
  /// list. To be called once, after all frames.
  Findings findings(Time end);

  /// The collected observations.
  const Observed& observed() const { return bus_; }

 private:
  NodeId sender_of(const Frame& frame, const decoder::Decoded& decoded) const;
  bool is_up(NodeId node) const;
  void hear_frame(Time at, const Frame& frame);
  void hear_sync(Time at, const Frame& frame);
  void hear_nmt(Time at, const Frame& frame);
  void hear_error_control(Time at, const Frame& frame);
  void hear_boot_up(Time at, NodeId node);
  void learn(const decoder::Decoded& decoded);

  decoder::Decoder decoder_;
  Observed bus_;
  bool has_begun_ = false;
  Frame last_;            ///< last frame
  Time last_at_ = never;  ///< time of the last frame; never: none
  ServiceMarks services_;
};

}  // namespace canvoy::text
