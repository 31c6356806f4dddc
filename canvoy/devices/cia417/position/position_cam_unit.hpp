// A position CAM unit: which cams the car is on (63A0h to 63A2h; CiA 417-4, 4.10). Where the cams
// are no object says, so the maker does.
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

/// A stretch of the shaft, in millimetres of the position unit. A cam may have several: it is
/// active on each of them.
struct Cam {
  std::uint8_t channel = 1;  ///< 1 to 254
  std::uint8_t number = 1;   ///< of this channel, 1 to 8
  std::uint8_t unit = 1;     ///< that measures it
  double low = 0;
  double high = 0;
  double hysteresis = 0;  ///< so far outside it stays active
};

class PositionCamUnit {
 public:
  /// `cams` must outlive this; those of channels that the dictionary does not have do nothing.
  PositionCamUnit(Dictionary& dictionary, unsigned lift, std::span<const Cam> cams)
      : dictionary_(&dictionary), lift_(lift), cams_(cams) {}

  /// A position unit has measured: the cams that it is for become active or inactive. A cam that is
  /// not enabled is inactive; the polarity inverts one that is: as they stand now, whoever wrote
  /// them. Linear in the number of stretches where one begins or ends since the last time, and in
  /// that of channels.
  void update(unsigned unit, double position_millimetre);
  /// 63A1h or 63A2h were written. Of a cam without a stretch the polarity alone speaks.
  void refresh();

 private:
  static constexpr std::size_t channels_end = 255;

  /// Positions of a unit, from low to high, between which no stretch begins or ends: there the cams
  /// are as they were found.
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
  std::array<std::uint8_t, channels_end> on_{};  ///< by channel: whether the car is on its cams
  Calm calm_{};
};

}  // namespace canvoy::cia417
