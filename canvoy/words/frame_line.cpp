#include "canvoy/words/frame_line.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "canvoy/words/object_words.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::words {

namespace {

/// `node 10 (0Ah)` of each node.
const std::string& node_name(NodeId node) {
  static const auto names = [] {
    std::array<std::string, 256> made;
    for (unsigned i = 0; i < made.size(); ++i) made[i] = node_text(static_cast<NodeId>(i));
    return made;
  }();
  return names[node];
}

void append_text(std::string& line, std::string_view text, std::size_t width) {
  line += text;
  if (text.size() < width) line.append(width - text.size(), ' ');
}

/// `(1700000000.000125)`, as candump writes it.
void append_time(std::string& line, Duration time) {
  constexpr std::int64_t second = 1'000'000;
  constexpr std::size_t length_max = 32;
  const std::int64_t count = time.count();
  std::array<char, length_max> digits{};
  char* at = digits.data();
  *at++ = '(';
  if (count < 0) *at++ = '-';
  const std::uint64_t size =
      count < 0 ? 0 - static_cast<std::uint64_t>(count) : static_cast<std::uint64_t>(count);
  at = std::to_chars(at, digits.data() + length_max, size / second).ptr;
  *at++ = '.';
  for (std::uint64_t place = second / 10; place > 0; place /= 10) {
    *at++ = static_cast<char>('0' + size % second / place % 10);
  }
  *at++ = ')';
  line.append(digits.data(), at);
}

}  // namespace

void append_meaning(std::string& line, const FrameWords& words, std::string_view text) {
  if (words.client != 0 && words.is_answer) {
    line.append(node_name(words.node)).append(" to ").append(node_name(words.client));
  } else {
    if (words.client != 0) line.append(node_name(words.client)).append(" to ");
    if (words.node != 0) line += node_name(words.node);
  }
  if (words.node != 0 && !text.empty()) line += ": ";
  line += text;
  if (!words.marks.empty()) line.append(" [!] ").append(marks_text(words.marks));
  if (!words.news.empty()) line.append(" => ").append(words.news);
}

namespace {

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80;
}

/// As many words as there is room for in each line.
void append_wrapped(std::string& line, std::string_view text, std::size_t room_of_first,
                    std::size_t indent, std::size_t width) {
  std::size_t room = room_of_first;
  const std::size_t room_of_others = width > indent ? width - indent : width;
  bool is_first_word = true;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, length);
    const auto columns = static_cast<std::size_t>(std::ranges::count_if(word, begins_character));
    const std::size_t needed = columns + (is_first_word ? 0 : 1);
    if (needed > room) {
      line += '\n';
      line.append(indent, ' ');
      room = room_of_others - std::min(columns, room_of_others);
    } else {
      if (!is_first_word) line += ' ';
      room -= needed;
    }
    line += word;
    is_first_word = false;
    text.remove_prefix(std::min(length + 1, text.size()));
  }
}

/// `12.345`
void append_seconds(std::string& line, Duration since) {
  constexpr std::int64_t milli = 1000;
  const std::int64_t count = std::max<std::int64_t>(since.count(), 0) / milli;
  std::string digits = std::to_string(count % milli + milli);
  digits[0] = '.';
  const std::string whole = std::to_string(count / milli);
  constexpr std::size_t whole_width = 4;
  if (whole.size() < whole_width) line.append(whole_width - whole.size(), ' ');
  line.append(whole).append(digits);
}

/// As append_meaning(), with numbers of nodes alone.
std::string narrow_meaning(const FrameWords& words, std::string_view text) {
  std::string meaning;
  const std::string node = std::to_string(words.node);
  const std::string client = std::to_string(words.client);
  if (words.client != 0) {
    meaning = words.is_answer ? node + " to " + client : client + " to " + node;
  } else if (words.node != 0) {
    meaning = node;
  }
  if (words.node != 0 && !text.empty()) meaning += ": ";
  meaning += text;
  if (!words.marks.empty()) meaning.append(" [!] ").append(marks_text(words.marks));
  if (!words.news.empty()) meaning.append(" => ").append(words.news);
  return meaning;
}

}  // namespace

void append_narrow_line(std::string& line, const FrameHead& head, const FrameWords& words,
                        std::string_view text, std::size_t width) {
  constexpr std::size_t frame_width = 20;
  constexpr std::size_t indent = 6;
  const std::size_t begin = line.size();
  append_seconds(line, head.time);
  line += ' ';
  if (!head.bus.empty()) line.append(head.bus).append(1, ' ');
  append_text(line, head.frame, frame_width);
  line.append(1, ' ').append(words.service).append(1, ' ');
  const std::size_t used = line.size() - begin;
  append_wrapped(line, narrow_meaning(words, text), width > used ? width - used : 0, indent, width);
}

void append_frame_line(std::string& line, const FrameHead& head, const FrameWords& words,
                       std::string_view text) {
  constexpr std::size_t frame_width = 21;
  constexpr std::size_t service_width = 16;
  append_time(line, head.time);
  line += ' ';
  line += head.bus;
  line += ' ';
  append_text(line, head.frame, frame_width);
  line += ' ';
  append_text(line, words.service, service_width);
  line += ' ';
  append_meaning(line, words, text);
}

}  // namespace canvoy::words
