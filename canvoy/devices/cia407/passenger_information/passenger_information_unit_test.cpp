// Displays at their wire: texts and mappings in, what is shown out. The bytes are those of the
// figures in 9.2.8.4 by their bit numbers.
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"

namespace canvoy::cia407::passenger_information_unit_test {
namespace {

using Content = ShownElement::Content;

struct Shown {
  std::string octets;
  ShownElement element;
};
struct Panel {
  std::vector<Shown> shown;
  int updates = 0;
  bool is_testing = false;
  bool is_stop_requested = false;

  void show(std::span<const ShownElement> elements) {
    ++updates;
    shown.clear();
    for (const ShownElement& element : elements) {
      shown.push_back({std::string(element.octets.begin(), element.octets.end()), element});
    }
  }
  void test(bool on) { is_testing = on; }
  void stop(bool on) { is_stop_requested = on; }
  DisplayHardware hardware() {
    return {.show = callback<&Panel::show>(*this),
            .test = callback<&Panel::test>(*this),
            .show_stop_request = callback<&Panel::stop>(*this)};
  }
};

template <InformationClass device_class, InformationSubclass subclass>
class Display : public testing::Test {
 protected:
  static constexpr const BusUnit* units[] = {
      &bus_unit<PassengerInformationKind<device_class, subclass>>};

  /// 6203h: what the n-th element is, and how it is shown; written in four bytes.
  void map(const std::string& sub, const std::string& value) {
    EXPECT_EQ(bench.ask("23 03 62 " + sub + " " + value), "60 03 62 " + sub + " 00 00 00 00");
  }
  void update(const std::string& count) { map("01", count + " 00 00 00"); }

