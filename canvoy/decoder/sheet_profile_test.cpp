#include "canvoy/decoder/sheet_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/formats/eds_reader.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder {
namespace {

// Typed by CiA 306: a device of CiA 418 with an object of its maker's, and one TPDO of it.
constexpr std::string_view sheet_text = R"([ManufacturerObjects]
SupportedObjects=1
1=0x2000
[1000]
ParameterName=Device type
ObjectType=0x7
DataType=0x0007
AccessType=ro
DefaultValue=0x000001A2
[1800]
ParameterName=TPDO
ObjectType=0x9
SubNumber=2
[1800sub0]
ParameterName=Highest sub-index
DataType=0x0005
AccessType=ro
DefaultValue=1
[1800sub1]
ParameterName=COB-ID
DataType=0x0007
AccessType=rw
DefaultValue=$NODEID+0x40000200
[1A00]
ParameterName=TPDO mapping
ObjectType=0x9
SubNumber=3
[1A00sub0]
ParameterName=Number of entries
DataType=0x0005
AccessType=rw
DefaultValue=2
[1A00sub1]
ParameterName=First
DataType=0x0007
AccessType=rw
DefaultValue=0x20000110
[1A00sub2]
ParameterName=Second
DataType=0x0007
AccessType=rw
DefaultValue=0x60100010
[2000]
ParameterName=Fan
ObjectType=0x9
SubNumber=2
[2000sub0]
ParameterName=Highest sub-index
DataType=0x0005
AccessType=const
DefaultValue=1
[2000sub1]
ParameterName=Speed
DataType=0x0006
AccessType=ro
PDOMapping=1
)";

class SheetProfileTest : public testing::Test {
 protected:
  formats::Findings findings_;
  SheetProfile sut_{formats::read_eds(sheet_text, findings_)};
  Decoder decoder_;
};

TEST_F(SheetProfileTest, NamesWhatTheProfileOfTheDeviceTypeDoesNot) {
  sut_.apply(decoder_.network(), 5);
  const Profile& profile = decoder_.network().profile(5);
  EXPECT_EQ(profile.number, 418);
  EXPECT_EQ(find_description(profile, 0x2000)->name, "Fan");
  EXPECT_EQ(find_entry(*find_description(profile, 0x2000), 1)->name, "Speed");
  EXPECT_EQ(find_description(profile, 0x6010), find_description(*find_profile("418"), 0x6010));
}

TEST_F(SheetProfileTest, SaysWhatThePdosOfTheNodeCarry) {
  sut_.apply(decoder_.network(), 5);
  const Decoded& decoded = decoder_.decode(parse_frame("205#0203A000").frame);
  ASSERT_EQ(decoded.values.size(), 2U);
  EXPECT_EQ(decoded.node, 5);
  EXPECT_EQ(decoded.pdo->direction, PdoInfo::Direction::transmit);
  EXPECT_EQ(decoded.values[0].object->name, "Fan");
  EXPECT_THAT(decoded.values[0].bytes(), testing::ElementsAre(0x02, 0x03));
  EXPECT_EQ(decoded.values[1].index, 0x6010);
  EXPECT_TRUE(decoded.marks.empty());
}

TEST_F(SheetProfileTest, GivesTheSameSheetToSeveralNodes) {
  sut_.apply(decoder_.network(), 5);
  sut_.apply(decoder_.network(), 6);
  EXPECT_EQ(decoder_.decode(parse_frame("206#0203A000").frame).node, 6);
}

TEST(SheetProfile, OfASheetWithoutADeviceTypeIsThatOfAnyNode) {
  formats::Findings findings;
  const SheetProfile sut(formats::read_eds("", findings));
  EXPECT_EQ(sut.profile().base, &base_profile());
  EXPECT_EQ(sut.profile().objects.size(), 0U);
}

}  // namespace
}  // namespace canvoy::decoder
