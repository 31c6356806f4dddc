// A frame as the Linux kernel has it, and what its error frames say about the controller.
//
//     can_frame raw = to_kernel(frame);  Frame frame = from_kernel(raw);
//     if (std::optional<BusState> state = reported_state(frame)) ...
#pragma once

#include <linux/can.h>

#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"

namespace canvoy::host {

can_frame to_kernel(const Frame& frame);
/// Lengths above 8 are taken as 8, as a classic controller does.
Frame from_kernel(const can_frame& raw);

/// The state of the controller, where the error frame tells of one (linux/can/error.h): bus-off,
/// restarted, passive or active again. A warning limit is still error-active. Nothing for all else.
std::optional<BusState> reported_state(const Frame& error);

/// Whether the error frame says that the controller had to drop a received frame.
bool reports_overrun(const Frame& error);

}  // namespace canvoy::host
