#include "canvoy/devices/cia417/position/position_cam_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"
#include "canvoy/devices/cia417/position/car_position_unit.hpp"
#include "canvoy/profiles/cia417/car_handles.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

constexpr AccessHandlers LonePositionCamUnit::hook_calls[] = {
    after_write<&LonePositionCamUnit::position_written, position_value_object>,
    after_write<&LonePositionCamUnit::cam_setting_written, cam_enable_object, cam_polarity_object>};
constexpr ServiceHandlers LonePositionCamUnit::service_calls = {
    .reset = method<&LonePositionCamUnit::reset>, .hooks = hook_calls};

LonePositionCamUnit::LonePositionCamUnit(Node& node, const NoHardware& /*none*/,
                                         const PositionCamSettings& settings)
    : dictionary_(node.dictionary()),
      settings_(settings),
      cams_(dictionary_, settings.lift, settings.cams) {
  node.attach(service_);
}

void LonePositionCamUnit::position_written() {
  const auto position = Values(dictionary_)[in_lift(settings_.lift, position_value[1])];
  cams_.update(1, static_cast<std::int32_t>(position.raw()) * settings_.step_millimetre);
}

template <std::uint8_t channels>
PositionCamSettings PositionCamKind<channels>::settings(const Environment& environment) {
  return {.cams = environment.get<CarPositionSettings>().cams};
}

const DeviceKind position_cam_kind = {
    .info = PositionCamKind<>::info, .profile = &profile, .forms = only_form<PositionCamKind<>>};

}  // namespace canvoy::cia417
