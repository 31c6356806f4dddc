// Keys and locks of a terminal at its wire (CiA 447-3, 4.2.9.2 to 4.2.9.16). Reserved bits are 1:
// the statuses start with 111b, function keys and tip switches with 1111b.
#include <gtest/gtest.h>

#include "canvoy/devices/cia447/terminal/terminal_bench_test.hpp"

namespace canvoy::cia447::terminal_keys_test {
namespace {

constexpr std::uint32_t keys = TerminalBench::keys_pdo;
constexpr std::uint32_t pad = TerminalBench::pad_pdo;

constexpr const char* done_6081 = "60 81 60 00 00 00 00 00";
constexpr const char* refused_6081 = "80 81 60 00 22 00 00 08";
constexpr const char* lock_6081 = "2F 81 60 00 FD 00 00 00";
constexpr const char* release_6081 = "2F 81 60 00 FC 00 00 00";

TEST(TerminalKeys, AllPartsAreTheVehiclesAtFirstAndNoKeyIsPressed) {
  TerminalBench terminal;
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E1 F0 E1 E0 E1 E1");
  EXPECT_EQ(terminal.last(pad), "39B#E1 F0 E1 FC");
}

TEST(TerminalKeys, AKeyIsToldWhileItIsPressed) {
  TerminalBench terminal;
  terminal.unit().press(NumberPadKey::key_0);
  EXPECT_EQ(terminal.last(keys), "39A#E1 EB E1 F0 E1 E0 E1 E1") << "0Bh is 0 (errata C6)";
  terminal.unit().press(NumberPadKey::star);
  EXPECT_EQ(terminal.last(keys), "39A#E1 ED E1 F0 E1 E0 E1 E1") << "more than one";
  terminal.unit().release(NumberPadKey::key_0);
  EXPECT_EQ(terminal.last(keys), "39A#E1 EC E1 F0 E1 E0 E1 E1");
  terminal.unit().release(NumberPadKey::star);
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E1 F0 E1 E0 E1 E1");
}

TEST(TerminalKeys, EachPadHasItsOwnPlace) {
  TerminalBench terminal;
  terminal.unit().press(FunctionKey::key_7);
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E1 F7 E1 E0 E1 E1");
  terminal.unit().press(ControlKey::f4);
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E1 F7 E1 EF E1 E1");
  terminal.unit().press(TipSwitch::switch_12);
  EXPECT_EQ(terminal.last(pad), "39B#E1 FC E1 FC");
  terminal.unit().press_emergency_key();
  EXPECT_EQ(terminal.last(pad), "39B#E1 FC E1 FD");
  terminal.unit().press_emergency_key(false);
  terminal.unit().release(TipSwitch::switch_12);
  EXPECT_EQ(terminal.last(pad), "39B#E1 F0 E1 FC");
  terminal.unit().release(FunctionKey::key_7);
  terminal.unit().release(ControlKey::f4);
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E1 F0 E1 E0 E1 E1");
}

TEST(TerminalKeys, APadThatIsLockedTellsWhoHasIt) {
  TerminalBench terminal;
  EXPECT_EQ(terminal.ask_as(2, lock_6081), done_6081);
  EXPECT_EQ(terminal.last(keys), "39A#E3 E0 E1 F0 E1 E0 E1 E1") << "03h is device 2";
  EXPECT_EQ(terminal.unit().holder(TerminalPart::number_pad), 2u);
  EXPECT_EQ(terminal.ask_as(2, release_6081), done_6081);
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E1 F0 E1 E0 E1 E1");
}

TEST(TerminalKeys, EachPartHasItsOwnCommand) {
  TerminalBench terminal;
  EXPECT_EQ(terminal.ask_as(2, "2F 86 60 00 FD 00 00 00"), "60 86 60 00 00 00 00 00");
  EXPECT_EQ(terminal.ask_as(16, "2F 8B 60 00 FD 00 00 00"), "60 8B 60 00 00 00 00 00");
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E3 F0 F1 E0 E1 E1") << "11h is device 16";
  EXPECT_EQ(terminal.ask_as(3, "2F 98 60 00 FD 00 00 00"), "60 98 60 00 00 00 00 00");
  EXPECT_EQ(terminal.ask_as(4, "2F 9D 60 00 FD 00 00 00"), "60 9D 60 00 00 00 00 00");
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E3 F0 F1 E0 E4 E5");
  EXPECT_EQ(terminal.ask_as(2, "2F 91 60 00 FD 00 00 00"), "60 91 60 00 00 00 00 00");
  EXPECT_EQ(terminal.ask_as(3, "2F 94 60 00 FD 00 00 00"), "60 94 60 00 00 00 00 00");
  EXPECT_EQ(terminal.last(pad), "39B#E3 F0 E4 FC");
}

TEST(TerminalKeys, TheGatewayIsDevice1) {
  TerminalBench terminal;
  EXPECT_EQ(terminal.ask(lock_6081), done_6081);
  EXPECT_EQ(terminal.last(keys), "39A#E2 E0 E1 F0 E1 E0 E1 E1");
}

TEST(TerminalKeys, AnotherDeviceIsRefusedWhileOneHasIt) {
  TerminalBench terminal;
  terminal.ask_as(2, lock_6081);
  EXPECT_EQ(terminal.ask_as(3, lock_6081), refused_6081);
  EXPECT_EQ(terminal.ask_as(3, release_6081), refused_6081);
  EXPECT_EQ(terminal.unit().holder(TerminalPart::number_pad), 2u);
  EXPECT_EQ(terminal.ask_as(3, "2F 81 60 00 FF 00 00 00"), done_6081) << "it does not care";
  EXPECT_EQ(terminal.ask_as(3, "2F 86 60 00 FD 00 00 00"), "60 86 60 00 00 00 00 00")
      << "another part is free";
  terminal.ask_as(2, release_6081);
  EXPECT_EQ(terminal.ask_as(3, lock_6081), done_6081);
  EXPECT_EQ(terminal.unit().holder(TerminalPart::number_pad), 3u);
}

TEST(TerminalKeys, ReservedCodesAreRefused) {
  TerminalBench terminal;
  for (const char* object : {"81", "86", "8B", "91", "94", "9D"}) {
    const std::string place = std::string(object) + " 60 00";
    EXPECT_EQ(terminal.ask_as(2, "2F " + place + " FE 00 00 00"), "80 " + place + " 30 00 09 06");
  }
  EXPECT_EQ(terminal.ask("40 80 60 00 00 00 00 00"), "4F 80 60 00 E1 00 00 00");
}

TEST(TerminalKeys, AHolderThatFallsSilentLosesAllItHas) {
  TerminalBench terminal;
  terminal.ask_as(2, lock_6081);
  terminal.ask_as(2, "2F 94 60 00 FD 00 00 00");
  terminal.ask_as(3, "2F 86 60 00 FD 00 00 00");
  terminal.run_for(10s, {2, 3});
  EXPECT_EQ(terminal.unit().holder(TerminalPart::number_pad), 2u) << "it is heard";
  terminal.run_for(1s, {3});
  EXPECT_EQ(terminal.unit().holder(TerminalPart::number_pad), 2u);
  terminal.run_for(1s, {3});
  // The last heartbeat of device 2 was 3 s ago.
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E4 F0 E1 E0 E1 E1");
  EXPECT_EQ(terminal.last(pad), "39B#E1 F0 E1 FC");
  EXPECT_EQ(terminal.ask_as(4, lock_6081), done_6081);
}

TEST(TerminalKeys, AHolderThatBootsAnewHasForgottenIt) {
  TerminalBench terminal;
  terminal.ask_as(2, lock_6081);
  terminal.bench.cable.send("702#00");
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E1 F0 E1 E0 E1 E1");
  EXPECT_EQ(terminal.ask_as(2, lock_6081), done_6081) << "and may have it again";
  EXPECT_EQ(terminal.last(keys), "39A#E3 E0 E1 F0 E1 E0 E1 E1");
  terminal.run_for(4s, {});
  EXPECT_EQ(terminal.last(keys), "39A#E1 E0 E1 F0 E1 E0 E1 E1") << "it is watched again";
}

TEST(TerminalKeys, AResetOfTheTerminalLetsGoOfAll) {
  for (const char* reset : {"000#81 05", "000#82 05"}) {
    TerminalBench terminal;
    terminal.ask_as(2, lock_6081);
    terminal.unit().press(NumberPadKey::key_3);
    terminal.bench.cable.send(reset);
    terminal.bench.cable.clear();
    terminal.bench.cable.send("000#01 05");
    EXPECT_EQ(terminal.last(keys), "39A#E1 E3 E1 F0 E1 E0 E1 E1") << "the key is still down";
    EXPECT_EQ(terminal.ask_as(3, lock_6081), done_6081);
  }
}

TEST(TerminalKeys, APadThatIsOffTellsNoKeys) {
  TerminalBench terminal;
  terminal.ask_as(2, lock_6081);
  terminal.unit().press(NumberPadKey::key_1);
  terminal.unit().sense(TerminalPart::number_pad, PartState::off);
  EXPECT_EQ(terminal.last(keys), "39A#E0 E0 E1 F0 E1 E0 E1 E1");
  EXPECT_EQ(terminal.ask_as(2, lock_6081), refused_6081) << "what is off is not locked";
  EXPECT_EQ(terminal.ask_as(2, release_6081), done_6081);
  terminal.unit().sense(TerminalPart::number_pad, PartState::working);
  EXPECT_EQ(terminal.last(keys), "39A#E1 E1 E1 F0 E1 E0 E1 E1") << "it is still pressed";
}

TEST(TerminalKeys, ABrokenPadSaysSoAndItsHolderHasItAgainWhenItIsMended) {
  TerminalBench terminal;
  terminal.ask_as(2, lock_6081);
  for (const TerminalPart part :
       {TerminalPart::number_pad, TerminalPart::function_pad, TerminalPart::control_pad,
        TerminalPart::switch_pad, TerminalPart::emergency_key}) {
    terminal.unit().sense(part, PartState::failure);
  }
  EXPECT_EQ(terminal.last(keys), "39A#FE FE FE FE FE FE E1 E1");
  EXPECT_EQ(terminal.last(pad), "39B#FE FE FE FE");
  EXPECT_EQ(terminal.ask_as(2, lock_6081), refused_6081);
  terminal.unit().sense(TerminalPart::number_pad, PartState::working);
  EXPECT_EQ(terminal.last(keys), "39A#E3 E0 FE FE FE FE E1 E1");
}

TEST(TerminalKeys, PartsThatAreNotThereAreNotAvailableAndNotImplemented) {
  TerminalBench terminal({.missing = 0b000'0001'1111});
  EXPECT_EQ(terminal.last(keys), "39A#FF FF FF FF FF FF E1 E1");
  EXPECT_EQ(terminal.last(pad), "39B#FF FF FF FF");
  for (const char* object : {"81", "86", "8B", "91", "94"}) {
    const std::string place = std::string(object) + " 60 00";
    EXPECT_EQ(terminal.ask("40 " + place + " 00 00 00 00"), "4F " + place + " FE 00 00 00");
  }
  terminal.ask_as(2, lock_6081);
  terminal.unit().press(NumberPadKey::key_1);
  terminal.unit().sense(TerminalPart::number_pad, PartState::working);
  EXPECT_EQ(terminal.ask("40 80 60 00 00 00 00 00"), "4F 80 60 00 FF 00 00 00");
  EXPECT_EQ(terminal.ask("40 82 60 00 00 00 00 00"), "4F 82 60 00 FF 00 00 00");
  EXPECT_EQ(terminal.ask("40 81 60 00 00 00 00 00"), "4F 81 60 00 FE 00 00 00");
}

TEST(TerminalKeys, StatusesAreReadOnly) {
  TerminalBench terminal;
  for (const char* object : {"80", "82", "85", "87", "8A", "8C", "90", "92", "93", "95", "97"}) {
    const std::string place = std::string(object) + " 60 00";
    EXPECT_EQ(terminal.ask("2F " + place + " 00 00 00 00"), "80 " + place + " 02 00 01 06");
  }
}

}  // namespace
}  // namespace canvoy::cia447::terminal_keys_test
