#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/decoder/sheet_profile.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder::known_units_test {
namespace {

/// Unit and step of the only value of the last frame.
struct Told {
  Unit unit = Unit::none;
  double of_one = 0;  ///< size of one count
  friend bool operator==(const Told&, const Told&) = default;
};
std::ostream& operator<<(std::ostream& out, const Told& told) {
  return out << told.of_one << ' ' << symbol(told.unit);
}

/// The bus of a lift with a load measuring unit at node 10, and a controller at node 11.
class NodeUnits : public testing::Test {
 public:
  NodeUnits() {
    for (const NodeId node : {NodeId{10}, NodeId{11}}) {
      sut.network().set_profile(node, *find_profile("417-4"));
    }
  }

  const Decoded& decode(std::string_view frame) { return sut.decode(parse_frame(frame).frame); }
  void feed(std::initializer_list<std::string_view> frames) {
    for (const std::string_view frame : frames) decode(frame);
  }
  Told told(std::string_view frame) {
    const Decoded& decoded = decode(frame);
    if (decoded.values.empty() || decoded.values.front().entry == nullptr) return {};
    const EntryInfo& entry = *decoded.values.front().entry;
    const auto* sensor = std::ranges::find(entry.fields, "Sensor value", &FieldInfo::name);
    const ValueInfo& value = sensor == entry.fields.end() ? entry.value : sensor->value;
    return {value.unit, to_physical(1, value.scale)};
  }

