// Prints the contents of the printer transport on paper (CiA 447-3, 60EBh, table 381; errata Z23):
// text, graphics in four kinds of dots with their escape sequences, and logos.
//
//     PrintStream stream(paper, {.dots_per_line = 384});
//     stream.set_mode(PrinterMode::text);
//     stream.write(bytes);   // as they come, in any pieces
//     stream.end();          // of this transport
//
// A text line stays open at the end of a transport, and the next transport continues it; a row of
// dots does not. A full line ends with the character or dot for which it has no room, not before: a
// new line character that follows is the same new line.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia447/printer/printer_paper.hpp"
#include "canvoy/devices/cia447/printer/utf8_stream.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

/// Properties of the paper and its knife.
struct PrintStreamSettings {
  unsigned dots_per_line = 384;             ///< 1 to PrintStream::dots_max
  bool can_cut = true;                      ///< has a knife
  std::span<const PrinterLogo> logos = {};  ///< number 1 is the first; 20 at most
};

class PrintStream {
 public:
  static constexpr unsigned dots_max = 1024;  ///< in a line at most

  /// Everything to which the callbacks and `settings` refer must outlive this.
  PrintStream(const PrinterPaper& paper, const PrintStreamSettings& settings);

  /// Sets one of the six modes, and ends an open line.
  void set_mode(PrinterMode mode);
  /// Kind of data that is expected next.
  PrinterMode mode() const { return mode_; }
  /// Applies to all that is printed afterwards; a line has at most this number of characters.
  void set_style(const PrintStyle& style, unsigned characters_per_line);

  /// Takes bytes of the transport, of any length.
  void write(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) write(byte);
  }
  /// Takes a byte of the transport.
  void write(std::uint8_t byte);
  /// Ends a transport: an incomplete character, dot or escape sequence is discarded.
  void end();
  /// Prints empty lines of text.
  void feed_lines(unsigned count);

  /// Number of dots by which the paper has moved.
  std::uint32_t fed() const { return fed_; }
  /// Number of bytes without a meaning at their position: unknown escape sequences, missing logos,
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
  unsigned left_ = 0;         ///< used dots of the line
  unsigned characters_ = 0;   ///< on the line
  unsigned line_height_ = 0;  ///< height of its highest character; 0: the line is empty

  // Graphics.
  std::array<PrintColor, dots_max> row_{};
  unsigned column_ = 0;
  bool has_row_ = false;  ///< the row is in use, even after a carriage return
  bool is_escaped_ = false;
  std::array<std::uint8_t, 4> dot_bytes_{};
  unsigned dot_byte_count_ = 0;

  std::uint32_t fed_ = 0;
  std::uint32_t ignored_ = 0;
};

}  // namespace canvoy::cia447
