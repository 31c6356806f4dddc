// Displays, buzzer, warnings and icons of a terminal at its wire (CiA 447-3, 4.2.9.17 to 4.2.9.32).
#include <gtest/gtest.h>

#include "canvoy/devices/cia447/terminal/terminal_bench_test.hpp"

namespace canvoy::cia447::terminal_display_test {
namespace {

constexpr const char* lock_display_1 = "2F 98 60 00 FD 00 00 00";
constexpr const char* release_display_1 = "2F 98 60 00 FC 00 00 00";
constexpr const char* write_abc = "27 99 60 00 61 62 63 00";
constexpr const char* done_text = "60 99 60 00 00 00 00 00";
constexpr const char* refused_text = "80 99 60 00 22 00 00 08";
constexpr const char* wrong_text = "80 99 60 00 30 00 09 06";

// Displays.

TEST(TerminalDisplays, TheParametersCountFromOne) {
  TerminalBench terminal({.display_1 = {.lines = 1, .columns = 254, .characters = 254},
                          .display_2 = {.lines = 2, .columns = 16, .characters = 32}});
  // 00h is one line, FDh 254 columns (errata A6).
  EXPECT_EQ(terminal.ask("40 96 60 00 00 00 00 00"), "4F 96 60 00 03 00 00 00");
  EXPECT_EQ(terminal.ask("40 96 60 01 00 00 00 00"), "4F 96 60 01 00 00 00 00");
  EXPECT_EQ(terminal.ask("40 96 60 02 00 00 00 00"), "4F 96 60 02 FD 00 00 00");
  EXPECT_EQ(terminal.ask("40 96 60 03 00 00 00 00"), "4F 96 60 03 FD 00 00 00");
  EXPECT_EQ(terminal.ask("40 9B 60 01 00 00 00 00"), "4F 9B 60 01 01 00 00 00");
  EXPECT_EQ(terminal.ask("40 9B 60 02 00 00 00 00"), "4F 9B 60 02 0F 00 00 00");
  EXPECT_EQ(terminal.ask("40 9B 60 03 00 00 00 00"), "4F 9B 60 03 1F 00 00 00");
}

TEST(TerminalDisplays, WhoHasADisplayWritesOnIt) {
  TerminalBench terminal;
  terminal.ask_as(2, lock_display_1);
  EXPECT_EQ(terminal.holder, 2u);
  EXPECT_EQ(terminal.ask_as(2, write_abc), done_text);
  EXPECT_EQ(terminal.display, 1u);
  EXPECT_EQ(terminal.text, "abc");
  EXPECT_EQ(terminal.ask_as(2, "2B 9A 60 00 48 69 00 00"), "60 9A 60 00 00 00 00 00");
  EXPECT_EQ(terminal.title, "Hi");
  EXPECT_EQ(terminal.text, "abc");
  EXPECT_TRUE(terminal.is_on);
  EXPECT_EQ(terminal.ask("40 99 60 00 00 00 00 00"), "47 99 60 00 61 62 63 00");
}

TEST(TerminalDisplays, TheSecondOneIsAnothersMeanwhile) {
  TerminalBench terminal;
  terminal.ask_as(2, lock_display_1);
  terminal.ask_as(3, "2F 9D 60 00 FD 00 00 00");
  EXPECT_EQ(terminal.ask_as(3, "27 9E 60 00 78 79 7A 00"), "60 9E 60 00 00 00 00 00");
  EXPECT_EQ(terminal.display, 2u);
  EXPECT_EQ(terminal.holder, 3u);
  EXPECT_EQ(terminal.text, "xyz");
  EXPECT_EQ(terminal.ask_as(2, "27 9E 60 00 78 79 7A 00"), "80 9E 60 00 22 00 00 08");
  EXPECT_EQ(terminal.ask_as(3, write_abc), refused_text);
}

TEST(TerminalDisplays, NobodyWritesOnADisplayOfTheCar) {
  TerminalBench terminal;
  const unsigned shows = terminal.shows;
  EXPECT_EQ(terminal.ask_as(2, write_abc), refused_text);
  EXPECT_EQ(terminal.ask_as(2, "2B 9A 60 00 48 69 00 00"), "80 9A 60 00 22 00 00 08");
  EXPECT_EQ(terminal.shows, shows);
}

TEST(TerminalDisplays, WhatItsHolderWroteIsGoneWithTheHolder) {
  TerminalBench terminal;
  terminal.ask_as(2, lock_display_1);
  terminal.ask_as(2, write_abc);
  terminal.ask_as(2, release_display_1);
  EXPECT_EQ(terminal.text, "");
  EXPECT_EQ(terminal.holder, 0u);
  EXPECT_EQ(terminal.unit().content(TerminalDisplay::display_1).text, "");
  terminal.ask_as(2, lock_display_1);
  terminal.ask_as(2, write_abc);
  terminal.run_for(4s);
  EXPECT_EQ(terminal.text, "") << "it fell silent";
  EXPECT_EQ(terminal.last(TerminalBench::keys_pdo), "39A#E1 E0 E1 F0 E1 E0 E1 E1");
}

TEST(TerminalDisplays, ATextHasToHaveRoom) {
  TerminalBench terminal({.display_1 = {.lines = 2, .columns = 4, .characters = 6}});
  terminal.ask_as(2, lock_display_1);
  // "hello" goes over two lines of four columns.
  EXPECT_EQ(terminal.ask_as(2, "21 99 60 00 05 00 00 00"), done_text);
  EXPECT_EQ(terminal.ask_as(2, "05 68 65 6C 6C 6F 00 00"), "20 00 00 00 00 00 00 00");
  EXPECT_EQ(terminal.text, "hello");
  // "hello wo": eight are too many.
  terminal.ask_as(2, "21 99 60 00 08 00 00 00");
  terminal.ask_as(2, "00 68 65 6C 6C 6F 20 77");
  EXPECT_EQ(terminal.ask_as(2, "1D 6F 00 00 00 00 00 00"), wrong_text);
  EXPECT_EQ(terminal.text, "hello") << "and nothing changed";
  // Three lines; a control character; no UTF-8.
  terminal.ask_as(2, "21 99 60 00 05 00 00 00");
  EXPECT_EQ(terminal.ask_as(2, "05 61 0A 62 0A 63 00 00"), wrong_text);
  EXPECT_EQ(terminal.ask_as(2, "2B 99 60 00 61 07 00 00"), wrong_text);
  EXPECT_EQ(terminal.ask_as(2, "2B 99 60 00 61 C3 00 00"), wrong_text);
  EXPECT_EQ(terminal.ask_as(2, "2B 99 60 00 C3 A4 00 00"), done_text);
  EXPECT_EQ(terminal.text, "ä");
  // A title is one line.
  EXPECT_EQ(terminal.ask_as(2, "27 9A 60 00 61 0A 62 00"), "80 9A 60 00 30 00 09 06");
}

TEST(TerminalDisplays, LockedForIsoTpTheFirstTakesNoTexts) {
  TerminalBench terminal;
  EXPECT_EQ(terminal.ask_as(2, "2F 98 60 00 FE 00 00 00"), "60 98 60 00 00 00 00 00");
  EXPECT_EQ(terminal.last(TerminalBench::keys_pdo), "39A#E1 E0 E1 F0 E1 E0 E3 E1");
  EXPECT_EQ(terminal.ask_as(2, write_abc), refused_text) << "the content comes another way";
  EXPECT_EQ(terminal.ask_as(3, lock_display_1), "80 98 60 00 22 00 00 08");
  terminal.ask_as(2, lock_display_1);
  EXPECT_EQ(terminal.ask_as(2, write_abc), done_text);
}

TEST(TerminalDisplays, OneThatIsOffTakesNothing) {
  TerminalBench terminal;
  terminal.ask_as(2, lock_display_1);
  terminal.unit().sense(TerminalPart::display_1, PartState::off);
  EXPECT_EQ(terminal.last(TerminalBench::keys_pdo), "39A#E1 E0 E1 F0 E1 E0 E0 E1") << "00h: off";
  EXPECT_FALSE(terminal.is_on);
  EXPECT_EQ(terminal.ask_as(2, write_abc), refused_text);
  terminal.unit().sense(TerminalPart::display_1, PartState::working);
  EXPECT_TRUE(terminal.is_on);
  EXPECT_EQ(terminal.ask_as(2, write_abc), done_text) << "it is still the holder's";
  terminal.unit().sense(TerminalPart::display_1, PartState::failure);
  EXPECT_EQ(terminal.last(TerminalBench::keys_pdo), "39A#E1 E0 E1 F0 E1 E0 FE E1");
}

TEST(TerminalDisplays, OnesThatAreNotThereHaveNoParameters) {
  TerminalBench terminal({.missing = 0b000'0110'0000});
  EXPECT_EQ(terminal.last(TerminalBench::keys_pdo), "39A#E1 E0 E1 F0 E1 E0 FF FF");
  EXPECT_EQ(terminal.ask("40 96 60 01 00 00 00 00"), "4F 96 60 01 FF 00 00 00");
  EXPECT_EQ(terminal.ask("40 9B 60 03 00 00 00 00"), "4F 9B 60 03 FF 00 00 00");
  EXPECT_EQ(terminal.ask("40 9D 60 00 00 00 00 00"), "4F 9D 60 00 FE 00 00 00");
  EXPECT_EQ(terminal.ask("40 98 60 00 00 00 00 00"), "4F 98 60 00 FF 00 00 00")
      << "no code is left for it (errata A7)";
  terminal.ask_as(2, lock_display_1);
  EXPECT_EQ(terminal.ask_as(2, write_abc), refused_text);
  EXPECT_EQ(terminal.shows, 0u);
}

// Buzzer.

TEST(TerminalBuzzer, SoundsUntilItIsToldOtherwise) {
  TerminalBench terminal;
  EXPECT_FALSE(terminal.buzzes);
  EXPECT_EQ(terminal.ask_as(2, "2F A0 60 00 FD 00 00 00"), "60 A0 60 00 00 00 00 00");
  EXPECT_TRUE(terminal.buzzes);
  terminal.ask_as(3, "2F A0 60 00 FF 00 00 00");
  EXPECT_TRUE(terminal.buzzes) << "don't care";
  EXPECT_EQ(terminal.ask_as(3, "2F A0 60 00 FE 00 00 00"), "80 A0 60 00 30 00 09 06");
  terminal.ask_as(3, "2F A0 60 00 FC 00 00 00");
  EXPECT_FALSE(terminal.buzzes);
}

TEST(TerminalBuzzer, IsSilentWhenWhoTurnedItOnIsGone) {
  TerminalBench terminal;
  terminal.ask_as(2, "2F A0 60 00 FD 00 00 00");
  terminal.run_for(10s, {2});
  EXPECT_TRUE(terminal.buzzes);
  terminal.run_for(4s);
  EXPECT_FALSE(terminal.buzzes);
  terminal.ask_as(2, "2F A0 60 00 FD 00 00 00");
  terminal.ask_as(3, "2F A0 60 00 FD 00 00 00");
  terminal.run_for(4s, {3});
  EXPECT_TRUE(terminal.buzzes) << "device 3 wants it too";
  terminal.bench.cable.send("000#81 05");
  EXPECT_FALSE(terminal.buzzes);
}

TEST(TerminalBuzzer, OneThatIsNotThereIsNotImplemented) {
  TerminalBench terminal({.missing = 0b000'1000'0000});
  EXPECT_EQ(terminal.ask("40 A0 60 00 00 00 00 00"), "4F A0 60 00 FE 00 00 00");
  terminal.ask_as(2, "2F A0 60 00 FD 00 00 00");
  EXPECT_FALSE(terminal.buzzes);
}

// Warnings. The status has fesce in bits 1..0, and fasi in 13..12 (errata Z01).

constexpr const char* read_warnings = "40 A1 60 00 00 00 00 00";

TEST(TerminalWarnings, EachIsSetAndReset) {
  struct Case {
    const char* code;
    const char* status;
  };
  TerminalBench terminal;
  EXPECT_EQ(terminal.ask(read_warnings), "43 A1 60 00 00 C0 FF FF");
  for (const Case& one :
       {Case{"01", "01 C0"}, Case{"02", "04 C0"}, Case{"03", "10 C0"}, Case{"04", "40 C0"},
        Case{"05", "00 C1"}, Case{"06", "00 C4"}, Case{"07", "00 D0"}}) {
    const std::string code = one.code;
    terminal.warned.clear();
    EXPECT_EQ(terminal.ask_as(2, "2B A2 60 00 " + code + " 80 00 00"), "60 A2 60 00 00 00 00 00");
    EXPECT_EQ(terminal.ask(read_warnings), "43 A1 60 00 " + std::string(one.status) + " FF FF");
    terminal.ask_as(2, "2B A2 60 00 " + code + " 80 00 00");
    EXPECT_EQ(terminal.warned, "+" + code.substr(1) + " ") << "it is on already";
    terminal.ask_as(3, "2B A2 60 00 " + code + " 00 00 00");
    EXPECT_EQ(terminal.ask(read_warnings), "43 A1 60 00 00 C0 FF FF");
  }
}

TEST(TerminalWarnings, AllAreResetAtOnce) {
  TerminalBench terminal;
  for (const char* code : {"01", "04", "07"}) {
    terminal.ask_as(2, "2B A2 60 00 " + std::string(code) + " 80 00 00");
  }
  EXPECT_EQ(terminal.ask(read_warnings), "43 A1 60 00 41 D0 FF FF");
  terminal.ask_as(2, "2B A2 60 00 FF FF 00 00");
  EXPECT_EQ(terminal.ask(read_warnings), "43 A1 60 00 41 D0 FF FF");
  terminal.ask_as(2, "2B A2 60 00 00 00 00 00");
  EXPECT_EQ(terminal.ask(read_warnings), "43 A1 60 00 00 C0 FF FF");
  EXPECT_EQ(terminal.warned, "+1 +4 +7 -1 -4 -7 ");
}

TEST(TerminalWarnings, ReservedCodesAreRefused) {
  TerminalBench terminal;
  for (const char* code : {"08 00", "00 80", "08 80", "FD FF", "FE FF"}) {
    EXPECT_EQ(terminal.ask_as(2, "2B A2 60 00 " + std::string(code) + " 00 00"),
              "80 A2 60 00 30 00 09 06");
  }
  EXPECT_EQ(terminal.warned, "");
}

TEST(TerminalWarnings, TheyOutliveAnNmtReset) {
  TerminalBench terminal;
  terminal.ask_as(2, "2B A2 60 00 02 80 00 00");
  terminal.bench.cable.send("000#81 05");
  EXPECT_EQ(terminal.ask(read_warnings), "43 A1 60 00 04 C0 FF FF");
  EXPECT_TRUE(terminal.unit().is_warning(TerminalWarning::fire_active));
}

TEST(TerminalWarnings, LampsThatAreBrokenOrNotThereSaySo) {
  TerminalBench terminal;
  terminal.unit().sense(TerminalPart::warnings, PartState::failure);
  EXPECT_EQ(terminal.ask(read_warnings), "43 A1 60 00 AA EA FF FF");
  TerminalBench without({.missing = 0b001'0000'0000});
  EXPECT_EQ(without.ask(read_warnings), "43 A1 60 00 FF FF FF FF");
  EXPECT_EQ(without.ask("40 A2 60 00 00 00 00 00"), "4B A2 60 00 FE FF 00 00");
}

// Icons: command in bits 1..0, icon in 9..2, format in 12..10, 111b above (errata Z24).

TEST(TerminalIcons, AreTheVehiclesAtFirst) {
  TerminalBench terminal;
  EXPECT_EQ(terminal.ask("40 A7 60 00 00 00 00 00"), "4F A7 60 00 04 00 00 00");
  EXPECT_EQ(terminal.ask("40 A7 60 01 00 00 00 00"), "4B A7 60 01 00 E0 00 00");
  EXPECT_EQ(terminal.ask("40 AB 60 04 00 00 00 00"), "4B AB 60 04 00 E0 00 00");
}

TEST(TerminalIcons, OneWordLocksAndShows) {
  TerminalBench terminal;
  terminal.icons.clear();
  // Lock, icon 11 (bell), highlighted: 111 001 0000 1011 01b is E42Dh.
  EXPECT_EQ(terminal.ask_as(2, "2B A6 60 03 2D E4 00 00"), "60 A6 60 03 00 00 00 00");
  EXPECT_EQ(terminal.ask("40 A7 60 03 00 00 00 00"), "4B A7 60 03 2D E4 00 00");
  EXPECT_EQ(terminal.icons.back(), (ShownIcon{.display = IconDisplay::display_1,
                                              .number = 3,
                                              .is_locked = true,
                                              .icon = Icon::bell,
                                              .is_highlighted = true}));
  // The second display, its first icon: lock, icon 14 (taximeter), format left alone.
  EXPECT_EQ(terminal.ask_as(3, "2B AA 60 01 39 FC 00 00"), "60 AA 60 01 00 00 00 00");
  EXPECT_EQ(terminal.ask("40 AB 60 01 00 00 00 00"), "4B AB 60 01 39 E0 00 00");
  EXPECT_EQ(terminal.icons.back().icon, Icon::taximeter);
  EXPECT_EQ(terminal.icons.back().display, IconDisplay::display_2);
}

TEST(TerminalIcons, WhatIsNotCaredForStays) {
  TerminalBench terminal;
  terminal.ask_as(2, "2B A6 60 01 2D E4 00 00");
  // Icon 12 alone: 111 111 0000 1100 11b.
  EXPECT_EQ(terminal.ask_as(2, "2B A6 60 01 33 FC 00 00"), "60 A6 60 01 00 00 00 00");
  EXPECT_EQ(terminal.ask("40 A7 60 01 00 00 00 00"), "4B A7 60 01 31 E4 00 00");
  // Standard format alone: 111 000 1111 1111 11b.
  terminal.ask_as(2, "2B A6 60 01 FF E3 00 00");
  EXPECT_EQ(terminal.ask("40 A7 60 01 00 00 00 00"), "4B A7 60 01 31 E0 00 00");
  terminal.ask_as(2, "2B A6 60 01 FF FF 00 00");
  EXPECT_EQ(terminal.ask("40 A7 60 01 00 00 00 00"), "4B A7 60 01 31 E0 00 00");
}

TEST(TerminalIcons, OnesOfAnotherOrOfTheCarAreRefused) {
  TerminalBench terminal;
  EXPECT_EQ(terminal.ask_as(2, "2B A6 60 01 33 FC 00 00"), "80 A6 60 01 22 00 00 08");
  terminal.ask_as(2, "2B A6 60 01 2D E4 00 00");
  EXPECT_EQ(terminal.ask_as(3, "2B A6 60 01 2D E4 00 00"), "80 A6 60 01 22 00 00 08");
  EXPECT_EQ(terminal.ask_as(3, "2B A6 60 01 33 FC 00 00"), "80 A6 60 01 22 00 00 08");
  EXPECT_EQ(terminal.ask_as(3, "2B A6 60 01 FC FF 00 00"), "80 A6 60 01 22 00 00 08");
  EXPECT_EQ(terminal.ask_as(3, "2B A6 60 01 FF FF 00 00"), "60 A6 60 01 00 00 00 00");
  EXPECT_EQ(terminal.ask_as(3, "2B A6 60 02 2D E4 00 00"), "60 A6 60 02 00 00 00 00");
}

TEST(TerminalIcons, AReleaseShowsNothingOfTheDevice) {
  TerminalBench terminal;
  terminal.ask_as(2, "2B A6 60 01 2D E4 00 00");
  // Release, and an icon in the same word.
  EXPECT_EQ(terminal.ask_as(2, "2B A6 60 01 30 E4 00 00"), "60 A6 60 01 00 00 00 00");
  EXPECT_EQ(terminal.ask("40 A7 60 01 00 00 00 00"), "4B A7 60 01 00 E0 00 00");
  EXPECT_FALSE(terminal.icons.back().is_locked);
}

TEST(TerminalIcons, AHolderThatFallsSilentLosesThem) {
  TerminalBench terminal;
  terminal.ask_as(2, "2B A6 60 01 2D E4 00 00");
  terminal.ask_as(3, "2B AA 60 02 2D E4 00 00");
  terminal.run_for(4s, {3});
  EXPECT_EQ(terminal.ask("40 A7 60 01 00 00 00 00"), "4B A7 60 01 00 E0 00 00");
  EXPECT_EQ(terminal.ask("40 AB 60 02 00 00 00 00"), "4B AB 60 02 2D E4 00 00");
  terminal.bench.cable.send("000#81 05");
  EXPECT_EQ(terminal.ask("40 AB 60 02 00 00 00 00"), "4B AB 60 02 00 E0 00 00");
}

TEST(TerminalIcons, ReservedCodesAreRefused) {
  TerminalBench terminal;
  // Command 2; icons 15, FDh and FEh; formats 2, 5 and 6: each with the lock.
  for (const char* word : {"2E E4", "3D E4", "F5 E7", "F9 E7", "2D E8", "2D F4", "2D F8"}) {
    EXPECT_EQ(terminal.ask_as(2, "2B A6 60 01 " + std::string(word) + " 00 00"),
              "80 A6 60 01 30 00 09 06")
        << word;
  }
  EXPECT_EQ(terminal.ask("40 A7 60 01 00 00 00 00"), "4B A7 60 01 00 E0 00 00");
}

// 2, FEh and 6 are "function not implemented" for a reader (4.2.9.29 and 4.2.9.31).
TEST(TerminalIcons, CommandsOfOnesThatAreNotThereAreNotImplemented) {
  TerminalBench terminal({.missing = 0b100'0000'0000});
  EXPECT_EQ(terminal.ask("40 AA 60 01 00 00 00 00"), "4B AA 60 01 FA FB 00 00");
  EXPECT_EQ(terminal.ask("40 AA 60 04 00 00 00 00"), "4B AA 60 04 FA FB 00 00");
  EXPECT_EQ(terminal.ask("40 A6 60 01 00 00 00 00"), "4B A6 60 01 FF FF 00 00");
}

// 2 is "function not implemented" for a reader, in each part's own command (4.2.9.3).
TEST(TerminalParts, CommandsOfOnesThatAreNotThereAreNotImplemented) {
  TerminalBench terminal({.missing = 0b111'1111'1111});
  for (const char* index : {"81", "86", "8B", "91", "94"}) {
    EXPECT_EQ(terminal.ask("40 " + std::string(index) + " 60 00 00 00 00 00"),
              "4F " + std::string(index) + " 60 00 FE 00 00 00");
  }
}

TEST(TerminalIcons, BrokenOnesSaySoAndOnesThatAreNotThereAreNotAvailable) {
  TerminalBench terminal({.missing = 0b100'0000'0000});
  terminal.unit().sense(TerminalPart::icon_display_1, PartState::failure);
  // Failure is 2, FEh and 6 (errata Z11): 111 110 1111 1110 10b.
  for (const char* number : {"01", "02", "03", "04"}) {
    EXPECT_EQ(terminal.ask("40 A7 60 " + std::string(number) + " 00 00 00 00"),
              "4B A7 60 " + std::string(number) + " FA FB 00 00");
  }
  EXPECT_EQ(terminal.ask_as(2, "2B A6 60 02 2D E4 00 00"), "80 A6 60 02 22 00 00 08");
  EXPECT_EQ(terminal.ask("40 AB 60 02 00 00 00 00"), "4B AB 60 02 FF FF 00 00");
  terminal.ask_as(2, "2B AA 60 02 2D E4 00 00");
  EXPECT_EQ(terminal.ask("40 AB 60 02 00 00 00 00"), "4B AB 60 02 FF FF 00 00");
}

}  // namespace
}  // namespace canvoy::cia447::terminal_display_test
