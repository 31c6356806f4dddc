// Writes the required contents to the displays of a segment by SDO: one write at a time to each,
// again where it did not arrive, and all of it where a display has returned. On request, it reads
// which character sets the displays inside offer, and uses ISO 8859-1 until they are known (CiA
// 407, 9.2.8.6).
//
//     DisplayServer displays(master, texts);
//     displays.add(5, DisplayUse::next_stop);
//     displays.want([&](DisplayUse use, CharacterSets sets) { return view_of(use, sets); });
//     displays.serve(now);   // often
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/text_sender.hpp"
#include "canvoy/worlds/bus_line/display_feed.hpp"

namespace canvoy::bus_line {

/// Use of a receiver of texts; `train` is no display, but the gateway to the other cars.
enum class DisplayUse : std::uint8_t { destination, next_stop, information, train };

/// Values of 6205h, beside 0.
using CharacterSets = std::span<const std::uint16_t>;

class DisplayServer {
 public:
  /// A receiver of texts.
  struct Display {
    NodeId node = 0;                           ///< node-ID
    DisplayUse use = DisplayUse::destination;  ///< its use
  };

  /// Both must outlive this object, which alone uses `texts`.
  DisplayServer(Node& node, const NmtMaster& master, cia407::TextSender& texts);
  DisplayServer(const DisplayServer&) = delete;
  DisplayServer& operator=(const DisplayServer&) = delete;

  /// Serves a further display.
  void add(const Display& display) { served_.push_back({.display = display}); }
  /// Marks the contents of a display as unknown; does nothing for other nodes.
  void forget(NodeId id);
  /// All contents are unknown, as after a reset of the own node.
  void forget_all();
  /// Asks `view_of(use, sets)` for the required contents of each display.
  template <class ViewOf>
  void want(const ViewOf& view_of) {
    for (Served& each : served_)
      each.feed.want(view_of(each.display.use, CharacterSets(each.sets)));
  }
  /// Begins the writes that are possible; call it often.
  void serve();
  /// Reads the character sets of next stop indicators and information displays, and again when one
  /// returns. Calls `learnt` when those of one are known: the required contents may change.
  void ask_for_sets(Callback<void()> learnt) {
    asks_for_sets_ = true;
    learnt_ = learnt;
  }

 private:
  struct Served {
    Display display{};
    DisplayFeed feed{};
    Time paused_until{};                      ///< after a failure
    std::vector<std::uint16_t> sets{1};       ///< the sets that it offers, as far as they are known
    std::vector<std::uint16_t> told_sets{};   ///< the sets before
    std::optional<std::uint8_t> asked_sub{};  ///< sub-index of 6205h that is being read
    std::uint8_t next_sub = 0;                ///< next sub-index to read
    unsigned last_sub = 0;                    ///< last sub-index of 6205h; unknown until sub-index
                                              ///< 0 is read
    bool has_told_sets = false;               ///< since forget()
  };

  bool wants_sets(const Served& served) const;
  bool ask(Served& served);
  void told(NodeId server, std::optional<std::uint32_t> value);

  Served* find(NodeId id);
  static void forget(Served& served);
  void arrived(NodeId server, bool has_arrived);

  Node& node_;
  const NmtMaster& master_;
  cia407::TextSender& texts_;
  std::vector<Served> served_;
  bool asks_for_sets_ = false;
  Callback<void()> learnt_;
};

}  // namespace canvoy::bus_line
