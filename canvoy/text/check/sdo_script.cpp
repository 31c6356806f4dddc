#include "canvoy/text/check/sdo_script.hpp"

#include <fmt/format.h>

#include <charconv>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

/// Time without an answer.
constexpr Duration silence = 100ms;

/// Takes the text up to the separator, and the separator.
std::string_view cut(std::string_view& text, std::string_view separator) {
  const std::size_t end = text.find(separator);
  const std::string_view front = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
  return formats::trimmed(front);
}

std::uint8_t byte_of(std::string_view word, std::uint16_t value) {
  if (word == "VL") return static_cast<std::uint8_t>(value);
  if (word == "VH") return static_cast<std::uint8_t>(value >> 8);
  // A different value: one bit is changed.
  if (word == "NL") return static_cast<std::uint8_t>(value ^ 1U);
  if (word == "NH") return static_cast<std::uint8_t>(value >> 8);
  unsigned byte = 0;
  std::from_chars(word.data(), word.data() + word.size(), byte, 16);
  return static_cast<std::uint8_t>(byte);
}

Bytes bytes_of_words(std::string_view words, std::uint16_t value) {
  Bytes bytes;
  while (!words.empty()) bytes.push_back(byte_of(cut(words, " "), value));
  return bytes;
}

bool fits_byte(std::string_view choices, std::uint8_t byte, std::uint16_t value) {
  if (choices == "??") return true;
  while (!choices.empty()) {
    if (byte_of(cut(choices, "/"), value) == byte) return true;
  }
  return false;
}

bool fits(std::string_view pattern, const Frame& answer, std::uint16_t value) {
  if (answer.length != answer.data.size() || answer.is_remote()) return false;
  for (std::size_t i = 0; i < answer.data.size() && !pattern.empty(); ++i) {
    if (!fits_byte(cut(pattern, " "), answer.data[i], value)) return false;
  }
  return true;
}

std::string joined(std::string_view script, bool wants_answers) {
  std::string text;
  while (!script.empty()) {
    std::string_view answer = cut(script, ";");
    const std::string_view request = cut(answer, ">");
    if (!text.empty()) text += "; ";
    text += wants_answers ? formats::trimmed(answer) : request;
  }
  return text;
}

}  // namespace

std::string sent_of(std::string_view script) {
  return joined(script, false);
}

std::string expected_of(std::string_view script) {
  return joined(script, true);
}

Verdict judge_script(Bench& bench, std::string_view script, std::uint16_t value) {
  while (!script.empty()) {
    std::string_view pattern = cut(script, ";");
    const Bytes request = bytes_of_words(cut(pattern, ">"), value);
    pattern = formats::trimmed(pattern);
    if (pattern == "nothing") {
      Frame frame = Frame::data_frame(can_id::sdo_request + bench.node(), request);
      frame.length = Frame::length_max;
      bench.drain();
      bench.send(frame);
      const auto came = bench.await(can_id::sdo_response + bench.node(), silence);
      if (!came) continue;
      return failed(fmt::format("to {} came {} in place of nothing", text::bytes_text(request),
                                text::bytes_text(came->frame.payload())));
    }
    const auto answer = bench.ask(request);
    if (answer && fits(pattern, *answer, value)) continue;
    return failed(fmt::format("to {} came {} in place of {}", text::bytes_text(request),
                              answer ? text::bytes_text(answer->payload()) : "nothing", pattern));
  }
  return passed();
}

}  // namespace canvoy::conformance
