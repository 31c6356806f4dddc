// State of a bus as a pure listener on the network of its first car receives it, such as the modem
// that reports the position to passenger information. Data are valid while their sender is heard. A
// sender that is silent for 2.5 s, or restarts, has no valid data.
//
//     HeardBus heard(line);
//     heard.hear(now, frame);                        // each frame
//     if (const auto fix = heard.position(now)) ...  // none without satellites, or their receiver
//
// It reads the messages 281h, 381h and 401h (CiA 407, 8.1.4.3), those of motion, mileage, position,
// movement and passengers of this network (CiA 407, 8.1.5), and heartbeats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/worlds/bus_line/bus_design.hpp"
#include "canvoy/worlds/bus_line/bus_line.hpp"

namespace canvoy::bus_line {

class HeardBus {
 public:
  /// Without a message of a device for this time, its data are invalid.
  static constexpr Duration time_out = 2500ms;

  /// A value, and the time at which its sender was last heard.
  template <class Value>
  struct Aged {
    Value value{};  ///< as received
    Time heard{};   ///< last message of its sender
  };
  /// A stop of the route.
  struct Stop {
    std::size_t place = 0;              ///< index of the one at which it stands, or of the next one
    std::optional<Time> arrived{};      ///< time at which doors opened there
    std::optional<Time> left_before{};  ///< time at which it left or passed the stop before
  };

  /// The line must outlive this object.
  explicit HeardBus(const BusLine& line, const BusDesign& design = {});
  HeardBus(const HeardBus&) = delete;
  HeardBus& operator=(const HeardBus&) = delete;

  /// Takes a frame that was completely transmitted on the bus.
  void hear(Time now, const Frame& frame);

  /// The journey that the driver has logged in; null: none of this line.
  const Journey* journey(Time now) const;
  /// Stop of the journey, by the on-board computer.
  std::optional<Aged<Stop>> stop(Time now) const;
  /// Position by satellites; empty without a fix.
  std::optional<Aged<GeoPoint>> position(Time now) const;
  std::optional<double> speed(Time now) const;        ///< m/s, by the wheels
  std::optional<double> odometer(Time now) const;     ///< m, by the wheels
  std::optional<bool> has_open_door(Time now) const;  ///< any door is open
  std::optional<unsigned> aboard(Time now) const;     ///< as counted

 private:
  /// Devices with data that are read.
  enum Source : std::uint8_t { computer, identification, gateway, positioning, counting, sources };
  struct Heard {
    Time at{};              ///< time of the last message
    bool is_there = false;  ///< and operational
  };

  Source source_of(std::uint32_t can_id) const;
  bool is_there(Source source, Time now) const;
  void forget(Source source);
  void hear_sign_of_life(Time now, Source source, const Frame& frame);
  void take(Time now, const Frame& frame);
  void take_vehicle(Time now, const Frame& frame);
  void take_journey(const Frame& frame);
  void take_doors(Time now, const Frame& frame);
  void look_for_place(Time now);
  std::optional<std::size_t> reported_place() const;

  const BusLine& line_;
  MessageIds ids_;
  std::array<NodeId, sources> nodes_;  ///< node-ID of each source
  std::array<Heard, sources> heard_{};
  const Journey* journey_ = nullptr;
  std::optional<std::uint32_t> stop_point_{};
  std::optional<unsigned> running_number_{};
  std::optional<Stop> stop_{};
  std::optional<GeoPoint> position_{};
  std::optional<double> speed_{};
  std::optional<double> odometer_{};
  std::optional<bool> has_open_door_{};
  std::optional<unsigned> aboard_{};
};

}  // namespace canvoy::bus_line
