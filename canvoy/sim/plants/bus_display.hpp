// The display of a bus as a passenger sees it at a point in time: texts at their positions,
// aligned, flashing, scrolling; as lines of text and as a picture (CiA 407, 9.2.8.4).
//
//     BusDisplay display({.columns = 32, .lines = 3}, clock);
//     environment.provide(Callback<cia407::DisplayHardware()>::to<&BusDisplay::hardware>(display));
//     display.text();      // "23a Airport" ...
//     display.picture();
//
// Interpretation of "the display device is responsible for a correct layout": an element is a line,
// from the top down. Where the first element is large and there are others, it stands to their
// left. Scrolling text enters at the left and moves to the right, one column each 250 ms. Slow
// flashing is dark in every other second, medium in every other half second, fast in every other
// quarter second. A text that is too long continues in the next line; a word that is too long is
// cut. Where there are more lines than the sign has, they are shown in turns of three seconds. Of
// an XML file, the text is shown without the tags; of a picture, three blocks. A character without
// a picture is a box. Character sets with such characters (6, 8 and 11) are not offered in 6205h.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"
#include "canvoy/sim/plants/picture.hpp"

namespace canvoy {

class BusDisplay {
 public:
  /// Size of the sign.
  struct Size {
    std::size_t columns = 32;  ///< of 8 dots
    std::size_t lines = 4;     ///< of 16 dots
  };

  /// The object to which `clock` refers must outlive this one.
  BusDisplay(const Size& size, Callback<Time()> clock) : size_(size), clock_(clock) {}
  BusDisplay(const BusDisplay&) = delete;
  BusDisplay& operator=(const BusDisplay&) = delete;

  /// The hardware must not outlive this object.
  cia407::DisplayHardware hardware();

  /// The text that can be read at present: UTF-8, all lines of the sign, each without blanks at its
  /// end.
  std::vector<std::string> text() const;
  /// The display at present, in black on white.
  Picture picture() const { return picture_of(page()); }
  /// Number of turns in which all is shown, at least 1, and what one of them shows.
  std::size_t pages() const;
  /// What one of the pages() shows, counted from 0.
  Picture picture_of(std::size_t page) const;
  /// The whole text of each element: UTF-8, without blanks at its end.
  std::vector<std::string> texts() const;
  /// True while the sign says that the bus will stop.
  bool is_stop_requested() const { return is_stop_requested_; }
  /// True while nothing is shown and no test is under way.
  bool is_dark() const { return elements_.empty() && !is_testing_; }

 private:
  struct Element {
    std::u32string text;
    cia407::FontSize size;
    cia407::Alignment alignment;
    cia407::FontStyle style;
    cia407::FlashSpeed flash;
  };
  /// A character and its position.
  struct Placed {
    char32_t character;
    std::size_t column;
    std::size_t line;
    bool is_large;
    bool is_bold;
  };

  void show(std::span<const cia407::ShownElement> elements);
  bool has_characters_of(const cia407::ShownElement& element);
  void test(bool is_on) { is_testing_ = is_on; }
  void show_stop_request(bool is_on) { is_stop_requested_ = is_on; }
  /// A line of an element.
  struct Row {
    const Element* element;
    std::u32string text;
  };
  bool has_side() const;
  /// Number of columns of the large line and the gap behind it.
  std::size_t beside() const;
  std::vector<Row> rows() const;
  std::size_t page() const;
  std::vector<Placed> placed(std::size_t page) const;
  void place(const Row& row, std::size_t line, std::size_t first, bool is_large,
             std::vector<Placed>& all) const;

  Size size_;
  Callback<Time()> clock_;
  std::vector<Element> elements_;
  Time shown_{};
  bool is_testing_ = false;
  bool is_stop_requested_ = false;
};

}  // namespace canvoy
