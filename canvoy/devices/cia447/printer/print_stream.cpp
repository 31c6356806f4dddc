#include "canvoy/devices/cia447/printer/print_stream.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/profiles/cia447/printer.hpp"

namespace canvoy::cia447 {

namespace {

constexpr std::uint8_t code(PrinterControl control) {
  return static_cast<std::uint8_t>(control);
}

/// Where a dot is printed twice, ink stays.
constexpr PrintColor over(const PrintColor& a, const PrintColor& b) {
  return {.red = std::min(a.red, b.red),
          .green = std::min(a.green, b.green),
          .blue = std::min(a.blue, b.blue)};
}

/// Remaining white after ink of one color and of black.
constexpr std::uint8_t left_of_white(unsigned color, unsigned black) {
  return static_cast<std::uint8_t>(((255 - color) * (255 - black) + 127) / 255);
}

constexpr PrintColor black = {.red = 0, .green = 0, .blue = 0};

constexpr unsigned bytes_of_dot(PrinterMode mode) {
  if (mode == PrinterMode::graphics_rgb) return 3;
  return mode == PrinterMode::graphics_cmyk ? 4 : 1;
}

}  // namespace

PrintStream::PrintStream(const PrinterPaper& paper, const PrintStreamSettings& settings)
    : paper_(paper), settings_(settings) {
  settings_.dots_per_line = std::clamp(settings_.dots_per_line, 1U, dots_max);
}

bool PrintStream::is_graphics() const {
  return mode_ != PrinterMode::text && mode_ != PrinterMode::logo;
}

void PrintStream::set_mode(PrinterMode mode) {
  if (mode == mode_) return;
  end();
  end_line();
  mode_ = mode;
}

void PrintStream::set_style(const PrintStyle& style, unsigned characters_per_line) {
  style_ = style;
  characters_per_line_ = std::max(1U, characters_per_line);
}

void PrintStream::write(std::uint8_t byte) {
  if (is_graphics()) {
    write_graphics(byte);
  } else if (mode_ == PrinterMode::logo) {
    logo(byte);
  } else {
    utf8_.push(byte, [this](char32_t one) { character(one); });
  }
}

void PrintStream::end() {
  utf8_.end([this](char32_t one) { character(one); });
  is_escaped_ = false;
  dot_byte_count_ = 0;
  if (has_row_) end_row();
}

void PrintStream::feed_lines(unsigned count) {
  for (unsigned i = 0; i < count; ++i) new_line();
}

// Text.

void PrintStream::character(char32_t one) {
  if (one == code(PrinterControl::cut_paper)) return cut();
  if (one == code(PrinterControl::new_line)) return new_line();
  if (one == code(PrinterControl::carriage_return)) {
    left_ = 0;
    characters_ = 0;
    return;
  }
  const bool is_control = one < 0x20 || (one >= 0x7F && one < 0xA0);
  constexpr char32_t byte_order_mark = 0xFEFF;
  if (is_control || one == byte_order_mark) {
    ++ignored_;
    return;
  }
  unsigned width = style_.has_variable_width ? paper_.width(one, style_) : 0;
  if (width == 0) width = style_.width;
  // A character that is wider than the paper is at its left edge.
  const bool has_room = left_ == 0 || left_ + width <= settings_.dots_per_line;
  if (characters_ >= characters_per_line_ || !has_room) new_line();
  paper_.put({.character = one, .left = left_, .style = style_});
  left_ += width;
  ++characters_;
  line_height_ = std::max<unsigned>(line_height_, style_.height);
}

void PrintStream::new_line() {
  feed(line_height_ > 0 ? line_height_ : style_.height);
  left_ = 0;
  characters_ = 0;
  line_height_ = 0;
}

// Graphics.

void PrintStream::write_graphics(std::uint8_t byte) {
  const bool is_escape = byte == code(PrinterControl::escape);
  if (!is_escaped_ && is_escape) {
    is_escaped_ = true;
  } else if (!is_escaped_ || is_escape) {
    is_escaped_ = false;
    dot_byte(byte);
  } else {
    is_escaped_ = false;
    control(byte);
  }
}

void PrintStream::control(std::uint8_t byte) {
  // A command between the bytes of one dot ends it.
  dot_byte_count_ = 0;
  if (byte == code(PrinterControl::cut_paper)) {
    cut();
  } else if (byte == code(PrinterControl::new_line)) {
    end_row();
  } else if (byte == code(PrinterControl::carriage_return)) {
    column_ = 0;
  } else {
    ++ignored_;
  }
}

void PrintStream::dot_byte(std::uint8_t byte) {
  if (mode_ == PrinterMode::graphics_black) {
    // A row starts with a byte: the rest of the last one is beside the paper.
    if (column_ >= settings_.dots_per_line) end_row();
    for (unsigned bit = 0; bit < 8 && column_ < settings_.dots_per_line; ++bit) {
      dot((byte << bit & 0x80) != 0 ? black : PrintColor{});
    }
    return;
  }
  check_invariant(dot_byte_count_ < bytes_of_dot(mode_));
  dot_bytes_[dot_byte_count_++] = byte;
  if (dot_byte_count_ < bytes_of_dot(mode_)) return;
  dot_byte_count_ = 0;
  const auto& [first, second, third, fourth] = dot_bytes_;
  if (mode_ == PrinterMode::graphics_gray) {
    const std::uint8_t light = left_of_white(0, first);
    dot({.red = light, .green = light, .blue = light});
  } else if (mode_ == PrinterMode::graphics_rgb) {
    dot({.red = first, .green = second, .blue = third});
  } else {
    dot({.red = left_of_white(first, fourth),
         .green = left_of_white(second, fourth),
         .blue = left_of_white(third, fourth)});
  }
}

void PrintStream::dot(const PrintColor& color) {
  if (column_ >= settings_.dots_per_line) end_row();
  row_[column_] = over(row_[column_], color);
  ++column_;
  has_row_ = true;
}

void PrintStream::end_row() {
  if (has_row_) paper_.put_row(std::span(row_).first(settings_.dots_per_line));
  feed(1);
  row_.fill({});
  column_ = 0;
  has_row_ = false;
}

// Logos.

void PrintStream::logo(std::uint8_t byte) {
  if (byte == code(PrinterControl::cut_paper)) return cut();
  if (byte == code(PrinterControl::new_line)) return feed(1);
  if (byte == code(PrinterControl::carriage_return)) return;
  const std::size_t number = static_cast<std::size_t>(byte) - first_logo;
  if (byte < first_logo || number >= settings_.logos.size() || number >= logo_count) {
    ++ignored_;
    return;
  }
  const PrinterLogo& logo = settings_.logos[number];
  const unsigned width = std::min(logo.width, settings_.dots_per_line);
  for (std::size_t y = 0; y < logo.height(); ++y) {
    const auto bits = logo.bits.subspan(y * logo.row_bytes(), logo.row_bytes());
    for (unsigned x = 0; x < width; ++x) {
      dot((bits[x / 8] << x % 8 & 0x80) != 0 ? black : PrintColor{});
    }
    end_row();
  }
}

// Paper.

void PrintStream::end_line() {
  if (line_height_ > 0) new_line();
  if (has_row_) end_row();
  column_ = 0;
  left_ = 0;
  characters_ = 0;
}

void PrintStream::cut() {
  end_line();
  if (settings_.can_cut) {
    paper_.cut();
  } else {
    ++ignored_;
  }
}

void PrintStream::feed(unsigned dots) {
  fed_ += dots;
  paper_.feed(dots);
}

}  // namespace canvoy::cia447
