// Access of another device to the navigation system, as its SDO client (CiA 447-3, 4.2.11): reads
// the position of the car (60C4h, 60C5h), the distance to the destination (60C0h) and its names
// (60C1h, 60C2h), and starts guidance (60C3h).
//
//     NavigationClient navigation(network, {.navigation = 7, .changed = ...});
//     navigation.guide({48.2, 11.575});
//     show(navigation.street(), navigation.metres());
//
// It reads in rounds. A system that was lost and returns gets the destination again. While it does
// not answer, no value is known.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/devices/cia447/navigation/geography.hpp"

namespace canvoy::cia447 {

/// The navigation system, and times.
struct NavigationClientSettings {
  NodeId navigation = 0;      ///< 1 to 16, another node
  Duration period = 1s;       ///< of the rounds
  Duration time_out = 500ms;  ///< for one answer
  /// Called after each round, and when the system was lost.
  Callback<void()> changed = {};
};

/// Construct it before the node starts. It sets on_lost() of the network, and calls the former
/// callback.
class NavigationClient {
 public:
  /// Bytes of UTF-8; a longer name is unknown.
  static constexpr std::size_t name_max = 64;

  /// Makes the client; `network` must outlive it.
  NavigationClient(CarNetwork& network, const NavigationClientSettings& settings);

  /// Starts guidance at once, replacing the present one.
  void guide(const GeoPosition& destination);
  /// No object ends a guidance: the system continues, but this device does not send the destination
  /// again.
  void forget_destination();

  // The last answers; empty if the system does not have the value, or does not answer.

  /// City of the present position; empty: not known.
  std::string_view city() const { return city_.view(); }
  /// Street of the present position; empty: not known.
  std::string_view street() const { return street_.view(); }
  /// Street of the destination; empty: none.
  std::string_view destination_street() const { return destination_street_.view(); }
  /// Distance to the destination; nothing: none, or not known.
  std::optional<double> metres() const { return metres_; }

 private:
  /// Steps of a round, in order.
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
  GeoPosition telling_;  ///< a destination that is being sent
  bool is_guided_ = false;
  bool is_described_ = false;
  Step step_ = Step::none;
  PlaceName name_;  ///< being received
  PlaceName city_;
  PlaceName street_;
  PlaceName destination_street_;
  std::optional<double> metres_;
  std::array<std::uint8_t, 4> value_{};
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia447
