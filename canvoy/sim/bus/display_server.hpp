// Has the displays of a segment show what they shall, by SDO: one write at a time to each, again
// where it did not arrive, and all of it where a display has come back. Where it is asked to, it
// reads which character sets those inside offer (CiA 407, 9.2.8.6); before they are known, it goes
// by ISO 8859-1.
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
#include "canvoy/sim/bus/display_feed.hpp"

namespace canvoy::bus {

/// What it is for; `train` is no display, but the gateway to the other cars, which takes the texts.
enum class DisplayUse : std::uint8_t { destination, next_stop, information, train };

/// Values of 6205h, beside 0.
using CharacterSets = std::span<const std::uint16_t>;

class DisplayServer {
 public:
  struct Display {
    NodeId node = 0;                           ///< its node-ID
    DisplayUse use = DisplayUse::destination;  ///< what it is for
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
    for (Served& each : served_)
      each.feed.want(view_of(each.display.use, CharacterSets(each.sets)));
  }
  void serve();
  /// Next stop indicators and information displays are asked for their character sets, each anew
  /// where it comes back; `learnt` is called when one has told them: what is wanted may be another.
  void ask_for_sets(Callback<void()> learnt) {
    asks_for_sets_ = true;
    learnt_ = learnt;
  }

 private:
  struct Served {
    Display display{};
    DisplayFeed feed{};
    Time paused_until{};                      ///< after a failure
    std::vector<std::uint16_t> sets{1};       ///< that it offers, as far as is known
    std::vector<std::uint16_t> told_sets{};   ///< until now
    std::optional<std::uint8_t> asked_sub{};  ///< of 6205h, under way
    std::uint8_t next_sub = 0;                ///< to be asked
    unsigned last_sub = 0;                    ///< of 6205h; with sub-index 0 it is not known yet
    bool has_told_sets = false;               ///< since it was forgotten
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

}  // namespace canvoy::bus