  Panel panel;
  BusBench bench{units, [this](Environment& environment) {
                   environment.provide(callback<&Panel::hardware>(panel));
                 }};
};
using TextDisplay = Display<InformationClass::next_stop, InformationSubclass::text>;
using GraphicsDisplay = Display<InformationClass::information, InformationSubclass::graphics>;
using SimpleDisplay = Display<InformationClass::destination, InformationSubclass::simple>;

TEST_F(TextDisplay, SaysWhatItIs) {
  EXPECT_EQ(bench.ask("40 00 10 00 00 00 00 00"), "43 00 10 00 97 01 22 03")
      << "407, class 2, subclass 2, code 03h";
}

TEST_F(TextDisplay, NothingIsShownUntilSubIndex1IsWritten) {
  EXPECT_EQ(panel.updates, 1) << "dark after the reset";
  EXPECT_TRUE(panel.shown.empty());
  EXPECT_TRUE(bench.download(0x6112, 3, "Central Station"));
  map("02", "03 61 12 00");
  EXPECT_EQ(panel.updates, 1);
  update("01");
  ASSERT_EQ(panel.shown.size(), 1u);
  EXPECT_EQ(panel.shown[0].octets, "Central Station");
  EXPECT_EQ(panel.shown[0].element.flash, FlashSpeed::no_flash);
  EXPECT_TRUE(bench.download(0x6112, 3, "Market"));
  EXPECT_EQ(panel.shown[0].octets, "Central Station") << "a text that is written shows nothing";
  update("01");
  EXPECT_EQ(panel.shown[0].octets, "Market");
}

TEST_F(TextDisplay, TakesTheStopRequestWithoutBeingConfigured) {
  bench.cable.send("1C1#01");
  EXPECT_TRUE(panel.is_stop_requested);
  bench.cable.send("1C1#00");
  EXPECT_FALSE(panel.is_stop_requested);
}

TEST_F(TextDisplay, IsDarkWhenItsNodeLeavesOperational) {
  bench.download(0x6112, 1, "Zoo");
  map("02", "01 61 12 00");
  update("01");
  EXPECT_EQ(bench.ask("2F 04 62 00 01 00 00 00"), "60 04 62 00 00 00 00 00");
  ASSERT_EQ(panel.shown.size(), 1u);
  EXPECT_TRUE(panel.is_stop_requested);
  bench.cable.send("000#80 05");
  EXPECT_TRUE(panel.shown.empty());
  EXPECT_FALSE(panel.is_stop_requested);
  update("01");
  EXPECT_EQ(panel.shown.size(), 1u) << "it is told anew before it is started";
  bench.cable.send("000#01 05");
  EXPECT_EQ(panel.shown.size(), 1u);
}

/// 1016h: node 1 is missing for 1.2 s, and 1029h is 0 (CiA 301, 7.5.2.32): pre-operational.
TEST_F(TextDisplay, IsDarkWhenItsComputerIsSilent) {
  EXPECT_EQ(bench.ask("23 16 10 01 B0 04 01 00"), "60 16 10 01 00 00 00 00");
  bench.cable.send("701#05");
  bench.download(0x6112, 1, "Zoo");
  map("02", "01 61 12 00");
  update("01");
  bench.cable.run_for(1199ms);
  EXPECT_EQ(panel.shown.size(), 1u);
  bench.cable.run_for(2ms);
  EXPECT_TRUE(panel.shown.empty());
}

TEST_F(TextDisplay, TheHighByteIsTheFormat) {
  bench.download(0x6112, 1, "Zoo");
  // Flash medium, scrolling, centred, large: 10 11 10 11.
  map("02", "01 61 12 BB");
  update("01");
  ASSERT_EQ(panel.shown.size(), 1u);
  EXPECT_EQ(panel.shown[0].element.flash, FlashSpeed::medium);
  EXPECT_EQ(panel.shown[0].element.style, FontStyle::scrolling);
  EXPECT_EQ(panel.shown[0].element.alignment, Alignment::center);
  EXPECT_EQ(panel.shown[0].element.size, FontSize::large);
}

TEST_F(TextDisplay, ATextOf128OctetsIsShownWhole) {
  const std::string longest(128, 'x');
  EXPECT_TRUE(bench.download(0x6112, 64, longest));
  map("02", "40 61 12 00");
  update("01");
  ASSERT_EQ(panel.shown.size(), 1u);
  EXPECT_EQ(panel.shown[0].octets, longest);
  EXPECT_FALSE(bench.download(0x6112, 64, std::string(129, 'y'))) << "and no more than those";
  update("01");
  EXPECT_EQ(panel.shown[0].octets, longest);
}

TEST_F(TextDisplay, SeveralElementsComeInTheirOrder) {
  bench.download(0x6196, 0, "23a");
  bench.download(0x610D, 2, "Airport");
  map("02", "00 61 96 0F");
  map("03", "02 61 0D 00");
  update("02");
  ASSERT_EQ(panel.shown.size(), 2u);
  EXPECT_EQ(panel.shown[0].octets, "23a");
  EXPECT_EQ(panel.shown[1].octets, "Airport");
  update("00");
  EXPECT_TRUE(panel.shown.empty());
}

TEST_F(TextDisplay, WhatCannotBeShownIsAnErrorAndAnEventUntilTheNextUpdate) {
  bench.download(0x6112, 1, "Zoo");
  map("02", "01 61 12 00");
  map("03", "00 67 40 00");
  bench.cable.clear();
  update("02");
  ASSERT_EQ(panel.shown.size(), 1u) << "the rest is shown";
  EXPECT_EQ(bench.cable.last(0x085), "085#04 FF 01 01 00 00 00 00");
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 04 00 00 03");
  update("01");
  EXPECT_EQ(bench.cable.last(0x085), "085#00 00 00 00 00 00 00 00");
  EXPECT_EQ(bench.cable.last(0x185), "185#00 00 00 00 00 00 00 00");
}

TEST_F(TextDisplay, NeitherMoreThanItHasNorObjectsOfCommunicationAreShown) {
  update("21");
  EXPECT_EQ(bench.cable.last(0x085), "085#04 FF 01 01 00 00 00 00") << "33 elements";
  map("02", "00 10 08 00");
  update("01");
  EXPECT_TRUE(panel.shown.empty());
  EXPECT_EQ(bench.cable.last(0x085), "085#04 FF 01 01 00 00 00 00");
}

TEST_F(TextDisplay, TheCharacterSetIsThatOf6205h) {
  bench.download(0x6112, 1, "Caf\xE9");
  bench.download(0x6120, 0, "4711");
  map("02", "01 61 12 00");
  map("03", "00 61 20 00");
  EXPECT_EQ(bench.ask("2B 05 62 01 01 00 00 00"), "60 05 62 01 00 00 00 00");
  update("02");
  ASSERT_EQ(panel.shown.size(), 2u);
  EXPECT_EQ(panel.shown[0].element.character_set, 1);
  EXPECT_EQ(panel.shown[1].element.character_set, 0) << "it is for plain texts alone";
  EXPECT_EQ(bench.ask("40 05 62 0F 00 00 00 00"), "4B 05 62 0F 0F 00 00 00") << "ISO 8859-15";
}

TEST_F(TextDisplay, ACharacterSetThatThereIsNotIsRefused) {
  EXPECT_EQ(bench.ask("2B 05 62 01 0C 00 00 00"), "80 05 62 01 30 00 09 06") << "ISO 8859-12";
  EXPECT_EQ(bench.ask("2B 05 62 01 00 80 00 00"), "80 05 62 01 30 00 09 06");
  EXPECT_EQ(bench.ask("40 05 62 01 00 00 00 00"), "4B 05 62 01 00 00 00 00");
}

TEST_F(TextDisplay, AnXmlFileHasItsFormatInItself) {
  const std::string file = "<text><bold>" + std::string(600, 'a') + "</bold></text>";
  EXPECT_TRUE(bench.download(0x6200, 2, file));
  map("02", "02 62 00 00");
  update("01");
  ASSERT_EQ(panel.shown.size(), 1u);
  EXPECT_EQ(panel.shown[0].octets, file);
  EXPECT_EQ(panel.shown[0].element.content, Content::xml);
  map("02", "02 62 00 40");
  update("01");
  EXPECT_TRUE(panel.shown.empty());
  EXPECT_EQ(bench.cable.last(0x085), "085#04 FF 01 01 00 00 00 00");
}

TEST_F(TextDisplay, TestModeLastsWhileItIsWanted) {
  bench.cable.clear();
  EXPECT_EQ(bench.ask("23 02 60 01 02 00 00 03"), "60 02 60 01 00 00 00 00");
  EXPECT_TRUE(panel.is_testing);
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 02 00 00 03");
  bench.ask("23 02 60 01 00 00 00 03");
  EXPECT_FALSE(panel.is_testing);
  EXPECT_EQ(bench.cable.last(0x185), "185#00 00 00 00 00 00 00 00");
}

TEST_F(TextDisplay, AStopThatIsWantedIsShownAtOnce) {
  EXPECT_EQ(bench.ask("2F 04 62 00 01 00 00 00"), "60 04 62 00 00 00 00 00");
  EXPECT_TRUE(panel.is_stop_requested);
  bench.ask("2F 04 62 00 00 00 00 00");
  EXPECT_FALSE(panel.is_stop_requested);
}

TEST_F(TextDisplay, AnNmtResetMakesItDark) {
  bench.download(0x6112, 1, "Zoo");
  map("02", "01 61 12 00");
  update("01");
  bench.ask("2F 04 62 00 01 00 00 00");
  bench.cable.send("000#81 05");
  EXPECT_TRUE(panel.shown.empty());
  EXPECT_FALSE(panel.is_stop_requested);
}

TEST_F(TextDisplay, IsATextCalledUpByAPdo) {
  bench.download(0x6112, 5, "Zoo");
  // Its second RPDO: update and first mapped object.
  EXPECT_EQ(bench.ask("40 01 16 01 00 00 00 00"), "43 01 16 01 20 01 03 62")
      << "6203h:01h, 32 bits";
  EXPECT_EQ(bench.ask("40 01 14 01 00 00 00 00"), "43 01 14 01 00 00 00 80") << "not valid";
  bench.ask("23 01 14 01 22 02 00 00");
  bench.cable.send("222#01 00 00 00 05 61 12 00");
  ASSERT_EQ(panel.shown.size(), 1u);
  EXPECT_EQ(panel.shown[0].octets, "Zoo");
}

TEST_F(GraphicsDisplay, PicturesAreStoredWholeOrNotAtAll) {
  std::string file;
  for (int i = 0; i < 800; ++i) file += static_cast<char>(i);
  EXPECT_TRUE(bench.download(0x6202, 8, file));
  EXPECT_EQ(bench.upload(0x6202, 8), file);
  EXPECT_EQ(bench.ask("21 02 62 08 01 20 00 00"), "80 02 62 08 12 00 07 06") << "8193 bytes";
  // One that is broken off after its first segment.
  bench.ask("21 02 62 08 0E 00 00 00");
  bench.ask("00 01 02 03 04 05 06 07");
  bench.cable.send("605#80 02 62 08 00 00 00 08");
  EXPECT_EQ(bench.upload(0x6202, 8), file);
  map("02", "08 62 02 00");
  update("01");
  ASSERT_EQ(panel.shown.size(), 1u);
  EXPECT_EQ(panel.shown[0].element.content, Content::picture);
  EXPECT_EQ(panel.shown[0].octets, file);
}

/// A node has one 6202h (9.2.8.3), whichever of its displays shows it.
TEST(TwoDisplays, OfOneNodeHaveTheSameFiles) {
  using Destination =
      PassengerInformationKind<InformationClass::destination, InformationSubclass::graphics>;
  using NextStop =
      PassengerInformationKind<InformationClass::next_stop, InformationSubclass::graphics>;
  static constexpr const BusUnit* units[] = {&bus_unit<Destination>, &bus_unit<NextStop>};
  std::array<Panel, 2> panels;
  std::size_t made = 0;
  auto hardware = [&] { return panels.at(made++).hardware(); };
  BusBench bench(units, [&](Environment& environment) {
    environment.provide(Callback<DisplayHardware()>::of(hardware));
  });
  const std::string picture = "GIF89a, and what follows";
  EXPECT_TRUE(bench.download(0x6202, 1, picture));
  EXPECT_EQ(bench.upload(0x6202, 1), picture);
  bench.ask("23 03 62 02 01 62 02 00");
  bench.ask("23 03 62 01 01 00 00 00");
  for (const Panel& panel : panels) {
    ASSERT_EQ(panel.shown.size(), 1u);
    EXPECT_EQ(panel.shown[0].octets, picture);
  }
  EXPECT_EQ(bench.cable.count(0x085), 0u);
  EXPECT_EQ(bench.ask("40 01 60 01 00 00 00 00"), "43 01 60 01 00 00 00 00") << "no event";
  bench.cable.send("000#81 05");
  EXPECT_EQ(bench.upload(0x6202, 1), "");
}

TEST_F(TextDisplay, ADisplayForTextShowsNoPictures) {
  bench.download(0x6202, 1, "GIF89a");
  map("02", "01 62 02 00");
  update("01");
  EXPECT_TRUE(panel.shown.empty());
}

TEST_F(GraphicsDisplay, SpecialCharactersAreStored) {
  EXPECT_TRUE(bench.download(0x6201, 16, std::string(256, '\x7F')));
  EXPECT_EQ(bench.upload(0x6201, 16), std::string(256, '\x7F'));
  EXPECT_FALSE(bench.download(0x6201, 1, std::string(257, '\x7F')));
}

TEST_F(GraphicsDisplay, NumbersAreShownAsPeopleReadThem) {
  bench.ask("2B 92 61 00 17 00 00 00");  // line 23
  bench.ask("2B 19 61 00 D7 00 00 00");  // 21.5 degrees Celsius
  const char* line[] = {"2F 0B 61 01 55 00 00 00", "2F 0B 61 02 38 00 00 00"};
  for (const char* character : line) bench.ask(character);
  map("02", "00 61 92 00");
  map("03", "00 61 19 00");
  map("04", "00 61 0B 00");
  update("03");
  ASSERT_EQ(panel.shown.size(), 3u);
  EXPECT_EQ(panel.shown[0].octets, "23");
  EXPECT_EQ(panel.shown[1].octets, "22");
  EXPECT_EQ(panel.shown[2].octets, "U8");
}

TEST_F(SimpleDisplay, HasTheObjectsOfItsColumnOfTheMatrixAlone) {
  EXPECT_EQ(bench.ask("40 00 10 00 00 00 00 00"), "43 00 10 00 97 01 11 03");
  EXPECT_EQ(bench.ask("40 0D 61 00 00 00 00 00"), "80 0D 61 00 00 00 02 06") << "no 610Dh";
  EXPECT_EQ(bench.ask("40 05 62 00 00 00 00 00"), "80 05 62 00 00 00 02 06") << "no 6205h";
  EXPECT_EQ(bench.ask("40 91 61 00 00 00 00 00"), "80 91 61 00 01 00 01 06") << "6191h is wo";
  EXPECT_EQ(bench.ask("40 03 62 01 00 00 00 00"), "43 03 62 01 02 00 00 00") << "6203h is rw";
}

}  // namespace
}  // namespace canvoy::cia407::passenger_information_unit_test
