// What comes through the printer transport, put on paper (CiA 447-3, 60EBh, table 381; errata Z23):
// text, graphics in four kinds of dots with their escape sequences, and logos.
//
//     PrintStream stream(paper, {.dots_per_line = 384});
//     stream.set_mode(PrinterMode::text);
//     stream.write(bytes);   // as they come, in any pieces
//     stream.end();          // of this transport
//
// A text line stays open at the end of a transport, so that the next one goes on in it; a row of
// dots does not. A line that is full is ended by the character or dot for which it has no room, not
// before: a new line that follows is the same new line.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia447/printer/printer_paper.hpp"
#include "canvoy/devices/cia447/printer/utf8_stream.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

struct PrintStreamSettings {
  unsigned dots_per_line = 384;  ///< 1 to PrintStream::dots_max
  bool can_cut = true;
  std::span<const PrinterLogo> logos = {};  ///< number 1 is the first; 20 at most
};

class PrintStream {
 public:
  static constexpr unsigned dots_max = 1024;

  /// What the callbacks and `settings` refer to must outlive this.
  PrintStream(const PrinterPaper& paper, const PrintStreamSettings& settings);

  /// Ends a line that is open. `mode` is one of the six.
  void set_mode(PrinterMode mode);
  PrinterMode mode() const { return mode_; }
  /// For what is printed from here on; a line has this many characters at most.
  void set_style(const PrintStyle& style, unsigned characters_per_line);

  void write(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) write(byte);
  }
  void write(std::uint8_t byte);
  /// Ends a transport: half a character, dot or escape sequence comes to nothing.
  void end();
  /// Empty lines of text.
  void feed_lines(unsigned count);

  /// Dots by which the paper has moved.
  std::uint32_t fed() const { return fed_; }
  /// Bytes that mean nothing in their place: unknown escape sequences, logos that are not there,
  /// control characters.
  std::uint32_t ignored() const { return ignored_; }

 private:
  bool is_graphics() const;
  void write_graphics(std::uint8_t byte);
  void control(std::uint8_t byte);
  void dot_byte(std::uint8_t byte);
  void dot(const PrintColor& color);
  void end_row();
  void character(char32_t character);
  void new_line();
  void logo(std::uint8_t byte);
  void end_line();
  void cut();
  void feed(unsigned dots);

  PrinterPaper paper_;
  PrintStreamSettings settings_;
  PrinterMode mode_ = PrinterMode::text;
  PrintStyle style_;
  unsigned characters_per_line_ = ~0U;

  // Text.
  Utf8Stream utf8_;
  unsigned left_ = 0;         ///< dots of the line that are taken
  unsigned characters_ = 0;   ///< on the line
  unsigned line_height_ = 0;  ///< of its highest character; 0: the line is empty

  // Graphics.
  std::array<PrintColor, dots_max> row_{};
  unsigned column_ = 0;
  bool has_row_ = false;  ///< something is in the row, even where a carriage return followed
  bool is_escaped_ = false;
  std::array<std::uint8_t, 4> dot_bytes_{};
  unsigned dot_byte_count_ = 0;

  std::uint32_t fed_ = 0;
  std::uint32_t ignored_ = 0;
};

}  // namespace canvoy::cia447
