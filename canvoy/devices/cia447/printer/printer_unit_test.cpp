// A printer at its wire (CiA 447-3, 4.2.13): what is transported by SDO, on paper.
#include "canvoy/devices/cia447/printer/printer_unit.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::printer_unit_test {
namespace {

/// PDO 72 is the 18th of the list: 380h + 17 of node 5.
constexpr std::uint32_t status_pdo = 0x391;
constexpr const char* ready = "391#D0 FC FF";
constexpr const char* busy = "391#C1 FC FF";
constexpr const char* transport_refused = "80 EB 60 00 22 00 00 08";

constexpr std::uint8_t cross_bits[] = {0xA0, 0x40, 0xA0};
constexpr PrinterLogo logos[] = {{.width = 3, .bits = cross_bits}};

/// A printer with paper of 32 dots: four characters in a line.
class PrinterBench {
 public:
  explicit PrinterBench(const PrinterSettings& settings)
      : settings_(settings), bench(only_unit<PrinterKind>, [this](Environment& environment) {
          environment.provide(callback<&PrinterBench::hardware>(*this));
          environment.provide(callback<&PrinterBench::settings>(*this));
          environment.watch(unit_);
        }) {}

  PrinterUnit& unit() { return *unit_; }
  std::string ask(const std::string& place) {
    const std::string answer = bench.ask("40 " + place + " 00 00 00 00");
    return answer.size() > 12 ? answer.substr(12) : answer;
  }
  std::string set_mode(const std::string& code) {
    return bench.ask_as(2, "2F E9 60 00 " + code + " 00 00 00");
  }
  std::string configure(const std::string& word) { return bench.ask_as(2, "23 E5 60 00 " + word); }

