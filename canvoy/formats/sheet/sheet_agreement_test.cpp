// Sheets with sections and objects that contradict each other.
#include "canvoy/formats/sheet/sheet_agreement.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::formats::sheet_agreement_test {
namespace {

constexpr std::string_view identity =
    "[1018]\nObjectType=9\nSubNumber=5\n"
    "[1018sub0]\nDataType=5\nAccessType=const\nDefaultValue=4\n"
    "[1018sub1]\nDataType=7\nAccessType=ro\nDefaultValue=0x2F0\n"
    "[1018sub2]\nDataType=7\nAccessType=ro\nDefaultValue=0x1A3\n"
    "[1018sub3]\nDataType=7\nAccessType=ro\nDefaultValue=0\n"
    "[1018sub4]\nDataType=7\nAccessType=ro\n";
constexpr std::string_view mapping =
    "[1A00]\nObjectType=9\nSubNumber=2\n[1A00sub0]\nDataType=5\nAccessType=rw\nDefaultValue=1\n"
    "[1A00sub1]\nDataType=7\nDefaultValue=0x60000108\nAccessType=";

/// The findings, as `[section] text; expected`.
std::vector<std::string> told(const std::string& text) {
  Findings reading;
  Findings findings;
  check_agreement(read_eds(text, reading), findings);
  std::vector<std::string> lines;
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.weight, Finding::Weight::warning);
    lines.push_back("[" + finding.section + "] " + finding.text + "; " + finding.expected);
  }
  return lines;
}
std::string device(const std::string& keys) {
  return "[DeviceInfo]\n" + keys + "\n";
}
using Lines = std::vector<std::string>;

TEST(SheetAgreement, TheIdentityIsThatOf1018h) {
  const std::string right = device("VendorNumber=752\nProductNumber=0x1A3\nRevisionNumber=7");
  EXPECT_EQ(told(right + std::string(identity)), Lines());
  EXPECT_EQ(told(device("VendorNumber=0x2F0\nProductNumber=0") + std::string(identity)),
            Lines{"[DeviceInfo] ProductNumber is 0; 0x1A3, as 1018sub2 has"});
  EXPECT_EQ(told(device("VendorNumber=0x2F1") + std::string(identity)),
            Lines{"[DeviceInfo] VendorNumber is 0x2F1; 0x2F0, as 1018sub1 has"});
  EXPECT_EQ(told(device("VendorNumber=5")), Lines()) << "a sheet without 1018h says nothing else";
}

TEST(SheetAgreement, LssTakesAllOf1018h) {
  EXPECT_EQ(told(device("LSS_Supported=1") + std::string(identity)), Lines());
  EXPECT_EQ(told(device("LSS_Supported=1")),
            Lines{"[DeviceInfo] LSS_Supported is 1; 0, or 1018sub1: the LSS address is all of "
                  "1018h"});
  EXPECT_EQ(told(device("LSS_Supported=0")), Lines());
}

TEST(SheetAgreement, GranularityIsOfMappingsThatCanBeWritten) {
  const std::string fixed = std::string(mapping) + "const\n";
  const std::string free = std::string(mapping) + "rw\n";
  EXPECT_EQ(told(device("Granularity=8") + free), Lines());
  EXPECT_EQ(told(device("Granularity=0") + fixed), Lines());
  EXPECT_EQ(told(device("Granularity=8") + fixed),
            Lines{"[DeviceInfo] Granularity is 8; 0, as no mapping of a PDO can be written"});
  EXPECT_EQ(told(device("Granularity=0") + free),
            Lines{"[DeviceInfo] Granularity is 0; 1 to 64 bits, as the mapping of PDOs can be "
                  "written"});
}

TEST(SheetAgreement, TheBitRateOfADcfIsOneThatTheDeviceHas) {
  const std::string node = "[DeviceComissioning]\nBaudrate=250\n";
  EXPECT_EQ(told(device("BaudRate_250=1") + node), Lines());
  const Lines wrong = {
      "[DeviceComissioning] Baudrate is 250; a rate that DeviceInfo has, BaudRate_250=1"};
  EXPECT_EQ(told(device("BaudRate_250=0") + node), wrong);
  EXPECT_EQ(told(device("BaudRate_125=1") + node), wrong);
}

TEST(SheetAgreement, TextsAreAscii) {
  EXPECT_EQ(told("[1000]\nParameterName=Ti \xE2\x80\x93 time\n"),
            Lines{"[1000] 'Ti \xE2\x80\x93 time' is not ASCII; ASCII (CiA 306)"});
  EXPECT_EQ(told(device("VendorName=Pr\xFC"
                        "fer") +
                 "[1000]\nParameterName=\xB5\n"),
            Lines{"[DeviceInfo] 'Pr\xC3\xBC"
                  "fer' and 1 more are not ASCII; ASCII (CiA 306)"});
}

}  // namespace
}  // namespace canvoy::formats::sheet_agreement_test
