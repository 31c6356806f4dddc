// Writes of a DCF to a node: values typed from CiA 301, with its order of writes to a PDO
// (7.5.2.36), SDO channels (7.5.2.33), SYNC (7.5.2.19).
#include "canvoy/formats/sheet/sheet_configuration.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace canvoy::formats::sheet_configuration_test {
namespace {

using Lines = std::vector<std::string>;

Configuration configuration(std::string text, NodeId node = 5) {
  Findings findings;
  return configuration_of(read_eds(text + "[DeviceComissioning]\nNodeID=5\n", findings), node);
}

/// `1017:00 F4 01`
Lines lines(const Configuration& made) {
  Lines all;
  for (const ConfigurationEntry& entry : made.entries) {
    all.push_back(
        fmt::format("{:04X}:{:02X} {:02X}", entry.index, entry.sub, fmt::join(entry.value, " ")));
  }
  return all;
}

std::string variable(const char* index, const char* type, const char* value,
                     const char* access = "rw", const char* more = "") {
  return fmt::format("[{}]\nDataType={}\nAccessType={}\nParameterValue={}\n{}", index, type, access,
                     value, more);
}

TEST(SheetConfiguration, WritesWhatHasAValueAndMayBeWritten) {
  EXPECT_EQ(
      lines(configuration(variable("1017", "6", "500") + variable("2000", "9", "front left") +
                          variable("2001", "7", "1", "ro") + variable("2002", "7", "") +
                          variable("2003", "7", "1", "const") + variable("2004", "2", "-1", "wo"))),
      (Lines{"1017:00 F4 01", "2000:00 66 72 6F 6E 74 20 6C 65 66 74", "2004:00 FF"}));
}

TEST(SheetConfiguration, LeavesOutProcessDataActionsStatesAndTheDate) {
  const Configuration made = configuration(variable("1003", "7", "0") + variable("1010", "7", "1") +
                                           variable("1020", "7", "9") + variable("1F51", "5", "1") +
                                           variable("6200", "5", "255", "rww", "PDOMapping=1\n") +
                                           variable("6201", "5", "255", "rw", "PDOMapping=1\n") +
                                           variable("6005", "5", "1", "rwr", "PDOMapping=1\n"));
  EXPECT_EQ(lines(made), (Lines{"6005:00 01"}));
  EXPECT_EQ(made.process_data, 2U);
}

TEST(SheetConfiguration, ValuesThatGoWithTheNodeIdGoWithTheNewOne) {
  const std::string text = variable("1014", "7", "0x85", "rw", "DefaultValue=$NODEID+0x80\n") +
                           variable("2000", "7", "0x85");
  EXPECT_EQ(lines(configuration(text, 5)),
            (Lines{"1014:00 85 00 00 80", "1014:00 85 00 00 00", "2000:00 85 00 00 00"}));
  const Configuration moved = configuration(text, 6);
  EXPECT_EQ(lines(moved),
            (Lines{"1014:00 86 00 00 80", "1014:00 86 00 00 00", "2000:00 85 00 00 00"}));
  EXPECT_EQ(moved.moved, 1U);
  EXPECT_EQ(moved.sheet_node, 5);
}

TEST(SheetConfiguration, TheNodeIdOfTheSheetIsReadInBothSpellingsOfItsSection) {
  const std::string value = variable("1014", "7", "0x8A", "rw", "DefaultValue=$NODEID+0x80\n");
  for (const char* node :
       {"[DeviceComissioning]\nNodeID=10\n", "[DeviceCommissioning]\nNodeID=10\n",
        "[devicecommissioning]\nNodeID=0x0A\n",
        "[DeviceComissioning]\nNodeName=a\n[DeviceCommissioning]\nNodeID=10\n"}) {
    Findings findings;
    const DataSheet sheet = read_eds(value + node, findings);
    const Configuration made = configuration_of(sheet, 11);
    EXPECT_EQ(lines(made), (Lines{"1014:00 8B 00 00 80", "1014:00 8B 00 00 00"})) << node;
    EXPECT_EQ(made.moved, 1U) << node;
    EXPECT_EQ(made.sheet_node, 10) << node;
    EXPECT_EQ(sheet.node_id(), 10) << node;
  }
}

TEST(SheetConfiguration, ASheetMaySayNoNodeId) {
  for (const char* node :
       {"", "[DeviceComissioning]\nNodeID=0\n", "[DeviceComissioning]\nNodeID=128\n",
        "[DeviceComissioning]\nNodeID=\n", "[DeviceInfo]\nNodeID=5\n"}) {
    Findings findings;
    EXPECT_EQ(read_eds(node, findings).node_id(), 0) << node;
  }
}

TEST(SheetConfiguration, AValueOfItsOwnStaysWhereTheDefaultGoesWithTheNodeId) {
  EXPECT_EQ(
      lines(configuration(variable("1014", "7", "0xC0", "rw", "DefaultValue=$NODEID+0x80\n"), 6)),
      (Lines{"1014:00 C0 00 00 80", "1014:00 C0 00 00 00"}));
}

const std::string pdo = "[1800]\nObjectType=9\n" + variable("1800sub0", "5", "5", "const") +
                        variable("1800sub1", "7", "0x40000185") + variable("1800sub2", "5", "1") +
                        variable("1800sub5", "6", "100") + "[1A00]\nObjectType=9\n" +
                        variable("1A00sub0", "5", "2") + variable("1A00sub1", "7", "0x60000008") +
                        variable("1A00sub2", "7", "0x60000108") +
                        variable("1A00sub3", "7", "0x60000208");

TEST(SheetConfiguration, TheLiftNumberOfCia417ComesBeforeWhatItMoves) {
  const std::string of_lift_2 =
      variable("1014", "7", "0xC0") + variable("6001", "5", "2") + variable("6B00", "5", "7");
  EXPECT_EQ(lines(configuration(variable("1000", "7", "0x040001A1", "ro") + of_lift_2, 6)),
            (Lines{"6001:00 02", "1014:00 C0 00 00 80", "1014:00 C0 00 00 00", "6B00:00 07"}));
  EXPECT_EQ(lines(configuration(variable("1000", "7", "0x040001A2", "ro") + of_lift_2, 6)),
            (Lines{"1014:00 C0 00 00 80", "1014:00 C0 00 00 00", "6001:00 02", "6B00:00 07"}))
      << "another profile has something else there";
}

TEST(SheetConfiguration, APdoIsInvalidWhileItChanges) {
  EXPECT_EQ(
      lines(configuration(pdo)),
      (Lines{"1800:01 85 01 00 C0", "1A00:00 00", "1A00:01 08 00 00 60", "1A00:02 08 01 00 60",
             "1A00:00 02", "1800:02 01", "1800:05 64 00", "1800:01 85 01 00 40"}));
}

TEST(SheetConfiguration, APdoThatIsOffStaysOff) {
  std::string text = pdo;
  text.replace(text.find("0x40000185"), 10, "0xC0000185");
  const Lines made = lines(configuration(text));
  EXPECT_EQ(made.front(), "1800:01 85 01 00 C0");
  EXPECT_EQ(made.back(), "1800:05 64 00");
}

TEST(SheetConfiguration, AMultiplexedPdoKeepsItsKind) {
  std::string text = pdo;
  text.replace(text.find("ParameterValue=2\n"), 17, "ParameterValue=0xFF\n");
  const Lines made = lines(configuration(text));
  EXPECT_NE(std::ranges::find(made, "1A00:03 08 02 00 60"), made.end());
  EXPECT_NE(std::ranges::find(made, "1A00:00 FF"), made.end());
}

TEST(SheetConfiguration, AnSdoChannelIsInvalidWhileItChanges) {
  EXPECT_EQ(
      lines(configuration("[1280]\nObjectType=9\n" + variable("1280sub1", "7", "0x60A") +
                          variable("1280sub2", "7", "0x58A") + variable("1280sub3", "5", "10"))),
      (Lines{"1280:01 0A 06 00 80", "1280:02 8A 05 00 80", "1280:03 0A", "1280:01 0A 06 00 00",
             "1280:02 8A 05 00 00"}));
}

TEST(SheetConfiguration, SyncIsProducedWhenAllOfItIsSet) {
  EXPECT_EQ(
      lines(configuration(variable("1005", "7", "0x40000080") + variable("1006", "7", "1000") +
                          variable("1007", "7", "500") + variable("1019", "5", "10"))),
      (Lines{"1005:00 80 00 00 00", "1006:00 00 00 00 00", "1019:00 0A", "1006:00 E8 03 00 00",
             "1005:00 80 00 00 40", "1007:00 F4 01 00 00"}));
}

TEST(SheetConfiguration, NoNodeIsWatchedTwiceMeanwhile) {
  EXPECT_EQ(lines(configuration("[1016]\nObjectType=8\n" + variable("1016sub0", "5", "2", "const") +
                                variable("1016sub1", "7", "0x000A01F4") +
                                variable("1016sub2", "7", "0"))),
            (Lines{"1016:01 00 00 00 00", "1016:02 00 00 00 00", "1016:01 F4 01 0A 00"}));
}

TEST(SheetConfiguration, AValueThatIsNoneIsTold) {
  const Configuration made = configuration(variable("1017", "6", "often"));
  ASSERT_EQ(made.bad.size(), 1U);
  EXPECT_EQ(made.bad[0].section, "1017sub0");
  EXPECT_EQ(made.bad[0].text, "ParameterValue is 'often'");
  EXPECT_EQ(made.bad[0].line, 1U);
}

}  // namespace
}  // namespace canvoy::formats::sheet_configuration_test
