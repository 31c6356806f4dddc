#include "canvoy/devices/cia417/position_cam_unit.hpp"

#include "canvoy/profiles/cia417/car_handles.hpp"

namespace canvoy::cia417 {

void PositionCamUnit::update(unsigned unit, double position_millimetre) {
  for (const Cam& cam : cams_) {
    if (cam.unit != unit || cam.channel == 0 || cam.channel >= on_.size()) continue;
    const auto bit = static_cast<std::uint8_t>(1U << (cam.number - 1));
    std::uint8_t& on = on_[cam.channel];
    const double margin = (on & bit) != 0 ? cam.hysteresis : 0;
    const bool is_on =
        position_millimetre >= cam.low - margin && position_millimetre <= cam.high + margin;
    const auto now = static_cast<std::uint8_t>(is_on ? on | bit : on & ~bit);
    if (now == on) continue;
    on = now;
    tell(cam.channel);
  }
}

void PositionCamUnit::refresh() {
  for (const Cam& cam : cams_) tell(cam.channel);
}

void PositionCamUnit::tell(unsigned channel) {
  const Values values(*dictionary_);
  const auto enabled = values[in_lift(lift_, cam_enable(channel))].raw();
  const auto inverted = values[in_lift(lift_, cam_polarity(channel))].raw();
  values[in_lift(lift_, cam_state(channel))] = (on_[channel] ^ inverted) & enabled;
}

}  // namespace canvoy::cia417
