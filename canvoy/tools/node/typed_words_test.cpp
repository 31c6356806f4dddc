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
  EXPECT_EQ(typed_words({"lss", "can0", "fastscan"}), (Words{"lss", "can0", "scan"}));
}

TEST_F(TypedWords, TheBusMayStandAnywhere) {
  EXPECT_EQ(typed_words({"read", "10", "can0", "1018"}), (Words{"read", "can0", "10", "1018"}));
  EXPECT_EQ(typed_words({"10", "can0", "read", "1018"}), (Words{"read", "can0", "10", "1018"}));
  EXPECT_EQ(typed_words({"replay", "can0", "a.log"}), (Words{"replay", "a.log", "can0"}));
  EXPECT_EQ(typed_words({"export", "can0", "dbc"}), (Words{"export", "dbc", "can0"}));
  EXPECT_EQ(typed_words({"eds", "read", "10", "can0"}), (Words{"eds", "read", "can0", "10"}));
  EXPECT_EQ(typed_words({"device", "can0", "battery", "11"}),
            (Words{"device", "battery", "can0", "--node-id", "11"}));
  EXPECT_EQ(typed_words({"--json", "read", "can0", "10", "1018"}),
            (Words{"read", "can0", "10", "1018", "--json"}));
  ::setenv("CANVOY_BUS", "can7", 1);
  EXPECT_EQ(typed_words({"device", "battery", "can0", "11"}),
            (Words{"device", "battery", "can0", "--node-id", "11"}));
}

TEST_F(TypedWords, VerbsOfOtherToolsAreOurs) {
  EXPECT_EQ(typed_words({"candump", "can0"}), (Words{"monitor", "can0"}));
  EXPECT_EQ(typed_words({"cansend", "can0", "123#11"}), (Words{"send", "can0", "123#11"}));
  EXPECT_EQ(typed_words({"get", "can0", "10", "1018"}), (Words{"read", "can0", "10", "1018"}));
  EXPECT_EQ(typed_words({"diff", "a.eds", "b.eds"}), (Words{"eds", "diff", "a.eds", "b.eds"}));
  EXPECT_EQ(typed_words({"convert", "a.eds", "b.xdd"}),
            (Words{"eds", "convert", "a.eds", "b.xdd"}));
  EXPECT_EQ(typed_words({"convert", "a.log", "b.asc"}), (Words{"convert-log", "a.log", "b.asc"}));
  EXPECT_EQ(typed_words({"start", "can0", "10", "--json"}),
            (Words{"nmt", "can0", "10", "start", "--json"}));
  EXPECT_EQ(typed_words({"help", "candump"}), (Words{"monitor", "--help"}));
  EXPECT_EQ(typed_words({"preop", "can0", "10"}), (Words{"nmt", "can0", "10", "preop"}));
  EXPECT_EQ(typed_words({"reset", "node", "can0", "10"}),
            (Words{"nmt", "can0", "10", "reset-node"}));
}

TEST_F(TypedWords, TheVerbIsThatOfWhatStandsBehindIt) {
  EXPECT_EQ(typed_words({"eds", "pump.eds"}), (Words{"eds", "check", "pump.eds"}));
  EXPECT_EQ(typed_words({"eds", "info", "pump.eds"}), (Words{"eds", "check", "pump.eds"}));
  EXPECT_EQ(typed_words({"explain", "58A#80"}), (Words{"decode", "58A#80"}));
  EXPECT_EQ(typed_words({"explain", "8130"}), (Words{"explain", "8130"}));
}

TEST_F(TypedWords, FiltersOfCandumpAreFilters) {
  EXPECT_EQ(typed_words({"monitor", "can0,180:780,700:780", "--json"}),
            (Words{"monitor", "can0", "--json", "--filter", "id=180:780,700:780"}));
  EXPECT_EQ(typed_words({"monitor", "can0,can1"}), (Words{"monitor", "can0,can1"}));
  EXPECT_EQ(typed_words({"monitor", "udp:239.74.163.2:43113"}),
            (Words{"monitor", "udp:239.74.163.2:43113"}));
}