  Decoder sut;
};

// 6480h:02h has 0002h by default, and loads are in kilograms if it does not exist (CiA 417-4,
// 4.12.1).
TEST_F(NodeUnits, AreKilogramsWhereNothingIsKnown) {
  EXPECT_EQ(told("58A#4B806401C2010000"), (Told{Unit::kilogram, 1}));
}

TEST_F(NodeUnits, AreWhatAnUploadOfTheUnitTells) {
  // Prefix in bits 15 to 8: milli; the unit in bits 7 to 0: kilogram.
  feed({"60A#4080640200000000", "58A#4B80640202FD0000"});
  EXPECT_EQ(told("58A#4B806401C2010000"), (Told{Unit::kilogram, 0.001}));
}

TEST_F(NodeUnits, AreWhatADownloadOfTheUnitTellsOnceItIsConfirmed) {
  feed({"60A#2B80640221000000"});
  feed({"58A#8080640230000906"});
  EXPECT_EQ(told("58A#4B806401C2010000"), (Told{Unit::kilogram, 1})) << "refused";
  feed({"60A#2B80640221000000", "58A#6080640200000000"});
  EXPECT_EQ(told("58A#4B806401C2010000"), (Told{Unit::newton, 1}));
}

// Limits, signalling limits and rope loads are in the same unit (CiA 417-4, 4.12.2 to 4.12.5).
TEST_F(NodeUnits, HoldForAllLoads) {
  feed({"60A#4080640200000000", "58A#4B80640221000000"});
  for (const std::string_view frame :
       {"58A#4B81640101000000", "58A#4B81640201000000", "58A#4B83640101000000",
        "58A#4B83640401000000", "58A#4B84640101000000", "58A#4B84640201000000",
        "58A#4B8464FE01000000"}) {
    feed({frame.starts_with("58A#4B8164") ? "60A#4081640100000000" : "60A#4084640100000000"});
    EXPECT_EQ(told(frame), (Told{Unit::newton, 1})) << frame;
  }
}

TEST_F(NodeUnits, AreNoneWhereNobodyKnowsTheCode) {
  feed({"60A#4080640200000000", "58A#4B806402EE000000"});
  EXPECT_EQ(told("58A#4B806401C2010000"), (Told{Unit::none, 1}));
}

TEST_F(NodeUnits, AreOfTheNodeThatTellsThem) {
  feed({"60B#4080640200000000", "58B#4B80640221000000"});
  EXPECT_EQ(told("58A#4B806401C2010000"), (Told{Unit::kilogram, 1}));
}

// The objects of lift 2 are 0800h above those of lift 1 (CiA 417-4, 4.1.1).
TEST_F(NodeUnits, AreThoseOfTheirLift) {
  feed({"60A#40806C0200000000", "58A#4B806C0221000000"});
  EXPECT_EQ(told("58A#4B806401C2010000"), (Told{Unit::kilogram, 1}));
  EXPECT_EQ(told("58A#4B806C01C2010000"), (Told{Unit::newton, 1}));
}

TEST_F(NodeUnits, HoldForPdosFromTheNextOneOn) {
  feed({"60A#2F001A0000000000", "58A#60001A0000000000", "60A#23001A0110018064",
        "58A#60001A0100000000", "60A#2F001A0001000000", "58A#60001A0000000000"});
  EXPECT_EQ(told("18A#C201"), (Told{Unit::kilogram, 1}));
  feed({"60A#4080640200000000", "58A#4B80640202FD0000"});
  EXPECT_EQ(told("18A#C201"), (Told{Unit::kilogram, 0.001}));
}

TEST_F(NodeUnits, OfWhatANodeReceivesAreThoseOfTheSender) {
  // 1600h:01h of the controller maps 6480h:01h.
  feed({"60B#2F00160000000000", "58B#6000160000000000", "60B#2300160110018064",
        "58B#6000160100000000", "60B#2F00160001000000", "58B#6000160000000000",
        "60A#4080640200000000", "58A#4B80640221000000"});
  EXPECT_EQ(told("20B#C201"), (Told{Unit::newton, 1}));
}

TEST_F(NodeUnits, AreForgottenWithTheDevice) {
  Decoder other;
  other.network().assume_profile(*find_profile("417-4"));
  const auto decoded = [&](std::string_view frame) {
    return other.decode(parse_frame(frame).frame);
  };
  decoded("58A#4318100401000000");
  decoded("60A#4080640200000000");
  decoded("58A#4B80640221000000");
  EXPECT_EQ(decoded("58A#4B806401C2010000").values.front().entry->value.unit, Unit::newton);
  decoded("60A#4018100400000000");
  decoded("58A#4318100402000000");  // another serial number
  decoded("60A#4080640100000000");
  EXPECT_EQ(decoded("58A#4B806401C2010000").values.front().entry->value.unit, Unit::kilogram);
}

// Parameter 3 of sensor n of group m has the unit in byte 2, the prefix in byte 3 (CiA 417-4,
// 4.13.4).
TEST_F(NodeUnits, OfASensorAreThoseOfItsParameter) {
  // 6562h:03h, of sensor 3 of group 3: kilopascal.
  feed({"60A#4062650300000000", "58A#43626503FFFF2203"});
  // A sensor of 6 bytes comes in segments; basic function 05h is pressure.
  const auto read = [&](std::string_view request, std::string_view answer) {
    feed({request, answer, "60A#6000000000000000"});
    return told("58A#0305010180040000");
  };
  EXPECT_EQ(read("60A#4002650300000000", "58A#4102650306000000"), (Told{Unit::pascal, 1000}));
  EXPECT_EQ(read("60A#4002650200000000", "58A#4102650206000000"), (Told{Unit::none, 1}));
  EXPECT_EQ(read("60A#4001650300000000", "58A#4101650306000000"), (Told{Unit::none, 1}));
}

// 6384h:01h to 03h give the size of one count of 6383h, 6390h and 6391h in multiples of 10 um, 0.1
// mm/s and 1 mm/s2; 10, 10 and 1 by default (CiA 417-4, 4.9.5).
TEST_F(NodeUnits, CountsAreAsManyStepsAsTheNodeTells) {
  EXPECT_EQ(told("58A#4383630110000000"), (Told{Unit::millimetre, 0.1}));
  EXPECT_EQ(told("58A#4B90630110000000"), (Told{Unit::millimetre_per_second, 1}));
  feed({"60A#4084630100000000", "58A#4384630132000000", "60A#4084630200000000",
        "58A#4384630205000000", "60A#4084630300000000", "58A#4384630304000000"});
  EXPECT_EQ(told("58A#4383630110000000"), (Told{Unit::millimetre, 0.5}));
  EXPECT_EQ(told("58A#4B90630110000000"), (Told{Unit::millimetre_per_second, 0.5}));
  EXPECT_EQ(told("58A#4B91630110000000"), (Told{Unit::millimetre_per_second_squared, 4}));
  EXPECT_EQ(told("58A#4383630210000000"), (Told{Unit::millimetre, 0.1})) << "6385h is of unit 2";
  // 63B4h: the limits of all work areas of unit 1 have the same step.
  EXPECT_EQ(told("58A#43B4630210000000"), (Told{Unit::millimetre, 0.5}));
  EXPECT_EQ(told("58A#43B463FE10000000"), (Told{Unit::millimetre, 0.5}));
}

TEST_F(NodeUnits, CountsThatAreNoStepsHaveNoUnit) {
  feed({"60A#4084630100000000", "58A#4384630100000000"});
  EXPECT_EQ(told("58A#4383630110000000"), (Told{Unit::none, 1}));
}

TEST_F(NodeUnits, OfANodeThatTellsOthersAllTheTimeTakeNoMemoryInTheEnd) {
  for (unsigned steps = 1; steps < 5000; ++steps) {
    sut.network().learn(
        10, 0x6384, 1,
        std::array{static_cast<std::uint8_t>(steps), static_cast<std::uint8_t>(steps >> 8)});
    told("58A#4383630110000000");
  }
  EXPECT_EQ(told("58A#4383630110000000"), (Told{Unit::none, 1}));
}

TEST_F(NodeUnits, AreWhatADataSheetSays) {
  formats::DataSheet sheet;
  sheet.objects[0x1000].own = {.name = "Device type", .data_type = 7, .default_value = "0x1A1"};
  for (const std::uint16_t index : {std::uint16_t{0x6480}, std::uint16_t{0x6C80}}) {
    formats::SheetObject& load = sheet.objects[index];
    load.subs[1] = {.name = "Absolute load value", .data_type = 6, .access = "ro"};
    load.subs[2] = {.name = "SI unit", .data_type = 6, .access = "rw"};
  }
  sheet.objects[0x6480].subs[2].default_value = "0x0021";
  sheet.objects[0x6C80].subs[2].default_value = "0xFD02";
  const SheetProfile profile(sheet);
  sut.network().set_sheet(12, profile.sheet());
  EXPECT_EQ(told("58C#4B806401C2010000"), (Told{Unit::newton, 1}));
  EXPECT_EQ(told("58C#4B806C01C2010000"), (Told{Unit::kilogram, 0.001}));
}

}  // namespace
}  // namespace canvoy::decoder::known_units_test
