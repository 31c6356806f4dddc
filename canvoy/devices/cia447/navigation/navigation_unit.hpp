// The navigation system: names places, and guides to them (60C0h to 60C5h; CiA 447-3, 4.2.11).
//
//     NavigationUnit navigation(network, {.gazetteer = Gazetteer(places)}, {});
//     navigation.select({48.137, 11.575});   // the driver chooses
//
// The position of the car is from its own receiver, or else from the GPS of the network (60B0h,
// which it consumes from any sender). When that one falls silent, the position is not available
// until it is received again.
//
// A destination sent "without interrupting" waits until the car has arrived at the present one. One
// can wait; a later one replaces it.
#pragma once

#include <optional>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/car_source.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/devices/cia447/navigation/gazetteer.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::cia447 {

/// What the system knows of places and routes.
struct NavigationHardware {
  /// Its own receiver; empty: the network's GPS.
  Callback<std::optional<GeoPosition>()> position = {};
  /// Metres of road from one position to another; empty: straight-line distance.
  Callback<double(const GeoPosition& from, const GeoPosition& to)> road = {};
  /// Called when guidance to a destination starts, or ends (null).
  Callback<void(const GeoPosition* destination)> guide = {};
  Gazetteer gazetteer = {};  ///< names of places
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(NavigationHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::position; } || requires { &Plain::road; } || requires { &Plain::guide; },
      "the class has no member function of NavigationHardware: position, road or guide");
  if constexpr (requires { &Plain::position; })
    hardware.position = callback<&Plain::position>(plain);
  if constexpr (requires { &Plain::road; }) hardware.road = callback<&Plain::road>(plain);
  if constexpr (requires { &Plain::guide; }) hardware.guide = callback<&Plain::guide>(plain);
}
/// Periods and limits of guidance.
struct NavigationSettings {
  /// Period of readings of the position.
  Duration period = 1s;
  /// Distance in metres from the destination within which the car has arrived.
  double arrival = 50;
};

class NavigationUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  NavigationUnit(CarNetwork& network, const NavigationHardware& hardware,
                 const NavigationSettings& settings);

  // For the driver.

  /// Starts guidance at once, and discards a waiting destination.
  void select(const GeoPosition& destination);
  /// Ends the guidance.
  void cancel();

  /// Destination of the guidance; nothing: none.
  const std::optional<GeoPosition>& destination() const { return destination_; }
  /// Place of the car; null if the position is not known, or no place is near.
  const NamedPlace* here() const;
  /// Metres to the destination; nothing without a destination or a position.
  std::optional<double> distance() const;
  /// Destination that waits for an answer of the driver; nothing: none.
  const std::optional<GeoPosition>& waiting() const { return waiting_; }

 private:
  /// The halves of a position arrive one by one.
  struct Request {
    std::optional<double> latitude = {};
    std::optional<double> longitude = {};

    std::optional<GeoPosition> position() const {
      if (!latitude || !longitude) return std::nullopt;
      return GeoPosition{*latitude, *longitude};
    }
  };

  void reset(ResetScope scope);
  void position_written(Source source) { gps_.came(source); }
  void position_lost();
  AbortCode refuses(const Commanded& wanted);
  void commanded(const Commanded& wanted);
  void describe();
  void report_current_position();
  void start(bool interrupts);
  void look(Time now);
  void follow();
  void report_distance();
  std::optional<GeoPosition> position() const;
  bool has_failed() const;

  CarNetwork& network_;
  NavigationHardware hardware_;
  NavigationSettings settings_;
  Values values_;
  Request described_;
  Request wanted_;
  std::optional<GeoPosition> destination_;
  std::optional<GeoPosition> waiting_;
  CarSource gps_;
  Commands commands_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

/// Catalogue row of the navigation system (4.2.11); car_unit makes it a part of a device.
struct NavigationKind : CarKind<NavigationUnit, NavigationHardware, NavigationSettings> {
  static constexpr DeviceInfo info = {.name = "navigation",
                                      .title = "navigation system",
                                      .product = "Canvoy CiA 447 navigation system",
                                      .product_code = 44708,
                                      .node_id = 4,
                                      .hardware = "a position, a map of places, a driver"};
  static constexpr const VirtualDeviceInfo& provides = navigation_system_device;
  static constexpr const ObjectInfo* consumes[] = {&gps_current_position_object};
};

}  // namespace canvoy::cia447
