// Text on the paper of a printer: characters in the order of printing, line by line.
//
//     PaperText paper;
//     hardware.paper = paper.paper();
//     for (const std::string& line : paper.lines()) ...
//     paper.copy_to(picture.paper());    // it is drawn as well
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "canvoy/devices/cia447/printer/printer_paper.hpp"

namespace canvoy::taxi {

class PaperText {
 public:
  /// The result must not outlive this object.
  cia447::PrinterPaper paper() {
    cia447::PrinterPaper made;
    made.put = Callback<void(const cia447::PrintedCharacter&)>::to<&PaperText::put>(*this);
    made.feed = Callback<void(unsigned)>::to<&PaperText::feed>(*this);
    made.cut = Callback<void()>::to<&PaperText::cut>(*this);
    return made;
  }
  /// Forwards all further output to this paper. The object that it refers to must outlive this one.
  void copy_to(const cia447::PrinterPaper& other) { other_ = other; }
  /// Discards the line that was begun.
  void new_roll() { line_.clear(); }
  /// The last lines, at most `count`, in their order.
  std::vector<std::string> last_lines(std::size_t count) const {
    return {lines_.end() - static_cast<std::ptrdiff_t>(std::min(count, lines_.size())),
            lines_.end()};
  }
  /// Lines without the empty ones, in ASCII; other characters are question marks.
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  void put(const cia447::PrintedCharacter& printed) {
    constexpr char32_t last_ascii = 0x7E;
    line_ += printed.character <= last_ascii ? static_cast<char>(printed.character) : '?';
    other_.put(printed);
  }
  void feed(unsigned dots) {
    if (!line_.empty()) lines_.push_back(line_);
    line_.clear();
    other_.feed(dots);
  }
  void cut() { other_.cut(); }

  cia447::PrinterPaper other_;
  std::string line_;
  std::vector<std::string> lines_;
};

}  // namespace canvoy::taxi
