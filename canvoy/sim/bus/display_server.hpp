// Has the displays of a segment show what they shall, by SDO: one write at a time to each, again
// where it did not arrive, and all of it where a display has come back.
//
//     DisplayServer displays(master, texts);
//     displays.add(5, DisplayUse::next_stop);
//     displays.want([&](DisplayUse use) { return view_of(use); });
//     displays.serve(now);   // often
#pragma once

#include <vector>

#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/text_sender.hpp"
#include "canvoy/sim/bus/display_feed.hpp"

namespace canvoy::bus {

/// What it is for; `train` is no display, but the gateway to the other cars, which takes the texts.
enum class DisplayUse : std::uint8_t { destination, next_stop, information, train };

class DisplayServer {
 public:
  struct Display {
    NodeId node = 0;
    DisplayUse use = DisplayUse::destination;
  };

  /// Both must outlive this; nobody else uses `texts`.
  DisplayServer(Node& node, const NmtMaster& master, cia407::TextSender& texts);
  DisplayServer(const DisplayServer&) = delete;
  DisplayServer& operator=(const DisplayServer&) = delete;

  void add(const Display& display) { served_.push_back({.display = display}); }
  /// What it has nobody knows; of a node that is none of them nothing happens.
  void forget(NodeId id);
  void forget_all();
  template <class ViewOf>
  void want(const ViewOf& view_of) {
    for (Served& each : served_) each.feed.want(view_of(each.display.use));
  }
  void serve();

 private:
  struct Served {
    Display display{};
    DisplayFeed feed{};
    Time paused_until{};
  };

  Served* find(NodeId id);
  void arrived(NodeId server, bool has_arrived);

  Node& node_;
  const NmtMaster& master_;
  cia407::TextSender& texts_;
  std::vector<Served> served_;
};

}  // namespace canvoy::bus
