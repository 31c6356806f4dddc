#include "canvoy/sim/plants/bus_display.hpp"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "canvoy/sim/plants/glyph.hpp"
#include "canvoy/sim/plants/paper_picture.hpp"

namespace canvoy {

namespace {

using cia407::Alignment;
using cia407::FlashSpeed;
using cia407::FontSize;
using cia407::FontStyle;
using cia407::ShownElement;

constexpr Duration scroll_step = 250ms;
constexpr char32_t not_a_character = 0xFFFD;
constexpr char32_t full_block = 0x2588;
constexpr unsigned cell_width = 8;
constexpr unsigned cell_height = 16;
constexpr std::size_t picture_blocks = 3;
constexpr Duration page_time = 3s;
constexpr unsigned ascii_end = 0x80;

/// Decodes a single-byte character set, byte by byte; an octet that the set does not have becomes
/// U+FFFD.
std::u32string decoded(std::span<const std::uint8_t> octets, unsigned character_set) {
  const std::string name =
      character_set == 0 ? "US-ASCII" : "ISO-8859-" + std::to_string(character_set);
  void* const converter = iconv_open("UTF-32LE", name.c_str());
  const bool is_known = converter != iconv_t(-1);  // NOLINT(performance-no-int-to-ptr)
  std::u32string text;
  for (const std::uint8_t octet : octets) {
    if (octet == 0) break;
    auto byte = static_cast<char>(octet);
    char* from = &byte;
    std::size_t left = 1;
    std::array<char, 4> made{};
    char* to = made.data();
    std::size_t room = made.size();
    const bool is_made = is_known && iconv(converter, &from, &left, &to, &room) == 0 && room == 0;
    text += is_made ? static_cast<char32_t>(
                          load<std::uint32_t>(reinterpret_cast<const std::uint8_t*>(made.data())))
                    : not_a_character;
  }
  if (is_known) iconv_close(converter);
  return text;
}

/// Text between the tags, with the five entities of every XML file.
std::u32string without_tags(const std::u32string& file) {
  struct Entity {
    std::u32string_view name;
    char32_t character;
  };
  constexpr Entity entities[] = {
      {U"&lt;", U'<'}, {U"&gt;", U'>'}, {U"&amp;", U'&'}, {U"&quot;", U'"'}, {U"&apos;", U'\''}};
  std::u32string text;
  bool is_in_tag = false;
  for (std::size_t at = 0; at < file.size();) {
    const auto rest = std::u32string_view(file).substr(at);
    const auto entity =
        std::ranges::find_if(entities, [&](const Entity& e) { return rest.starts_with(e.name); });
    if (!is_in_tag && entity != std::end(entities)) {
      text += entity->character;
      at += entity->name.size();
      continue;
    }
    const char32_t one = file[at++];
    if (one == U'<') is_in_tag = true;
    if (!is_in_tag) text += one < U' ' ? U' ' : one;
    if (one == U'>') is_in_tag = false;
  }
  return text;
}

std::u32string text_of(const ShownElement& element) {
  if (element.content == ShownElement::Content::picture) {
    return std::u32string(picture_blocks, full_block);
  }
  std::u32string text = decoded(element.octets, element.character_set);
  return element.content == ShownElement::Content::xml ? without_tags(text) : text;
}

/// Whether there is a picture of each character of ISO 8859-n from A0h on.
bool can_draw_all_of(std::uint16_t set) {
  std::array<std::uint8_t, 0x60> octets{};
  std::iota(octets.begin(), octets.end(), std::uint8_t{0xA0});
  return std::ranges::all_of(decoded(octets, set),
                             [](char32_t one) { return one == not_a_character || has_glyph(one); });
}

bool can_draw_set(void* /*context*/, std::uint16_t set) {
  static const auto drawn = [] {
    std::array<bool, 16> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = can_draw_all_of(static_cast<std::uint16_t>(i));
    }
    return all;
  }();
  return set < drawn.size() && drawn[set];
}

Duration flash_period(FlashSpeed speed) {
  switch (speed) {
    case FlashSpeed::slow:
      return 1s;
    case FlashSpeed::medium:
      return 500ms;
    case FlashSpeed::fast:
      return 250ms;
    default:
      return {};
  }
}

std::string as_utf8(const std::u32string& text) {
  std::string made;
  for (const char32_t one : text) {
    const auto code = static_cast<unsigned>(one);
    const auto tail = [&made, code](unsigned shift) {
      made += static_cast<char>(0x80U | (code >> shift & 0x3FU));
    };
    if (code < ascii_end) {
      made += static_cast<char>(code);
    } else if (code < 0x800) {
      made += static_cast<char>(0xC0U | code >> 6);
      tail(0);
    } else {
      made += static_cast<char>(0xE0U | code >> 12);
      tail(6);
      tail(0);
    }
  }
  return made;
}

std::string trimmed_utf8(std::u32string text) {
  text.erase(text.find_last_not_of(U' ') + 1);
  return as_utf8(text);
}

/// Lines of whole words, each filled as far as possible.
std::vector<std::u32string> wrapped(const std::u32string& text, std::size_t room) {
  std::vector<std::u32string> lines;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(U' ', at)) != std::u32string::npos) {
    const std::size_t end = std::min(text.find(U' ', at), text.size());
    const std::u32string word = text.substr(at, std::min(end - at, room));
    const bool fits = !lines.empty() && lines.back().size() + 1 + word.size() <= room;
    if (fits) {
      lines.back() += U' ' + word;
    } else {
      lines.push_back(word);
    }
    at = end;
  }
  return lines;
}

}  // namespace

