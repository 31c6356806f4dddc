// Reads the displays of a bus: tells what is to be read, and judges whether it is there, whole, and
// so.
//
//     DisplayWatch watch(nodes, options.line, displays, vehicle, referee, events);
//     watch.displays_changed();
//     watch.truth_changed();
//     watch.judge(now);            // each 100 ms
#pragma once

#include <array>
#include <string>
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
  bool is_lit(NodeId id) const;
  bool is_led_by_us(NodeId id) const;
  bool lies(NodeId id) const;
  std::string expected_text(NodeId id) const;
  bool is_whole_text(const std::string& text) const;

  BusNodes& nodes_;
  const BusLine& line_;
  const BusDisplays& displays_;
  const BusVehicle& vehicle_;
  BusReferee& referee_;
  EventLog<NetworkEvent>& events_;
  std::vector<std::string> whole_texts_;  ///< of each route
  std::array<std::string, node_id_max + 1> told_texts_;
  bool has_news_ = true;
  bool has_lie_ = false;
  std::size_t texts_ = 0;
};

}  // namespace canvoy::bus
