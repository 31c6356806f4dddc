// Lines of other programs, by their manuals (can-utils, tshark, python-can, cocomm of CANopenNode),
// and ours that mean the same.
#include "canvoy/tools/node/other_names.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/node/typed_words.hpp"

namespace canvoy::tools::other_names_test {
namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& text) {
  Words words(1);
  for (const char c : text) {
    if (c == ' ') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

void expect_line(const std::string& typed, const std::string& ours) {
  EXPECT_EQ(typed_words(words_of(typed)), words_of(ours)) << typed;
}

void expect_told(const std::string& typed, const std::string& part) {
  try {
    static_cast<void>(typed_words(words_of(typed)));
    ADD_FAILURE() << typed << " is taken";
  } catch (const UsageError& told) {
    EXPECT_NE(std::string(told.what()).find(part), std::string::npos) << told.what();
  }
}

TEST(OtherNames, OptionsOfCanUtilsMayBeJoined) {
  expect_line("candump -ta can0 -n 5", "monitor can0 --count 5");
  expect_line("candump -xtz -n5 can0", "monitor can0 --count 5");
  expect_line("candump -e -c can0,180:780", "monitor can0 --filter id=180:780");
  expect_line("canplayer -I a.log -l 3 -g 5 can0=can1", "replay a.log can0=can1 --loop 3");
  expect_line("canplayer -t -Ia.log can0", "replay a.log can0 --speed 0");
  expect_line("log2asc -I a.log -O a.asc", "convert-log a.log a.asc");
  expect_line("asc2log -O a.log -I a.asc", "convert-log a.asc a.log");
  expect_line("canbusload can0@125000 -t -b", "load can0 --bit-rate 125");
  expect_line("cansniffer -c can0", "monitor can0 --table");
  expect_line("tshark -r a.pcapng -c 5 -V", "decode a.pcapng --count 5");
  expect_line("tshark -i can0", "monitor can0");
}

TEST(OtherNames, CandumpWithAFileRecords) {
  const Words words = typed_words(words_of("candump -l can0"));
  ASSERT_EQ(words.size(), 3U);
  EXPECT_EQ(words[0] + ' ' + words[1], "record can0");
  EXPECT_TRUE(words[2].starts_with("candump-20") && words[2].ends_with(".log")) << words[2];
  expect_told("candump -L can0", "canvoy record can0 heard.log");
  expect_told("cangen can0 -g 10", "canvoy send can0 123#1122 --every 10ms");
}

TEST(OtherNames, UnknownOptionsOfAProgramAreLeftToTheVerb) {
  expect_line("candump -Z can0", "monitor can0 -Z");
  expect_line("candump can0 --json", "monitor can0 --json");
  expect_line("canbusload can0@125000 --for 1s", "load can0 --for 1s --bit-rate 125");
  expect_line("candump can0 -n", "monitor can0");
}

TEST(OtherNames, DriversOfPythonCanAreLeftOut) {
  expect_line("scan --interface socketcan --channel can0 --bitrate 125000", "scan can0");
  expect_line("monitor -i pcan -c can0 -b 125000", "monitor can0");
  expect_line("monitor can0 --interface can1", "monitor can0 --interface can1");
}

TEST(OtherNames, TheBusMayStandInFront) {
  expect_line("can0 scan", "scan can0");
  expect_line("can0 10 read 1018 4", "read can0 10 1018:4");
  expect_line("can0 read 10 1018", "read can0 10 1018");
  expect_line("can0 10 start", "nmt can0 10 start");
  expect_line("--bus can0 read 10 1018", "read can0 10 1018");
  expect_line("-i can0 -n 10 read 1018", "read can0 10 1018");
  expect_line("-v scan can0", "scan can0");
  expect_line("scan can0 --verbose", "scan can0");
  expect_line("can0 replay a.log", "replay a.log can0");
  expect_line("--bus can0 device battery", "device battery can0");
  expect_line("replay a.log --bus can0 --loop 2", "replay a.log can0 --loop 2");
  expect_line("read --bus can0 10 1018", "read can0 10 1018");
  expect_line("monitor --filter EMCY -i can0", "monitor can0 --filter EMCY");
  expect_told("can0", "canvoy monitor can0 shows its frames");
}

TEST(OtherNames, TheWordForWhatIsWorkedOnIsLeftOut) {
  expect_line("sdo read can0 10 1008", "read can0 10 1008");
  expect_line("sdo upload can0 10 1008", "read can0 10 1008");
  expect_line("sdo download can0 10 0x1017 0 1000", "write can0 10 1017:0 1000");
  expect_line("node scan can0", "scan can0");
  expect_line("profile list", "profile");
  expect_line("device list", "device --list");
}

TEST(OtherNames, WhatStandsBehindAWordSaysWhichVerbIsMeant) {
  expect_line("watch can0", "monitor can0");
  expect_line("watch can0 10 6010", "read can0 10 6010 --watch");
  expect_line("ping can0", "scan can0");
  expect_line("ping can0 10", "read can0 10 1000");
  expect_line("info can0", "scan can0");
  expect_line("info can0 10", "read can0 10 1000 1018");
  expect_line("dump can0", "monitor can0");
  expect_line("dump can0 10", "eds read can0 10");
  expect_line("backup can0 10 a.dcf", "eds read can0 10 a.dcf");
  expect_line("heartbeat can0", "monitor can0 --filter heartbeat");
  expect_line("heartbeat can0 10", "wait can0 node=10 and heartbeat");
  expect_line("emcy can0", "monitor can0 --filter EMCY");
  expect_line("emcy can0 10 8130 11", "emcy can0 10 8130 11");
  expect_line("simulate charger", "run charger");
  expect_line("sim battery can0", "device battery can0");
  expect_line("log can0 a.asc", "record can0 a.asc");
  expect_line("search 0x6010", "explain 0x6010");
  expect_line("log a.asc", "decode a.asc");
  expect_line("export csv a.log", "decode a.log --csv");
  expect_line("eds validate a.eds", "eds check a.eds");
  expect_line("validate a.eds", "eds check a.eds");
}

TEST(OtherNames, TheOtherWordOfResetMayStandBehindTheNode) {
  expect_line("reset can0 10 communication", "nmt can0 10 reset-communication");
  expect_line("reset can0 10 node", "nmt can0 10 reset-node");
  expect_line("reset node can0 10", "nmt can0 10 reset-node");
  expect_told("reset can0 10", "reset what? canvoy nmt can0 10 reset-node");
}

TEST(OtherNames, NamesOfVerbsMayBeJoinedByADash) {
  expect_line("check-eds a.eds", "eds check a.eds");
  expect_line("eds-check a.eds", "eds check a.eds");
  expect_line("sdo-read can0 10 1018", "read can0 10 1018");
  expect_line("read-sdo can0 10 1018", "read can0 10 1018");
  expect_line("list-nodes can0", "scan can0");
  expect_line("lss-scan can0", "lss can0 scan");
  expect_line("convert-log a.log a.asc", "convert-log a.log a.asc");
  expect_line("factory-reset can0 10", "restore can0 10");
}

TEST(OtherNames, TheWordForAPlaceMayStandBeforeIt) {
  expect_line("read can0 node 10 1018", "read can0 10 1018");
  expect_line("read can0 node 10 object 1018", "read can0 10 1018");
  expect_line("write can0 10 index 1017 value 500", "write can0 10 1017 500");
  expect_line("nmt can0 node 10 start", "nmt can0 10 start");
  expect_line("explain abort 06010002", "explain 06010002");
  expect_line("explain -a 06010002", "explain 06010002");
  expect_line("explain emcy code 8120", "explain 8120");
}

TEST(OtherNames, AFilterIsAVerbOfLogs) {
  expect_line("filter a.log 18A -o b.log", "decode a.log --filter 18A -o b.log");
  expect_line("filter a.log node=10", "decode a.log --filter node=10");
  expect_line("heartbeat can0 --node 10", "monitor can0 --filter heartbeat --node 10");
}

TEST(OtherNames, AnUnknownWordIsAnsweredByWhatStandsBehindIt) {
  expect_told("frobnicate a.log", "of a log there are canvoy decode a.log, canvoy stats a.log");
  expect_told("frobnicate can0", "of a bus there are canvoy scan can0");
  expect_told("frobnicate can0 10 x", "of a node there are canvoy read can0 10 1018");
  expect_told("frobnicate a.eds", "of a data sheet there are canvoy eds check a.eds");
  expect_told("read a.log", "'read' is of a bus; of a log there are canvoy decode a.log");
  expect_told("convert a.log", "canvoy convert-log a.log a.asc");
  expect_line("frobnicate", "frobnicate");
  expect_line("decdoe a.log", "decdoe a.log");  // the command says which verb is near
  expect_line("compare can0 10 a.dcf", "configure can0 10 a.dcf --diff");
}

TEST(OtherNames, AThingAloneIsShownOrPlayed) {
  expect_line("a.blf --count 5", "decode a.blf --count 5");
  expect_line("-r a.log", "decode a.log");
  expect_line("a.dcf", "eds check a.dcf");
  expect_line("yard.toml", "run yard.toml");
  expect_line("lift --for 1s", "run lift --for 1s");
  expect_told("a.dbc", "canvoy export dbc pump.eds");
}

TEST(OtherNames, WordsOfSpeechAreLeftOut) {
  expect_line("what is 06090011", "explain 06090011");
  expect_line("what does 06090011 mean", "explain 06090011");
  expect_line("read can0 knoten 10 6010h sub 1", "read can0 10 6010:1");
  expect_line("validate eds a.eds", "eds check a.eds");
  expect_line("hilfe decode", "decode --help");
  expect_line("decode /?", "decode --help");
}

TEST(OtherNames, WhatIsAskedForDependsOnTheThing) {
  expect_line("errors can0 10", "read can0 10 1003");
  expect_line("errors can0", "monitor can0 --filter EMCY");
  expect_line("errors a.log", "decode a.log --filter EMCY");
  expect_line("info a.mf4", "stats a.mf4");
  expect_line("heartbeat can0 10 1s", "write can0 10 1017 1s");
  expect_line("export a.eds b.dbc", "export dbc a.eds b.dbc");
  expect_line("download a.dcf --node 10", "configure a.dcf --node 10");
  expect_line("download can0 10 a.dcf", "configure can0 10 a.dcf");
}

TEST(OtherNames, ProgramsOfPythonCan) {
  expect_line("logger -i socketcan -c can0 -f a.asc", "record can0 a.asc");
  expect_line("logger -c can0", "monitor can0");
  expect_line("player -i socketcan -c can0 a.log", "replay a.log can0");
  expect_line("viewer -c can0", "monitor can0 --table");
  expect_line("canplayer -I a.log -l i can0", "replay a.log can0 --loop");
}

TEST(OtherNames, CommandsOfLssMayBeTwoWords) {
  expect_line("lss can0 set node 20", "lss can0 set-node-id 20");
  expect_line("lss can0 bitrate 250", "lss can0 set-bit-rate 250");
  expect_line("lss can0 set baudrate 250", "lss can0 set-bit-rate 250");
  expect_line("lss can0 get node", "lss can0 inquire");
  expect_line("lss can0 store", "lss can0 store");
}

TEST(OtherNames, WhatIsMissingIsToldWithTheLine) {
  expect_told("read can0 5,10 1008", "canvoy read can0 5 1008; canvoy scan can0");
  expect_told("read can0 all 1008", "canvoy read can0 10 1008");
  expect_told("pdo can0 10",
              "canvoy pdo can0 10 tpdo1, and its mapping read by canvoy read can0 10 1A00");
  expect_told("report a.log", "canvoy report a.log --out a.html");
  expect_line("record can0 --for 1s a.log", "record can0 --for 1s a.log");
}

TEST(OtherNames, ShortNamesOfCocommAreVerbs) {
  expect_line("r can0 10 0x1018 4 u32", "read can0 10 1018:4 --type u32");
  expect_line("w can0 10 0x1017 0 u16 750", "write can0 10 1017:0 750 --type u16");
}

TEST(OtherNames, ANodeInFrontOfAnObjectChoosesIt) {
  expect_line("plot a.log 10:6010", "plot a.log 6010 --filter node=10");
  expect_line("plot a.log 10:6010 10:6060", "plot a.log 6010 6060 --filter node=10");
  expect_line("plot a.log 6010:00", "plot a.log 6010:00");
  expect_line("plot a.log 10:6010 5:6060", "plot a.log 10:6010 5:6060");
}

}  // namespace
}  // namespace canvoy::tools::other_names_test
