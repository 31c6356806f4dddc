// Reads the displays of a bus by their dots: tells what comes up, and judges whether it can be
// read, is whole, and is so. What is no text of the line cannot be read: boxes, question marks, cut
// words, a test pattern.
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

#include "canvoy/sim/bus/bus_displays.hpp"
#include "canvoy/sim/bus/bus_nodes.hpp"
#include "canvoy/sim/bus/bus_referee.hpp"

namespace canvoy::bus {

class DisplayWatch {
 public:
  /// All must outlive this.
  DisplayWatch(BusNodes& nodes, const BusLine& line, const BusDisplays& displays,
               const BusVehicle& vehicle, BusReferee& referee, EventLog<NetworkEvent>& events);
  DisplayWatch(const DisplayWatch&) = delete;
  DisplayWatch& operator=(const DisplayWatch&) = delete;

  /// Something else is to be read on any of them.
  void displays_changed();
  /// Something else should be.
  void truth_changed() { has_news_ = true; }
  void judge(Time now);
  std::size_t texts() const { return texts_; }  ///< that came up

 private:
  enum class Seen : std::uint8_t { right, unreadable, lie };

  bool can_be_read(NodeId id) const;
  bool is_led_by_us(NodeId id) const;
  Seen look(NodeId id) const;
  bool says(NodeId id, const std::u32string& shown, const BusRoute& route, std::size_t place) const;
  bool says_any(NodeId id, const std::u32string& shown) const;
  bool says_way(const std::u32string& shown, const BusRoute& route) const;
  std::u32string_view name(const BusRoute& route, std::size_t place) const {
    return names_[route.stops[place].stop];
  }

  BusNodes& nodes_;
  const BusLine& line_;
  const BusDisplays& displays_;
  const BusVehicle& vehicle_;
  BusReferee& referee_;
  EventLog<NetworkEvent>& events_;
  std::u32string line_name_;
  std::vector<std::u32string> names_;  ///< of each stop of the line
  std::array<std::string, node_id_max + 1> told_texts_;
  std::array<std::u32string, node_id_max + 1> readings_;
  std::array<Seen, node_id_max + 1> seen_{};
  bool has_news_ = true;
  std::size_t texts_ = 0;
};

}  // namespace canvoy::bus
