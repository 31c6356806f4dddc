#include "canvoy/devices/cia417/position/position_cam_device.hpp"

#include "canvoy/devices/cia417/kinds.hpp"
#include "canvoy/devices/cia417/position/car_position_unit.hpp"
#include "canvoy/profiles/cia417/car_handles.hpp"

namespace canvoy::cia417 {

LonePositionCamUnit::LonePositionCamUnit(Node& node, const NoHardware& /*none*/,
                                         const PositionCamSettings& settings)
    : dictionary_(node.dictionary()),
      settings_(settings),
      cams_(dictionary_, settings.lift, settings.cams) {
  hook_.first = in_lift(settings.lift, position_value[1]).index();
  hook_.last = in_lift(settings.lift, cam_polarity(1)).index();
  hook_.after_write =
      Callback<void(const Entry&, Source)>::to<&LonePositionCamUnit::written>(*this);
  dictionary_.attach(hook_);
  service_.reset = Callback<void(ResetScope)>::to<&LonePositionCamUnit::reset>(*this);
  node.attach(service_);
}

void LonePositionCamUnit::written(const Entry& entry, Source) {
  const auto position = Values(dictionary_)[in_lift(settings_.lift, position_value[1])];
  if (entry.index == hook_.first) {
    cams_.update(1, static_cast<std::int32_t>(position.raw()) * settings_.step_millimetre);
  } else if (entry.index != in_lift(settings_.lift, cam_state(1)).index()) {
    cams_.refresh();
  }
}

template <std::uint8_t channels>
PositionCamSettings PositionCamKind<channels>::settings(const Site& site) {
  return {.cams = site.find<CarPositionSettings>().cams};
}

const DeviceKind position_cam_kind = {
    .info = PositionCamKind<>::info, .profile = &profile, .forms = only_form<PositionCamKind<>>};

}  // namespace canvoy::cia417
