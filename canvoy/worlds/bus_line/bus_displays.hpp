// The displays of a bus, in both cars.
//
//     BusDisplays displays(nodes, options.sabotage, changed);
//     displays.at(next_stop_id).text()
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "canvoy/sim/plants/bus_display.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"

namespace canvoy::bus_line {

// A display of a bus as passengers read it, reported when it changes; and faults between the device
// and its lamps.

class ShownDisplay {
 public:
  /// Faults of wires and memory, for tests of referees.
  struct Sabotage {
    bool is_cut = false;            ///< nothing is lit
    bool is_frozen = false;         ///< the first text stays for ever
    bool has_no_sign = false;       ///< the lamp of the stop sign is broken
    bool has_stuck_sign = false;    ///< the lamp is always lit
    std::size_t octets_max = 1000;  ///< longest text
  };

  /// `changed` is called when the text on it changes. What both callbacks refer to must outlive
  /// this object.
  ShownDisplay(const BusDisplay::Size& size, Callback<Time()> clock, Callback<void()> changed,
               const Sabotage& sabotage)
      : display_(size, clock), changed_(changed), sabotage_(sabotage) {}
  ShownDisplay(const ShownDisplay&) = delete;
  ShownDisplay& operator=(const ShownDisplay&) = delete;

  /// Hardware of the display unit; valid as long as this object.
  cia407::DisplayHardware hardware();
  /// Its device has no power: it is dark.
  void power_off();

  /// Text that the display was told to show, where it reaches the lamps: UTF-8, elements one after
  /// another, each in a line; empty: it is dark.
  const std::string& text() const { return text_; }
  /// Text that its dots show in all turns, one line after another.
  const std::u32string& reading() const { return reading_; }
  /// True if passengers see the sign "stop requested".
  bool is_sign_lit() const {
    return sabotage_.has_stuck_sign || (!sabotage_.has_no_sign && display_.is_stop_requested());
  }
  /// The dots of the display.
  const BusDisplay& display() const { return display_; }

 private:
  void show(std::span<const cia407::ShownElement> elements);
  void show_stop_request(bool is_on);
  void test(bool is_on);
  void look();

  BusDisplay display_;
  Callback<void()> changed_;
  Sabotage sabotage_;
  std::string text_;
  std::u32string reading_;
};

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
