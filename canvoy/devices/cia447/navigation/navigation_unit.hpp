// The navigation system: names places, and leads to them (60C0h to 60C5h; CiA 447-3, 4.2.11).
//
//     NavigationUnit navigation(network, {.gazetteer = Gazetteer(places)}, {});
//     navigation.select({48.137, 11.575});   // the driver chooses
//
// Where the car is, its own receiver says, or else the GPS of the network (60B0h, which it consumes
// from whoever sends it): when that one falls silent, the position is not available, until it is
// heard again.
//
// A destination that is to be taken "without interrupting" waits until the car has arrived at the
// present one; one can wait, and a later one takes its place.
#pragma once

#include <optional>

#include "canvoy/devices/cia447/car_kind.hpp"
#include "canvoy/devices/cia447/car_source.hpp"
#include "canvoy/devices/cia447/commands.hpp"
#include "canvoy/devices/cia447/navigation/gazetteer.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::cia447 {

struct NavigationHardware {
  /// Its own receiver; empty: the network's GPS.
  Callback<std::optional<GeoPosition>()> position = {};
  /// Metres of road from one position to another; empty: as the crow flies.
  Callback<double(const GeoPosition& from, const GeoPosition& to)> road = {};
  /// Guidance begins to a destination, or ends (null).
  Callback<void(const GeoPosition* destination)> guide = {};
  Gazetteer gazetteer = {};
};
struct NavigationSettings {
  /// How often the position is looked at.
  Duration period = 1s;
  /// Metres from the destination within which the car has arrived.
  double arrival = 50;
};

class NavigationUnit {
 public:
  /// What `hardware` refers to must outlive this.
  NavigationUnit(CarNetwork& network, const NavigationHardware& hardware,
                 const NavigationSettings& settings);
  NavigationUnit(const NavigationUnit&) = delete;
  NavigationUnit& operator=(const NavigationUnit&) = delete;

  // The driver.

  /// At once; what waits is forgotten.
  void select(const GeoPosition& destination);
  void cancel();

  const std::optional<GeoPosition>& destination() const { return destination_; }
  /// Where the car is: null, where nobody knows, or no place is near.
  const NamedPlace* here() const;
  /// Metres to the destination; nothing without one, and without a position.
  std::optional<double> distance() const;
  const std::optional<GeoPosition>& waiting() const { return waiting_; }

 private:
  /// Halves of a position come one by one.
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
  void tell_current_position();
  void start(bool interrupts);
  void look(Time now);
  void follow();
  void tell_distance();
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
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
};

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
