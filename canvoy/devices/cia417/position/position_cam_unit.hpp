// A position CAM unit: the cams on which the car is (63A0h to 63A2h; CiA 417-4, 4.10). No object
// has the positions of the cams: the maker defines them.
//
//     constexpr Cam door_zones[] = {{.channel = 1, .number = 1, .low = -100, .high = 100}, ...};
//     PositionCamUnit cams(node.dictionary(), 1, door_zones);
//     cams.update(1, 12'050);  // millimetres, by position unit 1
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy::cia417 {

/// A section of the shaft, in millimetres of the position unit. A cam may have several: it is
/// active in each of them.
struct Cam {
  std::uint8_t channel = 1;  ///< 1 to 254
  std::uint8_t number = 1;   ///< in this channel, 1 to 8
  std::uint8_t unit = 1;     ///< that measures it
  double low = 0;            ///< lower end
  double high = 0;           ///< upper end
  double hysteresis = 0;     ///< distance outside of it in which it stays active
};

class PositionCamUnit {
 public:
  /// `cams` must outlive this; those of channels that the dictionary does not have are ignored.
  PositionCamUnit(Dictionary& dictionary, unsigned lift, std::span<const Cam> cams)
      : dictionary_(&dictionary), lift_(lift), cams_(cams) {}

  /// Takes a measurement of a position unit: its cams become active or inactive. A cam that is not
  /// enabled is inactive; the polarity inverts one that is enabled. Both take effect with their
  /// present values, whatever wrote them. Linear in the number of sections that begin or end on the
  /// way since the last time, and in the number of channels.
  void update(unsigned unit, double position_millimetre);
  /// Call it when 63A1h or 63A2h was written. For a cam without a section, only the polarity
  /// counts.
  void refresh();

 private:
  static constexpr std::size_t channels_end = 255;

  /// Positions of a unit, from low to high, between which no section begins or ends: the cams do
  /// not change there.
  struct Calm {
    unsigned unit = 0;
    double low = 0;
    double high = 0;
  };

  void look_at_cams(unsigned unit, double position_millimetre);
  void tell(unsigned channel);

  Dictionary* dictionary_;
  unsigned lift_;
  std::span<const Cam> cams_;
  std::array<std::uint8_t, channels_end> on_{};  ///< by channel: true if the car is on its cams
  Calm calm_{};
};

}  // namespace canvoy::cia417