  /// Starts a segmented download of this number of bytes. Returns the answer.
  std::string begin(std::size_t size, unsigned client = 2) {
    toggle_ = false;
    char request[32];
    std::snprintf(request, sizeof request, "21 EB 60 00 %02X %02X 00 00",
                  static_cast<unsigned>(size & 0xFF), static_cast<unsigned>(size >> 8));
    return bench.ask_as(client, request);
  }
  /// One segment of seven bytes at most.
  std::string segment(std::string_view bytes, bool is_last, unsigned client = 2) {
    const auto unused = static_cast<unsigned>(7 - bytes.size());
    char byte[8];
    std::snprintf(byte, sizeof byte, "%02X",
                  (toggle_ ? 0x10U : 0U) | unused << 1 | (is_last ? 1U : 0U));
    std::string request = byte;
    for (std::size_t i = 0; i < 7; ++i) {
      std::snprintf(byte, sizeof byte, " %02X",
                    i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
      request += byte;
    }
    toggle_ = !toggle_;
    return bench.ask_as(client, request);
  }
  /// All of it; the last answer.
  std::string transport(std::string_view bytes) {
    std::string answer = begin(bytes.size());
    while (!bytes.empty() && answer.substr(0, 2) != "80") {
      const std::string_view piece = bytes.substr(0, 7);
      bytes.remove_prefix(piece.size());
      answer = segment(piece, bytes.empty());
    }
    return answer;
  }
  std::string last_status() {
    bench.cable.run_for(0s);
    return bench.cable.last(status_pdo);
  }
  std::string take() { return std::exchange(done, ""); }

  /// "A" a character, "+16" a feed, "|" a cut, ".#o" dots up to the last one that is not white.
  std::string done;
  PrintStyle style;

 private:
  void put(const PrintedCharacter& one) {
    done += one.character < 0x7F ? static_cast<char>(one.character) : '?';
    style = one.style;
  }
  void put_row(std::span<const PrintColor> row) {
    std::string dots;
    for (const PrintColor& dot : row) {
      dots += dot == PrintColor{} ? '.' : dot == PrintColor{0, 0, 0} ? '#' : 'o';
    }
    done += dots.substr(0, dots.find_last_not_of('.') + 1);
  }
  void feed(unsigned dots) { done += "+" + std::to_string(dots) + " "; }
  void cut() { done += "| "; }
  PrinterHardware hardware() {
    return {.paper = {.put = callback<&PrinterBench::put>(*this),
                      .put_row = callback<&PrinterBench::put_row>(*this),
                      .feed = callback<&PrinterBench::feed>(*this),
                      .cut = callback<&PrinterBench::cut>(*this)}};
  }
  PrinterSettings settings() { return settings_; }

  PrinterSettings settings_;
  PrinterUnit* unit_ = nullptr;
  bool toggle_ = false;

 public:
  CarBench bench;
};

class Printer : public testing::Test {
 protected:
  PrinterBench printer{{.font = {.dots_per_line = 32}, .logos = logos}};
};

constexpr const char* done_segment = "20 00 00 00 00 00 00 00";
constexpr const char* done_toggled = "30 00 00 00 00 00 00 00";

// 60E0h, 60E1h and the transport of text.

TEST_F(Printer, IsReadyAtFirst) {
  // Ready 0, buffer empty 1, reserved 11b; paper 0, seven times 11b.
  EXPECT_EQ(printer.bench.cable.last(status_pdo), ready);
  EXPECT_EQ(printer.ask("EA 60 00"), "00 00 00 00") << "text";
}

TEST_F(Printer, PrintsTextAndIsBusyUntilThePaperHasMoved) {
  EXPECT_EQ(printer.transport("Ab\n"), done_segment);
  EXPECT_EQ(printer.take(), "Ab+16 ");
  EXPECT_EQ(printer.ask("E0 60 00"), "C1 00 00 00") << "busy, and the buffer is not empty";
  // 16 dots at 400 dots a second take 40 ms.
  printer.bench.cable.run_for(39ms);
  EXPECT_EQ(printer.bench.cable.count(status_pdo), 0u);
  printer.bench.cable.run_for(1ms);
  EXPECT_EQ(printer.bench.cable.last(status_pdo), ready);
}

TEST_F(Printer, TheNextTransportWaitsInTheBuffer) {
  printer.transport("a\n");
  printer.bench.cable.run_for(10ms);
  printer.transport("b\nc\n");
  EXPECT_EQ(printer.take(), "a+16 b+16 c+16 ");
  printer.bench.cable.run_for(109ms);
  EXPECT_EQ(printer.ask("E0 60 00"), "C1 00 00 00");
  printer.bench.cable.run_for(1ms);
  EXPECT_EQ(printer.ask("E0 60 00"), "D0 00 00 00") << "48 dots after 120 ms";
}

TEST_F(Printer, TextIsPrintedAsItComes) {
  EXPECT_EQ(printer.begin(9), "60 EB 60 00 00 00 00 00");
  EXPECT_EQ(printer.last_status(), busy);
  EXPECT_EQ(printer.segment("a\nbcdef", false), done_segment);
  EXPECT_EQ(printer.take(), "a+16 bcde+16 f") << "a line has four characters";
  EXPECT_EQ(printer.segment("g\n", true), done_toggled);
  EXPECT_EQ(printer.take(), "g+16 ");
}

TEST_F(Printer, AShortTextFitsIntoOneFrame) {
  EXPECT_EQ(printer.bench.ask_as(2, "23 EB 60 00 48 69 0A 04"), "60 EB 60 00 00 00 00 00");
  EXPECT_EQ(printer.take(), "Hi+16 | ");
}

TEST_F(Printer, WhatWasTransportedIsNotKept) {
  EXPECT_EQ(printer.bench.ask("40 EB 60 00 00 00 00 00"), "80 EB 60 00 24 00 00 08");
}

TEST_F(Printer, OneClientAtATimeTransports) {
  printer.begin(4, 2);
  printer.segment("ab", false, 2);
  EXPECT_EQ(printer.bench.ask_as(3, "21 EB 60 00 02 00 00 00"), transport_refused);
  printer.segment("cd", true, 2);
  EXPECT_EQ(printer.begin(2, 3), "60 EB 60 00 00 00 00 00");
  printer.segment("e\n", true, 3);
  EXPECT_EQ(printer.take(), "abcd+16 e+16 ");
}

TEST_F(Printer, AClientThatBreaksOffLeavesThePrinterToOthers) {
  printer.begin(20);
  printer.segment("ab\xC3", false);
  printer.bench.ask_as(2, "80 EB 60 00 00 00 00 08");
  EXPECT_EQ(printer.take(), "ab?") << "half a character is none";
  printer.bench.cable.run_for(0s);
  EXPECT_EQ(printer.ask("E0 60 00"), "D0 00 00 00");
  EXPECT_EQ(printer.transport("c\n"), done_segment);
  EXPECT_EQ(printer.take(), "c+16 ") << "the line goes on";
}

TEST_F(Printer, AClientThatFallsSilentLeavesThePrinterToOthers) {
  printer.begin(20, 2);
  printer.segment("ab", false, 2);
  printer.bench.cable.run_for(999ms);
  EXPECT_EQ(printer.bench.ask_as(3, "21 EB 60 00 02 00 00 00"), transport_refused);
  // An SDO server waits for a second.
  printer.bench.cable.run_for(1ms);
  EXPECT_EQ(printer.begin(2, 3), "60 EB 60 00 00 00 00 00");
  EXPECT_EQ(printer.segment("c\n", true, 3), done_segment);
  EXPECT_EQ(printer.take(), "abc+16 ");
}

TEST_F(Printer, AnEmptyTransportIsNothing) {
  EXPECT_EQ(printer.begin(0), "60 EB 60 00 00 00 00 00");
  EXPECT_EQ(printer.segment("", true), done_segment);
  EXPECT_EQ(printer.take(), "");
  EXPECT_EQ(printer.last_status(), ready);
}

// Paper and mechanism.

TEST_F(Printer, WithoutPaperNothingIsPrinted) {
  printer.unit().sense_paper(false);
  // Failure Eh; np 01b.
  EXPECT_EQ(printer.last_status(), "391#DE FD FF");
  EXPECT_EQ(printer.begin(1), transport_refused);
  printer.unit().sense_paper(true);
  EXPECT_EQ(printer.last_status(), ready);
  EXPECT_EQ(printer.transport("a\n"), done_segment);
}

TEST_F(Printer, PaperThatEndsInTheMiddleEndsTheTransport) {
  printer.begin(20);
  printer.segment("ab\nc", false);
  printer.unit().sense_paper(false);
  EXPECT_EQ(printer.segment("d\n", false), transport_refused);
  EXPECT_EQ(printer.take(), "ab+16 c");
  EXPECT_EQ(printer.last_status(), "391#DE FD FF");
  printer.bench.cable.run_for(1s);
  EXPECT_EQ(printer.ask("E0 60 00"), "DE 00 00 00");
  printer.unit().sense_paper(true);
  EXPECT_EQ(printer.last_status(), ready);
}

TEST_F(Printer, ABrokenMechanismIsAFailureOfAllSignals) {
  printer.unit().sense(PrinterMechanism::failure);
  EXPECT_EQ(printer.last_status(), "391#EE FE FF");
  EXPECT_EQ(printer.begin(1), transport_refused);
  printer.unit().sense(PrinterMechanism::working);
  EXPECT_EQ(printer.last_status(), ready);
}

TEST_F(Printer, APrinterInStandbyWakesUpForATransport) {
  printer.unit().sense(PrinterMechanism::standby);
  EXPECT_EQ(printer.last_status(), "391#D2 FC FF");
  printer.begin(2);
  EXPECT_EQ(printer.last_status(), busy);
  EXPECT_EQ(printer.segment("a\n", true), done_segment);
  printer.bench.cable.run_for(1s);
  EXPECT_EQ(printer.bench.cable.last(status_pdo), ready);
}

TEST_F(Printer, AResetEndsATransport) {
  printer.begin(20);
  printer.segment("ab", false);
  printer.bench.cable.send("000#81 05");
  printer.bench.cable.send("000#01 05");
  EXPECT_EQ(printer.ask("EA 60 00"), "00 00 00 00");
  EXPECT_EQ(printer.transport("c\n"), done_segment);
  EXPECT_EQ(printer.take(), "abc+16 ");
}

// 60E9h and 60EAh.

TEST_F(Printer, EachModeHasItsBytes) {
  for (const char* code : {"00", "01", "02", "03", "04", "05"}) {
    EXPECT_EQ(printer.set_mode(code), "60 E9 60 00 00 00 00 00");
    EXPECT_EQ(printer.ask("EA 60 00"), std::string(code) + " 00 00 00");
  }
  printer.set_mode("01");
  printer.transport("\xA5\x1B\x0A");
  EXPECT_EQ(printer.take(), "#.#..#.#+1 ");
  printer.set_mode("02");
  printer.transport(std::string_view("\xFF\x01\x00\xFF\x1B\x0A", 6));
  EXPECT_EQ(printer.take(), "#o.#+1 ");
  printer.set_mode("03");
  printer.transport(std::string_view("\xFF\x00\x00\x00\x00\x00\x1B\x0A", 8));
  EXPECT_EQ(printer.take(), "o#+1 ");
  printer.set_mode("04");
  printer.transport(std::string_view("\x00\x00\x00\xFF\xFF\x00\x00\x00\x1B\x0A", 10));
  EXPECT_EQ(printer.take(), "#o+1 ");
  printer.set_mode("05");
  printer.transport("\x20\x0A\x04");
  EXPECT_EQ(printer.take(), "#.#+1 .#+1 #.#+1 +1 | ");
}

TEST_F(Printer, DoNotCareLeavesTheModeAndReservedOnesAreRefused) {
  printer.set_mode("03");
  EXPECT_EQ(printer.set_mode("FF"), "60 E9 60 00 00 00 00 00");
  EXPECT_EQ(printer.ask("EA 60 00"), "03 00 00 00");
  EXPECT_EQ(printer.set_mode("06"), "80 E9 60 00 30 00 09 06");
  EXPECT_EQ(printer.set_mode("FE"), "80 E9 60 00 30 00 09 06");
  EXPECT_EQ(printer.ask("EA 60 00"), "03 00 00 00");
}

TEST_F(Printer, TheModeStaysDuringATransport) {
  printer.begin(4);
  printer.segment("ab", false);
  EXPECT_EQ(printer.bench.ask_as(3, "2F E9 60 00 01 00 00 00"), "80 E9 60 00 22 00 00 08");
  EXPECT_EQ(printer.bench.ask_as(3, "2F E9 60 00 FF 00 00 00"), "60 E9 60 00 00 00 00 00");
  EXPECT_EQ(printer.segment("c\n", true), done_toggled);
  EXPECT_EQ(printer.take(), "abc+16 ");
}

// 60E5h and 60E6h: bold in bits 1..0, cursive, variable width, color space; then height, width and
// characters, a byte each.

TEST_F(Printer, NothingIsSetAtFirst) {
  EXPECT_EQ(printer.ask("E6 60 00"), "00 00 00 00");
  EXPECT_EQ(printer.ask("E3 60 00"), "09 00 00 00");
  EXPECT_EQ(printer.ask("E3 60 03"), "04 00 00 00") << "32 dots by 8";
  EXPECT_EQ(printer.ask("E3 60 06"), "10 00 00 00");
  EXPECT_EQ(printer.ask("E3 60 09"), "08 00 00 00");
}

TEST_F(Printer, TheFontIsSet) {
  // Bold, and not: cursive, variable; RGB; 32 dots high, 16 wide, characters left alone.
  EXPECT_EQ(printer.configure("41 20 10 FF"), "60 E5 60 00 00 00 00 00");
  EXPECT_EQ(printer.ask("E6 60 00"), "01 20 10 00");
  EXPECT_EQ(printer.ask("E3 60 03"), "02 00 00 00");
  EXPECT_EQ(printer.ask("E3 60 06"), "20 00 00 00");
  EXPECT_EQ(printer.ask("E3 60 09"), "10 00 00 00");
  printer.transport("abc\n");
  EXPECT_EQ(printer.take(), "ab+32 c+32 ");
  EXPECT_EQ(printer.style, (PrintStyle{.height = 32, .width = 16, .is_bold = true}));
}

TEST_F(Printer, DoNotCareLeavesASettingAndNoCommandTurnsStylesOff) {
  printer.configure("15 20 10 02");
  EXPECT_EQ(printer.ask("E6 60 00"), "15 20 10 02");
  EXPECT_EQ(printer.configure("FF FF FF FF"), "60 E5 60 00 00 00 00 00");
  EXPECT_EQ(printer.ask("E6 60 00"), "15 20 10 02");
  printer.configure("FC FF 00 FF");
  EXPECT_EQ(printer.ask("E6 60 00"), "14 20 10 02") << "bold alone; no command for the width";
  printer.configure("00 00 00 00");
  EXPECT_EQ(printer.ask("E6 60 00"), "00 20 10 02");
  printer.bench.cable.send("000#81 05");
  EXPECT_EQ(printer.ask("E6 60 00"), "00 00 00 00") << "after a reset nothing is set";
}

TEST_F(Printer, TheColorSpaceIsCountedInAnotherWayInTheStatus) {
  // Command 1 RGB, 2 CMYK; status 0 RGB, 1 CMYK (errata Z16).
  printer.configure("BF FF FF FF");
  EXPECT_EQ(printer.ask("E6 60 00"), "40 00 00 00");
  printer.configure("3F FF FF FF");
  EXPECT_EQ(printer.ask("E6 60 00"), "40 00 00 00") << "no command changes nothing here";
  printer.configure("7F FF FF FF");
  EXPECT_EQ(printer.ask("E6 60 00"), "00 00 00 00");
}

TEST_F(Printer, WhatItCannotDoIsRefusedAndNothingChanges) {
  // 15 and 65 dots high, 7 and 33 wide, 5 characters; FDh and FEh are reserved, 2 as well.
  for (const char* word :
       {"FF 0F FF FF", "FF 41 FF FF", "FF FF 07 FF", "FF FF 21 FF", "FF FF FF 05", "FF FD FF FF",
        "FF FF FE FF", "FE FF FF FF", "01 20 10 05"}) {
    EXPECT_EQ(printer.configure(word), "80 E5 60 00 30 00 09 06") << word;
  }
  EXPECT_EQ(printer.ask("E6 60 00"), "00 00 00 00");
}

// 60E2h to 60E4h.

TEST_F(Printer, TellsWhatItCanDo) {
  // Bits 21..0 eleven times 01b; one logo in bits 26..22; cut 01b in 28..27; 3 in 31..29.
  EXPECT_EQ(printer.ask("E2 60 00"), "55 55 55 68");
  EXPECT_EQ(printer.ask("E3 60 01"), "04 00 00 00");
  EXPECT_EQ(printer.ask("E3 60 02"), "01 00 00 00");
  EXPECT_EQ(printer.ask("E3 60 04"), "40 00 00 00");
  EXPECT_EQ(printer.ask("E3 60 05"), "10 00 00 00");
  EXPECT_EQ(printer.ask("E3 60 07"), "20 00 00 00");
  EXPECT_EQ(printer.ask("E3 60 08"), "08 00 00 00");
  EXPECT_EQ(printer.ask("E4 60 00"), "03 00 00 00");
  EXPECT_EQ(printer.ask("E4 60 01"), "20 00 00 00");
  EXPECT_EQ(printer.ask("E4 60 02"), "00 01 00 00");
  EXPECT_EQ(printer.ask("E4 60 03"), "08 00 00 00");
}

TEST(SimplePrinter, LacksWhatItCannotDo) {
  PrinterBench printer({.can = {.bold = false,
                                .cursive = false,
                                .variable_width = false,
                                .gray = false,
                                .rgb = false,
                                .cmyk = false,
                                .cut = false},
                        .font = {.dots_per_line = 32, .height_max = 16, .width_max = 8},
                        .lines_to_form_feed = 5});
  // Text, fixed width, graphics, black: bits 0, 10, 12, 14; form feed 5.
  EXPECT_EQ(printer.ask("E2 60 00"), "01 54 00 A0");
  EXPECT_EQ(printer.ask("E4 60 02"), "FF FF 00 00");
  EXPECT_EQ(printer.ask("E4 60 03"), "FF FF 00 00");
  // Bold, cursive and variable width read as not implemented: 10 10 10b.
  EXPECT_EQ(printer.ask("E5 60 00"), "EA FF FF FF");
  EXPECT_EQ(printer.configure("D5 FF FF FF"), "60 E5 60 00 00 00 00 00");
  EXPECT_EQ(printer.ask("E6 60 00"), "00 00 00 00");
  EXPECT_EQ(printer.configure("7F FF FF FF"), "80 E5 60 00 30 00 09 06") << "RGB";
  EXPECT_EQ(printer.configure("BF FF FF FF"), "80 E5 60 00 30 00 09 06") << "CMYK";
  for (const char* mode : {"02", "03", "04", "05"}) {
    EXPECT_EQ(printer.set_mode(mode), "80 E9 60 00 30 00 09 06") << mode;
  }
  printer.transport("a\x04");
  EXPECT_EQ(printer.take(), "a+16 ");
}

TEST(GraphicsPrinter, PrintsNoText) {
  PrinterBench printer({.can = {.text = false}, .font = {.dots_per_line = 32}});
  EXPECT_EQ(printer.ask("EA 60 00"), "01 00 00 00");
  EXPECT_EQ(printer.set_mode("00"), "80 E9 60 00 30 00 09 06");
  // Graphics, black, gray, RGB, CMYK, cut; form feed 3: 0000 0001 0101 0101 ...
  EXPECT_EQ(printer.ask("E2 60 00"), "00 50 15 68");
  EXPECT_EQ(printer.ask("E5 60 00"), "FF FE FE FE");
}

TEST(FeedingPrinter, FeedsByItselfWhenAllIsPrinted) {
  PrinterBench printer({.font = {.dots_per_line = 32}, .lines_to_form_feed = 0});
  EXPECT_EQ(printer.ask("E2 60 00"), "55 55 15 08");
  printer.transport("a\n");
  printer.transport("b\n");
  printer.bench.cable.run_for(79ms);
  EXPECT_EQ(printer.take(), "a+16 b+16 ");
  printer.bench.cable.run_for(1ms);
  EXPECT_EQ(printer.take(), "+16 +16 +16 ");
  EXPECT_EQ(printer.ask("E0 60 00"), "C1 00 00 00");
  printer.bench.cable.run_for(120ms);
  EXPECT_EQ(printer.ask("E0 60 00"), "D0 00 00 00");
  printer.bench.cable.run_for(10s);
  EXPECT_EQ(printer.take(), "") << "once";
}

}  // namespace
}  // namespace canvoy::cia447::printer_unit_test
