// Meanings of the values of CiA 401 inputs and outputs, and the shapes of its arrays. Profiles that
// are built on CiA 401 share them (CiA 852).
//
//     .entry = {.type = DataType::unsigned8, .value = {.names = cia401::error_mode_names}}
#pragma once

#include <algorithm>

#include "canvoy/profiles/model/numbered_name.hpp"
#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia401 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

/// Reaction of an output when the device fails or is stopped (6206h, 6443h and similar objects).
enum class ErrorMode : std::uint8_t { keep = 0, take_error_value = 1 };
inline constexpr NamedValue error_mode_names[] = {{ErrorMode::keep, "value is kept"},
                                                  {ErrorMode::take_error_value, "error value"}};
/// Error modes of analogue outputs, which have a byte each.
inline constexpr NamedValue error_mode_byte_names[] = {{ErrorMode::keep, "value is kept"},
                                                       {ErrorMode::take_error_value, "error value"},
                                                       {2, 0xFF, "reserved", Meaning::reserved}};

inline constexpr NamedValue polarity_names[] = {{0, "not inverted"}, {1, "inverted"}};
inline constexpr NamedValue enabled_names[] = {{0, "disabled"}, {1, "enabled"}};

/// One bit for each input or output.
inline constexpr ValueInfo mask = {.notation = Notation::bit_mask};

/// Maximum number of channels in an array.
inline constexpr std::uint8_t channels_max = 254;

/// Sub-index 00h of all arrays.
constexpr EntryInfo number_of_channels(std::string_view name) {
  return sub_index(0, name, entry(unsigned8, ro, no, highest_sub()));
}
/// An array with as many inputs or outputs as the device has.
constexpr std::array<EntryInfo, 2> channels(EntryInfo each, std::uint8_t last = channels_max) {
  each.sub_first = 1;
  each.sub_last = last;
  return {{number_of_channels("Highest sub-index supported"), each}};
}
/// Process values: inputs are read, outputs are written.
constexpr EntryInfo input(DataType type, std::string_view name) {
  return sub_index(0, name, entry(type, ro, optional));
}
/// See input(); 0 by default.
constexpr EntryInfo output(DataType type, std::string_view name) {
  return sub_index(0, name, entry(type, rw, optional, 0));
}
/// A parameter of an input or output.
constexpr EntryInfo parameter(DataType type, std::string_view name, Default initial,
                              const ValueInfo& value = {}) {
  return sub_index(0, name, entry(type, rw, no, initial, value));
}
/// The same entry, in a PDO by default.
constexpr EntryInfo by_default(EntryInfo entry) {
  entry.mapping = Mapping::by_default;
  return entry;
}
/// An optional array.
constexpr ObjectInfo array(std::uint16_t index, std::string_view name,
                           const std::array<EntryInfo, 2>& entries,
                           std::string_view description = {}) {
  return array_object(index, name, "", description, entries, {.category = Category::optional});
}

// An array is said once, in one row: its channels have its name and a number.
//
//     inline constexpr auto polarity_input_8_bit_object =
//         parameters<0x6002, "Polarity input 8-bit", unsigned8, 0, mask>("Which are inverted.");

namespace detail {

/// "Polarity input 8-bit #"
template <Name name>
inline constexpr auto channel_name = [] {
  std::array<char, name.text().size() + 2> text{};
  std::ranges::copy(name.text(), text.begin());
  std::ranges::copy(std::string_view(" #"), text.end() - 2);
  return text;
}();
template <Name name>
inline constexpr std::string_view channel_text(channel_name<name>.data(),
                                               channel_name<name>.size());

constexpr EntryInfo mapped(EntryInfo entry, Mapping mapping) {
  entry.mapping = mapping;
  return entry;
}
template <Name name, DataType type, Mapping mapping>
inline constexpr auto inputs = channels(mapped(input(type, channel_text<name>), mapping));
template <Name name, DataType type, Mapping mapping>
inline constexpr auto outputs = channels(mapped(output(type, channel_text<name>), mapping));
template <Name name, DataType type, std::int64_t initial, const ValueInfo& value>
inline constexpr auto parameters = channels(parameter(type, channel_text<name>, initial, value));

}  // namespace detail

/// A number without a unit.
inline constexpr ValueInfo plain = {};
/// Error modes of analogue outputs.
inline constexpr ValueInfo error_mode_byte = {.names = error_mode_byte_names};
/// A unit and its prefix (CiA 303-2).
inline constexpr ValueInfo unit_code = {.notation = Notation::hexadecimal};

/// Process values that are read.
template <std::uint16_t index, Name name, DataType type, Mapping mapping = Mapping::optional>
constexpr ObjectInfo inputs(std::string_view description = {}) {
  return array(index, name.text(), detail::inputs<name, type, mapping>, description);
}
/// Process values that are written, 0 by default.
template <std::uint16_t index, Name name, DataType type, Mapping mapping = Mapping::optional>
constexpr ObjectInfo outputs(std::string_view description = {}) {
  return array(index, name.text(), detail::outputs<name, type, mapping>, description);
}
/// Parameters of inputs or outputs.
template <std::uint16_t index, Name name, DataType type, std::int64_t initial,
          const ValueInfo& value = plain>
constexpr ObjectInfo parameters(std::string_view description = {}) {
  return array(index, name.text(), detail::parameters<name, type, initial, value>, description);
}

}  // namespace canvoy::cia401
