// Command lines as typed, and their meaning.
#include "canvoy/tools/node/typed_words.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::typed_words_test {
namespace {

using Words = std::vector<std::string>;

class TypedWords : public testing::Test {
 protected:
  ~TypedWords() override { ::unsetenv("CANVOY_BUS"); }
};

std::string refusal(const Words& words) {
  try {
    typed_words(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST_F(TypedWords, HelpOfAVerbIsItsHelp) {
  EXPECT_EQ(typed_words({"help", "read"}), (Words{"read", "--help"}));
  EXPECT_EQ(typed_words({"help", "lss", "scan"}), (Words{"lss", "scan", "--help"}));
  EXPECT_EQ(typed_words({"help"}), Words{"--help"});
}

TEST_F(TypedWords, NodeAndStateStandInEitherOrder) {
  EXPECT_EQ(typed_words({"nmt", "can0", "start", "10"}), (Words{"nmt", "can0", "10", "start"}));
  EXPECT_EQ(typed_words({"nmt", "can0", "10", "start"}), (Words{"nmt", "can0", "10", "start"}));
  EXPECT_EQ(typed_words({"nmt", "can0", "reset_node", "pump"}),
            (Words{"nmt", "can0", "pump", "reset_node"}));
}

TEST_F(TypedWords, BusAndLssCommandStandInEitherOrder) {
  EXPECT_EQ(typed_words({"lss", "scan", "can0"}), (Words{"lss", "can0", "scan"}));
  EXPECT_EQ(typed_words({"lss", "set-node-id", "can0", "5"}),
            (Words{"lss", "can0", "set-node-id", "5"}));
}

TEST_F(TypedWords, ASubIndexMayBeWrittenAsInADataSheet) {
  EXPECT_EQ(typed_words({"read", "can0", "10", "1018sub1"}),
            (Words{"read", "can0", "10", "1018:1"}));
  EXPECT_EQ(typed_words({"write", "can0", "10", "0x6020sub0A", "5"}),
            (Words{"write", "can0", "10", "6020:0A", "5"}));
}

TEST_F(TypedWords, WhatIsMeantByAnotherNameOrAnotherVerbIsTold) {
  EXPECT_EQ(typed_words({"version"}), Words{"--version"});
  EXPECT_EQ(refusal({}),
            "which verb? canvoy --help lists them all; canvoy scan can0 shows who is on a bus");
  EXPECT_EQ(refusal({"candump", "can0"}),
            "'candump' is not known here; monitor does that: canvoy monitor can0");
  EXPECT_EQ(refusal({"list"}), "'list' is not known here; scan does that: canvoy scan can0");
  EXPECT_EQ(refusal({"diff", "a.eds", "b.eds"}),
            "'diff' is not known here; eds diff does that: canvoy eds diff a.eds b.eds");
  EXPECT_EQ(refusal({"start", "can0", "10"}),
            "'start' is not known here; nmt does that: canvoy nmt can0 10 start");
  EXPECT_EQ(refusal({"record", "can0"}),
            "which file is to be written? canvoy record can0 night.log");
  EXPECT_EQ(refusal({"replay", "can0"}), "which log? canvoy replay night.log can0");
  EXPECT_EQ(refusal({"check", "my.eds"}), "a data sheet is checked by canvoy eds check my.eds");
  EXPECT_EQ(refusal({"export", "csv", "bus.log"}),
            "the values in a log are written by canvoy decode bus.log --csv");
  EXPECT_EQ(refusal({"monitor", "can0", "10"}),
            "what is of one node is chosen by canvoy monitor can0 --filter node=10");
  EXPECT_EQ(refusal({"nmt", "can0", "reset", "10"}),
            "reset what? canvoy nmt can0 10 reset-node, or reset-communication");
  EXPECT_EQ(refusal({"decode", "10.log"}), "");
}

TEST_F(TypedWords, IndexAndSubIndexAreOneObject) {
  EXPECT_EQ(typed_words({"write", "can0", "10", "0x1017", "0", "500"}),
            (Words{"write", "can0", "10", "1017:0", "500"}));
  EXPECT_EQ(typed_words({"write", "can0", "10", "0x1017", "500"}),
            (Words{"write", "can0", "10", "1017", "500"}));
  EXPECT_EQ(typed_words({"read", "can0", "10", "0x1018", "1"}),
            (Words{"read", "can0", "10", "1018:1"}));
  EXPECT_EQ(typed_words({"read", "can0", "10", "1018", "1017"}),
            (Words{"read", "can0", "10", "1018", "1017"}))
      << "two objects";
  EXPECT_EQ(typed_words({"read", "can0", "10", "1018h", "0x1017", "1008"}),
            (Words{"read", "can0", "10", "1018", "1017", "1008"}));
  EXPECT_EQ(typed_words({"write", "can0", "10", "temperature", "0", "5"}),
            (Words{"write", "can0", "10", "temperature", "0", "5"}));
}

TEST_F(TypedWords, TheBusOfTheEnvironmentStandsWhereNoneIsSaid) {
  ::setenv("CANVOY_BUS", "can7", 1);
  EXPECT_EQ(typed_words({"read", "10", "1018"}), (Words{"read", "can7", "10", "1018"}));
  EXPECT_EQ(typed_words({"nmt", "all", "start"}), (Words{"nmt", "can7", "all", "start"}));
  EXPECT_EQ(typed_words({"nmt", "start", "all"}), (Words{"nmt", "can7", "all", "start"}));
  EXPECT_EQ(typed_words({"read", "udp:", "10", "1018"}), (Words{"read", "udp:", "10", "1018"}));
  EXPECT_EQ(typed_words({"read", "vcan1", "10", "1018"}), (Words{"read", "vcan1", "10", "1018"}));
  EXPECT_EQ(typed_words({"monitor"}), (Words{"monitor", "can7"}));
  EXPECT_EQ(typed_words({"monitor", "--table"}), (Words{"monitor", "can7", "--table"}));
  EXPECT_EQ(typed_words({"monitor", "night.log"}), (Words{"monitor", "night.log"}));
  EXPECT_EQ(typed_words({"script", "a.canvoy"}), (Words{"script", "can7", "a.canvoy"}));
  EXPECT_EQ(typed_words({"device", "pump.eds"}), (Words{"device", "pump.eds", "can7"}));
  EXPECT_EQ(typed_words({"device", "pump.eds", "can0", "--json"}),
            (Words{"device", "pump.eds", "can0", "--json"}));
  EXPECT_EQ(typed_words({"decode", "night.log"}), (Words{"decode", "night.log"}));
}

TEST_F(TypedWords, TheBusOfTheEnvironmentStandsWhereTheVerbHasIt) {
  ::setenv("CANVOY_BUS", "can7", 1);
  EXPECT_EQ(typed_words({"replay", "a.log", "--speed", "2"}),
            (Words{"replay", "a.log", "can7", "--speed", "2"}));
  EXPECT_EQ(typed_words({"eds", "read", "10"}), (Words{"eds", "read", "can7", "10"}));
  EXPECT_EQ(typed_words({"eds", "check", "a.eds"}), (Words{"eds", "check", "a.eds"}));
  EXPECT_EQ(typed_words({"export", "dbc"}), (Words{"export", "dbc", "can7"}));
  EXPECT_EQ(typed_words({"export", "dbc", "10"}), (Words{"export", "dbc", "10"}));
  EXPECT_EQ(typed_words({"lss", "scan"}), (Words{"lss", "can7", "scan"}));
  EXPECT_EQ(typed_words({"check", "10"}), (Words{"check", "can7", "10"}));
  EXPECT_EQ(typed_words({"check", "--list"}), (Words{"check", "--list"}));
  EXPECT_EQ(typed_words({"load", "--for", "1s"}), (Words{"load", "can7", "--for", "1s"}));
  EXPECT_EQ(typed_words({"load", "lift"}), (Words{"load", "lift"}));
  EXPECT_EQ(typed_words({"doctor", "night.log"}), (Words{"doctor", "night.log"}));
}

TEST_F(TypedWords, WithoutABusTheLineToTypeIsSaid) {
  EXPECT_EQ(refusal({"read", "10", "1018"}),
            "which bus? canvoy read can0 10 1018; or export CANVOY_BUS=can0, and leave it out");
  EXPECT_EQ(refusal({"script", "a.canvoy"}),
            "which bus? canvoy script can0 a.canvoy; or export CANVOY_BUS=can0, and leave it out");
  EXPECT_EQ(refusal({"nmt", "start", "10"}),
            "which bus? canvoy nmt can0 10 start; or export CANVOY_BUS=can0, and leave it out");
  EXPECT_EQ(refusal({"replay", "a.log"}),
            "which bus? canvoy replay a.log can0; or export CANVOY_BUS=can0, and leave it out");
  EXPECT_EQ(refusal({"monitor"}),
            "which bus? canvoy monitor can0; or export CANVOY_BUS=can0, and leave it out");
  EXPECT_EQ(refusal({"lss", "scan"}),
            "which bus? canvoy lss can0 scan; or export CANVOY_BUS=can0, and leave it out");
  EXPECT_EQ(refusal({"check", "--list"}), "");
  EXPECT_EQ(refusal({"read", "--help"}), "");
}

TEST_F(TypedWords, KnowsWhatIsABus) {
  for (const char* bus : {"can0", "vcan12", "slcan3", "udp:", "tcp:host/can0", "sim", "can0,can1",
                          "can0/2:7", "lo"}) {
    EXPECT_TRUE(names_bus(bus)) << bus;
  }
  for (const char* other : {"10", "0x0A", "all", "pump.eds", "a.log", "./can", "can", "", "1018"}) {
    EXPECT_FALSE(names_bus(other)) << other;
  }
}

}  // namespace
}  // namespace canvoy::tools::typed_words_test
