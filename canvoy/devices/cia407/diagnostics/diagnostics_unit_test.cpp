// The diagnostics device at its wire: the rules of 9.2.27.
#include "canvoy/devices/cia407/diagnostics/diagnostics_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_entry.hpp"
#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"

namespace canvoy::cia407::diagnostics_unit_test {
namespace {

class Diagnostics : public testing::Test {
 protected:
  static constexpr const BusUnit* units[] = {&bus_unit<DiagnosticsKind>};
  std::string short_error(const std::string& sub) {
    return bench.ask("40 40 67 " + sub + " 00 00 00 00").substr(12);
  }
  std::string count(const std::string& place) {
    return bench.ask("40 " + place + " 00 00 00 00 00").substr(12, 2);
  }

  DiagnosticsUnit* unit = nullptr;
  BusBench bench{units, [this](Environment& environment) { environment.watch(unit); }};
};

TEST_F(Diagnostics, ShortErrorsMoveDownTheList) {
  bench.ask("23 40 67 01 20 31 12 00");
  bench.ask("23 40 67 01 01 FF 07 00");
  EXPECT_EQ(count("40 67"), "02");
  EXPECT_EQ(short_error("01"), "01 FF 07 00");
  EXPECT_EQ(short_error("02"), "20 31 12 00");
  EXPECT_EQ(bench.cable.last(0x285), "285#02") << "their number, as it changes";
  EXPECT_EQ(bench.ask("23 40 67 02 00 00 00 00"), "80 40 67 02 02 00 01 06") << "read only";
}

/// The 65,535 errors (9.2.27.1) are 1 to FFFFh: 0 means no error.
TEST_F(Diagnostics, NoErrorIsNone) {
  EXPECT_EQ(bench.ask("23 40 67 01 00 00 00 00"), "60 40 67 01 00 00 00 00");
  EXPECT_EQ(count("40 67"), "00");
  EXPECT_EQ(bench.upload(0x6741, 0), "");
  bench.ask("23 40 67 01 20 31 12 00");
  bench.ask("23 40 67 01 00 00 00 00");
  bench.ask("23 40 67 01 00 00 12 00");
  EXPECT_EQ(count("40 67"), "01");
  EXPECT_EQ(short_error("01"), "20 31 12 00");
  EXPECT_EQ(short_error("02"), "00 00 00 00");
}

TEST_F(Diagnostics, A0DeletesThemAndMoreIsRefused) {
  unit->report(0x12, 0x3120);
  EXPECT_EQ(bench.ask("2F 40 67 00 01 00 00 00"), "80 40 67 00 30 00 09 06");
  EXPECT_EQ(count("40 67"), "01");
  EXPECT_EQ(bench.ask("2F 40 67 00 00 00 00 00"), "60 40 67 00 00 00 00 00");
  EXPECT_EQ(count("40 67"), "00");
  EXPECT_EQ(short_error("01"), "00 00 00 00");
}

TEST_F(Diagnostics, OfAFullHistoryTheOldestGoes) {
  for (unsigned i = 1; i <= 200; ++i) unit->report(1, static_cast<std::uint16_t>(i));
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x185), "185#00 00 00 00 00 00 00 00") << "200 are no event";
  unit->report(1, 201);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 01 00 00 16") << "201 are";
  for (unsigned i = 202; i <= 260; ++i) unit->report(1, static_cast<std::uint16_t>(i));
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 03 00 00 16") << "close to the limit";
  EXPECT_EQ(count("40 67"), "FE");
  EXPECT_EQ(short_error("01"), "04 01 01 00");
  EXPECT_EQ(short_error("FE"), "07 00 01 00");
}

TEST_F(Diagnostics, MessagesStandInTheOrderOfTheirArrival) {
  EXPECT_TRUE(bench.download(0x6742, 1, "door 2 is stiff"));
  EXPECT_TRUE(bench.download(0x6742, 1, "oil is low now"));
  EXPECT_EQ(count("42 67"), "02");
  std::string first = "door 2 is stiff";
  first.resize(64);
  std::string second = "oil is low now";
  second.resize(64);
  EXPECT_EQ(bench.upload(0x6742, 1), first) << "zeros behind the end";
  EXPECT_EQ(bench.upload(0x6742, 2), second);
  EXPECT_EQ(count("43 67"), "00") << "another class";
}

TEST_F(Diagnostics, A0DeletesWhatWasReadAndA1All) {
  for (const char* text : {"first message", "second message", "third message"}) {
    bench.download(0x6743, 1, text);
  }
  bench.upload(0x6743, 2);
  EXPECT_EQ(bench.ask("2F 43 67 00 02 00 00 00"), "80 43 67 00 30 00 09 06");
  bench.ask("2F 43 67 00 00 00 00 00");
  EXPECT_EQ(count("43 67"), "02");
  EXPECT_EQ(bench.upload(0x6743, 2).substr(0, 13), "third message") << "gaps are closed";
  bench.ask("2F 43 67 00 01 00 00 00");
  EXPECT_EQ(count("43 67"), "00");
  EXPECT_EQ(bench.upload(0x6743, 1), "");
}

