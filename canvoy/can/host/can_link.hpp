// The settings of a CAN interface of the Linux kernel: state, bit rate, listen-only mode
// (rtnetlink, linux/can/netlink.h), like `ip link set can0 type can bitrate 125000 listen-only on`.
//
//     Result<CanLink> link = read_can_link("can0");
//     Result<void> done = restart_can_link("can0", 125'000, true);
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/can/host/result.hpp"
#include "canvoy/can/port.hpp"

namespace canvoy::host {

struct CanLink {
  bool has_controller = false;    ///< false for virtual CAN interfaces, and for others than CAN
  bool is_up = false;             ///< administratively up
  bool listens_only = false;      ///< the controller sends nothing, not even an acknowledgement
  std::uint32_t bit_rate = 0;     ///< bit/s; 0: not set, or the interface has none, like vcan0
  std::optional<BusState> state;  ///< of the controller, if it reports one
};

/// Reads the settings; needs no rights. Errors: no such interface, those of the system.
Result<CanLink> read_can_link(std::string_view interface);

/// Takes the interface down, sets it and brings it up again. An interface without a CAN controller
/// is not changed; if the settings fail, the previous ones are restored. Needs CAP_NET_ADMIN. In
/// listen-only mode, a controller that supports it reports errors of the bus as error frames, which
/// reveals a wrong bit rate.
Result<void> restart_can_link(std::string_view interface, std::uint32_t bit_rate, bool listen_only);
/// Restores the bit rate and the mode that were read from the interface, and takes it up or down as
/// before.
Result<void> restore_can_link(std::string_view interface, const CanLink& before);

// The messages, without their socket.

/// A message to the kernel, with its header.
using LinkMessage = std::vector<std::uint8_t>;
/// Message that takes an interface up or down.
LinkMessage up_message(int interface_index, bool up, std::uint32_t sequence);
/// Message that sets bit rate (bit/s) and mode of an interface that is down. Without
/// `reports_errors`, for controllers that do not support it, error frames are not asked for.
LinkMessage bit_rate_message(int interface_index, std::uint32_t bit_rate, bool listen_only,
                             std::uint32_t sequence, bool reports_errors = true);
/// Contents of a kernel's answer to RTM_GETLINK; nothing if it is another message, or is cut off.
std::optional<CanLink> parse_link_message(std::span<const std::uint8_t> message);

}  // namespace canvoy::host
