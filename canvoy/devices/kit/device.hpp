// A whole device, made of a unit: its dictionary, its node with all required services, and the
// unit, which is the behaviour of one virtual device.
//
//     Device<cia417::LoadKind<>> load(port, 13, hardware, {.tare_kg = 900});
//     load.node().start(now);
//     load.unit().hardware_changed();
//
// A kind describes such devices once:
//
//     struct LoadKind {
//       static constexpr DeviceInfo info = {.name = "lift-load", ...};  // for people
//       static constexpr auto description = describe(...);  // its objects; a maker has its own
//       template <const auto& device> static constexpr auto lay_out();  // its memory
//       using Unit = cia417::LoadMeasuringUnit;
//       using Hardware = cia417::LoadHardware;  // or NoHardware
//       using Settings = cia417::LoadSettings;
//       // What its profile wants of all devices, or NoProfileBehaviour.
//       using ProfileBehaviour = cia417::LiftBehaviour;
//       static Hardware simulated();    // for the catalogue, where an idle one will not do
//       static Settings fit(Settings);  // to what the description says
//       template <class Made, class Services>  // Made is Unit, or UnitOn<layout>
//       static Made make(Services&, const Hardware&, const Settings&);
//       template <class Services>
//       static void connect(Services&, Unit&);  // where there is need
//     };
//
// KindOf has defaults for all of them except the first two. A unit with memory that depends on the
// dictionary is Kind::UnitOn<layout>. The catalogue (catalogue.hpp) makes a row of a kind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/devices/kit/plain_hardware.hpp"
#include "canvoy/profiles/model/device_values.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy {

/// Description of a kind of device for users.
struct DeviceInfo {
  std::string_view name;           ///< as users type it: "lift-load"
  std::string_view title;          ///< "load measuring unit of a lift car"
  const char* product = "";        ///< its device name (1008h)
  std::uint32_t product_code = 0;  ///< 1018h:02h
  NodeId node_id = 0;              ///< the default
  std::string_view hardware = {};  ///< connections of a real device; empty: none
};

/// Hardware of a device that has none.
struct NoHardware {};

/// For devices of a profile without common behaviour.
struct NoProfileBehaviour {
  /// Does nothing.
  template <class Unit>
  constexpr NoProfileBehaviour(Node& /*node*/, Unit& /*unit*/) {}
};

/// Defaults for the members of a kind; see the top of this header for the whole list.
template <class UnitType, class HardwareType, class SettingsType>
struct KindOf {
  using Unit = UnitType;                        ///< behaviour of the virtual device
  using Hardware = HardwareType;                ///< what the unit senses and drives
  using Settings = SettingsType;                ///< what no object of the dictionary sets
  using ProfileBehaviour = NoProfileBehaviour;  ///< of all devices of its profile
  static constexpr std::size_t routes = 0;      ///< CAN-IDs that the unit itself receives

  /// Tables of a device with this description, or of a maker's with more objects.
  template <const auto& device>
  static constexpr auto lay_out() {
    return lay_out_device<device>();
  }
  /// Settings as the description allows them.
  static constexpr Settings fit(const Settings& settings) { return settings; }
  /// Constructs the unit in its place in the device.
  template <class Made, class Services>
  static Made make(Services& services, const Hardware& hardware, const Settings& settings) {
    return Made(services.node(), hardware, settings);
  }
};

namespace detail {

template <class Kind, const auto& layout>
struct UnitOn {
  using Type = typename Kind::Unit;
};
template <class Kind, const auto& layout>
  requires requires { typename Kind::template UnitOn<layout>; }
struct UnitOn<Kind, layout> {
  using Type = typename Kind::template UnitOn<layout>;
};

}  // namespace detail

/// Tables of a kind with its own description, made once.
template <class Kind>
inline constexpr auto layout_of = Kind::template lay_out<Kind::description>();

/// `layout` has a description with the objects that the kind's unit uses; `own_routes` are as in
/// DeviceNode.
template <class Kind, const auto& layout = layout_of<Kind>, std::size_t own_routes = 0>
class Device : public DeviceValues<Device<Kind, layout, own_routes>, layout> {
 public:
  using Unit = typename detail::UnitOn<Kind, layout>::Type;  ///< behaviour of the virtual device
  using Hardware = typename Kind::Hardware;                  ///< what the unit senses and drives
  using Settings = typename Kind::Settings;  ///< what no object of the dictionary sets

  /// The context of `port`, and everything to which `hardware` and `settings` refer, must outlive
  /// the device.
  Device(const Port& port, NodeId node_id, const Hardware& hardware, const Settings& settings = {})
    requires(!std::is_same_v<Hardware, NoHardware>)
      : services_(port, node_id), unit_(made(hardware, settings)) {
    connect();
  }
  /// The same for hardware that is a plain class, whose members are found by their names.
  template <PlainHardware<Hardware> Plain>
  Device(const Port& port, NodeId node_id, Plain& hardware, const Settings& settings = {})
      : Device(port, node_id, hardware_of<Hardware>(hardware), settings) {}
  /// The context of `port`, and everything to which `settings` refers, must outlive the device.
  explicit Device(const Port& port, NodeId node_id, const Settings& settings = {})
    requires std::is_same_v<Hardware, NoHardware>
      : services_(port, node_id), unit_(made(NoHardware{}, settings)) {
    connect();
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return services_.node(); }
  /// The node, for its states and counters.
  const Node& node() const { return services_.node(); }
  /// Behaviour of the virtual device.
  Unit& unit() { return unit_; }
  /// Behaviour of the virtual device.
  const Unit& unit() const { return unit_; }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return services_.emergency_producer(); }

 private:
  Unit made(const Hardware& hardware, const Settings& settings) {
    return Kind::template make<Unit>(services_, hardware, Kind::fit(settings));
  }
  void connect() {
    if constexpr (requires { Kind::connect(services_, unit_); }) Kind::connect(services_, unit_);
  }

  DeviceNode<layout, Kind::routes + own_routes> services_;
  [[no_unique_address]] typename Kind::ProfileBehaviour manners_{services_.node(), unit_};
  Unit unit_;
};

}  // namespace canvoy
