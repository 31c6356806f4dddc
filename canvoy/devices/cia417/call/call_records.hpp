// Calls of a lift in the records of its panels: requests of an input (6010h), and the
// acknowledgements (6011h; CiA 417-4, 4.3.1 and 4.4.1: basic functions 02h to 11h).
//
//     hall_call_of(input, 0b01)                        // {up, standard, floor 3, door 1}
//     encode(acknowledgement_of(call, lift_bit(1), true))
#pragma once

#include "canvoy/devices/cia417/lift/lift_calls.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"

namespace canvoy::cia417 {

/// The acknowledgement of a call. Car panels at all doors show it, in the column of the door that
/// opens.
VirtualOutput acknowledgement_of(const Call& call, std::uint8_t lifts, bool on);
/// The answer to the panel of an input: for a destination call or a connection.
VirtualOutput answer_to(const VirtualInput& input, bool on, std::uint8_t lifts);
/// The sub-function of a hall call: it addresses the lamps of each direction.
std::uint8_t hall_sub_function(CallKind kind);

/// The call of a hall call input at these doors.
Call hall_call_of(const VirtualInput& input, DoorMask doors);
/// How a destination call waits for the car at its source floor.
Call source_call_of(const VirtualInput& input, DoorMask doors);
/// Priority of a call by its basic function: 02h to 04h and so on.
CallPriority priority_of(BasicFunction function);
/// True for basic functions 0Fh to 11h.
constexpr bool is_connection_request(BasicFunction function) {
  return is_between(function, BasicFunction::access_code_upload,
                    BasicFunction::area_monitoring_connection);
}
/// True for basic functions 08h to 0Dh.
constexpr bool is_destination_call(BasicFunction function) {
  return is_between(function, BasicFunction::standard_destination_call,
                    BasicFunction::high_priority_call_to_destination_floor);
}

}  // namespace canvoy::cia417
