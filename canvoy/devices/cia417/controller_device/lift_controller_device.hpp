// A whole lift controller: call controller, car door controller and car drive controller in one
// node, which is the NMT master of the lift's bus, and the control of its trips.
//
//     LiftControllerDevice<> controller(port, 1, {.lift = {.floors = positions}});
//     controller.node().start(now);
//     controller.lift().floor()
//
// The controller monitors the heartbeats of all units and panels of the lift (1016h), and receives
// the emergencies of its units (1028h): by default those with recommended node-IDs. The loss of a
// node is reported by emergency 8130h with its node-ID. If a unit that a trip needs is silent or
// reports an error, the lift stops (LiftFault). Nodes that boot, or are found in pre-operational,
// are started. A node that comes or returns may have missed messages of this node, and vice versa:
// the state of units is requested, the inputs of all other nodes are read, and all outputs are sent
// (see ReturnedPanels). The same is done after a sign of lost frames (see GapWatch), and while the
// lift waits without an answer.
#pragma once

#include <array>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia417/call/call_controller.hpp"
#include "canvoy/devices/cia417/call/call_panels.hpp"
#include "canvoy/devices/cia417/call/returned_panels.hpp"
#include "canvoy/devices/cia417/controller/lift_controller.hpp"
#include "canvoy/devices/cia417/controller/lift_units.hpp"
#include "canvoy/devices/cia417/controller/unit_errors.hpp"
#include "canvoy/devices/cia417/door/car_door_controller.hpp"
#include "canvoy/devices/cia417/drive/car_drive_controller.hpp"
#include "canvoy/devices/cia417/kit/bus_warning.hpp"
#include "canvoy/devices/cia417/kit/lift_number.hpp"
#include "canvoy/devices/cia417/load/load_signals.hpp"
#include "canvoy/devices/cia417/panel/panel_description.hpp"
#include "canvoy/devices/cia417/virtual_io/multiplexed_panels.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_input_rpdos.hpp"
#include "canvoy/devices/kit/device.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"
#include "canvoy/profiles/model/device_values.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia417 {

// The parts of a lift controller: call controller, car door controller and car drive controller in
// one device, with the objects and pre-defined PDOs of all three (CiA 417-4, 4.2.1).
//
//     constexpr auto mine = describe(lift_controller<LiftControllerOptions{.lift = 2}>(),
//                                    cia301::identity({.vendor_id = 0x123}));

/// What a lift controller has room for.
struct LiftControllerOptions {
  unsigned lift = 1;      ///< 1 to 8
  unsigned panels = 127;  ///< virtual inputs of node-IDs up to this one are received
  /// Number of outputs of panels that are listed from 6200h on, six bytes each; 0: none.
  unsigned outputs = 254;
  /// Panels are also received by multiplexed PDOs, in this mode by default: two KiB.
  /// MpdoMode::none: they are not.
  MpdoMode multiplexed = MpdoMode::destination;
};

namespace detail {

inline constexpr VirtualDevice controllers[] = {VirtualDevice::call_controller,
                                                VirtualDevice::car_door_controller,
                                                VirtualDevice::car_drive_controller};

template <unsigned lift>
constexpr bool is_pdo_of_controller(const PdoInfo& pdo) {
  constexpr LiftDeviceOptions options{.lift = lift};
  return is_pdo_of<VirtualDevice::call_controller, options>(pdo) ||
         is_pdo_of<VirtualDevice::car_door_controller, options>(pdo) ||
         is_pdo_of<VirtualDevice::car_drive_controller, options>(pdo);
}

template <std::size_t capacity>
constexpr void add_controllers(DeviceDescription<capacity>& own, unsigned outputs) {
  add_virtual_device(own, profile, info_of(VirtualDevice::call_controller),
                     {0x6010, 0x6011, 0x6482});
  add_groups<VirtualDevice::call_controller>(own, output_group_object.index, outputs, false);
  add_virtual_device(own, profile, info_of(VirtualDevice::car_door_controller),
                     {0x6300, 0x6301, 0x6302, 0x6310});
  add_virtual_device(
      own, profile, info_of(VirtualDevice::car_drive_controller),
      {0x6383, 0x6400, 0x6401, 0x6403, 0x6404, 0x6406, 0x6420, 0x6430, 0x6431, 0x6432, 0x6433});
}

constexpr EntryInfo controller_type(std::uint8_t number) {
  EntryInfo entry = at(number, virtual_device_type);
  entry.initial = device_type(controllers[number - 1]) >> 16;
  return entry;
}
inline constexpr EntryInfo controller_type_entries[] = {supported_virtual_device_types_entries[0],
                                                        controller_type(1), controller_type(2),
                                                        controller_type(3)};
/// 6000h names all three.
inline constexpr ObjectInfo controller_types_object =
    with_subs(supported_virtual_device_types_object, controller_type_entries);

}  // namespace detail

