// Violations of CiA 301, or of the profile, in a frame.
//
//     Marks marks;
//     marks.add(Mark::out_of_range);
//     if (marks.has(Mark::out_of_range)) show(mark_name(Mark::out_of_range));
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace canvoy::decoder {

/// A violation. Marks inform: a frame with one is decoded as far as it can be.
enum class Mark : std::uint8_t {
  reserved,         ///< a reserved value
  out_of_range,     ///< beyond absolute limits
  wrong_length,     ///< more or fewer bytes than the mapping, the type or the sender gives
  wrong_access,     ///< written or mapped, though the profile does not allow it
  wrong_toggle,     ///< the toggle bit of node guarding or of a segment has not alternated
  unknown_command,  ///< of SDO or NMT: undefined; of NMT: no node-ID
  out_of_place,     ///< of SDO: no message that was heard calls for this one
  wrong_checksum,   ///< of an SDO block transfer
};
/// In the order of their numbers.
inline constexpr std::array all_marks = {
    Mark::reserved,     Mark::out_of_range,    Mark::wrong_length, Mark::wrong_access,
    Mark::wrong_toggle, Mark::unknown_command, Mark::out_of_place, Mark::wrong_checksum};

/// Words for a mark, as people read them.
std::string_view mark_name(Mark mark);

/// A set of marks.
class Marks {
 public:
  /// Adds a mark.
  constexpr void add(Mark mark) { bits_ = static_cast<std::uint8_t>(bits_ | bit(mark)); }
  /// Adds all marks of another set.
  constexpr void add(Marks others) { bits_ = static_cast<std::uint8_t>(bits_ | others.bits_); }
  /// Removes a mark; no effect if it is not set.
  constexpr void remove(Mark mark) { bits_ = static_cast<std::uint8_t>(bits_ & ~bit(mark)); }
  /// True if the set has this mark.
  constexpr bool has(Mark mark) const { return (bits_ & bit(mark)) != 0; }
  constexpr bool empty() const { return bits_ == 0; }

 private:
  static constexpr unsigned bit(Mark mark) { return 1U << static_cast<unsigned>(mark); }
  std::uint8_t bits_ = 0;
};

}  // namespace canvoy::decoder
