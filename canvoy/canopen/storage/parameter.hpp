// Which entries of a dictionary are parameters, which are stored, and the group of parameters that
// each belongs to (CiA 301, 7.5.2.13).
//
//     ParameterWalk walk(dictionary);
//     for (Entry entry; walk.next(entry);) ...
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy {

/// A manufacturer-specific group: sub-index 4 to 127 of 1010h and 1011h. A group may have several
/// ranges, inside or outside 2000h to 5FFFh.
struct ParameterGroup {
  std::uint8_t sub = 4;          ///< sub-index of 1010h and 1011h, 4 to 127
  std::uint16_t first = 0x2000;  ///< index
  std::uint16_t last = 0x5FFF;   ///< index
};

/// Group of a device that does not divide its own objects further.
inline constexpr ParameterGroup manufacturer_group[] = {{}};

/// True if sub-index `sub` of 1010h and 1011h covers the object: 1 covers all, 2 covers 1000h to
/// 1FFFh, 3 covers 6000h to 9FFFh, the others the ranges in `groups`.
bool is_in_group(std::uint16_t index, std::uint8_t sub, std::span<const ParameterGroup> groups);

/// True for an entry that SDO may read and write, and that is neither a process value
/// (EntryTraits::not_stored) nor a communication object for an action or a state.
bool is_parameter(std::uint16_t index, const EntryShape& row);

/// Iterates over all parameters of a dictionary, in the order of their indices and sub-indices.
class ParameterWalk {
 public:
  /// Begins before the first parameter. `dictionary` must outlive the walk.
  explicit ParameterWalk(const Dictionary& dictionary) : dictionary_(&dictionary) {}

  /// Goes to the next parameter; false at the end.
  bool next(Entry& entry);

 private:
  const Dictionary* dictionary_;
  std::uint16_t object_ = 0;  ///< index in the table
  std::uint16_t number_ = 0;  ///< number among the objects of that shape
  std::uint16_t row_ = 0;     ///< number among the entry rows of the object
  std::uint16_t place_ = 0;   ///< number among the entries of that row
};

/// Checksum that distinguishes dictionaries with different parameters: indices, sub-indices, types
/// and lengths.
std::uint32_t parameter_signature(const Dictionary& dictionary);

}  // namespace canvoy
