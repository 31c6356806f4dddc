// A file of CiA 311 with unknown parts, which are kept.
#include "canvoy/formats/xdd/xdd.hpp"
#include "canvoy/formats/xdd/xdd_writer.hpp"

#include <gtest/gtest.h>

#include "canvoy/formats/eds/eds_writer.hpp"
#include "canvoy/formats/sheet/sheet_diff.hpp"

namespace canvoy::formats::xdd_test {
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
      <NetworkManagement><CANopenGeneralFeatures granularity="8" nrOfRxPDO="1" layerSettingServiceSlave="true"/></NetworkManagement>
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
  EXPECT_EQ(door->access, "rwr") << "a TPDO may carry it";
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
  sheet.configured = true;
  sheet.objects[0x2000].own = {.name = "New", .data_type = 5, .access = "rww"};
  const std::string text = write_xdd(sheet);
  EXPECT_EQ(text.find("Device type"), std::string::npos);
  EXPECT_NE(text.find("actualValue=\"5\""), std::string::npos);
  EXPECT_NE(text.find("uniqueIDRef=\"ID_7\""), std::string::npos);
  EXPECT_NE(text.find("vendorText"), std::string::npos);
  const DataSheet again = read(text);
  EXPECT_EQ(again.find(0x2000, 0)->access, "rw") << "rww is said by PDOmapping";
  EXPECT_TRUE(again.configured);
}

TEST(Xdd, AnEdsBecomesAnXddAndTheOtherWayRound) {
  Findings findings;
  const DataSheet eds = read_eds(write_eds(read(file)), findings);
  EXPECT_TRUE(compare_sheets(read(file), eds).empty());
  EXPECT_TRUE(compare_sheets(eds, read(write_xdd(eds))).empty());
}

