// A client of a terminal at the wire (CiA 447-3, 4.2.9): it is node 5, and the terminal is node 2,
// with requests on 341h and answers on 2C1h (facts 2.2). PDO 81 of node 2 is on 21Ah: statuses and
// keys of three pads, and two displays; 01h means that the car has a part, 06h that node 5 has it
// (the car and five).
#include "canvoy/devices/cia447/terminal/terminal_client.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"

namespace canvoy::cia447::terminal_client_test {
namespace {

constexpr VirtualDeviceInfo nothing = {.name = "application"};

struct ClientHardware {};
struct ClientOfTerminal {
  ClientOfTerminal(CarNetwork& network, const ClientHardware&, const ClientHardware&)
      : terminal(network, {.terminal = 2}) {}
  TerminalClient terminal;
};
struct ClientKind : CarKind<ClientOfTerminal, ClientHardware, ClientHardware> {
  static constexpr DeviceInfo info = {.name = "client", .title = "client"};
  static constexpr const VirtualDeviceInfo& provides = nothing;
  static constexpr auto consumes = terminal_keys_objects;
};

class ClientAtTerminal : public testing::Test {
 protected:
  ClientAtTerminal() {
    terminal().on_number_key(callback<&ClientAtTerminal::number>(*this));
    terminal().on_function_key(callback<&ClientAtTerminal::function>(*this));
    cable.run_for(0s);
    cable.clear();
  }
  TerminalClient& terminal() { return client_->terminal; }
  /// The request that is under way.
  std::string asked() {
    cable.run_for(0s);
    return cable.last(0x341);
  }
  void answer(const std::string& answer) {
    cable.clear();
    cable.send("2C1#" + answer);
    cable.run_for(0s);
  }
  void pdo(const std::string& bytes) {
    cable.send("21A#" + bytes);
    cable.run_for(0s);
  }
  void number(NumberPadKey key) { keys += "n" + std::to_string(static_cast<int>(key)) + " "; }
  void function(FunctionKey key) { keys += "f" + std::to_string(static_cast<int>(key)) + " "; }

  std::string keys;
  ClientOfTerminal* client_ = nullptr;
  CarBench bench{only_unit<ClientKind>,
                 [this](Environment& environment) { environment.watch(client_); }};
  Cable& cable = bench.cable;
};

TEST_F(ClientAtTerminal, APartIsLockedAndItsTextWritten) {
  terminal().show(TerminalText::text_2, "HI");
  EXPECT_EQ(asked(), "") << "the display is not wanted";
  terminal().want(TerminalPart::display_2, true);
  EXPECT_EQ(asked(), "341#2F 9D 60 00 FD 00 00 00") << "609Dh: lock is 01b";
  EXPECT_FALSE(terminal().has(TerminalPart::display_2));
  answer("60 9D 60 00 00 00 00 00");
  EXPECT_TRUE(terminal().has(TerminalPart::display_2));
  EXPECT_EQ(asked(), "341#2B 9E 60 00 48 49 00 00") << "609Eh";
  answer("60 9E 60 00 00 00 00 00");
  terminal().want(TerminalPart::display_2, false);
  EXPECT_EQ(asked(), "341#2F 9D 60 00 FC 00 00 00") << "release is 00b";
  answer("60 9D 60 00 00 00 00 00");
  EXPECT_FALSE(terminal().has(TerminalPart::display_2));
}

TEST_F(ClientAtTerminal, APartThatIsNotWantedAnyMoreWhileItIsStoppedIsReleasedAfterThat) {
  terminal().want(TerminalPart::display_2, true);
  asked();
  answer("60 9D 60 00 00 00 00 00");
  cable.send("000#02 05");
  terminal().want(TerminalPart::display_2, false);
  cable.run_for(1s);
  cable.send("000#01 05");
  cable.clear();
  cable.run_for(1s);
  EXPECT_EQ(cable.last(0x341), "341#2F 9D 60 00 FC 00 00 00") << "release is 00b";
}

TEST_F(ClientAtTerminal, WhatAnotherOneHoldsIsAskedForAgain) {
  terminal().want(TerminalPart::number_pad, true);
  EXPECT_EQ(asked(), "341#2F 81 60 00 FD 00 00 00");
  answer("80 81 60 00 22 00 00 08");
  EXPECT_FALSE(terminal().has(TerminalPart::number_pad));
  cable.run_for(299ms);
  EXPECT_EQ(cable.last(0x341), "");
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x341), "341#2F 81 60 00 FD 00 00 00");
}

