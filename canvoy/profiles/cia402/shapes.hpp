// Shapes of the objects of CiA 402. The text of CiA 402 is not at hand: see cia402.hpp.
//
//     inline constexpr auto polarity_object =
//         variable(0x607E, "Polarity", entry(unsigned8, rw));
#pragma once

#include <array>

#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/cia402/values.hpp"

namespace canvoy::cia402 {

/// An optional variable.
constexpr ObjectInfo variable(std::uint16_t index, std::string_view name, const EntryInfo& entry,
                              std::string_view description = {}) {
  return var_object(index, name, "", description, entry, {.category = Category::optional});
}
/// An optional array.
constexpr ObjectInfo array(std::uint16_t index, std::string_view name, Items<EntryInfo> entries,
                           std::string_view description = {}) {
  return array_object(index, name, "", description, entries, {.category = Category::optional});
}
/// Sub-index 00h and two entries of one shape.
constexpr std::array<EntryInfo, 3> pair(EntryInfo each, std::string_view first,
                                        std::string_view second) {
  std::array<EntryInfo, 3> entries{cia301::highest_sub_index, each, each};
  entries[1].sub_first = 1;
  entries[1].name = first;
  entries[2].sub_first = 2;
  entries[2].name = second;
  return entries;
}
/// A share of the rated torque or current.
inline constexpr ValueInfo per_mille_of_rated = {.unit = Unit::per_mille};
/// A number of steps, of revolutions, or of units that the notation and dimension indices (6089h to
/// 608Eh) and factors of the drive define.
inline constexpr ValueInfo drive_amount = {.counting = Counting::counts};
inline constexpr std::uint16_t text_capacity = 64;

}  // namespace canvoy::cia402
