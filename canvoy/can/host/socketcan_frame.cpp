#include "canvoy/can/host/socketcan_frame.hpp"

#include <linux/can/error.h>

#include <algorithm>

namespace canvoy::host {

can_frame to_kernel(const Frame& frame) {
  can_frame raw{};
  raw.can_id = frame.id;
  if (frame.is_extended()) raw.can_id |= CAN_EFF_FLAG;
  if (frame.is_remote()) raw.can_id |= CAN_RTR_FLAG;
  if (frame.is_error()) raw.can_id |= CAN_ERR_FLAG;
  raw.len = frame.length;
  std::copy(frame.data.begin(), frame.data.end(), raw.data);
  return raw;
}

Frame from_kernel(const can_frame& raw) {
  Frame frame;
  if ((raw.can_id & CAN_ERR_FLAG) != 0) {
    frame.flags = FrameFlags::error;
  } else if ((raw.can_id & CAN_EFF_FLAG) != 0) {
    frame.flags = FrameFlags::extended;
  }
  frame.id = raw.can_id & (frame.is_plain() ? CAN_SFF_MASK : CAN_EFF_MASK);
  frame.length = std::min<std::uint8_t>(raw.len, Frame::length_max);
  if ((raw.can_id & CAN_RTR_FLAG) != 0 && !frame.is_error()) {
    frame.flags = frame.flags | FrameFlags::remote;
  }
  std::copy_n(raw.data, frame.payload().size(), frame.data.begin());
  return frame;
}

std::optional<BusState> reported_state(const Frame& error) {
  if (!error.is_error()) return std::nullopt;
  if ((error.id & CAN_ERR_BUSOFF) != 0) return BusState::bus_off;
  if ((error.id & CAN_ERR_RESTARTED) != 0) return BusState::error_active;
  if ((error.id & CAN_ERR_CRTL) == 0) return std::nullopt;
  const unsigned status = error.data[1];
  const auto tells = [status](unsigned bits) { return (status & bits) != 0; };
  if (tells(CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) return BusState::error_passive;
  if (tells(CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) return BusState::error_warning;
  if (tells(CAN_ERR_CRTL_ACTIVE)) return BusState::error_active;
  return std::nullopt;
}

bool reports_overrun(const Frame& error) {
  return error.is_error() && (error.id & CAN_ERR_CRTL) != 0 &&
         (error.data[1] & CAN_ERR_CRTL_RX_OVERFLOW) != 0;
}

}  // namespace canvoy::host