/// As written by CANopenEditor for XDD, and by CANopenNode for its .xpd: the description of an
/// object is in the parameter that it refers to.
constexpr std::string_view with_parameters = R"(<?xml version="1.0" encoding="utf-8"?>
<ISO15745ProfileContainer xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.canopen.org/xml/1.1">
  <ISO15745Profile>
    <ProfileBody xmlns:q1="http://www.canopen.org/xml/1.1" xsi:type="q1:ProfileBody_Device_CANopen" xmlns="">
      <q1:ApplicationProcess>
        <q1:dataTypeList>
          <q1:array name="Errors" uniqueID="UID_ARR_1003"><q1:subrange lowerLimit="0" upperLimit="1"/><UDINT/></q1:array>
          <q1:derived name="Percent" uniqueID="UID_PERCENT"><USINT/></q1:derived>
          <q1:derived name="Loop" uniqueID="UID_LOOP"><q1:dataTypeIDRef uniqueIDRef="UID_LOOP"/></q1:derived>
        </q1:dataTypeList>
        <q1:templateList>
          <q1:parameterTemplate uniqueID="UID_TEMPLATE" access="readWriteOutput"><UINT/><q1:defaultValue value="9"/></q1:parameterTemplate>
        </q1:templateList>
        <q1:parameterList>
          <q1:parameter uniqueID="UID_OBJ_1000"><label lang="en">Type</label><UDINT/><q1:defaultValue value="0x00000191"/></q1:parameter>
          <q1:parameter uniqueID="UID_OBJ_1003"><q1:dataTypeIDRef uniqueIDRef="UID_ARR_1003"/></q1:parameter>
          <q1:parameter uniqueID="UID_SUB_100300" access="readWrite"><label lang="en">Number</label><USINT/></q1:parameter>
          <q1:parameter uniqueID="UID_SUB_100301"><label lang="en">Error</label><UDINT/></q1:parameter>
          <q1:parameter uniqueID="UID_OBJ_1014" access="readWrite"><UDINT/><q1:defaultValue value="0x80+$NODEID"/></q1:parameter>
          <q1:parameter uniqueID="UID_OBJ_1021"><BITSTRING/></q1:parameter>
          <q1:parameter uniqueID="UID_OBJ_2000" access="readWriteInput"><q1:dataTypeIDRef uniqueIDRef="UID_PERCENT"/><q1:actualValue value="7"/><q1:allowedValues><q1:range><q1:minValue value="1"/><q1:maxValue value="100"/></q1:range></q1:allowedValues></q1:parameter>
          <q1:parameter uniqueID="UID_OBJ_2001" templateIDRef="UID_TEMPLATE"/>
          <q1:parameter uniqueID="UID_OBJ_2002" access="const"><q1:dataTypeIDRef uniqueIDRef="UID_LOOP"/></q1:parameter>
        </q1:parameterList>
      </q1:ApplicationProcess>
    </ProfileBody>
  </ISO15745Profile>
  <ISO15745Profile>
    <ProfileBody xmlns:q2="http://www.canopen.org/xml/1.1" xsi:type="q2:ProfileBody_CommunicationNetwork_CANopen" xmlns="">
      <ApplicationLayers>
        <q2:CANopenObjectList>
          <CANopenObject index="1000" name="Device type" objectType="7" PDOmapping="no" uniqueIDRef="UID_OBJ_1000"/>
          <CANopenObject index="1003" name="Errors" objectType="8" uniqueIDRef="UID_OBJ_1003" subNumber="2">
            <CANopenSubObject subIndex="00" name="Number" objectType="7" PDOmapping="no" uniqueIDRef="UID_SUB_100300"/>
            <CANopenSubObject subIndex="01" name="Error" objectType="7" PDOmapping="no" uniqueIDRef="UID_SUB_100301"/>
          </CANopenObject>
          <CANopenObject index="1014" name="COB-ID EMCY" objectType="7" PDOmapping="no" uniqueIDRef="UID_OBJ_1014"/>
          <CANopenObject index="1021" name="Store EDS" objectType="2" PDOmapping="no" uniqueIDRef="UID_OBJ_1021"/>
          <CANopenObject index="2000" name="Percent" objectType="7" PDOmapping="TPDO" uniqueIDRef="UID_OBJ_2000"/>
          <CANopenObject index="2001" name="Templated" objectType="7" PDOmapping="RPDO" uniqueIDRef="UID_OBJ_2001" defaultValue="8"/>
          <CANopenObject index="2002" name="Loop" objectType="7" PDOmapping="no" uniqueIDRef="UID_OBJ_2002"/>
        </q2:CANopenObjectList>
      </ApplicationLayers>
    </ProfileBody>
  </ISO15745Profile>
</ISO15745ProfileContainer>
)";

// Keys of DeviceInfo (CiA 306) without a counterpart in CiA 311.
TEST(Xdd, KeepsRevisionAndBitRatesThatAreNotSupported) {
  Findings findings;
  const DataSheet eds = read_eds(
      "[FileInfo]\nFileName=a.eds\n[DeviceInfo]\nVendorName=Maker\nRevisionNumber=0x10002\n"
      "BaudRate_10=0\nBaudRate_125=1\n[1000]\nParameterName=Device type\nObjectType=7\n"
      "DataType=7\nAccessType=ro\n",
      findings);
  findings.clear();
  const DataSheet sheet = read_xdd(write_xdd(eds), findings);
  EXPECT_TRUE(findings.empty());
  EXPECT_EQ(sheet.text("DeviceInfo", "RevisionNumber"), "0x10002");
  EXPECT_EQ(sheet.text("DeviceInfo", "BaudRate_10"), "0");
  EXPECT_EQ(sheet.text("DeviceInfo", "BaudRate_125"), "1");
  const std::string other =
      "<a><DeviceIdentity><version versionType=\"HW\">1.0 B</version>"
      "</DeviceIdentity><CANopenObjectList/></a>";
  EXPECT_EQ(read_xdd(other, findings).text("DeviceInfo", "RevisionNumber"), "");
}

