#include "canvoy/devices/cia401/digital_outputs.hpp"

#include <algorithm>

#include "canvoy/devices/cia401/widths.hpp"

namespace canvoy::cia401 {

namespace {

// Distance from the object with the values.
constexpr std::uint16_t to_output_polarity = 2;
constexpr std::uint16_t to_error_mode = 6;
constexpr std::uint16_t to_error_value = 7;
constexpr std::uint16_t to_filter_mask = 8;

/// The 8 bits of a group in an object beside the values; wider objects have the same bits.
std::uint8_t of_group(const Dictionary& dictionary, std::uint16_t offset, std::size_t group) {
  const auto index = static_cast<std::uint16_t>(output_widths[0].index + offset);
  return static_cast<std::uint8_t>(dictionary.word(index, static_cast<std::uint8_t>(group + 1)));
}

/// Copies a written parameter of one width to the others.
void share(Dictionary& dictionary, const Width& written, std::uint16_t offset, std::size_t group,
           std::uint8_t value) {
  for (const Width& width : output_widths) {
    if (width.index == written.index) continue;
    const Result<Entry> entry = dictionary.find(static_cast<std::uint16_t>(width.index + offset),
                                                static_cast<std::uint8_t>(group / width.bytes + 1));
    if (entry) entry->value[group % width.bytes] = value;
  }
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
    const auto offset = static_cast<std::uint16_t>(index - width.index);
    if (offset > to_filter_mask || sub == 0) continue;
    Dictionary& dictionary = node_.dictionary();
    const std::uint32_t value = dictionary.word(index, sub);
    const std::uint32_t which =
        dictionary.word(static_cast<std::uint16_t>(width.index + to_filter_mask), sub, ~0U);
    const std::size_t first = std::size_t{sub - 1U} * width.bytes;
    const std::size_t end = std::min(first + width.bytes, groups_.size());
    for (std::size_t group = first; group < end; ++group) {
      const std::size_t shift = 8 * (group - first);
      if (offset == 0) {
        change(group, value >> shift, which >> shift);
      } else {
        share(dictionary, width, offset, group, static_cast<std::uint8_t>(value >> shift));
      }
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

/// In all objects that have them; other elements, which the same PDO may have written, are not
/// changed.
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
      if (entry->word() != value) put(dictionary, *entry, value);
    }
  }
}

}  // namespace canvoy::cia401
