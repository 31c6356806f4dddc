#include "canvoy/text/error_frame_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/can/error_frame.hpp"

namespace canvoy::text {

namespace {

struct ErrorWord {
  std::uint32_t code;
  std::string_view text;
};

constexpr auto controller_words = std::to_array<ErrorWord>({
    {0x01, "receive buffer overflow"},
    {0x02, "transmit buffer overflow"},
    {0x04, "error warning (reception)"},
    {0x08, "error warning (transmission)"},
    {0x10, "error-passive (reception)"},
    {0x20, "error-passive (transmission)"},
    {0x40, "error-active again"},
});

constexpr auto violation_words = std::to_array<ErrorWord>({
    {error_violation::bit, "bit error"},
    {error_violation::form, "form error"},
    {error_violation::stuff, "stuff error"},
    {0x08, "no dominant bit could be sent"},
    {0x10, "no recessive bit could be sent"},
    {0x20, "overload"},
    {0x40, "active error flag"},
});

/// The parts of a frame, as numbered by the SJA1000 and passed on by drivers.
constexpr auto location_words = std::to_array<ErrorWord>({
    {0x02, "in ID bits 28 to 21"},
    {0x03, "in the start of frame"},
    {0x04, "in the SRTR bit"},
    {0x05, "in the IDE bit"},
    {0x06, "in ID bits 20 to 18"},
    {0x07, "in ID bits 17 to 13"},
    {error_location::crc_sequence, "in the CRC sequence"},
    {0x09, "in reserved bit 0"},
    {0x0A, "in the data field"},
    {0x0B, "in the data length code"},
    {0x0C, "in the RTR bit"},
    {0x0D, "in reserved bit 1"},
    {0x0E, "in ID bits 4 to 0"},
    {0x0F, "in ID bits 12 to 5"},
    {0x11, "in the active error flag"},
    {0x12, "in the intermission"},
    {0x13, "in dominant bits behind an error flag"},
    {0x16, "in the passive error flag"},
    {0x17, "in the error delimiter"},
    {0x18, "in the CRC delimiter"},
    {error_location::ack_slot, "in the ACK slot"},
    {0x1A, "in the end of frame"},
    {error_location::ack_delimiter, "in the ACK delimiter"},
    {0x1C, "in the overload flag"},
});

constexpr auto wire_words = std::to_array<ErrorWord>({
    {0x04, "CANH has no wire"},
    {0x05, "CANH is shorted to the battery"},
    {0x06, "CANH is shorted to VCC"},
    {0x07, "CANH is shorted to ground"},
    {0x40, "CANL has no wire"},
    {0x50, "CANL is shorted to the battery"},
    {0x60, "CANL is shorted to VCC"},
    {0x70, "CANL is shorted to ground"},
    {0x80, "CANL is shorted to CANH"},
});

using Texts = std::vector<std::string>;

std::string joined(std::string_view title, const Texts& details) {
  if (details.empty()) return std::string(title);
  return fmt::format("{}: {}", title, fmt::join(details, ", "));
}

/// The words of the bits; unknown bits as a number.
Texts words_of_bits(std::span<const ErrorWord> words, std::uint32_t bits) {
  Texts texts;
  for (const ErrorWord& word : words) {
    if ((bits & word.code) != 0) texts.emplace_back(word.text);
    bits &= ~word.code;
  }
  if (bits != 0) texts.push_back(fmt::format("unknown bits {:02X}h", bits));
  return texts;
}

std::string word_of(std::span<const ErrorWord> words, std::uint32_t code) {
  for (const ErrorWord& word : words) {
    if (word.code == code) return std::string(word.text);
  }
  return fmt::format("unknown code {:02X}h", code);
}

std::string arbitration_text(const Frame& frame) {
  const unsigned bit = frame.data[error_byte::lost_in_bit];
  return bit == 0 ? "arbitration lost" : fmt::format("arbitration lost in bit {}", bit);
}

std::string protocol_text(const Frame& frame) {
  const unsigned violation = frame.data[error_byte::violation];
  Texts texts = words_of_bits(violation_words, violation & 0x7FU);
  std::string text = joined("protocol violation", texts);
  const bool is_sent = (violation & error_violation::on_transmission) != 0;
  if (is_sent) text += texts.empty() ? ": on transmission" : " on transmission";
  const unsigned location = frame.data[error_byte::location];
  if (location == 0) return text;
  return text + (texts.empty() && !is_sent ? ": " : " ") + word_of(location_words, location);
}

std::string transceiver_text(const Frame& frame) {
  constexpr unsigned high_wire = 0x0F;
  const unsigned status = frame.data[error_byte::transceiver];
  Texts texts;
  for (const unsigned wire : {status & high_wire, status & ~high_wire}) {
    if (wire != 0) texts.push_back(word_of(wire_words, wire));
  }
  return joined("transceiver", texts);
}

std::string counters_text(const Frame& frame) {
  return fmt::format("error counters: {} transmit, {} receive",
                     frame.data[error_byte::transmit_counter],
                     frame.data[error_byte::receive_counter]);
}

}  // namespace

std::string error_frame_text(const Frame& frame) {
  constexpr std::uint32_t known = 0x3FF;
  const auto is_of = [&frame](std::uint32_t error) { return (frame.id & error) != 0; };
  Texts texts;
  if (is_of(error_class::bus_off)) texts.emplace_back("bus-off");
  if (is_of(error_class::restarted)) texts.emplace_back("controller restarted");
  if (is_of(error_class::controller)) {
    const unsigned status = frame.data[error_byte::controller];
    texts.push_back(joined("controller", words_of_bits(controller_words, status)));
  }
  if (is_of(error_class::no_acknowledgement)) texts.emplace_back("no acknowledgement");
  if (is_of(error_class::lost_arbitration)) texts.push_back(arbitration_text(frame));
  if (is_of(error_class::transmit_timeout)) texts.emplace_back("transmit time-out");
  if (is_of(error_class::protocol)) texts.push_back(protocol_text(frame));
  if (is_of(error_class::transceiver)) texts.push_back(transceiver_text(frame));
  if (is_of(error_class::bus_error)) texts.emplace_back("bus error");
  if (is_of(~known)) texts.push_back(fmt::format("unknown classes {:08X}h", frame.id & ~known));
  const bool has_counts =
      (frame.data[error_byte::transmit_counter] | frame.data[error_byte::receive_counter]) != 0;
  if (is_of(error_class::counters) || has_counts) texts.push_back(counters_text(frame));
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace canvoy::text