TEST(Xdd, InAnotherEncodingIsReadAndWrittenAsUtf8) {
  const std::string in_windows =
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<a><CANopenObjectList><CANopenObject "
      "index=\"2000\" name=\"Verz\xF6gerung\" objectType=\"7\" dataType=\"0006\"/>"
      "</CANopenObjectList></a>\n";
  std::string in_utf16 = "\xFF\xFE";
  for (const char c : in_windows) in_utf16 += {c, '\0'};
  for (const std::string& text : {in_windows, in_utf16}) {
    EXPECT_TRUE(is_xml(text));
    Findings findings;
    const DataSheet sheet = read_xdd(text, findings);
    ASSERT_NE(sheet.find(0x2000, 0), nullptr);
    EXPECT_EQ(sheet.find(0x2000, 0)->name, "Verz\xC3\xB6gerung");
    EXPECT_EQ(findings.size(), 1U) << "said once";
    const std::string written = write_xdd(sheet);
    EXPECT_NE(written.find("encoding=\"UTF-8\""), std::string::npos);
    EXPECT_NE(written.find("Verz\xC3\xB6gerung"), std::string::npos);
  }
}

TEST(Xdd, ReadsWhatStandsInTheParametersOfTheApplicationProcess) {
  const DataSheet sheet = read(with_parameters);
  const auto entry = [&sheet](unsigned index, unsigned sub) {
    const SheetEntry* found = sheet.find(index, sub);
    return found == nullptr ? SheetEntry() : *found;
  };
  EXPECT_EQ(entry(0x1000, 0).data_type, 7U);
  EXPECT_EQ(entry(0x1000, 0).access, "ro") << "the access of a parameter that says none";
  EXPECT_EQ(entry(0x1000, 0).default_value, "0x00000191");
  EXPECT_EQ(sheet.objects.at(0x1003).own.data_type, 0U) << "of an array, its entries have one";
  EXPECT_EQ(entry(0x1003, 0).access, "rw");
  EXPECT_EQ(entry(0x1003, 0).data_type, 5U);
  EXPECT_EQ(entry(0x1003, 1).data_type, 7U);
  EXPECT_EQ(entry(0x1014, 0).default_value, "0x80+$NODEID");
  EXPECT_EQ(entry(0x1021, 0).data_type, 15U) << "a BITSTRING without a default is a domain";
  EXPECT_EQ(entry(0x2000, 0).data_type, 5U);
  EXPECT_EQ(entry(0x2000, 0).access, "rwr");
  EXPECT_EQ(entry(0x2000, 0).low_limit, "1");
  EXPECT_EQ(entry(0x2000, 0).high_limit, "100");
  EXPECT_EQ(entry(0x2000, 0).value, "7");
  EXPECT_EQ(entry(0x2001, 0).data_type, 6U);
  EXPECT_EQ(entry(0x2001, 0).access, "rww");
  EXPECT_EQ(entry(0x2001, 0).default_value, "8") << "what the object says itself goes first";
  EXPECT_EQ(entry(0x2002, 0).data_type, 0U) << "a type that is itself is none";
  EXPECT_TRUE(sheet.configured);
}

TEST(Xdd, ParametersStayAndWhatWasChangedIsSaidByTheObject) {
  DataSheet sheet = read(with_parameters);
  EXPECT_EQ(write_xdd(sheet), with_parameters);
  sheet.objects.at(0x1000).own.default_value = "0x192";
  const std::string text = write_xdd(sheet);
  EXPECT_NE(text.find("uniqueIDRef=\"UID_OBJ_1000\" defaultValue=\"0x192\""), std::string::npos);
  EXPECT_EQ(read(text).find(0x1000, 0)->default_value, "0x192");
  sheet.configured = false;
  EXPECT_FALSE(read(write_xdd(sheet)).configured) << "an XDD has no values";
}