/// All parts of the controller except its identity; the objects are those of lift `options.lift`.
template <LiftControllerOptions options = LiftControllerOptions{}>
constexpr auto lift_controller() {
  static_assert(options.lift >= 1 && options.lift <= lift_count, "there are 8 lifts");
  static_assert(options.outputs <= group_count * last_of_many, "32 groups of 254 outputs");
  DeviceDescription<80> own;
  detail::add_controllers(own, options.outputs);
  DeviceDescription<152> parts;
  parts.add(cia301::profile);
  parts.add(profile);
  parts.add(cia301::device_type(device_type(VirtualDevice::several)));
  parts.add(cia301::error_register_object);
  parts.add(detail::controller_types_object);
  for (const Part& part : own) {
    if (part.index() == lift_number_object.index) {
      parts.add(part.initial(1U << (options.lift - 1)));
    } else {
      parts.add(is_of_lift(part.index()) ? part.moved((options.lift - 1) * block_pitch) : part);
    }
  }
  constexpr auto is_mine = [](const PdoInfo& pdo) {
    return detail::is_pdo_of_controller<options.lift>(pdo);
  };
  parts.add(predefined_pdos<profile, is_mine>());
  parts.add(virtual_input_rpdos<options.panels>());
  if constexpr (options.multiplexed != MpdoMode::none) {
    parts.add(multiplexed_panels<options.multiplexed, options.panels>());
  }
  return parts;
}

/// Settings of the controllers in the device.
struct LiftControllerDeviceSettings {
  CallControllerSettings calls{};      ///< call controller
  CarDoorControllerSettings doors{};   ///< car door controller
  CarDriveControllerSettings drive{};  ///< car drive controller
  LiftControllerSettings lift{};       ///< trips
  NodeId load_unit = 13;               ///< 0: the car is not weighed
  /// Panels and other monitored devices of the lift that are not needed; must outlive the device.
  std::span<const NodeId> others = recommended_others;
  /// Outputs of panels that 6200h lists; must outlive the device.
  std::span<const VirtualOutput> outputs{};
  /// Starts the other nodes, and its own.
  bool manage_network = true;
};

/// Minimum time between two emergencies (1015h, in 100 us). A cut cable may cause a hundred of
/// them: at this distance, at most one of them delays a PDO.
inline constexpr std::uint16_t lift_emergency_inhibit = 20;

/// Of the catalogue.
inline constexpr DeviceInfo lift_controller_info = {
    .name = "lift-controller",
    .title = "lift controller: calls, doors and drive of a lift",
    .product = "Canvoy CiA 417 lift controller",
    .product_code = 41700,
    .node_id = 1};

/// A heartbeat every 300 ms; room to monitor all nodes, and to receive their emergencies.
template <LiftControllerOptions options = LiftControllerOptions{}>
inline constexpr auto full_lift_controller = describe(
    lift_controller<options>(),
    cia301::identity({.product_code = lift_controller_info.product_code}),
    cia301::names({.device = lift_controller_info.product,
                   .hardware_version = "simulated",
                   .software_version = "0.1.0"}),
    cia301::sync_consumer(), cia301::heartbeat_producer(300),
    cia301::heartbeat_consumers(node_id_max),
    cia301::emergency().initial(cia301::emergency_inhibit_object, 0, lift_emergency_inhibit),
    cia301::emergency_consumers(node_id_max), cia301::error_history(16),
    cia301::error_behavior().initial(1, keeps_state));
