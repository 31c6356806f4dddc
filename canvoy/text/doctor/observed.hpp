// All that was heard on one bus, for the rows of finding.hpp to judge.
#pragma once

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/text/doctor/error_watch.hpp"
#include "canvoy/text/doctor/heartbeat_watch.hpp"
#include "canvoy/text/doctor/known_parameters.hpp"
#include "canvoy/text/doctor/node_watch.hpp"
#include "canvoy/text/doctor/pdo_watch.hpp"
#include "canvoy/text/doctor/sdo_watch.hpp"
#include "canvoy/text/doctor/sheet_watch.hpp"
#include "canvoy/text/doctor/sync_watch.hpp"
#include "canvoy/text/doctor/traffic_watch.hpp"
#include "canvoy/text/doctor/value_watch.hpp"

namespace canvoy::text {

/// Data of each watch, from `begin` to `end`.
struct Observed {
  /// `bit_rate` in bit/s; 0: unknown, the load is not judged.
  explicit Observed(std::uint32_t bit_rate) : traffic(bit_rate) {}

  Time begin{};               ///< start of listening
  Time end{};                 ///< last frame, or end of listening
  KnownParameters known;      ///< parameters from nodes and sheets
  TrafficWatch traffic;       ///< amount of traffic, by sender
  ErrorWatch errors;          ///< error frames, by sender of the affected frames
  HeartbeatWatch heartbeats;  ///< by node
  PdoWatch pdos;              ///< by CAN-ID
  SyncWatch syncs;            ///< rhythm and counter
  SdoWatch sdos;              ///< by server
  NodeWatch nodes;            ///< boot-ups and emergencies by node
  ValueWatch values;          ///< values and messages with marks of the decoder
  SheetWatch sheets;          ///< differences from data sheets
};

}  // namespace canvoy::text
