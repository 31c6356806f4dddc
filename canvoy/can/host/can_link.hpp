// The settings of a CAN interface of the Linux kernel: its state, its bit rate, listen-only mode
// (rtnetlink, linux/can/netlink.h), as `ip link set can0 type can bitrate 125000 listen-only on`.
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
  bool has_controller = false;  ///< false of virtual CAN interfaces, and of all that are no CAN
  bool is_up = false;
  bool listens_only = false;
  std::uint32_t bit_rate = 0;     ///< bit/s; 0: none was set, or the interface has none, as vcan0
  std::optional<BusState> state;  ///< of the controller, where it tells
};

Result<CanLink> read_can_link(std::string_view interface);

/// Takes the interface down, sets it and brings it up again; one without a CAN controller is not
/// touched, and one that cannot be set so gets back what it had. It needs CAP_NET_ADMIN. While it
/// only listens, a controller that can do so reports errors of the bus as error frames, which is
/// how a wrong bit rate shows.
Result<void> restart_can_link(std::string_view interface, std::uint32_t bit_rate, bool listen_only);
/// Gives it back the bit rate and the mode that were read from it, and takes it up or down as it
/// was.
Result<void> restore_can_link(std::string_view interface, const CanLink& before);

// The messages, apart from their socket.

using LinkMessage = std::vector<std::uint8_t>;
LinkMessage up_message(int interface_index, bool up, std::uint32_t sequence);
LinkMessage bit_rate_message(int interface_index, std::uint32_t bit_rate, bool listen_only,
                             std::uint32_t sequence, bool reports_errors = true);
/// What a kernel's answer to RTM_GETLINK says; nothing where it is none, or is cut off.
std::optional<CanLink> parse_link_message(std::span<const std::uint8_t> message);

}  // namespace canvoy::host