/// Tables of full_lift_controller, for any of the 8 lifts.
template <LiftControllerOptions options = LiftControllerOptions{}>
inline constexpr auto full_lift_controller_layout =
    in_any_lift(lay_out_device<full_lift_controller<options>>());

/// `layout` has a description with lift_controller<options>(); `destinations` is the maximum number
/// of waiting destination calls.
template <LiftControllerOptions options = LiftControllerOptions{},
          const auto& layout = full_lift_controller_layout<options>,
          std::size_t destinations = destinations_default, std::size_t further_routes = 0>
class LiftControllerDevice
    : public DeviceValues<LiftControllerDevice<options, layout, destinations, further_routes>,
                          layout> {
 public:
  /// The lift in `settings` is that of `options`, and the doors are those of the door controller.
  /// The context of `port` must outlive the device.
  LiftControllerDevice(const Port& port, NodeId node_id,
                       const LiftControllerDeviceSettings& settings)
      : manages_(settings.manage_network),
        device_(port, node_id, settings.manage_network),
        nmt_master_(node(), remote_nodes_),
        client_(node()),
        register_client_(node()),
        key_client_(node()),
        calls_(node(), device_.tpdos(), destinations_, of_lift(settings.calls)),
        panels_(node(), calls_, settings.outputs),
        returned_(node(), key_client_, calls_),
        doors_(node(), of_lift(settings.doors), &device_.rpdos()),
        drive_(node(), {.rpdos = &device_.rpdos(), .tpdos = &device_.tpdos(), .client = &client_},
               between(settings.lift.floors, of_lift(settings.drive))),
        load_(node(), device_.rpdos(), device_.heartbeat_consumer(),
              {.lift = options.lift, .load_unit = settings.load_unit}),
        units_(units_of(settings)),
        errors_(node(), device_.emergency_consumer(), register_client_, units_),
        lift_(node(), calls_,
              errors_.guard({.motion = drive_.interface(),
                             .doors = doors_.interface(),
                             .load = load_.interface(),
                             .ask_anew = callback<&LiftControllerDevice::ask_units_anew>(*this)}),
              with_doors(settings.lift, settings.doors.doors)) {
    const auto update = Callback<void()>::template to<&LiftController::update>(lift_);
    doors_.on_change(update);
    drive_.on_change(update);
    load_.on_change(update);
    errors_.on_change(update);
    errors_.on_emergency(callback<&LiftControllerDevice::told>(*this));
    returned_.on_question(callback<&LiftControllerDevice::has_inputs>(*this));
    nmt_master_.on_message(callback<&LiftControllerDevice::heard>(*this));
    nmt_master_.on_change(callback<&LiftControllerDevice::network_changed>(*this));
    node().on_defaults_restored(callback<&LiftControllerDevice::restored>(*this));
    service_.state_entered = callback<&LiftControllerDevice::state_entered>(*this);
    node().attach(service_);
  }

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// The node, for its states and counters.
  const Node& node() const { return device_.node(); }
  /// The call controller in the device.
  CallController& calls() { return calls_; }
  /// The car door controller in the device.
  CarDoorController& doors() { return doors_; }
  /// The car drive controller in the device.
  CarDriveController& drive() { return drive_; }
  /// Control of trips.
  LiftController& lift() { return lift_; }
  /// Control of trips.
  const LiftController& lift() const { return lift_; }
  /// States of all nodes on the bus of the lift.
  NmtMaster& nmt_master() { return nmt_master_; }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  /// The NMT master receives all nodes, and each SDO client one.
  static constexpr std::size_t own_routes = node_id_max + 3 + further_routes;

  template <class Settings>
  static constexpr Settings of_lift(Settings settings) {
    settings.lift = options.lift;
    return settings;
  }
  static constexpr CarDriveControllerSettings between(std::span<const std::int32_t> floors,
                                                      CarDriveControllerSettings settings) {
    if (floors.empty()) return settings;
    settings.lowest_micrometre = floors.front();
    settings.highest_micrometre = floors.back();
    return settings;
  }
  static constexpr LiftControllerSettings with_doors(LiftControllerSettings settings,
                                                     DoorMask doors) {
    settings.doors = doors;
    return settings;
  }
  static constexpr LiftUnits units_of(const LiftControllerDeviceSettings& settings) {
    return {.drive = settings.drive.drive,
            .position_unit = settings.drive.position_unit,
            .door_units = settings.doors.door_units,
            .light_barrier_units = settings.doors.light_barrier_units,
            .load_unit = settings.load_unit,
            .others = settings.others};
  }
  void restored(ResetScope) {
    panels_.use(options.panels);
    watch(node().dictionary(), units_);
  }
  void state_entered(NmtState state) {
    if (manages_ && state == NmtState::operational) {
      const bool is_sent = nmt_master_.command(NmtMaster::all_nodes, NmtCommand::start);
      is_to_be_started_.fill(!is_sent);
    }
  }
  void lift_changed(std::uint8_t lift) {
    if (lift == calls_.lift_mask()) return;
    drive_.begin_anew();
    doors_.begin_anew();
    load_.begin_anew();
    calls_.set_lift_mask(lift);
    lift_.update();
  }
  bool has_inputs(NodeId id) { return !units_.has(id); }
  void network_changed(NodeId id, RemoteState state) {
    if (state == RemoteState::boot_up) errors_.booted(id);
    doors_.heard(id, state);
    drive_.heard(id, state);
    load_.heard(id, state);
    returned_.heard(id, state);
    const bool waits = state == RemoteState::boot_up || state == RemoteState::pre_operational;
    if (manages_ && waits && node().state() == NmtState::operational) start(id);
  }
  void told(NodeId unit, const Emergency& emergency) { gaps_.heard(unit, emergency); }
  void ask_units_anew() {
    drive_.ask_anew();
    doors_.ask_anew();
    load_.ask_anew();
  }
  void ask_anew(NodeId id) {
    if (id == GapWatch::everyone || units_.has(id)) {
      ask_units_anew();
      errors_.ask_anew();
    }
    returned_.ask_anew(id);
  }
  /// Handles each heartbeat: repeats a command that found no room, for example behind a cut cable.
  void heard(NodeId id, RemoteState state) {
    gaps_.heard(id, state);
    const bool waits = state == RemoteState::pre_operational && is_to_be_started_[id];
    if (waits && node().state() == NmtState::operational) start(id);
  }
  void start(NodeId id) { is_to_be_started_[id] = !nmt_master_.command(id, NmtCommand::start); }

  bool manages_;
  /// Room for the loss of all nodes at once: their errors, and those of the lift.
  static constexpr std::size_t errors_max = node_id_max + 17;

  DeviceNode<layout, own_routes, true, 16, errors_max> device_;
  BusWarning bus_warning_{device_.node()};
  LiftNumber lift_number_{device_.node(),
                          {.refuses = callback<&LiftController::refuses_lift_number>(lift_),
                           .changed = callback<&LiftControllerDevice::lift_changed>(*this)}};
  std::array<NmtMaster::RemoteNode, node_id_max> remote_nodes_;
  NmtMaster nmt_master_;
  std::array<bool, node_id_max + 1> is_to_be_started_{};  ///< a command found no room
  SdoClient client_;
  SdoClient register_client_;
  SdoClient key_client_;
  std::array<CallController::Destination, destinations> destinations_;
  CallController calls_;
  CallPanels<layout> panels_;
  ReturnedPanels returned_;
  CarDoorController doors_;
  CarDriveController drive_;
  LoadSignals load_;
  LiftUnits units_;
  UnitErrors errors_;
  LiftController lift_;
  std::array<GapWatch::Rhythm, node_id_max> rhythms_;
  GapWatch gaps_{node(), callback<&LiftControllerDevice::ask_anew>(*this), rhythms_};
  Service service_;
};

}  // namespace canvoy::cia417
