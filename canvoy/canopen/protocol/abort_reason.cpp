#include "canvoy/canopen/protocol/abort_reason.hpp"

namespace canvoy {

std::string_view abort_reason(AbortCode code) {
  using enum AbortCode;
  switch (code) {
    case none:
      return "no abort";
    case toggle_bit:
      return "the toggle bit did not alternate";
    case time_out:
      return "SDO time-out";
    case command_specifier:
      return "the command specifier is unknown or not supported";
    case block_size:
      return "invalid block size";
    case sequence_number:
      return "invalid sequence number";
    case crc:
      return "the checksums differ";
    case out_of_memory:
      return "out of memory";
    case unsupported_access:
      return "access of this kind is not supported";
    case write_only:
      return "the object is write-only";
    case read_only:
      return "the object is read-only";
    case no_object:
      return "the object does not exist in the dictionary";
    case not_mappable:
      return "the object cannot be mapped into this PDO";
    case pdo_length:
      return "the mapped objects exceed the length of a PDO";
    case parameter_incompatible:
      return "the parameter does not fit the others";
    case internal_incompatible:
      return "the device does not fit the request";
    case hardware:
      return "a hardware error prevents the access";
    case length:
      return "the length does not match the data type";
    case length_too_high:
      return "the value is longer than the data type";
    case length_too_low:
      return "the value is shorter than the data type";
    case no_sub_index:
      return "the object has no such sub-index";
    case value_range:
      return "the value is not allowed";
    case value_too_high:
      return "the value is too high";
    case value_too_low:
      return "the value is too low";
    case maximum_below_minimum:
      return "the maximum is less than the minimum";
    case no_sdo_connection:
      return "no SDO connection";
    case general:
      return "general error";
    case cannot_store:
      return "the data cannot be stored or transferred";
    case local_control:
      return "the device is under local control";
    case device_state:
      return "not possible in the present state of the device";
    case no_dictionary:
      return "no object dictionary";
    case no_data:
      return "no data available";
    case deferred:
      break;
  }
  return "unknown abort code";
}

}  // namespace canvoy
