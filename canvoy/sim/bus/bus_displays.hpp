// The displays of a bus as they hang there, in both cars.
//
//     BusDisplays displays(nodes, options.sabotage, changed);
//     displays.at(next_stop_id).text()
#pragma once

#include <array>
#include <memory>

#include "canvoy/sim/bus/bus_nodes.hpp"
#include "canvoy/sim/bus/shown_display.hpp"

namespace canvoy::bus {

inline constexpr std::array<NodeId, 6> display_ids = {front_display_id,      next_stop_id,
                                                      information_id,        side_display_id,
                                                      second_destination_id, second_next_stop_id};

class BusDisplays {
 public:
  /// All must outlive this. `changed` is called when something else is to be read on any.
  BusDisplays(BusNodes& nodes, const Sabotage& sabotage, const Callback<void()>& changed)
      : nodes_(nodes), sabotage_(sabotage), changed_(changed) {}
  BusDisplays(const BusDisplays&) = delete;
  BusDisplays& operator=(const BusDisplays&) = delete;

  /// Puts those of a car on the bus.
  void add_first_car();
  void add_second_car();
  /// What it does without power; of other nodes nothing happens.
  void lose_power(NodeId id);

  const ShownDisplay& at(NodeId id) const { return *displays_.at(id); }
  /// Null: the node is none, or it is not there yet.
  const ShownDisplay* find(NodeId id) const { return displays_.at(id).get(); }
  /// Some sign that the bus will stop is lit in this car.
  bool is_sign_lit(unsigned car) const;

 private:
  void add(NodeId id, const ShownDisplay::Sabotage& sabotage);
  Time clock() { return nodes_.world().now(); }

  BusNodes& nodes_;
  const Sabotage& sabotage_;
  Callback<void()> changed_;
  std::array<std::unique_ptr<ShownDisplay>, node_id_max + 1> displays_;
};

}  // namespace canvoy::bus
