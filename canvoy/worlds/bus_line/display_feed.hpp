// Decides what the on-board computer sends a display by SDO: texts before they are needed, what is
// shown, and the command to show it. It compares the required contents of the display with those
// that have arrived, so that a display that returns receives all that it needs, and nothing twice
// (CiA 407, 5.2).
//
//     feed.want({.shown = {{0x6112, 1, 0, octets}}});
//     while (auto write = feed.next()) send(*write);      // one at a time
//     feed.done(true);
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace canvoy::bus_line {

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

}  // namespace canvoy::bus_line
