// A file as CiA 311 has it, with what nobody here knows: it stays.
#include "canvoy/formats/xdd.hpp"

#include <gtest/gtest.h>

#include "canvoy/formats/eds_writer.hpp"
#include "canvoy/formats/sheet_diff.hpp"

namespace canvoy::formats {
namespace {

constexpr std::string_view file = R"(<?xml version="1.0" encoding="utf-8"?>
<co:ISO15745ProfileContainer xmlns:co="http://www.canopen.org/xml/1.1">
  <co:ISO15745Profile>
    <ProfileBody fileName="door.xdd" fileVersion="3">
      <DeviceIdentity>
        <vendorName>Somebody</vendorName>
        <vendorID>0x123</vendorID>
        <vendorText>unknown here</vendorText>
      </DeviceIdentity>
      <ApplicationProcess><parameterList/></ApplicationProcess>
    </ProfileBody>
  </co:ISO15745Profile>
  <co:ISO15745Profile>
    <ProfileBody>
      <ApplicationLayers>
        <CANopenObjectList>
          <CANopenObject index="1000" name="Device type" objectType="7" dataType="0007" accessType="ro" PDOmapping="no" defaultValue="0x1BF" own="kept"/>
          <CANopenObject index="6001" name="Doors" objectType="8" subNumber="2">
            <CANopenSubObject subIndex="00" name="count" objectType="7" dataType="0005" accessType="const" defaultValue="1"/>
            <CANopenSubObject subIndex="01" name="Door 1" objectType="7" dataType="0x06" accessType="rw" PDOmapping="TPDO" lowLimit="1" highLimit="9" defaultValue="2" denotation="left" uniqueIDRef="ID_7"/>
          </CANopenObject>
        </CANopenObjectList>
        <dummyUsage><dummy entry="Dummy0005=1"/></dummyUsage>
      </ApplicationLayers>
      <TransportLayers><PhysicalLayer><baudRate><supportedBaudRate value="125 Kbps"/></baudRate></PhysicalLayer></TransportLayers>
      <NetworkManagement><CANopenGeneralFeatures nrOfRxPDO="1" layerSettingServiceSlave="true"/></NetworkManagement>
    </ProfileBody>
  </co:ISO15745Profile>
</co:ISO15745ProfileContainer>
)";

DataSheet read(std::string_view text) {
  Findings findings;
  DataSheet sheet = read_xdd(text, findings);
  EXPECT_TRUE(findings.empty()) << findings.front().text;
  return sheet;
}

TEST(Xdd, ReadsObjectsAndTheirAttributes) {
  const DataSheet sheet = read(file);
  ASSERT_NE(sheet.find(0x1000, 0), nullptr);
  EXPECT_EQ(sheet.find(0x1000, 0)->default_value, "0x1BF");
  EXPECT_EQ(sheet.objects.at(0x1000).group, SheetObject::Group::mandatory);
  const SheetEntry* door = sheet.find(0x6001, 1);
  ASSERT_NE(door, nullptr);
  EXPECT_EQ(door->name, "Door 1");
  EXPECT_EQ(door->data_type, 6U);
  EXPECT_EQ(door->access, "rw");
  EXPECT_TRUE(door->pdo_mapping);
  EXPECT_EQ(door->low_limit, "1");
  EXPECT_EQ(door->high_limit, "9");
  EXPECT_EQ(door->denotation, "left");
  EXPECT_EQ(door->line, 20U);
  EXPECT_TRUE(sheet.dummies.at(5));
}

TEST(Xdd, ReadsWhatAnEdsHasInItsSections) {
  const DataSheet sheet = read(file);
  EXPECT_EQ(sheet.text("FileInfo", "FileVersion"), "3");
  EXPECT_EQ(sheet.text("DeviceInfo", "VendorName"), "Somebody");
  EXPECT_EQ(sheet.text("DeviceInfo", "VendorNumber"), "0x123");
  EXPECT_EQ(sheet.text("DeviceInfo", "LSS_Supported"), "1");
  EXPECT_EQ(sheet.text("DeviceInfo", "BaudRate_125"), "1");
}

TEST(Xdd, LosesNothingInARoundTrip) {
  EXPECT_EQ(write_xdd(read(file)), file);
}

TEST(Xdd, WritesWhatWasChangedAndLeavesTheRest) {
  DataSheet sheet = read(file);
  sheet.objects.erase(0x1000);
  sheet.objects.at(0x6001).subs.at(1).value = "5";
  sheet.objects[0x2000].own = {.name = "New", .data_type = 5, .access = "rww"};
  const std::string text = write_xdd(sheet);
  EXPECT_EQ(text.find("Device type"), std::string::npos);
  EXPECT_NE(text.find("actualValue=\"5\""), std::string::npos);
  EXPECT_NE(text.find("uniqueIDRef=\"ID_7\""), std::string::npos);
  EXPECT_NE(text.find("vendorText"), std::string::npos);
  const DataSheet again = read(text);
  EXPECT_EQ(again.find(0x2000, 0)->access, "rw") << "XDD has no rww";
  EXPECT_TRUE(again.configured);
}

TEST(Xdd, AnEdsBecomesAnXddAndTheOtherWayRound) {
  Findings findings;
  const DataSheet eds = read_eds(write_eds(read(file)), findings);
  EXPECT_TRUE(compare_sheets(read(file), eds).empty());
  EXPECT_TRUE(compare_sheets(eds, read(write_xdd(eds))).empty());
}

TEST(Xdd, TellsWhatIsNoXmlAndWhatIsNoDataSheet) {
  for (const char* text : {"<", "<a>", "<a/>", "<a><b></a>", "<?xml version='1.0'?>"}) {
    Findings findings;
    EXPECT_TRUE(read_xdd(text, findings).objects.empty());
    EXPECT_EQ(findings.size(), 1U) << text;
  }
}

TEST(Xdd, TellsIndicesThatAreNone) {
  Findings findings;
  const DataSheet sheet = read_xdd(
      "<x><CANopenObjectList>\n<CANopenObject index=\"10000\"/>\n<CANopenObject index=\"\"/>"
      "<CANopenObject index=\"1000\"><CANopenSubObject subIndex=\"100\"/></CANopenObject>"
      "\n<CANopenObject index=\"1000\"/></CANopenObjectList></x>",
      findings);
  EXPECT_EQ(sheet.objects.size(), 1U);
  ASSERT_EQ(findings.size(), 4U);
  EXPECT_EQ(findings[0].line, 2U);
  EXPECT_EQ(findings[3].line, 4U);
}

}  // namespace
}  // namespace canvoy::formats
