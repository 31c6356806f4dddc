// Findings at the limits of the rows, with jumps of time, and with invalid frames.
#include "canvoy/text/doctor/doctor.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "canvoy/can/random.hpp"
#include "canvoy/text/doctor/report_text.hpp"

namespace canvoy::doctor_test {
namespace {

using text::Doctor;
using text::FindingKind;
using text::Findings;

const text::Finding* find(const Findings& findings, FindingKind kind) {
  for (const text::Finding& finding : findings) {
    if (finding.kind == kind) return &finding;
  }
  return nullptr;
}

void beat(Doctor& doctor, Time from, Time until, Duration period, NodeId node = 5) {
  for (Time at = from; at < until; at += period) {
    doctor.hear(at, Frame::data_frame(can_id::error_control + node, {5}));
  }
}

/// A server reports its 1016h:01h: node 5 is lost after this number of milliseconds.
void report_consumer(Doctor& doctor, Time at, std::uint16_t milliseconds) {
  doctor.hear(at, Frame::data_frame(0x601, {0x40, 0x16, 0x10, 1, 0, 0, 0, 0}));
  doctor.hear(at + 1ms, Frame::data_frame(
                            0x581, {0x43, 0x16, 0x10, 1, static_cast<std::uint8_t>(milliseconds),
                                    static_cast<std::uint8_t>(milliseconds >> 8U), 5, 0}));
}

TEST(Doctor, TakesAHeartbeatForMissingBehindTheTimeOfAConsumerAndNotBefore) {
  for (const bool is_over : {false, true}) {
    Doctor sut;
    sut.begin(Time{});
    report_consumer(sut, Time(10ms), 1500);
    beat(sut, Time(1s), Time(10s), 1s);  // the last one is at 9 s
    sut.hear(Time(9s) + (is_over ? 1501ms : 1500ms), Frame::data_frame(0x705, {5}));
    const Findings findings = sut.findings(Time(11s));
    const text::Finding* missing = find(findings, FindingKind::heartbeat_missing);
    ASSERT_EQ(missing != nullptr, is_over);
    if (!is_over) continue;
    EXPECT_EQ(missing->node, 5);
    EXPECT_EQ(missing->count, 1U);
    EXPECT_EQ(missing->first, Time(10501ms));
    EXPECT_NE(missing->what.find("node 1 takes it for lost (1016h)"), std::string::npos);
  }
}

TEST(Doctor, ExpectsNoHeartbeatWhereANodeWasResetAndSaysNothingOfItsBootUp) {
  Doctor sut;
  beat(sut, Time(1s), Time(10s), 500ms);
  sut.hear(Time(10s), Frame::data_frame(0x000, {0x81, 5}));
  for (Time at(10s); at < Time(20s); at += 1s) sut.hear(at, Frame::data_frame(0x123, {}));
  sut.hear(Time(19s + 500ms), Frame::data_frame(0x705, {0}));
  beat(sut, Time(20s), Time(30s), 500ms);
  EXPECT_TRUE(sut.findings(Time(30s)).empty());
}

TEST(Doctor, TellsABootUpThatNobodyAskedFor) {
  Doctor sut;
  beat(sut, Time(1s), Time(10s), 500ms);
  sut.hear(Time(9600ms), Frame::data_frame(0x705, {0}));
  const Findings findings = sut.findings(Time(10s));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings.front().kind, FindingKind::unexpected_boot_up);
}

TEST(Doctor, NamesTheStatesThatComeInTurns) {
  Doctor sut;
  for (unsigned i = 0; i < 10; ++i) {
    sut.hear(Time(i * 500ms),
             Frame::data_frame(0x705, {static_cast<std::uint8_t>(i % 2 == 0 ? 5 : 0x7F)}));
  }
  beat(sut, Time(5s), Time(10s), 500ms);
  const Findings findings = sut.findings(Time(10s));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings.front().kind, FindingKind::node_id_twice);
  EXPECT_NE(findings.front().what.find("operational"), std::string::npos);
  EXPECT_NE(findings.front().what.find("pre-operational"), std::string::npos);
}

TEST(Doctor, TakesAnswersToRequestsThatWereGivenUpForNoSecondDevice) {
  Doctor sut;
  beat(sut, Time{}, Time(5s), 500ms);
  const auto ask = [&](Time at) {
    sut.hear(at, Frame::data_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}));
  };
  for (unsigned i = 0; i < 4; ++i) {
    const Time at(5s + i * 600ms);
    ask(at);
    // SDO time-out, 0504 0000h
    sut.hear(at + 500ms, Frame::data_frame(0x605, {0x80, 0x00, 0x10, 0, 0, 0, 4, 5}));
  }
  ask(Time(8s));
  for (unsigned i = 1; i <= 5; ++i) {
    sut.hear(Time(8s + i * 1ms), Frame::data_frame(0x585, {0x43, 0x00, 0x10, 0, 0xA2, 1, 0, 0}));
  }
  EXPECT_EQ(find(sut.findings(Time(8s + 100ms)), FindingKind::node_id_twice), nullptr);
}

