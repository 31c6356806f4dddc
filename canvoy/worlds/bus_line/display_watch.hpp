// Reads the displays of a bus by their dots, reports each text that appears, and judges whether it
// is readable, complete and true. What is no text of the line cannot be read: boxes, question
// marks, cut words, a test pattern.
//
//     DisplayWatch watch(nodes, options.line, displays, vehicle, referee, events);
//     watch.displays_changed();
//     watch.truth_changed();
//     watch.judge(now);            // each 100 ms
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/worlds/bus_line/bus_displays.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/bus_referee.hpp"

namespace canvoy::bus_line {

class DisplayWatch {
 public:
  /// All must outlive this object.
  DisplayWatch(BusNodes& nodes, const BusLine& line, const BusDisplays& displays,
               const BusVehicle& vehicle, BusReferee& referee, EventLog<NetworkEvent>& events);
  DisplayWatch(const DisplayWatch&) = delete;
  DisplayWatch& operator=(const DisplayWatch&) = delete;

  /// Call it when the text on any display changes.
  void displays_changed();
  /// Call it when the text that should be shown changes.
  void truth_changed() { has_news_ = true; }
  /// Reads all displays and judges what they show; call it in each step.
  void judge(Time now);
  std::size_t texts() const { return texts_; }  ///< number of texts that appeared

 private:
  enum class Seen : std::uint8_t { right, unreadable, lie };
  /// Indices of stops in the route.
  struct Place {
    std::size_t next = 0;  ///< the one at which the bus stands, or the next one
    std::size_t reached = 0;
  };

  bool can_be_read(DeviceKey key) const;
  bool is_led_by_us(DeviceKey key) const;
  Seen look(DeviceKey key) const;
  bool says(DeviceKey key, const std::u32string& shown, const BusRoute& route,
            const Place& place) const;
  bool says_any(DeviceKey key, const std::u32string& shown) const;
  bool says_way(const std::u32string& shown, const BusRoute& route,
                const std::u32string& destination) const;
  bool says_stops(const std::u32string& shown, const BusRoute& route, std::u32string text,
                  std::size_t longest) const;
  const std::u32string& line_name(const BusRoute& route) const {
    return line_names_[static_cast<std::size_t>(&route - line_.routes.data())];
  }
  std::u32string_view name(const BusRoute& route, std::size_t place) const {
    return names_[route.stops[place].stop];
  }

  BusNodes& nodes_;
  const BusLine& line_;
  const BusDisplays& displays_;
  const BusVehicle& vehicle_;
  BusReferee& referee_;
  EventLog<NetworkEvent>& events_;
  std::vector<std::u32string> line_names_;  ///< of each route
  std::vector<std::u32string> names_;       ///< of each stop of the line
  std::array<std::string, node_id_max + 1> told_texts_;
  std::array<std::u32string, node_id_max + 1> readings_;
  std::array<Seen, node_id_max + 1> seen_{};
  bool has_news_ = true;
  std::size_t texts_ = 0;
};

}  // namespace canvoy::bus_line
