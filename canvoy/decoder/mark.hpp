// What a frame may have that is against CiA 301, or against the profile.
//
//     Marks marks;
//     marks.add(Mark::out_of_range);
//     if (marks.has(Mark::out_of_range)) show(mark_name(Mark::out_of_range));
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace canvoy::decoder {

enum class Mark : std::uint8_t {
  reserved,         ///< a value that nobody may send
  out_of_range,     ///< beyond limits that are absolute
  wrong_length,     ///< more or fewer bytes than the mapping, the type, or who sends them says
  wrong_access,     ///< written, or mapped, though the profile does not allow it
  wrong_toggle,     ///< the toggle bit of node guarding, or of a segment, has not alternated
  unknown_command,  ///< of SDO: a command specifier that stands for nothing
  out_of_place,     ///< of SDO: nothing that was heard calls for this message
  wrong_checksum,   ///< of an SDO block transfer
};
inline constexpr std::array all_marks = {
    Mark::reserved,     Mark::out_of_range,    Mark::wrong_length, Mark::wrong_access,
    Mark::wrong_toggle, Mark::unknown_command, Mark::out_of_place, Mark::wrong_checksum};

std::string_view mark_name(Mark mark);

/// A set of marks.
class Marks {
 public:
  constexpr void add(Mark mark) { bits_ = static_cast<std::uint8_t>(bits_ | bit(mark)); }
  constexpr void add(Marks others) { bits_ = static_cast<std::uint8_t>(bits_ | others.bits_); }
  /// A mark that is not there is none to remove.
  constexpr void remove(Mark mark) { bits_ = static_cast<std::uint8_t>(bits_ & ~bit(mark)); }
  constexpr bool has(Mark mark) const { return (bits_ & bit(mark)) != 0; }
  constexpr bool empty() const { return bits_ == 0; }

 private:
  static constexpr unsigned bit(Mark mark) { return 1U << static_cast<unsigned>(mark); }
  std::uint8_t bits_ = 0;
};

}  // namespace canvoy::decoder
