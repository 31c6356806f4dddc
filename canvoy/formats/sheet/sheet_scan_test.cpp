// A node is read entry by entry; its answers become a DCF (CiA 306, 5).
#include "canvoy/formats/sheet/sheet_scan.hpp"

#include <gtest/gtest.h>

#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/eds/eds_writer.hpp"
#include "canvoy/formats/sheet/sheet_check.hpp"
#include "canvoy/profiles/cia419.hpp"

namespace canvoy::formats::sheet_scan_test {
namespace {

using Bytes = SheetScan::Bytes;

/// Answers like the SDO server of a node.
struct FakeNode {
  std::map<std::pair<unsigned, unsigned>, Result<Bytes>> entries;
  std::vector<std::pair<unsigned, unsigned>> asked;

  Result<Bytes> read(std::uint16_t index, std::uint8_t sub) {
    asked.emplace_back(index, sub);
    const auto found = entries.find({index, sub});
    if (found != entries.end()) return found->second;
    const bool has_object = std::ranges::any_of(
        entries, [index](const auto& entry) { return entry.first.first == index; });
    return has_object ? AbortCode::no_sub_index : AbortCode::no_object;
  }
  SheetScan scan() {
    return SheetScan([this](std::uint16_t index, std::uint8_t sub) { return read(index, sub); });
  }
};

constexpr std::string_view eds =
    "[FileInfo]\nFileName=any.eds\n"
    "[1000]\nParameterName=Device type\nDataType=7\nAccessType=ro\nDefaultValue=0x191\n"
    "[1014]\nParameterName=COB-ID EMCY\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x80\n"
    "[1F25]\nParameterName=Command\nDataType=7\nAccessType=wo\n"
    "[2000]\nParameterName=File\nObjectType=2\nDataType=0xF\nAccessType=rw\n"
    "[2002]\nParameterName=Text\nDataType=9\nAccessType=rw\n"
    "[2003]\nParameterName=Speed\nDataType=3\nAccessType=rw\n"
    "[2004]\nParameterName=Gain\nDataType=8\nAccessType=rw\n"
    "[2005]\nObjectType=9\n[2005sub0]\nParameterName=Count\nDataType=5\nAccessType=const\n"
    "[2005sub1]\nParameterName=Key\nDataType=0xA\nAccessType=rw\n";

class ScanByEds : public testing::Test {
 protected:
  DataSheet scan() {
    Findings findings;
    DataSheet sheet = read_eds(eds, findings);
    SheetScan scan = node_.scan();
    scan.read_values(sheet);
    unread_ = scan.unread();
    count_ = scan.count();
    return sheet;
  }
  FakeNode node_;
  std::vector<SheetScan::Unread> unread_;
  std::size_t count_ = 0;
};

TEST_F(ScanByEds, ValuesAreWrittenAsTheirTypesAsk) {
  node_.entries = {{{0x1000, 0}, Bytes{0x91, 0x01, 0, 0}}, {{0x1014, 0}, Bytes{0x85, 0, 0, 0}},
                   {{0x2002, 0}, Bytes{'a', ' ', 'b', 0}}, {{0x2003, 0}, Bytes{0xFE, 0xFF}},
                   {{0x2004, 0}, Bytes{0, 0, 0xC0, 0x3F}}, {{0x2005, 0}, Bytes{1}},
                   {{0x2005, 1}, Bytes{0x0A, 0xFF}}};
  const DataSheet sheet = scan();
  EXPECT_EQ(sheet.find(0x1000, 0)->value, "0x00000191");
  EXPECT_EQ(sheet.find(0x1014, 0)->value, "0x00000085");
  EXPECT_EQ(sheet.find(0x1014, 0)->default_value, "$NODEID+0x80") << "as the EDS has it";
  EXPECT_EQ(sheet.find(0x2002, 0)->value, "a b");
  EXPECT_EQ(sheet.find(0x2003, 0)->value, "-2");
  EXPECT_EQ(sheet.find(0x2004, 0)->value, "1.5");
  EXPECT_EQ(sheet.find(0x2005, 1)->value, "0A FF");
  EXPECT_EQ(count_, 7U);
  EXPECT_TRUE(unread_.empty());
}

TEST_F(ScanByEds, NeitherDomainsNorWhatIsWriteOnlyIsAskedFor) {
  scan();
  for (const auto& [index, sub] : node_.asked) {
    EXPECT_NE(index, 0x1F25U);
    EXPECT_NE(index, 0x2000U);
  }
}

TEST_F(ScanByEds, WhatTheNodeRefusesKeepsNoValueAndIsTold) {
  node_.entries = {{{0x1000, 0}, Bytes{0x91, 0x01, 0, 0}}, {{0x1014, 0}, AbortCode::device_state},
                   {{0x2002, 0}, Bytes{'a', '\n', 'b'}},   {{0x2003, 0}, Bytes{1}},
                   {{0x2004, 0}, Bytes{0, 0, 0xC0, 0x3F}}, {{0x2005, 0}, Bytes{1}}};
  const DataSheet sheet = scan();
  EXPECT_EQ(sheet.find(0x1014, 0)->value, "");
  ASSERT_EQ(unread_.size(), 4U);
  EXPECT_EQ(unread_[0].index, 0x1014);
  EXPECT_EQ(unread_[0].name, "COB-ID EMCY");
  EXPECT_EQ(unread_[0].abort, AbortCode::device_state);
  EXPECT_EQ(unread_[1].reason, "the text does not fit into a line of a file");
  EXPECT_EQ(unread_[2].reason, "the node has 1 bytes there, and the type 2");
  EXPECT_EQ(unread_[3].abort, AbortCode::no_sub_index);
  EXPECT_EQ(unread_[3].sub, 1);
}

TEST_F(ScanByEds, CommissioningNamesTheNodeAndKeepsOtherKeys) {
  node_.entries = {{{0x1000, 0}, Bytes{0x91, 0x01, 0, 0}}};
  DataSheet sheet = scan();
  sheet.sections.push_back(
      {"DeviceComissioning", 0, {{"NodeID", "1", 0}, {"NetworkName", "N", 0}}});
  commission(sheet, {.file_name = "five.dcf",
                     .node_id = 5,
                     .kilobits_per_second = 250,
                     .node_name = "Five",
                     .last_eds = "any.eds",
                     .serial_number = 77});
  EXPECT_EQ(sheet.text("DeviceComissioning", "NodeID"), "5");
  EXPECT_EQ(sheet.text("DeviceComissioning", "NodeName"), "Five");
  EXPECT_EQ(sheet.text("DeviceComissioning", "Baudrate"), "250");
  EXPECT_EQ(sheet.text("DeviceComissioning", "NetworkName"), "N");
  EXPECT_EQ(sheet.text("DeviceComissioning", "LSS_SerialNumber"), "77");
  EXPECT_EQ(sheet.text("FileInfo", "FileName"), "five.dcf");
  EXPECT_EQ(sheet.text("FileInfo", "LastEDS"), "any.eds");
  EXPECT_NE(write_eds(sheet).find("ParameterValue=0x00000191"), std::string::npos);
}

/// Objects of CiA 301 and 419, as in a small charger.
FakeNode small_charger() {
  FakeNode node;
  node.entries = {
      {{0x1000, 0}, Bytes{0xA3, 0x01, 0, 0}},
      {{0x1001, 0}, Bytes{0}},
      {{0x1003, 0}, Bytes{0}},
      {{0x1003, 1}, AbortCode::no_data},
      {{0x1018, 0}, Bytes{2}},
      {{0x1018, 1}, Bytes{0x23, 0x01, 0, 0}},
      {{0x1018, 2}, Bytes{7, 0, 0, 0}},
      {{0x1805, 0}, Bytes{2}},
      {{0x1805, 1}, Bytes{0x85, 0x02, 0, 0}},
      {{0x1805, 2}, Bytes{0xFF}},
      {{0x1A05, 0}, Bytes{0}},
      {{0x6000, 0}, Bytes{1}},
      {{0x6060, 0}, Bytes{0, 0xC8, 0, 0}},
  };
  return node;
}

TEST_F(ScanByEds, ADomainThatIsAskedForIsKeptInAFileThatTheDcfNames) {
  node_.entries[{0x2000, 0}] = Bytes{1, 2, 3};
  DataSheet sheet = scan();
  EXPECT_EQ(std::ranges::count(node_.asked, std::pair{0x2000U, 0U}), 0) << "of itself it is not";
  SheetScan domains = node_.scan();
  std::vector<Bytes> kept;
  domains.read_domains(sheet, [&kept](std::uint16_t index, std::uint8_t sub, const Bytes& bytes) {
    EXPECT_EQ(index, 0x2000);
    EXPECT_EQ(sub, 0);
    kept.push_back(bytes);
    return "file.bin";
  });
  EXPECT_EQ(kept, std::vector<Bytes>{Bytes({1, 2, 3})});
  EXPECT_EQ(domains.count(), 1U);
  EXPECT_NE(write_eds(sheet).find("UploadFile=file.bin"), std::string::npos);
}

TEST_F(ScanByEds, ADomainThatTheNodeDoesNotGiveIsToldOf) {
  node_.entries[{0x2000, 0}] = AbortCode::no_data;
  DataSheet sheet = scan();
  SheetScan domains = node_.scan();
  domains.read_domains(sheet, [](std::uint16_t, std::uint8_t, const Bytes&) {
    ADD_FAILURE();
    return std::string();
  });
  ASSERT_EQ(domains.unread().size(), 1U);
  EXPECT_EQ(domains.unread()[0].index, 0x2000);
  EXPECT_EQ(write_eds(sheet).find("UploadFile"), std::string::npos);
}

TEST(ScanByProfile, FindsWhatTheNodeHasOfAllThatIsDescribed) {
  FakeNode node = small_charger();
  SheetScan scan = node.scan();
  const DataSheet sheet = scan.read_profile(cia419::profile, {.node_id = 5});
  std::vector<unsigned> indices;
  for (const auto& [index, object] : sheet.objects) indices.push_back(index);
  EXPECT_EQ(indices, (std::vector<unsigned>{0x1000, 0x1001, 0x1003, 0x1018, 0x1805, 0x1A05, 0x6000,
                                            0x6060}));
  EXPECT_EQ(sheet.find(0x1018, 1)->value, "0x00000123");
  EXPECT_EQ(sheet.find(0x1018, 1)->default_value, "0x00000123") << "it does not change";
  EXPECT_EQ(sheet.find(0x1018, 3), nullptr);
  EXPECT_EQ(sheet.find(0x1805, 1)->value, "0x00000285");
  EXPECT_EQ(sheet.find(0x6060, 0)->value, "0x0000C800");
  EXPECT_TRUE(scan.unread().empty());
}

TEST(ScanByProfile, TheDcfIsWithoutAFinding) {
  FakeNode node = small_charger();
  SheetScan scan = node.scan();
  Findings findings;
  const DataSheet sheet =
      read_eds(write_eds(scan.read_profile(cia419::profile, {.node_id = 5})), findings);
  EXPECT_TRUE(findings.empty()) << findings.front().section << findings.front().text;
  check_sheet(sheet, nullptr, findings);
  EXPECT_TRUE(findings.empty()) << findings.front().section << findings.front().text;
  EXPECT_TRUE(sheet.configured);
}

TEST(ScanByProfile, OfManyEqualEntriesNoMoreAreAskedThanSubIndex00hCounts) {
  FakeNode node = small_charger();
  SheetScan scan = node.scan();
  static_cast<void>(scan.read_profile(cia419::profile, {.node_id = 5}));
  const auto asked = [&node](unsigned index) {
    return std::ranges::count(node.asked, index, &std::pair<unsigned, unsigned>::first);
  };
  EXPECT_EQ(asked(0x1003), 2);
  EXPECT_EQ(asked(0x1A05), 2) << "its number, and one entry that is not there";
  EXPECT_EQ(asked(0x1A06), 1) << "not there";
}

TEST(ScanByProfile, TellsHowFarItIs) {
  FakeNode node = small_charger();
  SheetScan scan = node.scan();
  std::size_t told = 0;
  scan.on_progress([&told](const SheetScan::Progress& progress) {
    EXPECT_EQ(progress.done, told++);
    EXPECT_LT(progress.done, progress.all);
  });
  static_cast<void>(scan.read_profile(cia419::profile, {.node_id = 5}));
  EXPECT_GT(told, 2000U) << "512 PDOs in both directions have two objects each";
}

TEST(ScanByProfile, DomainsOfAnArrayAreThereAsFarAsSubIndex00hCounts) {
  FakeNode node = small_charger();
  node.entries[{0x1F50, 0}] = Bytes{2};
  SheetScan scan = node.scan();
  const DataSheet sheet = scan.read_profile(cia419::profile, {.node_id = 5});
  EXPECT_EQ(sheet.objects.at(0x1F50).subs.size(), 3U);
  EXPECT_EQ(sheet.find(0x1F50, 0)->default_value, "0x02");
  EXPECT_EQ(std::ranges::count(node.asked, std::pair<unsigned, unsigned>{0x1F50, 1}), 0);
}

}  // namespace
}  // namespace canvoy::formats::sheet_scan_test
