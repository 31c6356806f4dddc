#include "canvoy/devices/cia401/digital_outputs.hpp"

#include <algorithm>

#include "canvoy/devices/cia401/widths.hpp"

namespace canvoy::cia401 {

namespace {

// From the object with the values.
constexpr std::uint16_t to_output_polarity = 2;
constexpr std::uint16_t to_error_mode = 6;
constexpr std::uint16_t to_error_value = 7;
constexpr std::uint16_t to_filter_mask = 8;

/// The 8 bits of a group of what an object beside the values says, by the narrowest width that the
/// device has.
std::uint8_t of_group(const Dictionary& dictionary, std::uint16_t offset, std::size_t group) {
  for (const Width& width : output_widths) {
    const auto index = static_cast<std::uint16_t>(width.index + offset);
    const auto sub = static_cast<std::uint8_t>(group / width.bytes + 1);
    const Result<Entry> entry = dictionary.find(index, sub);
    if (entry) return static_cast<std::uint8_t>(entry->word() >> 8 * (group % width.bytes));
  }
  return 0;
}

}  // namespace

void DigitalOutputs::begin() {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    groups_[i] = of_group(node_.dictionary(), 0, i);
    drive(i);
  }
  show(0, groups_.size());
}

void DigitalOutputs::written(std::uint16_t index, std::uint8_t sub) {
  for (const Width& width : output_widths) {
    const bool is_polarity = index == width.index + to_output_polarity;
    if ((index != width.index && !is_polarity) || sub == 0) continue;
    const Dictionary& dictionary = node_.dictionary();
    const std::uint32_t value = dictionary.word(width.index, sub);
    const std::uint32_t which =
        dictionary.word(static_cast<std::uint16_t>(width.index + to_filter_mask), sub, ~0U);
    const std::size_t first = std::size_t{sub - 1U} * width.bytes;
    const std::size_t end = std::min(first + width.bytes, groups_.size());
    for (std::size_t group = first; group < end; ++group) {
      const std::size_t shift = 8 * (group - first);
      if (!is_polarity) change(group, value >> shift, which >> shift);
      drive(group);
    }
    return show(first, end);
  }
}

void DigitalOutputs::fail() {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    change(i, of_group(node_.dictionary(), to_error_value, i),
           of_group(node_.dictionary(), to_error_mode, i));
    drive(i);
  }
  show(0, groups_.size());
}

void DigitalOutputs::change(std::size_t group, std::uint32_t value, std::uint32_t which) {
  groups_[group] = static_cast<std::uint8_t>((groups_[group] & ~which) | (value & which));
}

void DigitalOutputs::drive(std::size_t group) {
  const std::uint8_t polarity = of_group(node_.dictionary(), to_output_polarity, group);
  drive_(static_cast<unsigned>(group + 1), groups_[group] ^ polarity);
}

/// By all objects that have them; others, which the same PDO may have written, are not touched.
void DigitalOutputs::show(std::size_t first, std::size_t end) {
  Dictionary& dictionary = node_.dictionary();
  for (const Width& width : output_widths) {
    for (std::size_t element = first / width.bytes; element * width.bytes < end; ++element) {
      const Result<Entry> entry =
          dictionary.find(width.index, static_cast<std::uint8_t>(element + 1));
      if (!entry) break;
      std::uint32_t value = 0;
      for (unsigned i = 0; i < width.bytes; ++i) {
        const std::size_t group = element * width.bytes + i;
        if (group < groups_.size()) value |= std::uint32_t{groups_[group]} << 8 * i;
      }
      if (entry->word() != value) put(dictionary, *entry, value, true);
    }
  }
}

}  // namespace canvoy::cia401
