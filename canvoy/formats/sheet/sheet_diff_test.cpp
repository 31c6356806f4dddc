// Differences of two data sheets: of meaning, not of notation.
#include "canvoy/formats/sheet/sheet_diff.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "canvoy/formats/eds/eds_reader.hpp"

namespace canvoy::formats::sheet_diff_test {
namespace {

constexpr std::string_view speed =
    "[DeviceInfo]\nVendorName=Somebody\nVendorNumber=0x10\n"
    "[2000]\nParameterName=Speed\nObjectType=7\nDataType=3\nAccessType=rw\nDefaultValue=-1\n"
    "MyKey=mine\n; a comment\n";

/// `[2000] AccessType: rw | ro`, for the sheet with one text replaced.
std::string differences(std::string_view text, std::string_view with) {
  Findings findings;
  std::string changed(speed);
  const std::size_t place = changed.find(text);
  EXPECT_NE(place, std::string::npos) << text;
  changed.replace(place, text.size(), with);
  std::string lines;
  for (const Difference& each :
       compare_sheets(read_eds(speed, findings), read_eds(changed, findings))) {
    lines += fmt::format("[{}] {}: {} | {}\n", each.place, each.key, each.first, each.second);
  }
  return lines;
}

TEST(SheetDiff, TheSameValueInAnotherNotationIsNoDifference) {
  EXPECT_EQ(differences("=0x10", "=16"), "");
  EXPECT_EQ(differences("=-1", "=0xFFFF"), "");
  EXPECT_EQ(differences("DataType=3", "datatype=0x0003"), "");
  EXPECT_EQ(differences("AccessType=rw", "AccessType=RW"), "");
}

TEST(SheetDiff, CommentsAndTheDatesOfTheFileAreNoDifference) {
  EXPECT_EQ(differences("; a comment", "; another"), "");
  EXPECT_EQ(differences("[DeviceInfo]", "[FileInfo]\nFileName=x\n[DeviceInfo]"), "");
  EXPECT_EQ(differences("[DeviceInfo]", "; by hand\n[DeviceInfo]"), "");
}

TEST(SheetDiff, TheSpellingOfASectionIsNoDifference) {
  Findings findings;
  const DataSheet one = read_eds("[DeviceCommissioning]\nNodeID=5\n", findings);
  EXPECT_TRUE(compare_sheets(one, read_eds("[DeviceComissioning]\nNodeID=5\n", findings)).empty());
}

TEST(SheetDiff, EachAttributeThatDiffersIsTold) {
  EXPECT_EQ(differences("AccessType=rw", "AccessType=ro"), "[2000] AccessType: rw | ro\n");
  EXPECT_EQ(differences("DataType=3", "DataType=4"), "[2000] DataType: 0x3 | 0x4\n");
  EXPECT_EQ(differences("=-1", "=1"), "[2000] DefaultValue: -1 | 1\n");
  EXPECT_EQ(differences("Speed", "Velocity"), "[2000] ParameterName: Speed | Velocity\n");
  EXPECT_EQ(differences("DefaultValue=-1\n", ""), "[2000] DefaultValue: -1 | \n");
}

TEST(SheetDiff, KeysThatNobodyKnowsAreTold) {
  EXPECT_EQ(differences("MyKey=mine", "MyKey=yours"), "[2000] MyKey: mine | yours\n");
  EXPECT_EQ(differences("MyKey=mine\n", ""), "[2000] MyKey: mine | \n");
  EXPECT_EQ(differences("MyKey", "Other=1\nmykey"), "[2000] Other:  | 1\n");
  EXPECT_EQ(differences("Somebody", "Nobody"), "[DeviceInfo] VendorName: Somebody | Nobody\n");
}

TEST(SheetDiff, AnObjectOfOneSideIsTold) {
  EXPECT_EQ(differences("[2000]", "[2001]"), "[2000] : Speed | \n[2001] :  | Speed\n");
}

}  // namespace
}  // namespace canvoy::formats::sheet_diff_test
