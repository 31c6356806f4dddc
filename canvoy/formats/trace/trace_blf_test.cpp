// Vector BLF. `written` is the output of can.BLFWriter of python-can 4.1.0 for the messages that
// are expected here; damaged files are made from it.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/formats/trace/trace.hpp"

namespace canvoy::formats::trace_blf_test {
namespace {

// clang-format off
constexpr std::array<std::uint8_t, 310> written = {
    0x4C, 0x4F, 0x47, 0x47, 0x90, 0x00, 0x00, 0x00, 0x05, 0x00, 0x00, 0x00, 0x02, 0x06, 0x08, 0x01,
    0x36, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x24, 0x02, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x06, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xE7, 0x07, 0x0B, 0x00, 0x02, 0x00, 0x0E, 0x00,
    0x16, 0x00, 0x0D, 0x00, 0x14, 0x00, 0x00, 0x00, 0xE7, 0x07, 0x0B, 0x00, 0x02, 0x00, 0x0E, 0x00,
    0x16, 0x00, 0x0D, 0x00, 0x18, 0x00, 0xF4, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x4C, 0x4F, 0x42, 0x4A, 0x10, 0x00, 0x01, 0x00, 0xA3, 0x00, 0x00, 0x00, 0x0A, 0x00, 0x00, 0x00,
    0x02, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x74, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x78, 0x9C, 0xF3, 0xF1, 0x77, 0xF2, 0x52, 0x60, 0x60, 0x64, 0x30, 0x60, 0x60, 0x00, 0x92, 0x0C,
    0x0C, 0x4C, 0x0C, 0xA8, 0x00, 0x28, 0xC6, 0xD4, 0x0A, 0x24, 0xE4, 0xF4, 0x21, 0x7C, 0x1F, 0x1C,
    0xEA, 0xFF, 0xB8, 0xA5, 0x45, 0x32, 0x80, 0xF9, 0x8C, 0x1C, 0x02, 0x1F, 0x6F, 0xCD, 0x60, 0x64,
    0x62, 0x66, 0x61, 0x65, 0x63, 0xE7, 0xC0, 0xA9, 0x5E, 0x80, 0x71, 0x2A, 0xC4, 0xFC, 0x06, 0x16,
    0x46, 0x76, 0x84, 0x7D, 0x30, 0xF5, 0x0E, 0x40, 0xB6, 0x27, 0xB2, 0xFA, 0x5B, 0xB3, 0x2F, 0x40,
    0xDD, 0x83, 0x0E, 0x1A, 0x90, 0x39, 0x30, 0xFD, 0x25, 0x40, 0x76, 0x0A, 0xB2, 0x7E, 0xFB, 0xCC,
    0x77, 0x50, 0xFD, 0x9C, 0xCA, 0x30, 0x43, 0x18, 0x79, 0xA0, 0x34, 0xD4, 0xB1, 0x9C, 0x5C, 0xDC,
    0x98, 0xC6, 0x13, 0x06, 0xB8, 0xFC, 0xB8, 0x6D, 0x85, 0x19, 0x0F, 0xB6, 0x30, 0x05, 0x00, 0xF1,
    0x11, 0x19, 0xFE, 0x00, 0x00, 0x00,
};
// clang-format on

std::string_view file() {
  return {reinterpret_cast<const char*>(written.data()), written.size()};
}

TEST(BlfTrace, IsReadAsItWasWritten) {
  auto trace = TraceReader::of(file());
  ASSERT_TRUE(trace);
  EXPECT_EQ(trace->format(), TraceFormat::blf);
  const Time start = Time{} + 1'700'000'000s;
  const auto expect_next = [&](Time time, const Frame& expected, std::string_view channel,
                               TraceDirection direction) {
    TraceFrame frame;
    ASSERT_EQ(trace->next(frame), TraceRead::frame) << trace->problem();
    EXPECT_EQ(frame.time, time);
    EXPECT_EQ(frame.frame, expected);
    EXPECT_EQ(frame.channel, channel);
    EXPECT_EQ(frame.direction, direction);
  };
  // The date of the file has milliseconds only, to which python-can truncates its start: 125 us are
  // lost.
  using enum TraceDirection;
  expect_next(start, Frame::data_frame(0x185, {0x1E, 0x2F}), "can0", received);
  expect_next(start + 1499875us, Frame::data_frame(0x18DAF110, {1, 2, 3, 4, 5, 6, 7, 8}), "can1",
              sent);
  expect_next(start + 2499875us, Frame::remote_frame(0x701, 4), "can0", received);
  TraceFrame error;
  ASSERT_EQ(trace->next(error), TraceRead::frame);
  EXPECT_TRUE(error.frame.is_error());
  EXPECT_EQ(trace->next(error), TraceRead::fd);
  expect_next(start + 4499876us, Frame::data_frame(0, {}), "can1", received);
  EXPECT_EQ(trace->next(error), TraceRead::end);
  EXPECT_EQ(trace->fd_frames(), 1U);
  EXPECT_EQ(trace->bad(), 0U);
}

// An object of kind 73 (CAN_ERROR_EXT) without a container: channel, length, flags, register,
// position, DLC, reserved, length in ns, CAN-ID, further flags, reserved, data.
TEST(BlfTrace, TellsWhichErrorItIs) {
  const auto error = [](std::uint8_t flags, std::uint8_t register_value) {
    std::string content(file().substr(0, 0x90));
    content.append("LOBJ\x20\0\1\0\x40\0\0\0\x49\0\0\0", 16);
    content.append(16, '\0');
    std::array<char, 32> object{1};
    object[4] = static_cast<char>(flags);
    object[8] = static_cast<char>(register_value);
    content.append(object.data(), object.size());
    auto trace = TraceReader::of(content);
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::frame) << trace->problem();
    EXPECT_EQ(frame.channel, "can0");
    return std::string(FrameText(frame.frame).view());
  };
  EXPECT_EQ(error(0, 0), "20000080#0000000000000000");
  EXPECT_EQ(error(1, 0xA2), "20000088#0000040200000000") << "SJA1000: stuff, ID bits 28 to 21";
  EXPECT_EQ(error(2, 0x82), "20000088#0000040000000000") << "Vector: stuff, on reception";
}

// Some programs count from 1970, or from year 1, instead of the start of the file.
// An object of kind 101 (CAN_FD_MESSAGE_64): channel, DLC, number of bytes, transmissions, CAN-ID,
// length in ns, flags, two bit rates, two offsets of time, bits, direction, offset of what follows,
// checksum, data. Bit 12 of the flags is EDL.
TEST(BlfTrace, AClassicFrameInAnObjectOfFdFramesIsOne) {
  for (const bool is_fd : {false, true}) {
    std::string content(file().substr(0, 0x90));
    content.append("LOBJ\x20\0\1\0\x50\0\0\0\x65\0\0\0", 16);
    content.append(16, '\0');
    std::array<char, 48> object{1, 3, 3, 0, '\x85', 1};
    object[13] = is_fd ? '\x10' : '\0';
    object[40] = '\x11';
    object[41] = '\x22';
    object[42] = '\x33';
    content.append(object.data(), object.size());
    auto trace = TraceReader::of(content);
    TraceFrame frame;
    ASSERT_EQ(trace->next(frame), is_fd ? TraceRead::fd : TraceRead::frame) << trace->problem();
    if (!is_fd) {
      EXPECT_EQ(frame.frame, Frame::data_frame(0x185, {0x11, 0x22, 0x33}));
    }
  }
}

TEST(BlfTrace, WithTimesBeyondThirtyOneYearsIsRead) {
  const auto time_of = [](std::uint64_t unit, std::uint64_t count) {
    std::string content(file().substr(0, 40));
    content.append(0x90 - 40, '\0');
    content.append("LOBJ\x20\0\1\0\x30\0\0\0\1\0\0\0", 16);
    for (int byte = 0; byte < 8; ++byte)
      content += byte < 4 ? static_cast<char>(unit >> 8 * byte & 0xFF) : '\0';
    for (int byte = 0; byte < 8; ++byte) content += static_cast<char>(count >> 8 * byte & 0xFF);
    content.append("\1\0\0\0\x85\1\0\0\0\0\0\0\0\0\0\0", 16);
    auto trace = TraceReader::of(content);
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::frame) << trace->problem();
    return frame.time.time_since_epoch();
  };
  EXPECT_EQ(time_of(2, 1'700'000'000'000'125'000), Duration{1'700'000'000'000'125});
  EXPECT_EQ(time_of(1, 170'000'000'000'012), Duration{1'700'000'000'000'120});
  EXPECT_EQ(time_of(2, 0xFFFF'FFFF'FFFF'FFFF), Duration{18'446'744'073'709'552}) << "584 years";
}

// With any number of missing bytes, or any replaced byte, it is read to its end.
TEST(BlfTrace, ThatIsDamagedIsReadToItsEnd) {
  TraceFrame frame;
  for (std::size_t size = 4; size < written.size(); ++size) {
    auto trace = TraceReader::of(file().substr(0, size));
    ASSERT_TRUE(trace);
    while (trace->next(frame) != TraceRead::end) continue;
    EXPECT_EQ(trace->position(), size);
    if (size < 144) {
      EXPECT_EQ(trace->bad(), 1U) << size;
    }
  }
  for (std::size_t at = 144; at < written.size(); ++at) {
    std::string content(file());
    content[at] = static_cast<char>(content[at] ^ 0x55);
    auto trace = TraceReader::of(content);
    ASSERT_TRUE(trace);
    int steps = 0;
    while (trace->next(frame) != TraceRead::end && ++steps < 10'000) continue;
    EXPECT_LT(steps, 10'000) << at;
  }
}

TEST(BlfTrace, WithDamagedCompressionIsCountedAsBad) {
  std::string content(file());
  content[0xB0] = 0;
  auto trace = TraceReader::of(content);
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::bad);
  EXPECT_EQ(trace->problem(), "the compressed data of the container are damaged");
}

}  // namespace
}  // namespace canvoy::formats::trace_blf_test
