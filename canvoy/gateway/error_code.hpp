// Error codes that a gateway answers instead of an SDO abort code, and errors that it reports by
// itself (CiA 309-3; codes as in CANopenNode and Lely CANopen).
//
//     answer_text(7, Answer::failed(ErrorCode::syntax), Version::v3_0);  // [7] ERROR:101
#pragma once

#include <cstdint>
#include <string_view>

#include "canvoy/canopen/manager/boot_error.hpp"

namespace canvoy::gateway {

/// An error by its number.
enum class ErrorCode : std::uint16_t {
  none = 0,
  not_supported = 100,
  syntax = 101,
  internal_state = 102,  ///< the state of the gateway or of its node forbids it
  time_out = 103,
  no_default_net = 104,
  no_default_node = 105,
  unknown_net = 106,
  unknown_node = 107,
  guarding_lost = 200,
  connection_lost = 201,
  heartbeat_started = 202,
  heartbeat_lost = 203,
  wrong_nmt_state = 204,
  boot_up = 205,
  error_passive = 300,
  bus_off = 301,
  buffer_overflow = 303,
  can_init = 304,
  can_active = 305,
  pdo_in_use = 400,
  pdo_length = 401,
  lss = 501,
  lss_node_id = 502,
  lss_bit_rate = 503,
  lss_storing = 504,
  lss_media = 505,
  out_of_memory = 600,
};

/// A short description for people; empty for an unknown code.
std::string_view text_of(ErrorCode code);
/// A short description of a letter of the boot-up procedure.
std::string_view text_of(BootError error);

}  // namespace canvoy::gateway