TEST(Doctor, TakesAnswersToNodeGuardingForNoHeartbeat) {
  Doctor sut;
  Time at{};
  for (unsigned i = 0; i < 60; ++i, at += i % 2 == 0 ? 700ms : 300ms) {
    sut.hear(at, Frame::remote_frame(0x705, 1));
    sut.hear(at + 1ms,
             Frame::data_frame(0x705, {static_cast<std::uint8_t>(i % 2 == 0 ? 5 : 0x85)}));
  }
  EXPECT_TRUE(sut.findings(at).empty());
}

TEST(Doctor, CountsTheLoadOfASecondByTheBitsOfItsFrames) {
  // 400 frames of 8 bytes 00h and more in a second: 111 bits without stuff bits and intermission,
  // so at least 44,400 of 50,000.
  Doctor sut({.bit_rate = 50'000});
  for (unsigned i = 0; i < 2000; ++i) {
    sut.hear(Time(i * 2500us),
             Frame::data_frame(0x2AA, {0x55, 0xAA, 0x55, 0xAA, 0x55, 0xAA, 0, 1}));
  }
  const Findings findings = sut.findings(Time(5s));
  const text::Finding* peak = find(findings, FindingKind::load_peak);
  ASSERT_NE(peak, nullptr);
  EXPECT_EQ(peak->count, 5U);
  EXPECT_NE(peak->what.find("2AAh"), std::string::npos);
}

TEST(Doctor, TellsSilenceAsANoteAndNotAsAnAlarm) {
  Doctor sut;
  beat(sut, Time(1s), Time(10s), 500ms);
  const Findings findings = sut.findings(Time(60s));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings.front().kind, FindingKind::silence);
  EXPECT_EQ(text::worst_of(findings), text::Severity::note);
}

TEST(Doctor, TellsALostConnectionAndNotTheSilenceBehindIt) {
  Doctor sut;
  sut.begin(Time(1s));
  beat(sut, Time(1s), Time(10s), 500ms);
  sut.lose(Time(11s), "can0: the interface is down");
  const Findings findings = sut.findings(Time(60s));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings.front().kind, FindingKind::lost_bus);
  EXPECT_EQ(findings.front().first, Time(11s));
  EXPECT_NE(findings.front().what.find("the interface is down"), std::string::npos);
  EXPECT_EQ(text::worst_of(findings), text::Severity::error);
}

TEST(Doctor, TellsASilenceThatWasOverBeforeTheConnectionWasLost) {
  Doctor sut;
  beat(sut, Time(1s), Time(10s), 500ms);
  beat(sut, Time(20s), Time(30s), 500ms);
  sut.lose(Time(31s), "can0: the interface is down");
  const Findings findings = sut.findings(Time(32s));
  EXPECT_NE(find(findings, FindingKind::lost_bus), nullptr);
  EXPECT_NE(find(findings, FindingKind::silence), nullptr);
}

TEST(Doctor, IsNotLedAstrayByTimesThatJumpBack) {
  Doctor sut;
  beat(sut, Time(100s), Time(110s), 500ms);
  beat(sut, Time(1s), Time(3s), 500ms);
  for (const text::Finding& finding : sut.findings(Time(110s))) {
    EXPECT_GE(finding.first, Time(100s));
    EXPECT_LE(finding.last, Time(110s));
  }
}

TEST(Doctor, SurvivesNonsenseAndReportsItIn80Columns) {
  Random random(1);
  Doctor sut({.bit_rate = 125'000});
  Time at{};
  for (unsigned i = 0; i < 100'000; ++i) {
    Frame frame;
    frame.id = random.below(4) == 0 ? random.below(0x2000'0000) : random.below(0x800);
    frame.flags = static_cast<FrameFlags>(random.below(16) == 0 ? random.below(8) : 0);
    if (frame.id > Frame::id_max && !frame.is_error())
      frame.flags = frame.flags | FrameFlags::extended;
    frame.length = static_cast<std::uint8_t>(random.below(9));
    for (std::uint8_t i_byte = 0; i_byte < frame.length && !frame.is_remote(); ++i_byte)
      frame.data.at(i_byte) = static_cast<std::uint8_t>(random.below(256));
    sut.hear(at, frame);
    at += Duration(random.below(2000));
  }
  const Findings findings = sut.findings(at);
  EXPECT_FALSE(findings.empty());
  std::istringstream lines(text::report_text("can0", sut.observed(), findings));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(FindingRows, HaveNamesOfTheirOwnAndAllWords) {
  std::set<std::string_view> names;
  for (const text::FindingRow& row : text::finding_rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    for (const std::string_view text : {row.title, row.why, row.check, row.cure})
      EXPECT_FALSE(text.empty()) << row.name;
    EXPECT_NE(row.judge, nullptr) << row.name;
  }
}

}  // namespace
}  // namespace canvoy::doctor_test