TEST_F(TypedWords, ANodeBehindTheBusOfADeviceIsItsNode) {
  EXPECT_EQ(typed_words({"device", "battery", "can0", "11", "--json"}),
            (Words{"device", "battery", "can0", "--node-id", "11", "--json"}));
  EXPECT_EQ(typed_words({"device", "battery", "can0"}), (Words{"device", "battery", "can0"}));
  ::setenv("CANVOY_BUS", "can7", 1);
  EXPECT_EQ(typed_words({"device", "battery", "11"}),
            (Words{"device", "battery", "can7", "--node-id", "11"}));
}

TEST_F(TypedWords, AnNmtCommandMayBeTwoWords) {
  EXPECT_EQ(typed_words({"nmt", "can0", "10", "reset", "node"}),
            (Words{"nmt", "can0", "10", "reset-node"}));
  EXPECT_EQ(typed_words({"nmt", "can0", "reset", "communication", "all"}),
            (Words{"nmt", "can0", "all", "reset-communication"}));
  EXPECT_EQ(typed_words({"nmt", "can0", "10", "pre", "operational"}),
            (Words{"nmt", "can0", "10", "pre-operational"}));
}

TEST_F(TypedWords, ATypeMayStandAsInCia309) {
  EXPECT_EQ(typed_words({"read", "can0", "10", "0x1017", "0", "u16"}),
            (Words{"read", "can0", "10", "1017:0", "--type", "u16"}));
  EXPECT_EQ(typed_words({"write", "can0", "10", "0x1017", "0", "u16", "1000"}),
            (Words{"write", "can0", "10", "1017:0", "1000", "--type", "u16"}));
  EXPECT_EQ(typed_words({"write", "can0", "10", "1008", "us"}),
            (Words{"write", "can0", "10", "1008", "us"}))
      << "the value";
}

TEST_F(TypedWords, AValueMayBeParted) {
  EXPECT_EQ(typed_words({"write", "can0", "10", "1017", "500", "ms"}),
            (Words{"write", "can0", "10", "1017", "500 ms"}));
  EXPECT_EQ(typed_words({"write", "can0", "10", "1017", "5", "s"}),
            (Words{"write", "can0", "10", "1017", "5 s"}));
  EXPECT_EQ(typed_words({"write", "can0", "10", "6020", "2", "400", "Ah"}),
            (Words{"write", "can0", "10", "6020:2", "400 Ah"}));
  EXPECT_EQ(typed_words({"write", "can0", "10", "1017=500"}),
            (Words{"write", "can0", "10", "1017", "500"}));
  EXPECT_EQ(typed_words({"write", "can0", "10", "temperature", "=", "20"}),
            (Words{"write", "can0", "10", "temperature", "20"}));
}

TEST_F(TypedWords, BytesMayBeParted) {
  EXPECT_EQ(typed_words({"send", "can0", "60A", "40", "18", "0x10", "1"}),
            (Words{"send", "can0", "60A#40181001"}));
  EXPECT_EQ(typed_words({"send", "can0", "0x123", "DEADBEEF", "--every", "1s"}),
            (Words{"send", "can0", "123#DEADBEEF", "--every", "1s"}));
  EXPECT_EQ(typed_words({"send", "can0", "80", "00"}), (Words{"send", "can0", "080#00"}));
  EXPECT_EQ(typed_words({"send", "can0", "18FF1234", "00"}),
            (Words{"send", "can0", "18FF1234#00"}));
  EXPECT_EQ(typed_words({"send", "can0", "0x123#11"}), (Words{"send", "can0", "123#11"}));
  EXPECT_EQ(typed_words({"send", "can0", "60A", "nothing"}),
            (Words{"send", "can0", "60A", "nothing"}));
  EXPECT_EQ(refusal({"send", "can0", "18A", "2", "A0", "00"}),
            "is 2 the length? canvoy send can0 18A#A000, or 18A#02A000");
  EXPECT_EQ(typed_words({"emcy", "can0", "10", "8130", "11", "01", "0x02"}),
            (Words{"emcy", "can0", "10", "8130", "11", "--data", "01 02"}));
}

