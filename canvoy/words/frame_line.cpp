#include "canvoy/words/frame_line.hpp"

#include <array>
#include <charconv>

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
