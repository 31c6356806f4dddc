#include "canvoy/decoder/sheet_profile.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder::sheet_profile_test {
namespace {

// Typed from CiA 306: a device of CiA 418 with an object of its manufacturer in one TPDO.
constexpr std::string_view sheet_text = R"([ManufacturerObjects]
SupportedObjects=1
1=0x2000
[1000]
ParameterName=Device type
ObjectType=0x7
DataType=0x0007
AccessType=ro
DefaultValue=0x000001A2
[1018]
ParameterName=Identity
ObjectType=0x9
SubNumber=3
[1018sub0]
ParameterName=Highest sub-index
DataType=0x0005
AccessType=const
DefaultValue=2
[1018sub1]
ParameterName=Vendor-ID
DataType=0x0007
AccessType=ro
DefaultValue=0x2F0
[1018sub2]
ParameterName=Product code
DataType=0x0007
AccessType=ro
DefaultValue=0x1A2
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
AccessType=rwr
LowLimit=0x100
HighLimit=0x400
PDOMapping=1
[6010]
ParameterName=temperature
ObjectType=0x7
DataType=0x0003
AccessType=ro
LowLimit=0xFFF6
HighLimit=400
PDOMapping=1
[6081]
ParameterName=battery_state_of_charge
ObjectType=0x7
DataType=0x0005
AccessType=wo
PDOMapping=0
)";

class SheetProfileTest : public testing::Test {
 protected:
  formats::Findings findings_;
  SheetProfile sut_{formats::read_eds(sheet_text, findings_)};
  Decoder decoder_;
};

TEST_F(SheetProfileTest, NamesWhatTheProfileOfTheDeviceTypeDoesNot) {
  decoder_.network().set_sheet(5, sut_.sheet());
  const Profile& profile = decoder_.network().profile(5);
  EXPECT_EQ(profile.number, 418);
  EXPECT_EQ(find_description(profile, 0x2000)->name, "Fan");
  EXPECT_EQ(find_entry(*find_description(profile, 0x2000), 1)->name, "Speed");
  EXPECT_EQ(find_description(profile, 0x6010)->name, "temperature");
}

TEST_F(SheetProfileTest, SaysWhatThePdosOfTheNodeCarry) {
  decoder_.network().set_sheet(5, sut_.sheet());
  const Decoded& decoded = decoder_.decode(parse_frame("205#0203A000").frame);
  ASSERT_EQ(decoded.values.size(), 2U);
  EXPECT_EQ(decoded.node, 5);
  EXPECT_EQ(decoded.pdo->direction, PdoInfo::Direction::transmit);
  EXPECT_EQ(decoded.values[0].object->name, "Fan");
  EXPECT_THAT(decoded.values[0].bytes(), testing::ElementsAre(0x02, 0x03));
  EXPECT_EQ(decoded.values[1].index, 0x6010);
  EXPECT_TRUE(decoded.marks.empty());
}

TEST_F(SheetProfileTest, IsThatOfEachNodeWithItsVendorIdAndProductCode) {
  decoder_.network().add_sheet(sut_.sheet());
  for (const char* text : {"586#43181001F0020000", "586#43181002A2010000"}) {
    decoder_.decode(parse_frame(text).frame);
  }
  EXPECT_EQ(&decoder_.network().profile(6), &sut_.profile());
  EXPECT_EQ(decoder_.decode(parse_frame("206#0203A000").frame).values.size(), 2U);
}

TEST_F(SheetProfileTest, LimitsTheValuesOfItsObjectsAndThoseOfTheProfile) {
  decoder_.network().set_sheet(5, sut_.sheet());
  const auto is_out_of_range = [this](std::string_view text) {
    return decoder_.decode(parse_frame(text).frame).marks.has(Mark::out_of_range);
  };
  // Speed 100h to 400h; temperature -10 (FFF6h of 16 bits) to 400.
  EXPECT_FALSE(is_out_of_range("205#0001F6FF"));
  EXPECT_FALSE(is_out_of_range("205#00049001"));
  EXPECT_TRUE(is_out_of_range("205#FF00F6FF"));
  EXPECT_TRUE(is_out_of_range("205#0104F6FF"));
  EXPECT_TRUE(is_out_of_range("205#0001F5FF"));
  EXPECT_TRUE(is_out_of_range("205#00019101"));
}

TEST_F(SheetProfileTest, SaysWhatMayBeReadWrittenAndMapped) {
  decoder_.network().set_sheet(5, sut_.sheet());
  const auto is_wrong = [this](std::initializer_list<std::string_view> frames) {
    bool wrong = false;
    for (const std::string_view text : frames) {
      wrong = decoder_.decode(parse_frame(text).frame).marks.has(Mark::wrong_access);
    }
    return wrong;
  };
  EXPECT_FALSE(is_wrong({"605#2B00200100020000", "585#6000200100000000"})) << "rwr";
  EXPECT_FALSE(is_wrong({"585#4B00200100020000"})) << "rwr";
  EXPECT_TRUE(is_wrong({"605#2B106000A0000000", "585#6010600000000000"})) << "ro";
  EXPECT_TRUE(is_wrong({"585#4F81600032000000"})) << "wo";
  EXPECT_FALSE(is_wrong({"605#2F81600032000000", "585#6081600000000000"})) << "wo";
  // RPDO 1 (1400h, 1600h) maps 2000h:01h, which is for TPDOs only, and 6081h, which is not
  // mappable.
  for (const char* text : {"605#2300140105020000", "585#6000140100000000", "605#2300160110010020",
                           "585#6000160100000000", "605#2F00160001000000", "585#6000160000000000",
                           "605#2301180185010000", "585#6001180100000000", "605#23001A0108008160",
                           "585#60001A0100000000", "605#2F001A0001000000", "585#60001A0000000000",
                           "605#2300180185010000", "585#6000180100000000"}) {
    decoder_.decode(parse_frame(text).frame);
  }
  EXPECT_TRUE(is_wrong({"205#0002"})) << "rwr in an RPDO";
  EXPECT_TRUE(is_wrong({"185#32"})) << "not to be mapped";
}