TEST(Xdd, AccessAndDirectionOfPdosAreTwoAttributes) {
  struct Row {
    const char* access;
    bool mapped;
    const char* attributes;
  };
  constexpr Row rows[] = {
      {"rwr", true, R"(accessType="rw" PDOmapping="TPDO")"},
      {"rww", true, R"(accessType="rw" PDOmapping="RPDO")"},
      {"rw", true, R"(accessType="rw" PDOmapping="optional")"},
      {"ro", true, R"(accessType="ro" PDOmapping="optional")"},
      {"wo", false, R"(accessType="wo" PDOmapping="no")"},
  };
  for (const Row& row : rows) {
    DataSheet sheet;
    sheet.objects[0x2000].own = {
        .name = "a", .data_type = 5, .access = row.access, .pdo_mapping = row.mapped};
    const std::string text = write_xdd(sheet);
    EXPECT_NE(text.find(row.attributes), std::string::npos) << text;
    EXPECT_EQ(read(text).find(0x2000, 0)->access, row.access);
    EXPECT_EQ(read(text).find(0x2000, 0)->pdo_mapping, row.mapped);
  }
}

TEST(Xdd, AnAccessInCapitalsIsInTheLettersOfTheSchema) {
  DataSheet sheet;
  sheet.objects[0x2000].own = {.name = "a", .data_type = 5, .access = "RWR", .pdo_mapping = true};
  sheet.objects[0x2001].own = {.name = "b", .data_type = 5, .access = "Const"};
  const std::string text = write_xdd(sheet);
  EXPECT_NE(text.find(R"(accessType="rw" PDOmapping="TPDO")"), std::string::npos) << text;
  EXPECT_NE(text.find(R"(accessType="const" PDOmapping="no")"), std::string::npos) << text;
}

TEST(Xdd, WhatAnXdcSaysOfTheNodeGoesThereAndBack) {
  Findings findings;
  const DataSheet dcf = read_eds(
      "[DeviceComissioning]\nNodeID=0x05\nNodeName=\nBaudrate=125\nNetNumber=1\nNetworkName=\n"
      "CANopenManager=0\n[1000]\nParameterName=a\nDataType=7\nParameterValue=1\nObjFlags=0x1\n",
      findings);
  const std::string text = write_xdd(dcf);
  EXPECT_NE(text.find(R"(<deviceCommissioning nodeID="5" nodeName="" actualBaudRate="125 Kbps" )"
                      R"(networkNumber="1" networkName="" CANopenManager="false")"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(R"(objFlags="0001")"), std::string::npos);
  const DataSheet xdc = read(text);
  for (const IniLine& line : dcf.section("DeviceComissioning")->lines) {
    const std::string_view value = xdc.text("DeviceComissioning", line.key);
    EXPECT_EQ(value, line.key == "NodeID" ? "5" : line.value) << line.key;
  }
  EXPECT_EQ(xdc.find(0x1000, 0)->value, "1");
  DataSheet without = xdc;
  without.configured = false;
  EXPECT_EQ(write_xdd(without).find("deviceCommissioning"), std::string::npos);
  DataSheet xdd = read(file);
  xdd.sections.push_back(*dcf.section("DeviceComissioning"));
  xdd.configured = true;
  const DataSheet again = read(write_xdd(xdd));
  EXPECT_EQ(again.text("DeviceComissioning", "Baudrate"), "125");
}

TEST(Xdd, TheNodeOfADcfThatSpellsItsSectionOtherwiseIsInTheXdc) {
  Findings findings;
  const DataSheet dcf =
      read_eds("[DeviceCommissioning]\nNodeID=10\nNodeName=left\nBaudrate=250\n", findings);
  const std::string text = write_xdd(dcf);
  EXPECT_NE(
      text.find(R"(<deviceCommissioning nodeID="10" nodeName="left" actualBaudRate="250 Kbps")"),
      std::string::npos)
      << text;
  EXPECT_EQ(read(text).node_id(), 10);
}

TEST(Xdd, WhatXmlCannotHaveIsWrittenAsItsBytes) {
  DataSheet sheet;
  sheet.objects[0x2000].own = {.name = "a\x1B[2J \xFC", .data_type = 5, .access = "ro"};
  EXPECT_EQ(read(write_xdd(sheet)).find(0x2000, 0)->name, "a\\x1B[2J \\xFC");
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
}  // namespace canvoy::formats::xdd_test
