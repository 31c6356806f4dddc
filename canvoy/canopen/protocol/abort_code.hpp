// SDO abort codes, and a value or the abort code in its place (CiA 301, 7.2.4.3.17).
#pragma once

#include <cstdint>
#include <utility>

namespace canvoy {

/// Reason of a refusal, or of the early end of a transfer, with its number on the wire. `none` is
/// never sent; an unknown number of a server is kept as it is.
enum class AbortCode : std::uint32_t {
  none = 0,
  toggle_bit = 0x0503'0000,
  time_out = 0x0504'0000,
  command_specifier = 0x0504'0001,
  block_size = 0x0504'0002,
  sequence_number = 0x0504'0003,
  crc = 0x0504'0004,
  out_of_memory = 0x0504'0005,
  unsupported_access = 0x0601'0000,
  write_only = 0x0601'0001,
  read_only = 0x0601'0002,
  no_object = 0x0602'0000,
  not_mappable = 0x0604'0041,
  pdo_length = 0x0604'0042,
  parameter_incompatible = 0x0604'0043,
  internal_incompatible = 0x0604'0047,
  hardware = 0x0606'0000,
  length = 0x0607'0010,
  length_too_high = 0x0607'0012,
  length_too_low = 0x0607'0013,
  no_sub_index = 0x0609'0011,
  value_range = 0x0609'0030,
  value_too_high = 0x0609'0031,
  value_too_low = 0x0609'0032,
  maximum_below_minimum = 0x0609'0036,
  no_sdo_connection = 0x060A'0023,
  general = 0x0800'0000,
  cannot_store = 0x0800'0020,
  local_control = 0x0800'0021,
  device_state = 0x0800'0022,
  no_dictionary = 0x0800'0023,
  no_data = 0x0800'0024,
  /// Never on the wire: the answer to the write follows, see Node::finish_deferred().
  deferred = 0xFFFF'FFFF,
};

/// True if the server has no such entry.
constexpr bool is_absent(AbortCode answer) {
  return answer == AbortCode::no_object || answer == AbortCode::no_sub_index;
}

/// A value, or the abort code in its place.
template <class Value>
class [[nodiscard]] Result {
 public:
  constexpr Result() = default;
  /// A value: the operation has succeeded.
  constexpr Result(Value value)
      : value_(std::move(value)) {}  // NOLINT(google-explicit-constructor): as return value
  /// A refusal, without a value; `abort` is not none.
  constexpr Result(AbortCode abort)
      : abort_(abort) {}  // NOLINT(google-explicit-constructor): as return value

  /// Makes a result; the value is valid if `abort` is none.
  constexpr Result(const Value& value, AbortCode abort) : value_(value), abort_(abort) {}

  constexpr explicit operator bool() const { return abort_ == AbortCode::none; }
  constexpr const Value& operator*() const { return value_; }
  constexpr const Value* operator->() const { return &value_; }
  /// The reason of a refusal; none if there is a value.
  constexpr AbortCode abort() const { return abort_; }

 private:
  Value value_{};
  AbortCode abort_ = AbortCode::none;
};

}  // namespace canvoy
