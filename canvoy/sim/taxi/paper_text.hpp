// What is read on the paper of a printer: characters as they were put, line by line.
//
//     PaperText paper;
//     hardware.paper = paper.paper();
//     for (const std::string& line : paper.lines()) ...
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "canvoy/devices/cia447/printer/printer_paper.hpp"

namespace canvoy::taxi {

class PaperText {
 public:
  /// It must not outlive this.
  cia447::PrinterPaper paper() {
    cia447::PrinterPaper made;
    made.put = Callback<void(const cia447::PrintedCharacter&)>::to<&PaperText::put>(*this);
    made.feed = Callback<void(unsigned)>::to<&PaperText::feed>(*this);
    return made;
  }
  /// Without those that are empty. Of ASCII; other characters are question marks.
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  void put(const cia447::PrintedCharacter& printed) {
    constexpr char32_t last_ascii = 0x7E;
    line_ += printed.character <= last_ascii ? static_cast<char>(printed.character) : '?';
  }
  void feed(unsigned /*dots*/) {
    if (!line_.empty()) lines_.push_back(line_);
    line_.clear();
  }

  std::string line_;
  std::vector<std::string> lines_;
};

}  // namespace canvoy::taxi
