// All that was heard of one bus, as the rows of finding.hpp judge it.
#pragma once

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/words/doctor/error_watch.hpp"
#include "canvoy/words/doctor/heartbeat_watch.hpp"
#include "canvoy/words/doctor/known_parameters.hpp"
#include "canvoy/words/doctor/node_watch.hpp"
#include "canvoy/words/doctor/pdo_watch.hpp"
#include "canvoy/words/doctor/sdo_watch.hpp"
#include "canvoy/words/doctor/sheet_watch.hpp"
#include "canvoy/words/doctor/traffic_watch.hpp"
#include "canvoy/words/doctor/value_watch.hpp"

namespace canvoy::words {

/// What each watch has heard, from `begin` to `end`.
struct Observed {
  /// `bit_rate` in bit/s; 0: not known, and the load is not judged.
  explicit Observed(std::uint32_t bit_rate) : traffic(bit_rate) {}

  Time begin{};               ///< when the listening began
  Time end{};                 ///< that of the latest frame, or when the listening ended
  KnownParameters known;      ///< what nodes and sheets tell of communication
  TrafficWatch traffic;       ///< how much was sent, and by whom
  ErrorWatch errors;          ///< error frames, and whom they strike
  HeartbeatWatch heartbeats;  ///< by node
  PdoWatch pdos;              ///< by CAN-ID
  SdoWatch sdos;              ///< by server
  NodeWatch nodes;            ///< boot-ups and emergencies by node
  ValueWatch values;          ///< values and messages that the decoder marks
  SheetWatch sheets;          ///< differences from data sheets
};

}  // namespace canvoy::words