TEST_F(ClientAtTerminal, NoPartIsLockedBeforeThoseInFrontOfIt) {
  terminal().want(TerminalPart::display_1, true);
  terminal().want(TerminalPart::number_pad, true);
  EXPECT_EQ(asked(), "341#2F 81 60 00 FD 00 00 00");
  answer("80 81 60 00 22 00 00 08");
  cable.run_for(300ms);
  EXPECT_EQ(cable.last(0x341), "341#2F 81 60 00 FD 00 00 00") << "not 6094h, the display's";
}

TEST_F(ClientAtTerminal, AKeyCountsOnceForWhoHasThePad) {
  pdo("01 00 01 00 01 00 01 01");
  pdo("01 03 01 00 01 00 01 01");
  EXPECT_EQ(keys, "") << "it is the car's";
  pdo("06 03 01 00 01 00 01 01");
  EXPECT_EQ(keys, "") << "it was pressed for somebody else";
  pdo("06 00 01 00 01 00 01 01");
  pdo("06 05 01 00 01 00 01 01");
  pdo("06 05 01 00 01 00 01 01");
  EXPECT_EQ(keys, "n5 ");
  pdo("06 00 01 00 01 00 01 01");
  pdo("07 05 01 00 01 00 01 01");
  EXPECT_EQ(keys, "n5 ") << "node 6 has it";
  pdo("01 00 06 00 01 00 01 01");
  pdo("01 00 06 02 01 00 01 01");
  EXPECT_EQ(keys, "n5 f2 ");
  pdo("01 00 06 00 01 00 01 01");
  pdo("01 00 06 08 01 00 01 01");
  EXPECT_EQ(keys, "n5 f2 ") << "several keys are none";
}

/// It does not report an unchanged pad.
TEST_F(ClientAtTerminal, TheFirstKeyOfATerminalThatIsHeardAgainCounts) {
  pdo("06 00 01 00 01 00 01 01");
  cable.run_for(6s);
  EXPECT_FALSE(terminal().has(TerminalPart::number_pad)) << "it is silent";
  pdo("06 05 01 00 01 00 01 01");
  EXPECT_EQ(keys, "n5 ");
}

/// It has booted so quickly that its terminal has not lost it: a lock that changes nothing is no
/// event, and its keys (6087h) are not sent.
TEST_F(ClientAtTerminal, TheFirstKeyAfterABootCounts) {
  terminal().want(TerminalPart::function_pad, true);
  asked();
  answer("60 86 60 00 00 00 00 00");
  cable.run_for(299ms);
  EXPECT_EQ(cable.last(0x341), "") << "they may come by themselves";
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x341), "341#40 87 60 00 00 00 00 00");
  answer("4F 87 60 00 F0 00 00 00");
  pdo("01 00 06 F2 01 00 01 01");
  EXPECT_EQ(keys, "f2 ");
}

TEST_F(ClientAtTerminal, AKeyThatIsDownAfterABootWasPressedBeforeIt) {
  terminal().want(TerminalPart::function_pad, true);
  asked();
  answer("60 86 60 00 00 00 00 00");
  cable.run_for(300ms);
  answer("4F 87 60 00 F2 00 00 00");
  pdo("01 00 06 F2 01 00 01 01");
  EXPECT_EQ(keys, "");
  pdo("01 00 06 F0 01 00 01 01");
  pdo("01 00 06 F2 01 00 01 01");
  EXPECT_EQ(keys, "f2 ");
}

TEST_F(ClientAtTerminal, AStatusThatNamesAnotherOneIsALoss) {
  terminal().want(TerminalPart::number_pad, true);
  asked();
  answer("60 81 60 00 00 00 00 00");
  EXPECT_TRUE(terminal().has(TerminalPart::number_pad));
  pdo("01 00 01 00 01 00 01 01");
  EXPECT_FALSE(terminal().has(TerminalPart::number_pad));
  EXPECT_EQ(asked(), "341#2F 81 60 00 FD 00 00 00") << "it is locked anew";
}

