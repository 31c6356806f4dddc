#include "canvoy/formats/sheet/sheet_check.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "canvoy/formats/eds/eds_writer.hpp"
#include "canvoy/formats/sheet/sheet_export.hpp"
#include "canvoy/formats/xdd/xdd.hpp"
#include "canvoy/formats/xdd/xdd_writer.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/profiles/cia852/operator_environment.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::formats::sheet_check_test {
namespace {

constexpr auto charger =
    describe(cia419::charger({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}),
             cia301::identity({.product_code = 419}), cia301::heartbeat_producer(1000),
             cia301::error_behavior());

/// The sheet of the charger, with one line replaced.
Findings check_charger(std::string_view line = "", std::string_view with = "",
                       const Profile* profile = &cia419::profile) {
  SheetMaker maker(cia419::profile, {});
  maker.add(charger);
  std::string text = write_eds(maker.take());
  if (!line.empty()) {
    const std::size_t place = text.find(line);
    EXPECT_NE(place, std::string::npos) << line;
    text.replace(place, line.size(), with);
  }
  Findings findings;
  const DataSheet sheet = read_eds(text, findings);
  check_sheet(sheet, profile, findings);
  return findings;
}

std::string texts(const Findings& findings) {
  std::string all;
  for (const Finding& finding : findings) {
    all +=
        fmt::format("{}|{}|{}|{}\n", finding.line, finding.section, finding.text, finding.expected);
  }
  return all;
}

struct Wrong {
  std::string_view line;
  std::string_view with;
  std::string_view section;
  std::string_view text;
  std::string_view expected;
};

constexpr std::string_view status_head =
    "[6000]\r\nParameterName=battery_status\r\nObjectType=0x7\r\nDataType=0x0005\r\nAccessType="
    "rw\r\n"
    "DefaultValue=0x00\r\nLowLimit=0x00\r\nHighLimit=0x01\r\nPDOMapping=1\r\n";

const Wrong wrongs[] = {
    {status_head,
     "[6000]\r\nParameterName=battery_status\r\nObjectType=0x7\r\nDataType=0x0006\r\nAccessType="
     "rw\r\n"
     "DefaultValue=0x00\r\nPDOMapping=1\r\n",
     "6000", "DataType is 0x0006", "0x0005 UNSIGNED8"},
    {status_head,
     "[6000]\r\nParameterName=battery_status\r\nObjectType=0x7\r\nDataType=0x0005\r\nAccessType="
     "ro\r\n"
     "DefaultValue=0x00\r\nPDOMapping=1\r\n",
     "6000", "AccessType is ro", "rw"},
    {status_head,
     "[6000]\r\nParameterName=battery_status\r\nObjectType=0x7\r\nDataType=0x0005\r\nAccessType="
     "rx\r\n"
     "DefaultValue=0x00\r\nPDOMapping=1\r\n",
     "6000", "AccessType is 'rx'", "one of ro, wo, rw, rwr, rww, const"},
    {status_head,
     "[6000]\r\nParameterName=battery_status\r\nObjectType=0x7\r\nDataType=0x0005\r\nAccessType="
     "rw\r\n"
     "DefaultValue=256\r\nPDOMapping=1\r\n",
     "6000", "DefaultValue is '256'", "a value of UNSIGNED8"},
    {status_head,
     "[6000]\r\nParameterName=battery_status\r\nObjectType=0x7\r\nDataType=0x0005\r\nAccessType="
     "rw\r\n"
     "DefaultValue=0x00\r\nPDOMapping=0\r\n",
     "1600sub2", "6000h:00h is mapped", "PDOMapping=1 there"},
    {status_head,
     "[6000]\r\nParameterName=battery_status\r\nObjectType=0x7\r\nDataType=0x0005\r\nAccessType="
     "rw\r\n"
     "DefaultValue=7\r\nLowLimit=0\r\nHighLimit=1\r\nPDOMapping=1\r\n",
     "6000", "DefaultValue is 7", "0 to 1"},
    {status_head,
     "[6000]\r\nParameterName=battery_status\r\nObjectType=0x7\r\nDataType=0x0005\r\nAccessType="
     "rw\r\n"
     "LowLimit=2\r\nHighLimit=1\r\nPDOMapping=1\r\n",
     "6000", "LowLimit is above HighLimit", ""},
    {status_head, "", "6000", "battery_status is missing", "CiA 419 has it in all devices"},
    {"DefaultValue=0x60100010", "DefaultValue=0x60100008", "1600sub1", "8 bits are mapped", "16"},
    {"DefaultValue=0x60100010", "DefaultValue=0x60110010", "1600sub1",
     "6011h:00h is mapped and not there", ""},
    {"VendorNumber=0x00000000", "VendorNumber=", "DeviceInfo", "VendorNumber is ''", "a number"},
    {"FileVersion=1", "FileVersion=-", "FileInfo", "FileVersion is '-'", "a number"},
    {"NrOfRXPDO=3", "NrOfRXPDO=4", "DeviceInfo", "NrOfRXPDO is 4", "3, as there are parameters"},
    {"EDSVersion=4.0\r\n", "", "FileInfo", "EDSVersion is missing", ""},
    {"[1018]\r\nParameterName=Identity object\r\nObjectType=0x9",
     "[1018]\r\nParameterName=Identity object\r\nObjectType=0x8", "1018", "ObjectType is 0x8",
     "0x9: Identity object is RECORD"},
    {"[1001]", "[2001]", "1001", "the object is missing", "all devices have it (CiA 301)"},
};

TEST(SheetCheck, TellsValuesThatTheProfileReservesOrHasNoRoomFor) {
  // 640Ch may be 00h, 01h, 02h, 04h, 06h (CiA 417-4, errata A16).
  const auto check_jerk = [](const char* key, const char* value) {
    Findings findings;
    const DataSheet sheet = read_eds(
        fmt::format("[640C]\nParameterName=Profile jerk use\nDataType=5\nAccessType=rw\n{}={}\n",
                    key, value),
        findings);
    findings.clear();
    check_sheet(sheet, find_profile("417-4"), findings);
    std::string found;
    for (const Finding& finding : findings) {
      if (finding.section == "640C" && finding.text.starts_with(key)) {
        found += finding.text + '|' + finding.expected;
      }
    }
    return found;
  };
  EXPECT_EQ(check_jerk("ParameterValue", "4"), "");
  EXPECT_EQ(check_jerk("ParameterValue", "0x03"), "ParameterValue is 0x03, which is reserved|");
  EXPECT_EQ(check_jerk("DefaultValue", "5"), "DefaultValue is 5, which is reserved|");
  EXPECT_EQ(check_jerk("DefaultValue", "7"), "DefaultValue is 7|0 to 6");
}

TEST(SheetCheck, FindsNothingInWhatTheProjectExports) {
  EXPECT_EQ(texts(check_charger()), "");
}

TEST(SheetCheck, AsksAnXddForNothingThatItHasNoPlaceFor) {
  SheetMaker maker(cia419::profile, {});
  maker.add(charger);
  Findings findings;
  const DataSheet sheet = read_xdd(write_xdd(maker.take()), findings);
  check_sheet(sheet, &cia419::profile, findings);
  EXPECT_EQ(texts(findings), "");
}

TEST(SheetCheck, TellsPlaceFaultAndWhatWouldBeRight) {
  for (const Wrong& wrong : wrongs) {
    const Findings findings = check_charger(wrong.line, wrong.with);
    const auto found = std::ranges::find_if(findings, [&wrong](const Finding& finding) {
      return finding.section == wrong.section && finding.text == wrong.text &&
             finding.expected == wrong.expected;
    });
    EXPECT_NE(found, findings.end()) << wrong.text << ", but:\n" << texts(findings);
  }
}

TEST(SheetCheck, WithoutAProfileItAsksForWhatCia301Says) {
  const Findings findings = check_charger(
      "[1017]\r\nParameterName=Producer heartbeat time\r\nObjectType=0x7\r\nDataType=0x0006",
      "[1017]\r\nParameterName=Producer heartbeat time\r\nObjectType=0x7\r\nDataType=0x0007",
      nullptr);
  ASSERT_EQ(findings.size(), 1U) << texts(findings);
  EXPECT_EQ(findings[0].section, "1017");
  EXPECT_EQ(findings[0].expected, "0x0006 UNSIGNED16");
}

constexpr cia852::OperatorEnvironment remote_elements = {.push_button_clusters = 1};
constexpr auto remote =
    describe(cia852::operator_environment<remote_elements>(), cia301::identity({.vendor_id = 1}),
             cia301::heartbeat_producer(1000));

DataSheet remote_sheet() {
  SheetMaker maker(cia852::profile, {});
  maker.add(remote);
  Findings findings;
  return read_eds(write_eds(maker.take()), findings);
}
Findings check_remote(const DataSheet& sheet) {
  Findings findings;
  check_sheet(sheet, &cia852::profile, findings);
  return findings;
}

TEST(SheetCheck, TakesConstWhereTheProfileLeavesTheChoice) {  // CiA 852, Table 26: rw or const
  DataSheet sheet = remote_sheet();
  EXPECT_EQ(texts(check_remote(sheet)), "");
  sheet.objects.at(0x1821).subs.at(2).access = "const";
  EXPECT_EQ(texts(check_remote(sheet)), "");
  sheet.objects.at(0x1821).subs.at(3).access = "const";  // the inhibit time is rw
  EXPECT_NE(texts(check_remote(sheet)).find("AccessType is const|rw"), std::string::npos);
}

TEST(SheetCheck, MissesMandatoryCommunicationObjectsOfVirtualDevices) {  // CiA 852, Table A 1
  DataSheet sheet = remote_sheet();
  sheet.objects.erase(0x1015);
  EXPECT_NE(texts(check_remote(sheet)).find("1015|Inhibit time EMCY is missing"),
            std::string::npos);
}

TEST(SheetExport, WritesTheDefaultOfARealAsANumber) {  // 1.0, not the bits 3F800000h
  SheetMaker maker(cia401::profile, {});
  maker.add(Part(cia401::analogue_input_scaling_float_object).up_to(1));
  EXPECT_EQ(maker.take().objects.at(0x642F).subs.at(1).default_value, "1");
}

/// TPDO 3 has its parameters at 1802h and its mapping at 1A02h, RPDO 3 at 1402h and 1602h (CiA 301,
/// 7.5.2.35 to 7.5.2.38).
TEST(SheetExport, APdoHasItsParametersAndItsMappingAtTheirIndices) {
  constexpr std::uint32_t mapped[] = {0x6000'00'08, 0x6052'00'10};
  for (const bool is_transmitted : {true, false}) {
    SheetMaker maker(cia419::profile, {});
    maker.add(PdoInfo{
        .direction = is_transmitted ? PdoInfo::Direction::transmit : PdoInfo::Direction::receive,
        .number = 3,
        .cob_id = 0x380,
        .plus_node_id = true,
        .mapping = mapped});
    const DataSheet sheet = maker.take();
    const SheetObject& parameter = sheet.objects.at(is_transmitted ? 0x1802 : 0x1402);
    EXPECT_EQ(parameter.subs.at(1).default_value, "$NODEID+0x380");
    const SheetObject& mapping = sheet.objects.at(is_transmitted ? 0x1A02 : 0x1602);
    EXPECT_EQ(mapping.subs.size(), 3U);
    EXPECT_EQ(mapping.own.name,
              is_transmitted ? "TPDO mapping parameter" : "RPDO mapping parameter");
  }
}

}  // namespace
}  // namespace canvoy::formats::sheet_check_test
