// A frame of the Linux kernel, and the state of the controller in its error frames.
//
//     can_frame raw = to_kernel(frame);  Frame frame = from_kernel(raw);
//     if (std::optional<BusState> state = reported_state(frame)) ...
#pragma once

#include <linux/can.h>

#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"

namespace canvoy::host {

/// Converts a frame for the kernel: CAN_EFF_FLAG, CAN_RTR_FLAG and CAN_ERR_FLAG as in its flags.
can_frame to_kernel(const Frame& frame);
/// Converts a frame of the kernel. Lengths above 8 are taken as 8, as a classic controller does.
Frame from_kernel(const can_frame& raw);

/// State of the controller in an error frame, if it has one (linux/can/error.h): bus-off,
/// restarted, passive or active again. A warning limit is still error-active. Nothing for all other
/// error frames.
std::optional<BusState> reported_state(const Frame& error);

/// True if the error frame reports that the controller dropped a received frame.
bool reports_overrun(const Frame& error);

}  // namespace canvoy::host
