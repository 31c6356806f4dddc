#include "canvoy/text/frame_line.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "canvoy/formats/trace/trace_line.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

/// `node 10 (0Ah)` for each node.
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

using Head = formats::TraceLine;

/// `(1700000000.000125) `, in the format of candump.
void put_time(Head& head, Duration time) {
  constexpr unsigned microsecond_digits = 6;
  thread_local formats::TraceSeconds seconds({.before = '('});
  const std::int64_t count = time.count();
  if (count < 0) {
    head.put("(-");
    head.put_fixed<microsecond_digits>(0 - static_cast<std::uint64_t>(count));
  } else {
    seconds.put(head, static_cast<std::uint64_t>(count));
  }
  head.put(") ");
}

/// Sender and receiver: `node 10 (0Ah) to node 5 (05h)`.
void put_nodes(Head& head, const FrameWords& words) {
  const NodeId first = words.is_answer || words.client == 0 ? words.node : words.client;
  const NodeId second = words.is_answer ? words.client : words.node;
  if (words.client != 0) {
    head.put(node_name(first));
    head.put(" to ");
    if (second != 0) head.put(node_name(second));
  } else if (first != 0) {
    head.put(node_name(first));
  }
}

void append_rest(std::string& line, const FrameWords& words, std::string_view text) {
  line += text;
  if (!words.marks.empty()) line.append(" [!] ").append(marks_text(words.marks));
  if (!words.news.empty()) line.append(" => ").append(words.news);
}

}  // namespace

void append_meaning(std::string& line, const FrameWords& words, std::string_view text) {
  Head head;
  put_nodes(head, words);
  if (words.node != 0 && !text.empty()) head.put(": ");
  line += head.view();
  append_rest(line, words, text);
}

namespace {

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80;
}

/// Puts as many words as fit into each line.
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

/// Like append_meaning(), but with node numbers only.
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

namespace {

/// ` TPDO1            node 10 (0Ah): `
void put_service(Head& head, const FrameWords& words, bool has_text) {
  constexpr std::size_t service_width = 16;
  head.put(' ');
  const std::size_t column = head.length();
  head.put(words.service);
  head.pad_to(column + service_width);
  head.put(' ');
  put_nodes(head, words);
  if (words.node != 0 && has_text) head.put(": ");
}

/// Most PDOs say again what they have said.
bool append_kept(std::string& line, const Head& head, const FrameWords& words,
                 std::string_view text) {
  if (words.kept == nullptr || !words.marks.empty() || !words.news.empty()) return false;
  if (words.kept->empty()) {
    Head behind;
    put_service(behind, words, !text.empty());
    words.kept->append(behind.view()).append(text);
  }
  line.append(head.view()).append(*words.kept);
  return true;
}

}  // namespace

void append_frame_line(std::string& line, const FrameHead& head_of_line, const FrameWords& words,
                       std::string_view text) {
  constexpr std::size_t frame_width = 21;
  constexpr std::size_t usual = 64;  // size of a bus name and a frame; those of CAN FD are longer
  Head head;
  put_time(head, head_of_line.time);
  const bool is_usual = head_of_line.bus.size() + head_of_line.frame.size() <= usual;
  if (is_usual) {
    head.put(head_of_line.bus);
    head.put(' ');
    head.put_padded<frame_width>(head_of_line.frame);
  } else {
    line.append(head.view()).append(head_of_line.bus).append(1, ' ');
    append_text(line, head_of_line.frame, frame_width);
    head.clear();
  }
  if (append_kept(line, head, words, text)) return;
  put_service(head, words, !text.empty());
  line += head.view();
  append_rest(line, words, text);
}

}  // namespace canvoy::text
