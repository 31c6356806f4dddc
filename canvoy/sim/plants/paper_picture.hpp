// The paper of a printer as a picture: what a person reads who tears it off.
//
//     PaperPicture paper(384);
//     PrinterUnit printer(network, {.paper = paper.paper()}, {.font = {.dots_per_line = 384}});
//     ...
//     paper.receipts().back()   // the last one that was cut
//     paper.present()           // what hangs out of the printer
//
// Characters are drawn with the glyphs of glyph_table.hpp, stretched to the size of the style. A
// character without a glyph is a box.
#pragma once

#include <deque>

#include "canvoy/sim/plants/picture.hpp"

namespace canvoy {

class PaperPicture {
 public:
  /// Longest receipt in rows of dots: a longer one tears off by itself. When there are too many
  /// receipts, the oldest are discarded.
  static constexpr std::size_t rows_max = 20'000;
  static constexpr std::size_t receipts_max = 64;  ///< kept

  /// `width` is in dots.
  explicit PaperPicture(std::size_t width = 384) : present_(width) {}
  PaperPicture(const PaperPicture&) = delete;
  PaperPicture& operator=(const PaperPicture&) = delete;

  /// The result must not outlive this object.
  cia447::PrinterPaper paper();

  /// Receipts that were cut off, the oldest first.
  const std::deque<Picture>& receipts() const { return receipts_; }
  /// What hangs out of the printer since the last cut.
  const Picture& present() const { return present_; }
  /// Number of receipts cut off, including those discarded.
  std::size_t cuts() const { return cuts_; }

 private:
  void put(const cia447::PrintedCharacter& character);
  unsigned width(char32_t character, const cia447::PrintStyle& style);
  void put_row(std::span<const cia447::PrintColor> row);
  void feed(unsigned dots);
  void cut();

  Picture present_;
  std::deque<Picture> receipts_;
  std::size_t row_ = 0;  ///< present row of the paper
  std::size_t cuts_ = 0;
};

}  // namespace canvoy