cia407::DisplayHardware BusDisplay::hardware() {
  return {.show = callback<&BusDisplay::show>(*this),
          .test = callback<&BusDisplay::test>(*this),
          .show_stop_request = callback<&BusDisplay::show_stop_request>(*this),
          .has_character_set = {&can_draw_set, nullptr},
          .has_characters_of = callback<&BusDisplay::has_characters_of>(*this)};
}

bool BusDisplay::has_characters_of(const ShownElement& element) {
  return element.content == ShownElement::Content::picture ||
         std::ranges::all_of(text_of(element), has_glyph);
}

void BusDisplay::show(std::span<const ShownElement> elements) {
  shown_ = clock_();
  elements_.clear();
  for (const ShownElement& element : elements) {
    elements_.push_back(
        {text_of(element), element.size, element.alignment, element.style, element.flash});
  }
}

bool BusDisplay::has_side() const {
  return elements_.size() > 1 && elements_[0].size == FontSize::large && size_.lines > 1;
}

std::size_t BusDisplay::beside() const {
  return has_side() ? 2 * elements_[0].text.size() + 1 : 0;
}

/// Rows of all elements except a large one at the left.
std::vector<BusDisplay::Row> BusDisplay::rows() const {
  const std::size_t room = size_.columns - std::min(beside(), size_.columns);
  std::vector<Row> all;
  for (std::size_t i = has_side() ? 1 : 0; i < elements_.size(); ++i) {
    const Element& element = elements_[i];
    const bool fits = element.text.size() <= room || element.style == FontStyle::scrolling;
    if (fits) {
      all.push_back({&element, element.text});
      continue;
    }
    for (std::u32string& line : wrapped(element.text, room)) {
      all.push_back({&element, std::move(line)});
    }
  }
  return all;
}

std::size_t BusDisplay::pages() const {
  if (is_testing_ || size_.lines == 0) return 1;
  return std::max<std::size_t>(1, (rows().size() + size_.lines - 1) / size_.lines);
}

std::size_t BusDisplay::page() const {
  const Duration passed = clock_() - shown_;
  return static_cast<std::size_t>(passed / page_time) % pages();
}

void BusDisplay::place(const Row& row, std::size_t line, std::size_t first, bool is_large,
                       std::vector<Placed>& all) const {
  const Element& element = *row.element;
  const Duration passed = clock_() - shown_;
  const Duration period = flash_period(element.flash);
  if (period > Duration::zero() && passed / period % 2 == 1) return;
  const auto room = static_cast<std::ptrdiff_t>(size_.columns - std::min(first, size_.columns));
  const auto length = static_cast<std::ptrdiff_t>(row.text.size());
  std::ptrdiff_t begin = 0;
  if (element.style == FontStyle::scrolling) {
    begin = passed / scroll_step % (room + length) + 1 - length;
  } else if (is_large) {
    begin = 0;  // at the left of the others, whatever its alignment
  } else if (element.alignment == Alignment::center) {
    begin = std::max<std::ptrdiff_t>(0, (room - length) / 2);
  } else if (element.alignment == Alignment::right) {
    begin = std::max<std::ptrdiff_t>(0, room - length);
  }
  for (std::ptrdiff_t i = 0; i < length; ++i) {
    const std::ptrdiff_t column = begin + (is_large ? 2 * i : i);
    if (column < 0 || column >= room) continue;
    all.push_back({row.text[static_cast<std::size_t>(i)], first + static_cast<std::size_t>(column),
                   line, is_large, element.style == FontStyle::bold});
  }
}

std::vector<BusDisplay::Placed> BusDisplay::placed(std::size_t page) const {
  std::vector<Placed> all;
  if (is_testing_) {
    for (std::size_t cell = 0; cell < size_.columns * size_.lines; ++cell) {
      all.push_back({full_block, cell % size_.columns, cell / size_.columns, false, false});
    }
    return all;
  }
  if (has_side()) place({elements_.data(), elements_[0].text}, 0, 0, true, all);
  const std::vector<Row> rows = this->rows();
  for (std::size_t line = 0; line < size_.lines; ++line) {
    const std::size_t row = page * size_.lines + line;
    if (row < rows.size()) place(rows[row], line, beside(), false, all);
  }
  return all;
}

std::vector<std::string> BusDisplay::text() const {
  std::vector<std::u32string> lines(size_.lines, std::u32string(size_.columns, U' '));
  for (const Placed& each : placed(page())) lines[each.line][each.column] = each.character;
  std::vector<std::string> made;
  made.reserve(lines.size());
  for (std::u32string& line : lines) made.push_back(trimmed_utf8(std::move(line)));
  return made;
}

std::vector<std::string> BusDisplay::texts() const {
  std::vector<std::string> made;
  made.reserve(elements_.size());
  for (const Element& element : elements_) made.push_back(trimmed_utf8(element.text));
  return made;
}

Picture BusDisplay::picture_of(std::size_t page) const {
  PaperPicture sheet(size_.columns * cell_width);
  const cia447::PrinterPaper paper = sheet.paper();
  const std::vector<Placed> all = placed(page);
  const std::vector<cia447::PrintColor> ink(sheet.present().width(), {0, 0, 0});
  for (std::size_t line = 0; line < size_.lines; ++line) {
    for (const Placed& each : all) {
      if (each.line != line) continue;
      const auto height = static_cast<std::uint8_t>(each.is_large ? 2 * cell_height : cell_height);
      const auto width = static_cast<std::uint8_t>(each.is_large ? 2 * cell_width : cell_width);
      paper.put({.character = each.character,
                 .left = static_cast<unsigned>(each.column) * cell_width,
                 .style = {.height = height, .width = width, .is_bold = each.is_bold}});
    }
    for (unsigned row = 0; row < cell_height; ++row) {
      if (is_testing_) paper.put_row(ink);
      paper.feed(1);
    }
  }
  return sheet.present();
}

}  // namespace canvoy