TEST_F(Diagnostics, AMessageIs64CharactersOf7Bits) {
  EXPECT_TRUE(bench.download(0x6744, 1, std::string(64, 'x')));
  EXPECT_FALSE(bench.download(0x6744, 1, std::string(65, 'x')));
  EXPECT_FALSE(bench.download(0x6744, 1, "caf\xE9 is closed"));
  EXPECT_EQ(count("44 67"), "01");
}

TEST_F(Diagnostics, AFullClassTakesNoMore) {
  for (unsigned i = 0; i < 254; ++i) EXPECT_TRUE(unit->report(ErrorClass::third, "again"));
  EXPECT_FALSE(unit->report(ErrorClass::third, "again"));
  EXPECT_FALSE(bench.download(0x6744, 1, "one more of them"));
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 10 00 00 16");
}

TEST_F(Diagnostics, TheFileHasALineForEachAndIsErasedBy0) {
  const char* told[] = {"2F 0E 61 01 29 00 00 00", "2F 0E 61 02 5C 00 00 00",
                        "2F 0E 61 03 0B 00 00 00", "2F 0E 61 04 08 00 00 00",
                        "2F 0E 61 05 05 00 00 00", "2F 0E 61 06 04 00 00 00"};
  for (const char* each : told) bench.ask(each);
  bench.ask("23 40 67 01 20 31 12 00");
  bench.download(0x6742, 1, "door 2 is stiff");
  EXPECT_EQ(bench.upload(0x6741, 0),
            "2026-11-23 08:05:01 0012 3120\n\r2026-11-23 08:05:01 door 2 is stiff\n\r");
  EXPECT_EQ(bench.ask("2F 41 67 00 01 00 00 00"), "80 41 67 00 30 00 09 06");
  EXPECT_EQ(bench.ask("2F 41 67 00 00 00 00 00"), "60 41 67 00 00 00 00 00");
  EXPECT_EQ(unit->file(), "");
}

TEST_F(Diagnostics, OfAFullFileTheOldestLinesGo) {
  for (unsigned i = 0; i < 3000; ++i) unit->report(0, static_cast<std::uint16_t>(i));
  EXPECT_LE(unit->file().size(), DiagnosticsUnit::file_size);
  EXPECT_GT(unit->file().size(), DiagnosticsUnit::file_size - 11);
  EXPECT_EQ(unit->file().substr(unit->file().size() - 11), "0000 0BB7\n\r");
  EXPECT_EQ(unit->file().substr(0, 5), "0000 ") << "a whole line";
}

/// 6741h, segment by segment (CiA 301, 7.2.4.3.5).
class FileReader {
 public:
  explicit FileReader(BusBench& bench) : bench_(bench) {}
  /// The answer to the request for it.
  std::string begin() { return bench_.ask("40 41 67 00 00 00 00 00"); }
  /// Empty: there is one; else the abort.
  std::string next() {
    const std::string answer =
        bench_.ask((toggle_ ? "70" : "60") + std::string(" 00 00 00 00 00 00 00"));
    const unsigned long command = std::stoul(answer, nullptr, 16);
    if (command == 0x80) return answer;
    toggle_ = !toggle_;
    is_over = (command & 1) != 0;
    for (std::size_t i = 1; i <= 7 - (command >> 1 & 7); ++i) {
      text += static_cast<char>(std::stoul(answer.substr(i * 3, 2), nullptr, 16));
    }
    return "";
  }

  std::string text;
  bool is_over = false;

 private:
  BusBench& bench_;
  bool toggle_ = false;
};

/// A line of 11 bytes for each; 1489 of them fill the file, and the next one drops the oldest.
std::string lines_of(unsigned first, unsigned end) {
  std::string lines;
  for (unsigned i = first; i < end; ++i) {
    char line[16];
    std::snprintf(line, sizeof line, "0000 %04X\n\r", i);
    lines += line;
  }
  return lines;
}
constexpr unsigned full = 1489;

TEST_F(Diagnostics, WhoReadsTheFileGetsItAsItWasWhenHeBegan) {
  for (unsigned i = 0; i < full; ++i) unit->report(0, static_cast<std::uint16_t>(i));
  FileReader reader(bench);
  EXPECT_EQ(reader.begin(), "41 41 67 00 FB 3F 00 00") << "16,379 bytes";
  for (unsigned i = 0; !reader.is_over && i < 3000; ++i) {
    ASSERT_EQ(reader.next(), "") << "segment " << i;
    // Lines that the reader already has are dropped.
    if (i % 100 == 50) unit->report(0, 0xFFFF);
  }
  EXPECT_EQ(reader.text, lines_of(0, full));
}

/// The first answer that is no segment; empty: there is none until the end.
template <class Reader>
std::string last_answer_of(Reader& reader) {
  std::string answer;
  while (answer.empty() && !reader.is_over) answer = reader.next();
  return answer;
}