TEST(SheetProfile, LettersOfAnAccessMayBeOfEitherCase) {
  struct Row {
    const char* access;
    bool is_read;
    bool is_written;
    bool is_transmitted;
    bool is_received;
  };
  for (const Row& row :
       {Row{"RO", true, false, true, false}, Row{"Wo", false, true, false, true},
        Row{"RW", true, true, true, true}, Row{"RWR", true, true, true, false},
        Row{"Rww", true, true, false, true}, Row{"Const", true, false, true, false}}) {
    const std::string sheet = fmt::format(
        "[1400]\nObjectType=9\n[1400sub1]\nDataType=7\nDefaultValue=0x205\n"
        "[1600]\nObjectType=9\n[1600sub0]\nDataType=5\nDefaultValue=1\n"
        "[1600sub1]\nDataType=7\nDefaultValue=0x20000010\n"
        "[1800]\nObjectType=9\n[1800sub1]\nDataType=7\nDefaultValue=0x185\n"
        "[1A00]\nObjectType=9\n[1A00sub0]\nDataType=5\nDefaultValue=1\n"
        "[1A00sub1]\nDataType=7\nDefaultValue=0x20000010\n"
        "[2000]\nParameterName=a\nDataType=6\nPDOMapping=1\nAccessType={}\n",
        row.access);
    formats::Findings findings;
    const SheetProfile sut(formats::read_eds(sheet, findings));
    Decoder decoder;
    decoder.network().set_sheet(5, sut.sheet());
    const auto is_right = [&](std::initializer_list<std::string_view> frames) {
      bool right = false;
      for (const std::string_view text : frames) {
        const Decoded& decoded = decoder.decode(parse_frame(text).frame);
        right = decoded.values.size() == 1 && decoded.marks.empty();
      }
      return right;
    };
    EXPECT_EQ(is_right({"585#4B00200002000000"}), row.is_read) << row.access;
    EXPECT_EQ(is_right({"605#2B00200002000000", "585#6000200000000000"}), row.is_written)
        << row.access;
    EXPECT_EQ(is_right({"185#0200"}), row.is_transmitted) << row.access;
    EXPECT_EQ(is_right({"205#0200"}), row.is_received) << row.access;
  }
}

TEST_F(SheetProfileTest, GivesTheSameSheetToSeveralNodes) {
  decoder_.network().set_sheet(5, sut_.sheet());
  decoder_.network().set_sheet(6, sut_.sheet());
  EXPECT_EQ(decoder_.decode(parse_frame("206#0203A000").frame).node, 6);
}

TEST(SheetProfile, OfASheetWithoutADeviceTypeIsThatOfAnyNode) {
  formats::Findings findings;
  const SheetProfile sut(formats::read_eds("", findings));
  EXPECT_EQ(sut.profile().base, &base_profile());
  EXPECT_EQ(sut.profile().objects.size(), 0U);
}

// `#` is a placeholder in the profiles of CiA; in a text of a manufacturer it stands for itself.
TEST(SheetProfile, ANumberSignInTheNameOfAMakerIsItself) {
  constexpr std::string_view sheet =
      "[2000]\nParameterName=Motor #2\nObjectType=7\nDataType=6\nAccessType=rw\n"
      "[2001]\nParameterName=C#\nObjectType=8\nSubNumber=2\n"
      "[2001sub0]\nParameterName=Highest\nDataType=5\nAccessType=ro\nDefaultValue=1\n"
      "[2001sub1]\nParameterName=Speed #\nDataType=6\nAccessType=rw\n"
      "[2002]\nParameterName=Map #3\nObjectType=7\nDataType=0x21\nAccessType=ro\n";
  formats::Findings findings;
  const SheetProfile profile(formats::read_eds(sheet, findings));
  const Profile& read = profile.profile();
  const auto name = [&read](std::string_view text) {
    const auto address = find_address(read, text);
    return address ? formats::object_name(read, *address->object, address->index) + "/" +
                         formats::entry_name(*address->object, *address->entry, address->sub)
                   : "nothing";
  };
  EXPECT_EQ(name("2000"), "Motor #2/Motor #2");
  EXPECT_EQ(name("2001:1"), "C#/Speed #");
  EXPECT_EQ(name("2002"), "Map #3/Map #3") << "of the type of a record (CiA 301, 7.4.8)";
  EXPECT_EQ(name("Motor #2"), "Motor #2/Motor #2") << "and is found by it";
  EXPECT_EQ(name("motor_#2"), "Motor #2/Motor #2");
  EXPECT_EQ(name("C#:Speed #"), "C#/Speed #");
  EXPECT_EQ(name("Motor 12"), "nothing");
}

}  // namespace
}  // namespace canvoy::decoder::sheet_profile_test
