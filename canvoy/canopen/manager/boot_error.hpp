// Why a slave did not boot: the letters A to O of the boot-up procedure, with the cause (CiA 302-2,
// error status of "boot NMT slave").
//
//     report.error == BootError::vendor_id   // D
//     letter(report.error)                   // 'D'
#pragma once

#include <cstdint>

#include "canvoy/canopen/sdo/sdo_outcome.hpp"

namespace canvoy {

/// Result of the boot-up. The number is that of the letter; CiA 309-3 reports it in this form.
enum class BootError : std::uint8_t {
  none = 0,
  not_in_list = 'A',          ///< not a slave by 1F81h
  no_answer = 'B',            ///< to the request for 1000h
  device_type = 'C',          ///< 1000h differs from 1F84h, or is refused
  vendor_id = 'D',            ///< 1018h:01h differs from 1F85h
  no_heartbeat = 'E',         ///< to the request for the state of a slave to be kept alive
  no_guarding_answer = 'F',   ///< like no_heartbeat, but for node guarding
  no_program_data = 'G',      ///< what the software check needs is missing or inconsistent
  program_not_allowed = 'H',  ///< an update is needed, but 1F81h does not allow it
  program_download = 'I',     ///< the update failed
  configuration = 'J',        ///< the download of the configuration failed
  no_error_control = 'K',     ///< no heartbeat after error control was started
  already_operational = 'L',  ///< no failure: a slave to be kept alive was left as it was
  product_code = 'M',         ///< 1018h:02h differs from 1F86h
  revision_number = 'N',      ///< 1018h:03h differs from 1F87h
  serial_number = 'O',        ///< 1018h:04h differs from 1F88h
};

/// Letter of an error; `-` for none.
constexpr char letter(BootError error) {
  return error == BootError::none ? '-' : static_cast<char>(error);
}

/// End of a step of the procedure: a letter, and the end of the request that caused it.
struct BootOutcome {
  BootError error = BootError::none;  ///< letter, or none
  SdoEnd end = {};

  friend constexpr bool operator==(const BootOutcome&, const BootOutcome&) = default;
};

}  // namespace canvoy
