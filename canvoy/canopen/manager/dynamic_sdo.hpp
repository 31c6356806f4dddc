// The protocol between SDO manager and requesting devices: the request on CAN-ID 6E0h, and the bits
// of 1F00h, 1F01h and 1F10h (CiA 302-5).
//
// It follows devices in the field; the specification is not public. The error codes are specific to
// this implementation.
//
//     DynamicSdoState state(dictionary.number(0x1F10, 0));
//     if (state.status == DynamicSdoState::Status::connected) use(state.client_parameter);
#pragma once

#include <cstdint>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/sdo/sdo_channel.hpp"

namespace canvoy {

namespace can_id {
/// Without data, from a requesting device.
inline constexpr std::uint16_t dynamic_sdo_request = 0x6E0;
}  // namespace can_id

namespace dynamic_sdo {
inline constexpr std::uint16_t request = 0x1F00;      ///< request a connection
inline constexpr std::uint16_t release = 0x1F01;      ///< release a connection
inline constexpr std::uint16_t cob_ids = 0x1F02;      ///< that the manager may assign
inline constexpr std::uint16_t connections = 0x1F03;  ///< 1F03h to 1F06h
inline constexpr std::uint16_t state = 0x1F10;        ///< of the requesting device: DynamicSdoState

/// True for an SDO client parameter: 1280h to 12FFh.
constexpr bool is_client_parameter(unsigned index) {
  return index >= sdo_client_parameter && index < sdo_client_parameter + sdo_channels_max;
}
}  // namespace dynamic_sdo

/// Why the SDO manager refused a connection, or ended one (1F10h, bits 15 to 8).
enum class DynamicSdoError : std::uint8_t {
  none = 0,
  no_cob_id = 1,           ///< 1F02h has no two free ones
  no_server_channel = 2,   ///< all of 1201h to 127Fh of the server are in use, or it has none
  server_silent = 3,       ///< no answer to SDO requests
  server_refused = 4,      ///< with an abort code
  no_manager_channel = 5,  ///< the manager has no free server channel for the requesting device
  connection_lost = 6,     ///< the server is lost, or restarted
  device_refused = 7,      ///< the requesting device refused, with an abort code
};

/// Contents of 1F10h: written by the device before its request, and by the SDO manager as an
/// answer.
struct DynamicSdoState {
  /// Bits 2 and 1 of 1F10h.
  enum class Status : std::uint8_t {
    failed = 0,  ///< with an error code; without one, a request without an answer yet
    registered = 1,
    all_given = 2,
    connected = 3,
  };

  std::uint16_t client_parameter = 0;             ///< index of the SDO client: 1280h + n
  DynamicSdoError error = DynamicSdoError::none;  ///< if failed
  Status status = Status::failed;                 ///< see Status
  bool wants_all = false;  ///< all default SDO channels, instead of one connection

  constexpr DynamicSdoState() = default;
  /// Takes a value of 1F10h apart; of 64 bits, the lower 32 count.
  constexpr explicit DynamicSdoState(std::uint64_t value)
      : client_parameter(static_cast<std::uint16_t>(value >> 16)),
        error(static_cast<DynamicSdoError>(static_cast<std::uint8_t>(value >> 8))),
        status(static_cast<Status>(value >> 1 & 3)),
        wants_all((value & 1) != 0) {}

  /// Value of 1F10h.
  constexpr std::uint32_t value() const {
    return static_cast<std::uint32_t>(client_parameter) << 16 |
           static_cast<std::uint32_t>(error) << 8 | static_cast<std::uint32_t>(status) << 1 |
           (wants_all ? 1U : 0U);
  }
  /// True for a device that waits for the SDO manager.
  constexpr bool is_request() const {
    return status == Status::failed && error == DynamicSdoError::none &&
           dynamic_sdo::is_client_parameter(client_parameter);
  }
};

/// Value written to 1F00h and 1F01h of the SDO manager.
struct DynamicSdoRequest {
  std::uint16_t client_parameter = 0;  ///< 1F01h: 0 means all connections of the device
  NodeId device = 0;                   ///< the requesting device
  NodeId server = 0;                   ///< 1F01h: 0 means the registration, and all connections

  /// Value to write: client parameter (bits 31 to 16), device, server.
  constexpr std::uint32_t value() const {
    return static_cast<std::uint32_t>(client_parameter) << 16 |
           static_cast<std::uint32_t>(device) << 8 | server;
  }
  /// Takes a written value apart; of 64 bits, the lower 32 count.
  static constexpr DynamicSdoRequest from(std::uint64_t value) {
    return {.client_parameter = static_cast<std::uint16_t>(value >> 16),
            .device = static_cast<NodeId>(value >> 8),
            .server = static_cast<NodeId>(value)};
  }
};

}  // namespace canvoy
