// The paper of a printer as a picture: what somebody would read who tears it off.
//
//     PaperPicture paper(384);
//     PrinterUnit printer(network, {.paper = paper.paper()}, {.font = {.dots_per_line = 384}});
//     ...
//     paper.receipts().back()   // the last one that was cut
//     paper.present()           // what hangs out of the printer
//
// Characters are drawn with the glyphs of glyph_table.hpp, stretched to the size that the style
// wants; one that has none is a box.
#pragma once

#include <deque>

#include "canvoy/sim/plants/picture.hpp"

namespace canvoy {

class PaperPicture {
 public:
  /// A receipt that grows longer tears by itself, and of more receipts the oldest are thrown away.
  static constexpr std::size_t rows_max = 20'000;
  static constexpr std::size_t receipts_max = 64;

  /// `width` in dots.
  explicit PaperPicture(std::size_t width = 384) : present_(width) {}
  PaperPicture(const PaperPicture&) = delete;
  PaperPicture& operator=(const PaperPicture&) = delete;

  /// It must not outlive this.
  cia447::PrinterPaper paper();

  /// What was cut off, the oldest first.
  const std::deque<Picture>& receipts() const { return receipts_; }
  const Picture& present() const { return present_; }
  /// How many there were, with those that were thrown away.
  std::size_t cuts() const { return cuts_; }

 private:
  void put(const cia447::PrintedCharacter& character);
  unsigned width(char32_t character, const cia447::PrintStyle& style);
  void put_row(std::span<const cia447::PrintColor> row);
  void feed(unsigned dots);
  void cut();

  Picture present_;
  std::deque<Picture> receipts_;
  std::size_t row_ = 0;  ///< where the paper stands
  std::size_t cuts_ = 0;
};

}  // namespace canvoy
