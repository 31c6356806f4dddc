// What somebody knows of a bus who only listens to the network of its first car, as the modem does
// that tells passengers' information where it is: from the frames that he has received, and no
// longer than their sender is heard. Who is silent for 2.5 s, or starts anew, has told nothing.
//
//     HeardBus heard(line);
//     heard.hear(now, frame);                        // each frame
//     if (const auto fix = heard.position(now)) ...  // none without satellites, or their receiver
//
// Read are 8.1.4.3 of CiA 407 (281h, 381h, 401h), the messages of motion, mileage, position,
// movement and passengers of this network (8.1.5), and heartbeats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/sim/bus/bus_line.hpp"

namespace canvoy::bus {

class HeardBus {
 public:
  /// Without a message of a device nothing that it has told counts any more.
  static constexpr Duration time_out = 2500ms;

  /// A value, and when its sender was heard last.
  template <class Value>
  struct Aged {
    Value value{};  ///< as told
    Time heard{};   ///< its sender, last
  };
  /// A stop of the route.
  struct Stop {
    std::size_t place = 0;              ///< the one at which it stands, or the next one
    std::optional<Time> arrived{};      ///< when doors opened there
    std::optional<Time> left_before{};  ///< when it left the one before, or went past it
  };

  /// The line outlives this.
  explicit HeardBus(const BusLine& line) : line_(line) {}
  HeardBus(const HeardBus&) = delete;
  HeardBus& operator=(const HeardBus&) = delete;

  /// One that went over the bus whole.
  void hear(Time now, const Frame& frame);

  /// The one that the driver has logged in; null: none of this line.
  const Journey* journey(Time now) const;
  /// Of the journey, by the on-board computer.
  std::optional<Aged<Stop>> stop(Time now) const;
  /// By satellites: nothing without a fix.
  std::optional<Aged<GeoPoint>> position(Time now) const;
  std::optional<double> speed(Time now) const;        ///< m/s, by the wheels
  std::optional<double> odometer(Time now) const;     ///< m, by the wheels
  std::optional<bool> has_open_door(Time now) const;  ///< any
  std::optional<unsigned> aboard(Time now) const;     ///< as counted

 private:
  /// Those that tell something.
  enum Source : std::uint8_t { computer, identification, gateway, positioning, counting, sources };
  struct Heard {
    Time at{};              ///< last
    bool is_there = false;  ///< and operational
  };

  static Source source_of(std::uint32_t can_id);
  bool is_there(Source source, Time now) const;
  void forget(Source source);
  void hear_sign_of_life(Time now, Source source, const Frame& frame);
  void take(Time now, const Frame& frame);
  void take_journey(const Frame& frame);
  void take_doors(Time now, const Frame& frame);
  void look_for_place(Time now);
  std::optional<std::size_t> told_place() const;

  const BusLine& line_;
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

}  // namespace canvoy::bus
