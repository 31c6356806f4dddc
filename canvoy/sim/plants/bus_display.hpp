// The display of a bus as a passenger sees it at a point in time: texts in their place, aligned,
// flashing, scrolling; as lines of text and as a picture (CiA 407, 9.2.8.4).
//
//     BusDisplay display({.columns = 32, .lines = 3}, clock);
//     site.offer(Callback<cia407::DisplayHardware()>::to<&BusDisplay::hardware>(display));
//     display.text();      // "23a Airport" ...
//     display.picture();
//
// Our reading of "the display device is responsible for a correct layout": an element is a line,
// from the top on; where the first one is large and there are others, it stands at the left of
// them. What scrolls comes in at the left and goes to the right, a column each 250 ms. What flashes
// slowly is dark each other second, at medium speed each other half, fast each other quarter. A
// text that is too long goes on in the next line, a word that is too long is cut; where there are
// more lines than the sign has, they are shown in turns of three seconds. Of an XML file its text
// is shown, without the tags; of a picture three blocks.
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
  struct Size {
    std::size_t columns = 32;  ///< of 8 dots
    std::size_t lines = 4;     ///< of 16 dots
  };

  /// What `clock` refers to must outlive this.
  BusDisplay(const Size& size, Callback<Time()> clock) : size_(size), clock_(clock) {}
  BusDisplay(const BusDisplay&) = delete;
  BusDisplay& operator=(const BusDisplay&) = delete;

  /// It must not outlive this.
  cia407::DisplayHardware hardware();

  /// What is to be read now: UTF-8, as many lines as there are, each without blanks at its end.
  std::vector<std::string> text() const;
  /// The same in black on white.
  Picture picture() const { return picture_of(page()); }
  /// In how many turns all is to be read, 1 at least, and what is to be seen in one of them.
  std::size_t pages() const;
  Picture picture_of(std::size_t page) const;
  /// What each element says, whole: UTF-8, without blanks at its end.
  std::vector<std::string> texts() const;
  bool is_stop_requested() const { return is_stop_requested_; }
  bool is_dark() const { return elements_.empty() && !is_testing_; }

 private:
  struct Element {
    std::u32string text;
    cia407::FontSize size;
    cia407::Alignment alignment;
    cia407::FontStyle style;
    cia407::FlashSpeed flash;
  };
  /// A character at its place.
  struct Placed {
    char32_t character;
    std::size_t column;
    std::size_t line;
    bool is_large;
    bool is_bold;
  };

  void show(std::span<const cia407::ShownElement> elements);
  void test(bool is_on) { is_testing_ = is_on; }
  void show_stop_request(bool is_on) { is_stop_requested_ = is_on; }
  /// A line of an element.
  struct Row {
    const Element* element;
    std::u32string text;
  };
  bool has_side() const;
  /// Columns of the large line and the gap behind it.
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