TEST_F(TypedWords, APdoAndItsNumberMayBeParted) {
  EXPECT_EQ(typed_words({"pdo", "can0", "10", "tpdo", "1", "temperature=20"}),
            (Words{"pdo", "can0", "10", "tpdo1", "temperature=20"}));
}

TEST_F(TypedWords, WhatThereIsBesideABusIsListed) {
  EXPECT_EQ(typed_words({"devices"}), (Words{"device", "--list"}));
  EXPECT_EQ(typed_words({"list", "devices", "--json"}), (Words{"device", "--list", "--json"}));
  EXPECT_EQ(typed_words({"profiles"}), Words{"profile"});
  EXPECT_EQ(typed_words({"info", "447-3"}), (Words{"profile", "447-3"}));
  EXPECT_EQ(typed_words({"networks"}), (Words{"run", "--help"}));
  EXPECT_EQ(typed_words({"demo"}), (Words{"run", "charger"}));
}

TEST_F(TypedWords, AFrameAloneIsDecoded) {
  EXPECT_EQ(typed_words({"18A#AC0001"}), (Words{"decode", "18A#AC0001"}));
  EXPECT_EQ(typed_words({"18A#R4", "--node", "10=418"}),
            (Words{"decode", "18A#R4", "--node", "10=418"}));
}

TEST_F(TypedWords, ANodeInFrontOfAFilterIsPartOfIt) {
  EXPECT_EQ(typed_words({"wait", "can0", "10", "heartbeat"}),
            (Words{"wait", "can0", "node=10", "and", "heartbeat"}));
  EXPECT_EQ(typed_words({"wait", "can0", "5", "s"}), (Words{"wait", "can0", "5", "s"}));
}

TEST_F(TypedWords, WhatIsMeantByAnotherNameOrAnotherVerbIsTold) {
  EXPECT_EQ(typed_words({"version"}), Words{"--version"});
  EXPECT_EQ(refusal({}),
            "which verb? canvoy --help lists them all; canvoy scan can0 shows who is on a bus");
  EXPECT_EQ(refusal({"list"}),
            "which bus? canvoy scan can0; or export CANVOY_BUS=can0, and leave it out");
  EXPECT_EQ(refusal({"download", "can0", "10", "app.bin"}),
            "'download' is not known here; write does that: canvoy write can0 10 app.bin");
  EXPECT_EQ(refusal({"info", "a.eds"}),
            "'info' is not known here; eds check does that: canvoy eds check a.eds");
  EXPECT_EQ(refusal({"record", "can0"}),
            "which file is to be written? canvoy record can0 night.log");
  EXPECT_EQ(refusal({"replay", "can0"}), "which log? canvoy replay night.log can0");
  EXPECT_EQ(refusal({"check", "my.eds"}), "a data sheet is checked by canvoy eds check my.eds");
  EXPECT_EQ(refusal({"monitor", "can0", "10"}),
            "what is of one node is chosen by canvoy monitor can0 --filter node=10");
  EXPECT_EQ(refusal({"nmt", "can0", "reset", "10"}),
            "reset what? canvoy nmt can0 10 reset-node, or reset-communication");
  EXPECT_EQ(refusal({"nmt", "can0", "start"}),
            "which node? canvoy nmt can0 10 start, or canvoy nmt can0 all start");
  EXPECT_EQ(refusal({"nmt", "can0", "reset", "comm"}),
            "which node? canvoy nmt can0 10 reset-comm, or canvoy nmt can0 all reset-comm");
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

}  // namespace
}  // namespace canvoy::tools::typed_words_test
