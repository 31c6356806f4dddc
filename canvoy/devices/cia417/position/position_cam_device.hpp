// A position CAM unit in a separate device (CiA 417-4, 4.10): receives the car position of the
// position unit, and reports the cams on which the car is.
//
//     PositionCamDevice<> cams(port, 15, {.cams = stretches});
#pragma once

#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/cia417/position/position_cam_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/profiles/cia417/handles.hpp"

namespace canvoy::cia417 {

/// The lift, and the cams.
struct PositionCamSettings {
  unsigned lift = 1;               ///< 1 to 8
  std::span<const Cam> cams = {};  ///< cams of position unit 1; must outlive the device
  double step_millimetre = 0.1;    ///< one count of 6383h
};

/// A position CAM unit that does not measure itself.
class LonePositionCamUnit {
 public:
  /// Makes the unit; `node` and what `settings` refers to must outlive it.
  LonePositionCamUnit(Node& node, const NoHardware& /*none*/, const PositionCamSettings& settings);

 private:
  void reset(ResetScope /*scope*/) { cams_.refresh(); }
  void position_written();
  void cam_setting_written() { cams_.refresh(); }

  Dictionary& dictionary_;
  PositionCamSettings settings_;
  PositionCamUnit cams_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this, block_shift(settings_.lift)};
};

/// State of the cams of channel 1.
inline constexpr std::uint32_t cam_pdo_mapping[] = {mapped_in(1, cam_state_object, 1)};
/// PDO of the state of cams.
inline constexpr PdoInfo cam_pdo = {
    .cob_id = invalid_pdo | 0x180, .plus_node_id = true, .mapping = cam_pdo_mapping};
/// Its parameters as objects.
using CamPdo = canvoy::detail::PredefinedPdo<canvoy::detail::OwnPdo<cam_pdo>>;

/// Eight cams in each channel, and a heartbeat every 500 ms. Part 3 has no PDO for cams: TPDO 1 has
/// those of channel 1, and is invalid until it gets its COB-ID. Its virtual device is the position
/// unit, since part 2 has no code for cams alone.
template <std::uint8_t channels = 1>
struct PositionCamKind : LiftKind<LonePositionCamUnit, NoHardware, PositionCamSettings> {
  static constexpr DeviceInfo info = {.name = "lift-cams",
                                      .title = "position CAM unit of a car",
                                      .product = "Canvoy CiA 417 position CAM unit",
                                      .product_code = 41714,
                                      .node_id = 15};
  /// True for the pre-defined PDO of the car position of lift 1.
  static constexpr bool is_position_heard(const PdoInfo& pdo) {
    return is_pdo_of<VirtualDevice::car_drive_controller, LiftDeviceOptions{}>(pdo) &&
           MappingValue(pdo.mapping[0]).index == position_value_object.index;
  }
  static constexpr auto description =
      describe(lift_device<VirtualDevice::car_position_unit>(
                   {{0x63A0, channels}, {0x63A1, channels}, {0x63A2, channels}}),
               Part(position_value_object).consumed().up_to(1),
               predefined_pdos<profile, is_position_heard>(), CamPdo::parameter, CamPdo::mapping,
               lift_basics(info, 500));

  /// The cams of the shaft, which are those of a position unit.
  static PositionCamSettings settings(const Environment& environment);
};

/// A position CAM unit of lift 1, or of the lift of `layout`.
template <const auto& layout = layout_of<PositionCamKind<>>, std::size_t own_routes = 0>
using PositionCamDevice = Device<PositionCamKind<>, layout, own_routes>;

}  // namespace canvoy::cia417
