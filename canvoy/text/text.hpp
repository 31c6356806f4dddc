// Text for users: the library uses codes, and only here do the tools turn them into words.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/canopen/sdo/sdo_outcome.hpp"
#include "canvoy/devices/cia419/charge_control.hpp"

namespace canvoy::text {

/// Text of a node: `node 10 (0Ah)`.
std::string node_text(NodeId node);
/// Text of an address: `6383h:01h`.
std::string object_text(std::uint16_t index, std::uint8_t sub);
/// Text of bytes: `10 82 00`.
std::string bytes_text(std::span<const std::uint8_t> bytes);
/// Text of an abort code: `06020000h: the object does not exist in the dictionary`.
std::string abort_text(AbortCode code);
/// Text of the end of a request: as abort_text() for an abort by the server, `aborted here, ...` by
/// this side, `no answer`, `cancelled, ...`, `done`.
std::string end_text(const SdoEnd& end);
/// Meaning of an emergency error code, or of its class if the code is unknown.
std::string_view emergency_text(std::uint16_t code);
/// Text of an NMT state: `pre-operational`.
std::string_view nmt_state_text(NmtState state);
/// Text of a controller's state: `error-passive`, `bus-off`.
std::string_view bus_state_text(BusState state);
/// Text of a reason: `the battery is not ready`.
std::string_view stop_reason_text(cia419::StopReason reason);
/// Text of a duration: `1h 02min 03.456s`, without leading and trailing units that are zero:
/// `5min`.
std::string duration_text(Duration duration);

}  // namespace canvoy::text