TEST_F(Diagnostics, WhereLinesGoThatAreNotReadYetThereIsNoFile) {
  for (unsigned i = 0; i < full; ++i) unit->report(0, static_cast<std::uint16_t>(i));
  FileReader reader(bench);
  reader.begin();
  EXPECT_EQ(reader.next(), "");
  constexpr unsigned more = 400;  // the first lines are dropped: more than a server reads ahead
  for (unsigned i = full; i < full + more; ++i) unit->report(0, static_cast<std::uint16_t>(i));
  EXPECT_EQ(last_answer_of(reader), "80 41 67 00 22 00 00 08") << "the state of the device";
  EXPECT_EQ(bench.upload(0x6741, 0), lines_of(more, full + more)) << "again, and whole";
}

/// Like another SDO channel: writes a 0 to 6741h.
AbortCode erase(Dictionary& dictionary) {
  std::array<std::uint8_t, 8> buffer{};
  SdoEntry entry(dictionary, buffer);
  AbortCode answer = entry.find({extended_diagnostic_message_file_object.index, 0});
  if (answer == AbortCode::none) answer = entry.open_write(1);
  const std::uint8_t zero = 0;
  if (answer == AbortCode::none) answer = entry.write({&zero, 1});
  return answer == AbortCode::none ? entry.finish() : answer;
}

TEST_F(Diagnostics, WhoIsNotAtItsEndWhenTheFileIsErasedGetsNone) {
  for (unsigned i = 0; i < 300; ++i) unit->report(0, static_cast<std::uint16_t>(i));
  FileReader reader(bench);
  EXPECT_EQ(reader.begin(), "41 41 67 00 E4 0C 00 00") << "3,300 bytes: more than is read ahead";
  EXPECT_EQ(reader.next(), "");
  EXPECT_EQ(erase(bench.node().dictionary()), AbortCode::none);
  // Lines of the new file are at the positions of the old ones.
  for (unsigned i = 7; i < 10; ++i) unit->report(0, static_cast<std::uint16_t>(i));
  EXPECT_EQ(last_answer_of(reader), "80 41 67 00 22 00 00 08") << "the state of the device";
  EXPECT_EQ(bench.upload(0x6741, 0), lines_of(7, 10)) << "the new one, and whole";
}

TEST_F(Diagnostics, WhoErasesTheFileOnTheChannelThatReadsItEndsTheReading) {
  for (unsigned i = 0; i < 3; ++i) unit->report(0, static_cast<std::uint16_t>(i));
  FileReader reader(bench);
  reader.begin();
  EXPECT_EQ(reader.next(), "");
  EXPECT_EQ(bench.ask("2F 41 67 00 00 00 00 00"), "60 41 67 00 00 00 00 00");
  EXPECT_EQ(reader.next().substr(12), "01 00 04 05") << "no transfer goes on (CiA 301, 7.2.4.3.17)";
  EXPECT_EQ(bench.upload(0x6741, 0), "");
}

/// 9.2.27.2: a 0 deletes it, values above 0 are refused. A 0 has as many bytes as its writer likes.
TEST_F(Diagnostics, AZeroOfAnySizeErasesTheFileAndNothingElse) {
  for (const char* const zero :
       {"2F 41 67 00 00 00 00 00", "2B 41 67 00 00 00 00 00", "23 41 67 00 00 00 00 00",
        "22 41 67 00 00 00 00 00", "2F 41 67 00 30 00 00 00"}) {
    unit->report(0x12, 0x3120);
    EXPECT_NE(bench.upload(0x6741, 0), "");
    EXPECT_EQ(bench.ask(zero), "60 41 67 00 00 00 00 00") << zero;
    EXPECT_EQ(bench.upload(0x6741, 0), "") << zero;
  }
  unit->report(0x12, 0x3120);
  for (const char* const other :
       {"2F 41 67 00 01 00 00 00", "2B 41 67 00 00 01 00 00", "2B 41 67 00 30 30 00 00",
        "2B 41 67 00 00 30 00 00", "2B 41 67 00 30 00 00 00"}) {
    EXPECT_EQ(bench.ask(other), "80 41 67 00 30 00 09 06") << other;
  }
  EXPECT_FALSE(bench.download(0x6741, 0, std::string(9, '\0'))) << "no number has nine bytes";
  EXPECT_NE(bench.upload(0x6741, 0), "");
}

TEST_F(Diagnostics, ItsHistoriesOutliveAReset) {
  unit->report(0x12, 0x3120);
  bench.download(0x6742, 1, "door 2 is stiff");
  bench.cable.send("000#81 05");
  EXPECT_EQ(count("40 67"), "01");
  EXPECT_EQ(short_error("01"), "20 31 12 00");
  EXPECT_EQ(bench.upload(0x6742, 1).substr(0, 15), "door 2 is stiff");
}

}  // namespace
}  // namespace canvoy::cia407::diagnostics_unit_test
