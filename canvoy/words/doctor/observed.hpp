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

struct Observed {
  explicit Observed(std::uint32_t bit_rate) : traffic(bit_rate) {}

  Time begin{};
  Time end{};
  KnownParameters known;
  TrafficWatch traffic;
  ErrorWatch errors;
  HeartbeatWatch heartbeats;
  PdoWatch pdos;
  SdoWatch sdos;
  NodeWatch nodes;
  ValueWatch values;
  SheetWatch sheets;
};

}  // namespace canvoy::words
