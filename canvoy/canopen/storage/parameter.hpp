// Which entries of a dictionary are parameters, and so worth to be kept without power, and to which
// group of parameters they belong (CiA 301, 7.5.2.13).
//
//     ParameterWalk walk(dictionary);
//     for (Entry entry; walk.next(entry);) ...
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy {

/// A manufacturer-specific group: sub-index 4 to 127 of 1010h and 1011h. A group may have several
/// ranges, and they need not be in 2000h to 5FFFh.
struct ParameterGroup {
  std::uint8_t sub = 4;
  std::uint16_t first = 0x2000;  ///< index
  std::uint16_t last = 0x5FFF;   ///< index
};

/// Of a device that divides its own objects no further.
inline constexpr ParameterGroup manufacturer_group[] = {{}};

/// Whether sub-index `sub` of 1010h and 1011h is about the object: 1 about all, 2 about 1000h to
/// 1FFFh, 3 about 6000h to 9FFFh, the others about what `groups` says.
bool is_in_group(std::uint16_t index, std::uint8_t sub, std::span<const ParameterGroup> groups);

/// What SDO may read and write, and is neither a value of the process (EntryTraits::not_stored) nor
/// one of those communication objects that stand for an action or a state.
bool is_parameter(std::uint16_t index, const EntryShape& row);

/// All parameters of a dictionary, in the order of their indices and sub-indices.
class ParameterWalk {
 public:
  explicit ParameterWalk(const Dictionary& dictionary) : dictionary_(&dictionary) {}

  /// False at the end.
  bool next(Entry& entry);

 private:
  const Dictionary* dictionary_;
  std::uint16_t object_ = 0;  ///< its place in the table
  std::uint16_t number_ = 0;  ///< which of the objects of that shape
  std::uint16_t row_ = 0;     ///< which of the entry rows of the object
  std::uint16_t place_ = 0;   ///< which of the entries of that row
};

/// Tells dictionaries with other parameters apart: indices, sub-indices, types and lengths.
std::uint32_t parameter_signature(const Dictionary& dictionary);

}  // namespace canvoy
