// What another device has of the navigation system, as its SDO client (CiA 447-3, 4.2.11): where
// the car is (60C4h, 60C5h), how far the destination is (60C0h), what is there (60C1h, 60C2h); and
// it has the car led there (60C3h).
//
//     NavigationClient navigation(network, {.navigation = 7, .changed = ...});
//     navigation.guide({48.2, 11.575});
//     show(navigation.street(), navigation.metres());
//
// It asks in rounds. A system that was lost and comes back is told the destination anew; while it
// does not answer, nothing is known.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/devices/cia447/navigation/geography.hpp"

namespace canvoy::cia447 {

struct NavigationClientSettings {
  NodeId navigation = 0;  ///< 1 to 16, another node
  Duration period = 1s;   ///< of the rounds
  Duration time_out = 500ms;
  /// After each round, and when the system was lost.
  Callback<void()> changed = {};
};

/// It has to be made before the node starts. It takes on_lost() of the network, and calls who was
/// called before.
class NavigationClient {
 public:
  /// Bytes of UTF-8; a name that is longer is not known.
  static constexpr std::size_t name_max = 64;

  NavigationClient(CarNetwork& network, const NavigationClientSettings& settings);
  NavigationClient(const NavigationClient&) = delete;
  NavigationClient& operator=(const NavigationClient&) = delete;

  /// At once, whatever the system was at.
  void guide(const GeoPosition& destination);
  /// No object ends a guidance: the system leads on, and this device does not ask for it any more.
  void forget_destination();

  // What was answered last; empty where the system does not know, or does not answer.

  std::string_view city() const { return city_.view(); }
  std::string_view street() const { return street_.view(); }
  std::string_view destination_street() const { return destination_street_.view(); }
  std::optional<double> metres() const { return metres_; }

 private:
  /// Of a round, in this order.
  enum class Step : std::uint8_t {
    guide_latitude,
    guide_longitude,
    guide_start,
    describe_latitude,
    describe_longitude,
    destination_street,
    ask_position,
    city,
    street,
    how_far,
    none,
  };
  struct PlaceName {
    std::array<std::uint8_t, name_max> bytes{};
    std::size_t length = 0;
    std::string_view view() const { return {reinterpret_cast<const char*>(bytes.data()), length}; }
  };

  void reset(ResetScope scope);
  void lost(NodeId node);
  void forget_answers();
  void begin(Time now);
  void ask(Step step);
  std::uint32_t value_to_write() const;
  void answered(SdoClient::Outcome outcome);
  void take(SdoClient::Outcome outcome);
  void take_distance(std::size_t length);
  Step after(SdoClient::Outcome outcome);
  void end();

  CarNetwork& network_;
  NavigationClientSettings settings_;
  SdoClient client_;
  Callback<void(NodeId)> next_lost_;
  std::optional<GeoPosition> destination_;
  GeoPosition telling_;  ///< a destination that is on its way
  bool is_guided_ = false;
  bool is_described_ = false;
  Step step_ = Step::none;
  PlaceName name_;  ///< that comes
  PlaceName city_;
  PlaceName street_;
  PlaceName destination_street_;
  std::optional<double> metres_;
  std::array<std::uint8_t, 4> value_{};
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia447
