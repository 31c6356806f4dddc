#include "canvoy/devices/cia417/position/position_cam_unit.hpp"

#include <algorithm>
#include <limits>

#include "canvoy/profiles/cia417/car_handles.hpp"

namespace canvoy::cia417 {

void PositionCamUnit::update(unsigned unit, double position_millimetre) {
  const bool is_calm =
      unit == calm_.unit && position_millimetre > calm_.low && position_millimetre < calm_.high;
  if (!is_calm) look_at_cams(unit, position_millimetre);
  refresh();
}

/// A tall shaft has hundreds of sections, and hundreds of measurements are made on the way past
/// one.
void PositionCamUnit::look_at_cams(unsigned unit, double position_millimetre) {
  std::array<std::uint8_t, channels_end> measured{};
  std::array<std::uint8_t, channels_end> reached{};
  Calm calm{unit, -std::numeric_limits<double>::infinity(),
            std::numeric_limits<double>::infinity()};
  const auto ends_at = [&calm, position_millimetre](double edge) {
    if (edge <= position_millimetre) calm.low = std::max(calm.low, edge);
    if (edge >= position_millimetre) calm.high = std::min(calm.high, edge);
  };
  for (const Cam& cam : cams_) {
    if (cam.unit != unit || cam.channel == 0 || cam.channel >= channels_end) continue;
    const auto bit = static_cast<std::uint8_t>(1U << (cam.number - 1));
    const double margin = (on_[cam.channel] & bit) != 0 ? cam.hysteresis : 0;
    const bool is_on =
        position_millimetre >= cam.low - margin && position_millimetre <= cam.high + margin;
    measured[cam.channel] |= bit;
    if (is_on) reached[cam.channel] |= bit;
    for (const double edge :
         {cam.low - cam.hysteresis, cam.low, cam.high, cam.high + cam.hysteresis}) {
      ends_at(edge);
    }
  }
  for (std::size_t channel = 1; channel < channels_end; ++channel) {
    on_[channel] =
        static_cast<std::uint8_t>((on_[channel] & ~measured[channel]) | reached[channel]);
  }
  calm_ = calm;
}

void PositionCamUnit::refresh() {
  const std::uint16_t index = in_lift(lift_, cam_state(1)).index();
  const auto channels = static_cast<unsigned>(dictionary_->number(index, 0));
  for (unsigned channel = 1; channel <= channels; ++channel) tell(channel);
}

void PositionCamUnit::tell(unsigned channel) {
  const Values values(*dictionary_);
  const auto enabled = values[in_lift(lift_, cam_enable(channel))].raw();
  const auto inverted = values[in_lift(lift_, cam_polarity(channel))].raw();
  values[in_lift(lift_, cam_state(channel))] = (on_[channel] ^ inverted) & enabled;
}

}  // namespace canvoy::cia417
