// The main on-board computer: reports the identity of the vehicle, its position on the route, and
// the time; sends texts; forwards events (CiA 407, 6.2, 9.2.6). The course of the journey is up to
// the application.
//
//     MainOnBoardComputerUnit computer(device, {.clock = ...}, {.vehicle_id = 4711});
//     computer.set_position({.stop_point_id = 17, .fare_zone = 2, .route_segment = 1});
//     computer.texts().send(5, 0x6112, 1, octets);
//
// The time is sent at each full minute and when it becomes known. Otherwise its message would be
// sent every second (8.1.4.3: on each change of value).
#pragma once

#include <optional>
#include <string_view>

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/text_sender.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// What the application adds to the computer.
struct MainOnBoardComputerHardware {
  /// Local time; nothing if it is not known.
  Callback<std::optional<CivilTime>()> clock = {};
  /// Degrees Celsius in the cabin; nothing: no change.
  Callback<std::optional<double>()> inside_temperature = {};
  /// Called when another device has written an event to the n-th entry of 6001h.
  Callback<void(unsigned number, std::uint32_t event)> on_event = {};
  /// Called when an object that it consumes has been written.
  Callback<void(const Entry&)> on_told = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(MainOnBoardComputerHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::clock; } || requires { &Plain::inside_temperature; } ||
          requires { &Plain::on_event; } || requires { &Plain::on_told; },
      "the class has no member function of MainOnBoardComputerHardware: clock, inside_temperature, "
      "on_event or on_told");
  if constexpr (requires { &Plain::clock; }) hardware.clock = callback<&Plain::clock>(plain);
  if constexpr (requires { &Plain::inside_temperature; })
    hardware.inside_temperature = callback<&Plain::inside_temperature>(plain);
  if constexpr (requires { &Plain::on_event; })
    hardware.on_event = callback<&Plain::on_event>(plain);
  if constexpr (requires { &Plain::on_told; }) hardware.on_told = callback<&Plain::on_told>(plain);
}

/// Identity of the vehicle.
struct MainOnBoardComputerSettings {
  std::uint32_t vehicle_id = 0;                    ///< number of the vehicle
  std::uint16_t body_id = 0;                       ///< of the body
  std::uint16_t garage_id = 0;                     ///< where the vehicle is at home
  std::uint32_t radio_id = 0;                      ///< of the radio
  VehicleClass vehicle_class = VehicleClass::bus;  ///< bus, tram or train
  std::uint8_t vehicle_units = 1;                  ///< number of coupled units
  std::string_view vehicle_id_text = {};           ///< as text
  std::string_view body_id_text = {};              ///< as text
  std::string_view garage_id_text = {};            ///< as text
  std::string_view radio_id_text = {};             ///< as text
};

/// Position of the vehicle on its route.
struct RoutePosition {
  std::uint32_t stop_point_id = 0;     ///< the present or next stop
  std::uint8_t number_of_running = 1;  ///< of the stop point in the route, from 1 on
  std::uint8_t fare_zone = 0;          ///< of the stop
  std::uint16_t route_segment = 0;     ///< of the route
  JourneyDirection direction = JourneyDirection::forward;  ///< forward or backward
};

class MainOnBoardComputerUnit {
 public:
  /// Everything to which `hardware` and `settings` refer must outlive this.
  MainOnBoardComputerUnit(VirtualDevice& device, const MainOnBoardComputerHardware& hardware,
                          const MainOnBoardComputerSettings& settings);

  /// Sets the position. The old zone and segment become the previous ones when others are entered
  /// (table 1).
  void set_position(const RoutePosition& position);
  /// Starts a journey, without previous zone and segment.
  void begin_route(const RoutePosition& position);
  /// Blocks or releases ticket cancellers and printers.
  void block_tickets(bool is_blocked);
  /// Sets or clears the request of a passenger to get off. Opening doors end it.
  void request_stop(bool is_requested = true);
  /// Reports the name of the line, for displays.
  void set_line_name(std::string_view name) { device_.tell(line_short_representation, name); }
  /// Reports the name of the stop point, for displays.
  void set_stop_name(std::string_view name) { device_.tell(stop_point_short_representation, name); }
  /// Reports the scheduled time.
  void set_scheduled(const CivilTime& time) { report_clock(device_, scheduled_clock, time); }
  /// Sets event flags for the n-th virtual device of 6002h, 1 to 32. Without flags and information,
  /// the entry is cleared.
  void command(unsigned number, DeviceCode code, std::uint8_t flags, std::uint16_t information = 0);
  /// Reads the clock at the next call of the node, after it was set.
  void clock_changed() { node().timers().arm(timer_, node().now()); }

  /// The virtual device, for further values and events.
  VirtualDevice& device() { return device_; }
  /// Sends texts to the displays.
  TextSender& texts() { return texts_; }

 private:
  static const AccessHandlers hook_calls[];

  Node& node() { return device_.node(); }
  void reset(ResetScope scope);
  void report_vehicle();
  void look(Time now);
  void event_written(const Entry& entry);
  void doors_written();
  void mileage_written();
  void mileage_precision_written();
  void told(const Entry& entry);
  void take_event(std::uint8_t sub);
  void satellite_speed_written();
  void follow_speed();
  void report_position(const RoutePosition& position);

  VirtualDevice& device_;
  MainOnBoardComputerHardware hardware_;
  MainOnBoardComputerSettings settings_;
  TextSender texts_;
  bool has_satellite_speed_ = false;  ///< 6662h was received: its 0 is a valid speed
  Timer timer_;
  bool are_doors_open_ = false;
};

/// Catalogue row of the main on-board computer (6.2); bus_unit makes it a part of a device.
struct MainOnBoardComputerKind
    : BusKind<MainOnBoardComputerUnit, MainOnBoardComputerHardware, MainOnBoardComputerSettings> {
  static constexpr DeviceInfo info = {.name = "on-board-computer",
                                      .title = "main on-board computer of a bus",
                                      .product = "Canvoy CiA 407 on-board computer",
                                      .product_code = 40701,
                                      .node_id = 1,
                                      .hardware = "a clock, a thermometer; who drives"};
  static constexpr const VirtualDeviceInfo& provides = main_on_board_computer;
  static constexpr std::size_t routes = TextSender::servers_max;
  static constexpr std::array pdos = {
      own_pdo<events_of_rpdo<1>>,  own_pdo<events_of_rpdo<2>>, own_pdo<events_of_rpdo<3>>,
      own_pdo<events_of_rpdo<4>>,  own_pdo<events_of_rpdo<5>>, own_pdo<events_of_rpdo<6>>,
      own_pdo<events_of_rpdo<7>>,  own_pdo<events_of_rpdo<8>>, own_pdo<motion_rpdo>,
      own_pdo<mileage_rpdo>,       own_pdo<position_rpdo>,     own_pdo<movement_rpdo>,
      own_pdo<aboard_rpdo>,        own_pdo<stop_request_tpdo>, own_pdo<events_to_tpdo<1>>,
      own_pdo<events_to_tpdo<2>>,  own_pdo<events_to_tpdo<3>>, own_pdo<events_to_tpdo<4>>,
      own_pdo<universal_time_rpdo>};
};

}  // namespace canvoy::cia407
