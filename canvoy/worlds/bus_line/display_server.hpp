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

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/text_sender.hpp"

namespace canvoy::bus_line {

// Decides what the on-board computer sends a display by SDO: texts before they are needed, what is
// shown, and the command to show it. It compares the required contents of the display with those
// that have arrived, so that a display that returns receives all that it needs, and nothing twice
// (CiA 407, 5.2).
//
//     feed.want({.shown = {{0x6112, 1, 0, octets}}});
//     while (auto write = feed.next()) send(*write);      // one at a time
//     feed.done(true);

/// A text at an entry of the display: 610Ch, 610Dh or 6112h.
struct DisplayText {
  std::uint16_t index = 0;             ///< of the object
  std::uint8_t sub = 1;                ///< of the entry
  std::uint8_t format = 0;             ///< of 6203h
  std::vector<std::uint8_t> octets{};  ///< in the character set of the display; at most 128

  friend bool operator==(const DisplayText&, const DisplayText&) = default;
};

/// Number of entries of 6112h: as many as the devices hold.
inline constexpr std::size_t stop_texts = 64;
/// Sub-index in 6112h of the text of a stop: 0 is the first of the route.
constexpr std::uint8_t stop_text_sub(std::size_t place) {
  return static_cast<std::uint8_t>(place % stop_texts + 1);
}

/// Required contents of a display. Without a shown text, it is dark.
struct DisplayView {
  std::vector<DisplayText> shown{};  ///< in the order of the lines
  std::vector<DisplayText> soon{};   ///< texts that are shown next
  std::uint16_t character_set = 0;   ///< value of 6205h; 0: unchanged
  bool has_mapping = true;           ///< false: nothing is shown, as at a receiver of the texts
                                     ///< without 6203h

  friend bool operator==(const DisplayView&, const DisplayView&) = default;
};

class DisplayFeed {
 public:
  /// A write by SDO.
  struct Write {
    std::uint16_t index = 0;             ///< of the object
    std::uint8_t sub = 0;                ///< of the entry
    std::vector<std::uint8_t> octets{};  ///< the whole value
  };

  /// Call it when the display has booted, or was not heard for a time: its contents are unknown.
  void forget();
  /// Sets the required contents; next() has the writes that lead to them.
  void want(DisplayView view) {
    view_ = std::move(view);
    has_all_ = false;
  }
  /// The next write; empty while one is under way, or when all has arrived.
  std::optional<Write> next();
  /// Call it when the write has ended.
  void done(bool has_arrived);
  /// True from next() to done().
  bool is_busy() const { return under_way_.has_value(); }

 private:
  using Place = std::pair<std::uint16_t, std::uint8_t>;

  bool is_missing(const Write& write) const;
  std::optional<Write> first_missing() const;

  DisplayView view_;
  std::map<Place, std::vector<std::uint8_t>> has_;
  std::optional<Write> under_way_;
  bool was_forgotten_ = false;  ///< forgotten while a write was under way
  bool has_all_ = false;
};

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