TEST_F(ClientAtTerminal, WhoHasWhatIsHeldIsAskedNowAndThen) {
  terminal().want(TerminalPart::function_pad, true);
  asked();
  answer("60 86 60 00 00 00 00 00");
  pdo("01 00 06 00 01 00 01 01");
  cable.run_for(1999ms);
  EXPECT_EQ(cable.last(0x341), "");
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x341), "341#40 85 60 00 00 00 00 00") << "6085h";
  answer("4F 85 60 00 06 00 00 00");
  EXPECT_TRUE(terminal().has(TerminalPart::function_pad)) << "node 5 has it still";
  cable.send("702#05");
  cable.run_for(2s);
  EXPECT_EQ(cable.last(0x341), "341#40 85 60 00 00 00 00 00");
  answer("4F 85 60 00 07 00 00 00");
  EXPECT_FALSE(terminal().has(TerminalPart::function_pad)) << "node 6 has it meanwhile";
  EXPECT_EQ(asked(), "341#2F 86 60 00 FD 00 00 00") << "it is asked for anew";
}

/// The terminal and this device may not have received each other for three seconds: one of the two
/// frames came in time, and the PDO that reports the loss did not arrive.
TEST_F(ClientAtTerminal, ALossOfWhichNobodyTellsIsFoundAndTheTextWrittenAnew) {
  terminal().show(TerminalText::text_2, "HI");
  terminal().want(TerminalPart::display_2, true);
  asked();
  answer("60 9D 60 00 00 00 00 00");
  answer("60 9E 60 00 00 00 00 00");
  cable.run_for(2s);
  EXPECT_EQ(cable.last(0x341), "341#40 9C 60 00 00 00 00 00") << "609Ch";
  answer("4F 9C 60 00 01 00 00 00");
  EXPECT_EQ(asked(), "341#2F 9D 60 00 FD 00 00 00") << "it is the car's";
  answer("60 9D 60 00 00 00 00 00");
  EXPECT_EQ(asked(), "341#2B 9E 60 00 48 49 00 00");
}

TEST_F(ClientAtTerminal, ATextThatChangesOnTheWayIsWrittenAsItIsThen) {
  terminal().show(TerminalText::text_2, "abc");
  terminal().want(TerminalPart::display_2, true);
  asked();
  terminal().show(TerminalText::text_2, "ab");
  answer("60 9D 60 00 00 00 00 00");
  EXPECT_EQ(asked(), "341#2B 9E 60 00 61 62 00 00");
  terminal().show(TerminalText::text_2, "a");
  EXPECT_EQ(asked(), "341#2B 9E 60 00 61 62 00 00") << "one at a time";
  answer("60 9E 60 00 00 00 00 00");
  EXPECT_EQ(asked(), "341#2F 9E 60 00 61 00 00 00");
}

TEST_F(ClientAtTerminal, ATextThatHasNoRoomKeepsNobodyFromTheRest) {
  terminal().show(TerminalText::text_2, "abc");
  terminal().want(TerminalPart::display_2, true);
  asked();
  answer("60 9D 60 00 00 00 00 00");
  EXPECT_EQ(asked(), "341#27 9E 60 00 61 62 63 00");
  answer("80 9E 60 00 30 00 09 06");
  EXPECT_TRUE(terminal().has(TerminalPart::display_2));
  terminal().want(TerminalPart::number_pad, true);
  EXPECT_EQ(asked(), "341#2F 81 60 00 FD 00 00 00");
  answer("60 81 60 00 00 00 00 00");
  terminal().show(TerminalText::text_2, "a");
  EXPECT_EQ(asked(), "341#2F 9E 60 00 61 00 00 00");
}

TEST_F(ClientAtTerminal, WhatIsNotWantedIsNotAskedFor) {
  terminal().show(TerminalText::text_2, "HI");
  cable.run_for(10s);
  EXPECT_EQ(cable.last(0x341), "") << "another device may have the display";
}

TEST_F(ClientAtTerminal, ATerminalThatBootsHasForgottenAll) {
  terminal().show(TerminalText::text_2, "HI");
  terminal().want(TerminalPart::display_2, true);
  asked();
  answer("60 9D 60 00 00 00 00 00");
  answer("60 9E 60 00 00 00 00 00");
  cable.send("702#00");
  cable.clear();
  cable.run_for(300ms);
  EXPECT_EQ(cable.last(0x341), "341#2F 9D 60 00 FD 00 00 00");
  answer("60 9D 60 00 00 00 00 00");
  EXPECT_EQ(asked(), "341#2B 9E 60 00 48 49 00 00");
}

TEST_F(ClientAtTerminal, ATerminalThatDoesNotAnswerIsAskedAgain) {
  terminal().want(TerminalPart::display_2, true);
  asked();
  cable.clear();
  cable.run_for(799ms);
  EXPECT_EQ(cable.last(0x341), "341#80 9D 60 00 00 00 04 05") << "half a second is too long";
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x341), "341#2F 9D 60 00 FD 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia447::terminal_client_test
