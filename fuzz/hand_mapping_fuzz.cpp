// Arbitrary text as the mapping of an input device (canvoy device operator --joystick): it is
// refused, or any value of its axes gives a position.
#include <cstdint>
#include <string_view>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/seat/hand_mapping.hpp"
#include "fuzz/require.hpp"

namespace {

using namespace canvoy;

constexpr cia852::OperatorEnvironment elements = {.joysticks = 2,
                                                  .foot_pedals = 2,
                                                  .encoders = 1,
                                                  .wheels = 2,
                                                  .push_button_clusters = 1,
                                                  .indicator_clusters = 1};

/// A device with axes from 0 to 1023.
void check_axis(const tools::HandAxis& axis) {
  for (const bool is_pedal : {false, true}) {
    const tools::AxisCalibration whole = axis.calibration.completed(0, 1023, is_pedal);
    if (!whole.complaint().empty()) continue;
    int last = whole.position(-1e9);
    const int first = last;
    const int end = whole.position(1e9);
    for (int value = -2000; value <= 2000; value += 50) {
      const int position = whole.position(value);
      // It is monotonic.
      fuzz::require(first <= end ? position >= last : position <= last);
      last = position;
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tools::HandMapping mapping;
  try {
    tools::TomlFile file("stick.toml", std::string_view(reinterpret_cast<const char*>(data), size));
    mapping = tools::read_hand_mapping(file, elements);
  } catch (const tools::Failure&) {
    return 0;
  }
  fuzz::require(!mapping.device.empty());
  fuzz::require(!mapping.axes.empty() || !mapping.buttons.empty() || !mapping.lights.empty());
  for (const tools::HandAxis& axis : mapping.axes) check_axis(axis);
  for (const tools::HandLight& light : mapping.lights) {
    fuzz::require(light.cluster == 1 && light.indicator >= 1 && light.indicator <= 64);
  }
  return 0;
}
