// The emergency object in the form of the wire, and its COB-ID (CiA 301, 7.2.7).
//
//     Frame frame = encode(Emergency{.code = 0x8130, .register_bits = 0x11}, 0x085);
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

/// An emergency message, byte for byte as it is sent.
struct Emergency {
  static constexpr std::uint8_t length = 8;  ///< of the frame, in bytes

  std::uint16_t code = 0;                 ///< 0000h: an error has disappeared
  std::uint8_t register_bits = 0;         ///< error register 1001h at that moment
  std::array<std::uint8_t, 5> info = {};  ///< manufacturer-specific field

  friend constexpr bool operator==(const Emergency&, const Emergency&) = default;
};
static_assert(sizeof(Emergency) == Emergency::length, "it is kept as it travels");

/// Data frame with the message. `can_id` has 11 bits.
inline Frame encode(const Emergency& emergency, std::uint32_t can_id) {
  Frame frame = Frame::data_frame(can_id, {});
  frame.length = Emergency::length;
  store(frame.data.data(), emergency.code);
  frame.data[2] = emergency.register_bits;
  std::copy(emergency.info.begin(), emergency.info.end(), frame.data.begin() + 3);
  return frame;
}

/// Decodes a frame of Emergency::length bytes.
inline Emergency decode_emergency(const Frame& frame) {
  Emergency emergency;
  emergency.code = load<std::uint16_t>(frame.data.data());
  emergency.register_bits = frame.data[2];
  std::copy_n(frame.data.begin() + 3, emergency.info.size(), emergency.info.begin());
  return emergency;
}

/// Checks whether 1014h or a sub-index of 1028h may change from `present` to `wanted`: bits 30 to
/// 11 must be zero, a valid COB-ID must not be restricted, and the CAN-ID may change only while the
/// object is invalid. Abort: value_range.
constexpr AbortCode check_emergency_cob_id(CobId present, CobId wanted) {
  constexpr std::uint32_t allowed = CobId::bit31 | Frame::id_max;
  const bool stays = !present.valid() || present.can_id() == wanted.can_id();
  const bool fits = !wanted.valid() || (stays && has_free_id(wanted));
  return fits && (wanted.raw & ~allowed) == 0 ? AbortCode::none : AbortCode::value_range;
}

}  // namespace canvoy
