// The displays of a bus, in both cars.
//
//     BusDisplays displays(nodes, options.sabotage, changed);
//     displays.at(next_stop_id).text()
#pragma once

#include <array>
#include <memory>

#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/shown_display.hpp"

namespace canvoy::bus_line {

/// Node-IDs of the displays for passengers.
inline constexpr std::array<NodeId, 6> display_ids = {front_display_id,      next_stop_id,
                                                      information_id,        side_display_id,
                                                      second_destination_id, second_next_stop_id};

/// Size of a display where the design states none.
BusDisplay::Size usual_size(NodeId id);

class BusDisplays {
 public:
  /// All must outlive this object. `changed` is called when the text on any display changes.
  BusDisplays(BusNodes& nodes, const Sabotage& sabotage, const Callback<void()>& changed)
      : nodes_(nodes), sabotage_(sabotage), changed_(changed) {}
  BusDisplays(const BusDisplays&) = delete;
  BusDisplays& operator=(const BusDisplays&) = delete;

  /// Puts the displays of the first car on the bus.
  void add_first_car();
  /// Puts the displays of the second car on the bus.
  void add_second_car();
  /// Takes power from a display; does nothing to other nodes.
  void lose_power(NodeId id);

  /// Throws std::out_of_range where there is no display with this node-ID.
  const ShownDisplay& at(NodeId id) const { return *displays_.at(id); }
  /// Null where the node is no display, or does not exist yet.
  const ShownDisplay* find(NodeId id) const { return displays_.at(id).get(); }
  /// True if a sign that the bus will stop is lit in this car.
  bool is_sign_lit(unsigned car) const;

 private:
  void add(NodeId id, const ShownDisplay::Sabotage& sabotage);
  BusDisplay::Size size_of(NodeId id) const;
  Time clock() { return nodes_.world().now(); }

  BusNodes& nodes_;
  const Sabotage& sabotage_;
  Callback<void()> changed_;
  std::array<std::unique_ptr<ShownDisplay>, node_id_max + 1> displays_;
};

}  // namespace canvoy::bus_line
