// pcapng and pcap with CAN frames (link type 227), typed from the descriptions of the formats.
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace.hpp"

namespace canvoy::formats::trace_capture_test {
namespace {

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

std::string little(std::uint64_t value, int size = 4) {
  std::string text;
  for (int byte = 0; byte < size; ++byte) text += static_cast<char>(value >> 8 * byte & 0xFF);
  return text;
}

std::string block(std::uint32_t type, const std::string& body) {
  const std::string size = little(body.size() + 12);
  return little(type) + size + body + size;
}

const std::string section =
    block(0x0A0D0D0A, little(0x1A2B3C4D) + little(1) + std::string(8, '\xFF'));
const std::string can_interface = block(1, little(227) + little(0));
const std::string can_185 = bytes({0, 0, 1, 0x85, 2, 0, 0, 0, 0x1E, 0x2F});

// An enhanced packet block at 1 700 000 000.000125 s: 60A24181E407Dh microseconds.
std::string packet(const std::string& data, const std::string& options = "",
                   std::uint32_t interface = 0) {
  const std::string padding((4 - data.size() % 4) % 4, '\0');
  return block(6, little(interface) + little(0x60A24) + little(0x181E407D) + little(data.size()) +
                      little(data.size()) + data + padding + options);
}

struct Read {
  TraceRead read = TraceRead::end;
  TraceFrame frame;
  std::string channel;
  std::string where;
};

Read first_of(const std::string& content) {
  auto trace = TraceReader::of(content);
  EXPECT_TRUE(trace);
  Read first;
  first.read = trace->next(first.frame);
  first.channel = first.frame.channel;
  first.where = trace->where();
  return first;
}

constexpr Time expected_time = Time{} + 1'700'000'000s + 125us;

TEST(PcapngTrace, HasPacketsOfInterfaces) {
  const Read read = first_of(section + can_interface + packet(can_185));
  ASSERT_EQ(read.read, TraceRead::frame);
  EXPECT_EQ(read.frame.time, expected_time);
  EXPECT_EQ(read.frame.frame, Frame::data_frame(0x185, {0x1E, 0x2F}));
  EXPECT_EQ(read.channel, "can0") << "without a name, by its number";
  EXPECT_EQ(read.where, "byte " + std::to_string(section.size() + can_interface.size()));
}

TEST(PcapngTrace, HasNamesOfInterfacesAndDirections) {
  const std::string named = block(1, little(227) + little(0) + little(2, 2) + little(5, 2) +
                                         "vcan7" + std::string(3, '\0') + little(0));
  const std::string sent = little(2, 2) + little(4, 2) + little(2) + little(0);
  const Read read = first_of(section + can_interface + named + packet(can_185, sent, 1));
  EXPECT_EQ(read.channel, "vcan7");
  EXPECT_EQ(read.frame.direction, TraceDirection::sent);
}

TEST(PcapngTrace, TellsInterfacesOfOneNameApart) {
  const std::string named = block(1, little(227) + little(0) + little(2, 2) + little(5, 2) +
                                         "vcan7" + std::string(3, '\0') + little(0));
  const std::string both = section + named + named + named;
  EXPECT_EQ(first_of(both + packet(can_185, "", 0)).channel, "vcan7");
  EXPECT_EQ(first_of(both + packet(can_185, "", 1)).channel, "vcan7_2");
  EXPECT_EQ(first_of(both + packet(can_185, "", 2)).channel, "vcan7_3");
}

TEST(PcapngTrace, HasTimesInTheResolutionOfTheInterface) {
  const auto time_with = [](int resolution, std::uint64_t ticks) {
    const std::string interface = block(1, little(227) + little(0) + little(9, 2) + little(1, 2) +
                                               bytes({resolution, 0, 0, 0}) + little(0));
    const std::string body = little(0) + little(ticks >> 32) + little(ticks) + little(10) +
                             little(10) + can_185 + std::string(2, '\0');
    return first_of(section + interface + block(6, body)).frame.time;
  };
  EXPECT_EQ(time_with(9, 1'500'000'123), Time{} + 1'500'000us);
  EXPECT_EQ(time_with(3, 1'500), Time{} + 1'500ms);
  EXPECT_EQ(time_with(0, 7), Time{} + 7s);
  EXPECT_EQ(time_with(0x80 | 1, 3), Time{} + 1'500ms);
  EXPECT_EQ(time_with(0x80 | 32, 0x1'8000'0000), Time{} + 1'500ms);
  EXPECT_EQ(time_with(0x80 | 60, std::uint64_t{3} << 59), Time{} + 1'500ms);
}

TEST(PcapngTrace, OfABigEndianMachineIsRead) {
  const std::string content =
      bytes({0x0A, 0x0D, 0x0D, 0x0A, 0, 0, 0, 28, 0x1A, 0x2B, 0x3C, 0x4D, 0, 1, 0, 0}) +
      std::string(8, '\xFF') + bytes({0, 0, 0, 28}) +
      bytes({0, 0, 0, 1, 0, 0, 0, 20, 0, 227, 0, 0, 0, 0, 0, 0, 0, 0, 0, 20}) +
      bytes({0,    0,    0,    6,    0,    0,    0, 44, 0, 0,  0, 0, 0, 6,
             0x0A, 0x24, 0x18, 0x1E, 0x40, 0x7D, 0, 0,  0, 10, 0, 0, 0, 10}) +
      can_185 + std::string(2, '\0') + bytes({0, 0, 0, 44});
  const Read read = first_of(content);
  ASSERT_EQ(read.read, TraceRead::frame);
  EXPECT_EQ(read.frame.time, expected_time);
  EXPECT_EQ(read.frame.frame.id, 0x185U);
}

TEST(PcapngTrace, HasExtendedRemoteAndErrorFrames) {
  const auto frame_of = [](const std::string& data) {
    return first_of(section + can_interface + packet(data)).frame.frame;
  };
  Frame extended = Frame::data_frame(0x18EB'FF00, {7});
  EXPECT_EQ(frame_of(bytes({0x98, 0xEB, 0xFF, 0, 1, 0, 0, 0, 7})), extended);
  EXPECT_EQ(frame_of(bytes({0x40, 0, 7, 1, 4, 0, 0, 0})), Frame::remote_frame(0x701, 4));
  const Frame error = frame_of(bytes({0x20, 0, 0, 4, 8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}));
  EXPECT_TRUE(error.is_error());
  EXPECT_EQ(error.id, 4U);
}

TEST(PcapngTrace, CountsFdFramesAndPassesOverWhatIsNotCan) {
  const std::string ethernet = block(1, little(1) + little(0));
  const std::string content =
      section + can_interface + ethernet + packet(bytes({0, 0, 1, 0x85, 2, 4, 0, 0, 1, 2})) +
      packet(bytes({0, 0, 1, 0x85, 12, 0, 0, 0}) + std::string(12, '\0')) +
      packet(std::string(60, 'x'), "", 1) + block(5, std::string(100, 'x')) +
      block(0xBAD, std::string(200'000, 'x')) + packet(can_185);
  auto trace = TraceReader::of(content);
  ASSERT_TRUE(trace);
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::fd);
  EXPECT_EQ(frame.frame.id, 0x185U);
  EXPECT_EQ(frame.fd.length, 2);
  EXPECT_EQ(frame.fd.data[1], 2);
  EXPECT_EQ(trace->next(frame), TraceRead::fd);
  EXPECT_EQ(frame.fd.length, 12);
  EXPECT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(trace->next(frame), TraceRead::end);
  EXPECT_EQ(trace->fd_frames(), 2U);
  EXPECT_EQ(trace->notes_skipped(), 6U);
  EXPECT_EQ(trace->bad(), 0U);
}

TEST(PcapngTrace, WithABadBlockIsReadOnBehindIt) {
  const std::string head = section + can_interface;
  std::string two_lengths = packet(can_185);
  two_lengths.back() = 1;
  for (const std::string& wrong :
       {packet(can_185, "", 1), packet(bytes({0, 0, 1, 0x85})), two_lengths,
        packet(bytes({0, 0, 8, 0, 0, 0, 0, 0})), packet(bytes({0x40, 0, 8, 0, 0, 0, 0, 0})),
        packet(bytes({0, 0, 1, 0x85, 3, 0, 0, 0, 1, 2})), block(6, little(0)), block(1, ""),
        block(6, std::string(100'000, '\0')), block(0x0A0D0D0A, little(0x1A2B3C4D)),
        block(6, little(0) + little(0) + little(0) + little(9) + little(9) + std::string(8, '\0')),
        block(6, little(0) + little(~0U) + little(0) + little(8) + little(8) +
                     std::string(8, '\0'))}) {
    const std::string content = head + wrong + section + can_interface + packet(can_185);
    auto trace = TraceReader::of(content);
    ASSERT_TRUE(trace);
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::bad);
    EXPECT_EQ(trace->where(), "byte " + std::to_string(head.size()));
    EXPECT_EQ(trace->next(frame), TraceRead::frame) << trace->problem();
    EXPECT_EQ(trace->next(frame), TraceRead::end);
  }
}

TEST(PcapngTrace, EndsWhereNoNextBlockCanBeFound) {
  for (const std::string& wrong :
       {little(6) + little(8) + little(8), little(6) + little(14) + std::string(6, '\0'),
        little(6) + little(0) + little(0)}) {
    const std::string content = section + can_interface + wrong + packet(can_185);
    auto trace = TraceReader::of(content);
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::bad);
    EXPECT_EQ(trace->next(frame), TraceRead::end);
    EXPECT_EQ(trace->position(), content.size());
  }
}

TEST(PcapngTrace, CutOffAnywhereLosesNoWholePacket) {
  const std::string before = section + can_interface + packet(can_185);
  const std::string content = before + packet(can_185);
  for (std::size_t length = before.size(); length < content.size(); ++length) {
    auto trace = TraceReader::of(std::string_view(content).substr(0, length));
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::frame);
    if (length > before.size()) {
      EXPECT_EQ(trace->next(frame), TraceRead::bad) << length;
    }
    EXPECT_EQ(trace->next(frame), TraceRead::end);
  }
}

std::string pcap_file(std::uint32_t magic, std::uint32_t link_type, std::uint32_t fraction,
                      const std::string& data) {
  return little(magic) + little(0x0004'0002) + little(0) + little(0) + little(65535) +
         little(link_type) + little(1'700'000'000) + little(fraction) + little(data.size()) +
         little(data.size()) + data;
}

TEST(PcapTrace, HasTimesInMicrosecondsOrNanoseconds) {
  for (const auto& [magic, fraction] : {std::pair{0xA1B2C3D4U, 125U}, {0xA1B23C4DU, 125'999U}}) {
    const Read read = first_of(pcap_file(magic, 227, fraction, can_185));
    ASSERT_EQ(read.read, TraceRead::frame);
    EXPECT_EQ(read.frame.time, expected_time);
    EXPECT_EQ(read.frame.frame, Frame::data_frame(0x185, {0x1E, 0x2F}));
  }
}

TEST(PcapTrace, OfABigEndianMachineIsRead) {
  const std::string content =
      bytes({0xA1, 0xB2, 0xC3, 0xD4, 0,    2,    0, 4,  0, 0,   0,    0,    0,    0,
             0,    0,    0,    0,    0xFF, 0xFF, 0, 0,  0, 227, 0x65, 0x53, 0xF1, 0,
             0,    0,    0,    125,  0,    0,    0, 10, 0, 0,   0,    10}) +
      can_185;
  const Read read = first_of(content);
  ASSERT_EQ(read.read, TraceRead::frame);
  EXPECT_EQ(read.frame.time, expected_time);
}

TEST(PcapTrace, PassesOverOtherLinksAndTellsOfWhatIsCutOff) {
  EXPECT_EQ(first_of(pcap_file(0xA1B2C3D4, 1, 0, can_185)).read, TraceRead::end);
  const std::string whole = pcap_file(0xA1B2C3D4, 227, 125, can_185);
  for (std::size_t length = 25; length < whole.size(); ++length)
    EXPECT_EQ(first_of(whole.substr(0, length)).read, TraceRead::bad) << length;
  EXPECT_EQ(first_of(whole.substr(0, 12)).read, TraceRead::bad);
}

}  // namespace
}  // namespace canvoy::formats::trace_capture_test
