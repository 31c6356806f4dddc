// What people read: the library speaks in codes, and the tools turn them into words, here and
// nowhere else.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/dictionary/abort_code.hpp"
#include "canvoy/canopen/nmt/nmt.hpp"
#include "canvoy/canopen/sdo/sdo_outcome.hpp"
#include "canvoy/devices/cia419/charge_control.hpp"

namespace canvoy::words {

/// `node 10 (0Ah)`
std::string node_text(NodeId node);
/// `6383h:01h`
std::string object_text(std::uint16_t index, std::uint8_t sub);
/// `10 82 00`
std::string bytes_text(std::span<const std::uint8_t> bytes);
/// `06020000h: the object does not exist in the dictionary`
std::string abort_text(AbortCode code);
/// Who ended a request: the same of a server's abort, `aborted here, ...` of one by this side,
/// `no answer`, `cancelled, ...`, `done`.
std::string end_text(const SdoEnd& end);
/// What an emergency error code means, by its class where the code itself is not known.
std::string_view emergency_text(std::uint16_t code);
/// `pre-operational`
std::string_view nmt_state_text(NmtState state);
std::string_view bus_state_text(BusState state);
/// `the battery is not ready`
std::string_view stop_reason_text(cia419::StopReason reason);
/// `1h 02min 03.456s`, without units that are zero at its ends: `5min`.
std::string duration_text(Duration duration);

}  // namespace canvoy::words
