// What the on-board computer sends a display by SDO (CiA 407, 5.2): texts before they are needed,
// what is shown, and the order to show it. It compares what the display shall have with what has
// arrived there, so that a display that comes back is told all that it needs, and nothing twice.
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

namespace canvoy::bus {

/// A text in a place of the display: 610Ch, 610Dh or 6112h.
struct DisplayText {
  std::uint16_t index = 0;
  std::uint8_t sub = 1;
  std::uint8_t format = 0;  ///< of 6203h
  std::vector<std::uint8_t> octets{};

  friend bool operator==(const DisplayText&, const DisplayText&) = default;
};

/// Of 6112h: as many as the devices have room for.
inline constexpr std::size_t stop_texts = 64;
/// Where the text of a stop stands in 6112h: 0 is the first of the route.
constexpr std::uint8_t stop_text_sub(std::size_t place) {
  return static_cast<std::uint8_t>(place % stop_texts + 1);
}

/// Nothing shown: it is dark.
struct DisplayView {
  std::vector<DisplayText> shown{};
  std::vector<DisplayText> soon{};  ///< shown next
  std::uint16_t character_set = 0;  ///< 6205h; 0: as it is
  bool has_mapping = true;          ///< else nothing is shown: who gets the texts has no 6203h

  friend bool operator==(const DisplayView&, const DisplayView&) = default;
};

class DisplayFeed {
 public:
  struct Write {
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::vector<std::uint8_t> octets{};
  };

  /// It has booted, or was not heard for a time: nobody knows what it has.
  void forget();
  void want(DisplayView view) {
    view_ = std::move(view);
    has_all_ = false;
  }
  /// What is to be sent; nothing: one is under way, or all is there.
  std::optional<Write> next();
  /// The one that was under way.
  void done(bool has_arrived);
  bool is_busy() const { return under_way_.has_value(); }

 private:
  using Place = std::pair<std::uint16_t, std::uint8_t>;

  bool is_missing(const Write& write) const;
  std::optional<Write> first_missing() const;

  DisplayView view_;
  std::map<Place, std::vector<std::uint8_t>> has_;
  std::optional<Write> under_way_;
  bool was_forgotten_ = false;  ///< while one was under way
  bool has_all_ = false;
};

}  // namespace canvoy::bus
