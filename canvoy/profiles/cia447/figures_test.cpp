// CiA 447-3: the figures, as they are printed: bit positions from the most significant one on, and
// the names below them. Where an erratum decided, or the figure is lost, it stands beside.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "canvoy/profiles/cia447.hpp"

namespace canvoy::figures_test {
namespace {

struct Figure {
  unsigned index;
  unsigned sub;
  const char* positions;
  const char* names;
};
/// Fields of two bits throughout.
constexpr const char* pairs_16 = "15 14 13 12 11 10 9 8 7 6 5 4 3 2 1 0";
constexpr const char* pairs_32 =
    "31 30 29 28 27 26 25 24 23 22 21 20 19 18 17 16 15 14 13 12 11 10 9 8 7 6 5 4 3 2 1 0";
constexpr Figure figures[] = {
    {0x6007, 0, "7 6 5 4 3 2 1 0", "ignition start ignition on accessory ignition lock"},
    {0x6009, 0, "7 4 3 0", "r central locking system status"},
    {0x600A, 0, "7 4 3 0", "r central locking system command"},
    {0x600B, 0, "23 18 17 15 14 12 11 9 8 6 5 3 2 0", "r w3rl w3rr wrl wrr wfp wd"},
    {0x600C, 0, "15 12 11 10 9 8 7 6 5 4 3 2 1 0", "r w3rl w3rr wrl wrr wfp wd"},
    {0x600D, 0, "15 12 11 9 8 6 5 3 2 0", "r drl drr dfp dd"},
    {0x600E, 0, "7 6 5 4 3 2 1 0", "drl drr dfp dd"},
    {0x6010, 0, "23 22 21 18 17 15 14 12 11 9 8 6 5 3 2 0", "r sr blw bd ct bl fd eh"},
    {0x6011, 0, "15 14 12 11 10 9 8 7 6 5 4 3 2 1 0", "r sr blw bd ct bl fd eh"},
    {0x6018, 1, "23 22 21 20 19 18 17 15 14 12 11 10 9 8 7 6 5 4 3 2 1 0",
     "r r r sm rm hud sbfb stsfb sals sud sfb"},
    {0x6018, 2, "23 22 21 20 19 18 17 15 14 12 11 10 9 8 7 6 5 4 3 2 1 0",
     "r r r sm rm hud sbfb stsfb sals sud sfb"},
    {0x6019, 1, "23 22 21 20 19 18 17 15 14 12 11 10 9 8 7 6 5 4 3 2 1 0",
     "r r r sm rm hud sbfb stsfb sals sud sfb"},
    {0x6019, 2, "23 22 21 20 19 18 17 15 14 12 11 10 9 8 7 6 5 4 3 2 1 0",
     "r r r sm rm hud sbfb stsfb sals sud sfb"},
    {0x601A, 0, "15 14 12 11 9 8 6 5 3 2 0", "r wwr wsr wspf wwf wsf"},
    {0x601B, 0, "15 14 13 12 11 10 9 8 7 6 4 3 2 1 0", "r r r r r wwr wsr wspf wwf wsf"},
    {0x601C, 0, "15 14 13 0", "swas steering wheel angle"},  // B6
    {0x601D, 0, "7 4 3 2 1 0", "r left turn indicator reset right turn indicator reset"},
    {0x6025, 0, pairs_16, "r r recair temp dfw acc hrw hfw"},
    {0x6026, 0, pairs_16, "r r recair temp dfw acc hrw hfw"},
    {0x6027, 0, pairs_16, "3rmocs 3rlocs 3rrocs rmpocs rlpocs rrpocs fpocs docs"},
    {0x6028, 0, pairs_16, "3rm 3rl 3rr bsrm bsrl bsrr bsfp bsd"},
    {0x602C, 0, "7 6 5 4 0", "r r r language"},
    {0x602D, 0, "7 6 5 4 0", "r r r language"},  // figure of 602Ch
    {0x6030, 0, "7 2 1 0", "r day/night detection"},
    {0x6032, 0, pairs_16, "r r r r accident ams pate airrel"},
    {0x6033, 0, "7 2 1 0", "r UDS diagnose session"},
    // lost: the order of the table (B1)
    {0x6040, 0, pairs_32, "pll plr pl fl ef ttil ttir til tir flr flf lb hb rdl bl dtrl"},
    // lost: the order of the table (B1)
    {0x6044, 0, pairs_32, "pll plr pl fl ef ttil ttir til tir flr flf lb hb rdl bl dtrl"},
    {0x6045, 0, "15 14 13 12 11 10 9 8 7 6 5 4 3 2 0", "r r r bli lrirl lrirr lrifp lrid ii"},
    // figure of 6045h
    {0x6046, 0, "15 14 13 12 11 10 9 8 7 6 5 4 3 2 0", "r r r bli lrirl lrirr lrifp lrid ii"},
    {0x6047, 0, "7 3 2 0", "r anti theft warning system"},
    {0x6048, 0, "7 3 2 0", "r anti theft warning system"},  // figure of 6047h
    {0x604A, 0, "7 2 1 0", "r horn status"},
    {0x604B, 0, "7 2 1 0", "r horn command"},
    {0x604C, 0, pairs_32, "r r r r r r r dtrln dtrld lbn lbd hbn hbd fln fld gclf"},
    // figures of 604Ch
    {0x604D, 0, pairs_32, "r r r r r r r dtrln dtrld lbn lbd hbn hbd fln fld gclf"},
    {0x6050, 0, "15 14 13 0", "t61 actual engine revolutions"},
    {0x6052, 0, "15 14 11 10 9 8 7 6 4 3 0", "r engaged gear cs pb agm selector lever position"},
    {0x6055, 0, "23 18 17 16 15 0", "r pcvalid wheel pulse counter"},
    {0x6056, 0, "23 18 17 16 15 0", "r valid wheel pulse counter overrun value"},
    {0x605C, 0, "15 14 13 12 11 10 9 8 7 0", "r r r r r r tlm tank level"},
    {0x605D, 0, "31 20 19 18 17 16 15 0", "r fsu fco current average fuel consumption"},
    {0x6060, 0, "15 14 13 12 11 10 9 8 7 6 4 3 2 1 0", "r r r r r r r dcs store ad acc"},
    // figure of 6060h
    {0x6061, 0, "15 14 13 12 11 10 9 8 7 6 4 3 2 1 0", "r r r r r r r dcs store ad acc"},
    {0x6062, 0, "7 6 5 4 3 2 1 0", "r r r r r r four-wheel drive"},
    {0x6063, 0, "7 6 5 4 3 2 1 0", "r r r r r r four-wheel drive"},  // figure of 6062h
    {0x6069, 0, "7 4 3 0", "r fire extinguishing system status"},
    {0x606C, 0, "7 4 3 0", "r emergency fresh-air system status"},
    {0x6070, 0, "7 6 5 4 3 2 1 0", "radio overload 5murpco after run active radio power on"},
    {0x6071, 0, "7 6 5 4 3 2 1 0", "r r r radio power off"},
    {0x6073, 0, "7 6 5 4 3 2 1 0",
     "periphery overload 5muppco after run active periphery power on"},
    {0x6074, 0, "7 6 5 4 3 2 1 0", "r r r periphery power off"},
    {0x6078, 0, pairs_16, "r r r beacon sdi roof sign di occupdet di PTT di taximeter di"},
    {0x6080, 0, "7 6 5 4 0", "r r r number pad access"},
    {0x6081, 0, "7 6 5 4 3 2 1 0", "r r r number pad command"},
    {0x6082, 0, "7 6 5 4 0", "r r r number pad"},
    {0x6085, 0, "7 6 5 4 0", "r r r function key access"},
    {0x6086, 0, "7 6 5 4 3 2 1 0", "r r r function key command"},                      // lost (B2)
    {0x6087, 0, "7 6 5 4 3 0", "r r r r function key"},                                // lost (B2)
    {0x608A, 0, "7 6 5 4 0", "r r r control key access"},                              // lost (B2)
    {0x608B, 0, "7 6 5 4 3 2 1 0", "r r r control keys command"},                      // lost (B2)
    {0x608C, 0, "7 6 5 4 0", "r r r control key"},                                     // B3
    {0x6090, 0, "7 6 5 4 0", "r r r steering wheel switch pad access"},                // B3
    {0x6091, 0, "7 6 5 4 3 2 1 0", "r r r steering wheel switch pad access command"},  // lost (B2)
    {0x6092, 0, "7 6 5 4 3 0", "r r r r steering wheel switch pad interaction"},
    {0x6093, 0, "7 6 5 4 0", "r r r emergency key access"},                   // lost (B2)
    {0x6094, 0, "7 6 5 4 3 2 1 0", "r r r emergency key access command"},     // lost (B2)
    {0x6095, 0, "7 6 5 4 3 2 1 0", "r r r r r r emergency key interaction"},  // lost (B2)
    {0x6097, 0, "7 5 4 0", "r display 1 status"},                             // lost (B2)
    {0x6098, 0, "7 2 1 0", "r display 1 command"},                            // lost (B2)
    {0x609C, 0, "7 5 4 0", "r display 2 status"},                             // B4
    {0x609D, 0, "7 2 1 0", "r display 2 command"},                            // lost (B2)
    {0x60A0, 0, "7 2 1 0", "r buzzer command"},
    // one lower (Z01)
    {0x60A1, 0, "31 14 13 12 11 10 9 8 7 6 5 4 3 2 1 0", "r fasi fasa fasce fesf feso fesa fesce"},
    {0x60A6, 1, "15 14 13 12 10 9 2 1 0", "r r r format icon content command"},
    {0x60A6, 2, "15 14 13 12 10 9 2 1 0", "r r r format icon content command"},
    {0x60A6, 3, "15 14 13 12 10 9 2 1 0", "r r r format icon content command"},
    {0x60A6, 4, "15 14 13 12 10 9 2 1 0", "r r r format icon content command"},
    {0x60A7, 1, "15 14 13 12 10 9 2 1 0", "r r r format icon content status"},
    {0x60A7, 2, "15 14 13 12 10 9 2 1 0", "r r r format icon content status"},
    {0x60A7, 3, "15 14 13 12 10 9 2 1 0", "r r r format icon content status"},
    {0x60A7, 4, "15 14 13 12 10 9 2 1 0", "r r r format icon content status"},
    {0x60AA, 1, "15 14 13 12 10 9 2 1 0", "r r r format icon content command"},
    {0x60AA, 2, "15 14 13 12 10 9 2 1 0", "r r r format icon content command"},
    {0x60AA, 3, "15 14 13 12 10 9 2 1 0", "r r r format icon content command"},
    {0x60AA, 4, "15 14 13 12 10 9 2 1 0", "r r r format icon content command"},
    {0x60AB, 1, "15 14 13 12 10 9 2 1 0", "r r r format icon content status"},
    {0x60AB, 2, "15 14 13 12 10 9 2 1 0", "r r r format icon content status"},
    {0x60AB, 3, "15 14 13 12 10 9 2 1 0", "r r r format icon content status"},
    {0x60AB, 4, "15 14 13 12 10 9 2 1 0", "r r r format icon content status"},
    {0x60B1, 0, "7 4 3 0", "tracked satellites visible satellites"},
    {0x60B2, 0, "31 28 27 24 23 16 15 8 7 0", "r GPS fix GPS pdop GPS hdop GPS vdop"},
    {0x60B3, 0, "31 26 25 20 19 16 15 0", "r GPS date day GPS date month GPS date year"},
    {0x60B4, 0, "23 11 10 5 4 0", "GPS UTC second GPS UTC minute GPS UTC hour"},
    {0x60C4, 0, "7 6 5 4 3 2 1 0", "r r r r r r r rcp"},
    {0x60D3, 0, "15 8 7 0", "tariff level character 2 tariff level character 1"},
    {0x60D8, 0, "7 6 5 4 3 0", "r r ticof taximeter status"},
    {0x60DB, 0, "7 0", "taxi trip data sequence counter"},  // Z03
    {0x60E0, 0, "7 6 5 4 3 0", "r r buffer empty printer status"},
    {0x60E1, 0, pairs_16, "r r r r r r r np"},
    {0x60E2, 0, "31 29 28 27 26 22 21 20 19 18 17 16 15 14 13 12 11 10 9 8 7 6 5 4 3 2 1 0",
     "ltff atcp logo number cymk rgb apgr apbw apg fws vws ast apc apb apt"},
    // two figures
    {0x60E5, 0, "31 24 23 16 15 8 7 6 5 4 3 2 1 0",
     "number of chars per line width of used font height of used font uccs uvwf pc pb"},
    // two figures
    {0x60E6, 0, "31 24 23 16 15 8 7 6 5 4 3 2 1 0",
     "number of chars per line width of used font height of used font color space variable "
     "width font text cursive text bold"},
    {0x60F0, 0, "31 28 27 20 19 16 15 0", "r RTC date day RTC date month RTC date year"},  // Z02
    // figure of 60F0h
    {0x60F1, 0, "31 28 27 20 19 16 15 0", "r RTC date day RTC date month RTC date year"},
    {0x60F2, 0, "31 16 15 8 7 0", "RTC second RTC minute RTC hour"},
    {0x60F3, 0, "31 16 15 8 7 0", "RTC second RTC minute RTC hour"},  // figure of 60F2h
    {0x60F4, 0, "31 22 21 14 13 12 11 10 9 8 7 4 3 0",
     "r offset from UTC DST status DST support RTC status RTC trustability RTC source"},
    {0x60FA, 0, "7 6 5 4 3 2 1 0", "r r ID system failure data state logged in"},
    {0x6100, 0, "15 14 13 11 10 6 5 4 3 2 1 0",
     "r r tlc number of lamps/lights dldi input power down"},
    {0x6101, 0, "31 28 27 24 23 20 19 16 15 12 11 8 7 4 3 0",
     "fl8 fl7 fl6 fl5 fl4 emcy light vacant light taxi light"},
    {0x6102, 0, "31 28 27 24 23 20 19 16 15 12 11 8 7 4 3 0",
     "fl16 fl15 fl14 fl13 fl12 fl11 fl10 fl9"},
    {0x6103, 0, pairs_32, "i16 i15 i14 i13 i12 i11 i10 i9 i8 i7 i6 i5 i4 i3 i2 i1"},  // Z37
    {0x6104, 0, "31 28 27 24 23 20 19 16 15 12 11 8 7 4 3 0",
     "l8 l7 l6 l5 l4 emcy light vacant light taxi light"},
    {0x6105, 0, "31 28 27 24 23 20 19 16 15 12 11 8 7 4 3 0", "l16 l15 l14 l13 l12 l11 l10 l9"},
    {0x6106, 0, "31 28 27 24 23 20 19 16 15 12 11 8 7 4 3 0",
     "l8 l7 l6 l5 l4 emcy light vacant light taxi light"},
    {0x6107, 0, "31 28 27 24 23 20 19 16 15 12 11 8 7 4 3 0", "l16 l15 l14 l13 l12 l11 l10 l9"},
    {0x6109, 0, "7 6 5 4 3 2 1 0", "r r r r configure epdm"},
    {0x610A, 0, "15 8 7 0", "tariff level character 2 tariff level character 1"},
    {0x6110, 0, pairs_16, "r r r r r r recr rakp akp faa saa"},
    {0x6115, 0, "7 4 3 2 1 0", "r rpod rerr1"},
    {0x6116, 0, "7 4 3 2 1 0", "r ptt rp"},
    {0x6117, 0, "7 4 3 2 1 0", "r tx-ptt rp"},
    {0x6120, 0, "23 16 15 8 7 0", "gain audio output channel audio input channel"},  // Z04
    {0x6121, 0, "15 8 7 0", "audio output channel audio input channel"},
    {0x6130, 1, pairs_32,
     "rf2 rf1 wlr1 wlf1 all1 alr1 ff2 ff1 hdf2 hdf1 alb4 alb3 alb2 alb1 mlb2 mlb1"},
    {0x6130, 2, pairs_32,
     "rf4 rf3 wlr2 wlf2 all2 alr2 ff4 ff3 hdf4 hdf3 alb8 alb7 alb6 alb5 mlb4 mlb3"},
    {0x6130, 3, pairs_32,
     "slp sslud sslrl sl rwf8 rwf7 rwf6 rwf5 rwf4 rwf3 rwf2 rwf1 di4 di3 di2 di1"},
    {0x6130, 4, pairs_32,
     "r rl7 rl6 rl5 rl4 rl3 rl2 rl1 alb16 alb15 alb14 alb13 alb12 alb11 alb10 alb9"},
    {0x6130, 5, pairs_32, "af16 af15 af14 af13 af12 af11 af10 af9 af8 af7 af6 af5 af4 af3 af2 af1"},
    {0x6131, 1, pairs_32,
     "rf2 rf1 wlr1 wlf1 all1 alr1 ff2 ff1 hdf2 hdf1 alb4 alb3 alb2 alb1 mlb2 mlb1"},
    {0x6131, 2, pairs_32,
     "rf4 rf3 wlr2 wlf2 all2 alr2 ff4 ff3 hdf4 hdf3 alb8 alb7 alb6 alb5 mlb4 mlb3"},
    {0x6131, 3, pairs_32,
     "slp sslud sslrl sl rwf8 rwf7 rwf6 rwf5 rwf4 rwf3 rwf2 rwf1 di4 di3 di2 di1"},
    {0x6131, 4, pairs_32,
     "rbllv rl7 rl6 rl5 rl4 rl3 rl2 rl1 alb16 alb15 alb14 alb13 alb12 alb11 alb10 alb9"},
    {0x6131, 5, pairs_32, "af16 af15 af14 af13 af12 af11 af10 af9 af8 af7 af6 af5 af4 af3 af2 af1"},
    {0x613A, 1, "31 30 29 24 23 22 21 20 19 18 17 16 15 10 9 8 7 0",
     "vdva sound volume svdn ato sor scl r swds additional sound"},
    {0x613A, 2, pairs_32, "r r r r r r r r r r r r r r r aac"},
    {0x613B, 1, "31 30 29 24 23 22 21 20 19 18 17 16 15 10 9 8 7 0",
     "vdva sound volume svdn ato sor scl r swds additional sound"},
    {0x613B, 2, pairs_32, "r r r r r r r r r r r r r rbslv speak aas"},
    {0x6140, 0, pairs_32, "r r r r r r mfl mfr tlfl tlfr sfl sfr rfl rfr ffl ffr"},  // Z05
    {0x6141, 0, pairs_32, "r r r r r r mfl mfr tlfl tlfr sfl sfr rfl rfr ffl ffr"},  // Z05
    {0x6150, 0, "7 2 1 0", "r radio hand-free key"},
    {0x6151, 0, "7 4 3 2 1 0", "r audio mute indication LED"},
};

/// With its number in place of `#`.
std::string full_name(const FieldInfo& field) {
  std::string name(field.name);
  const std::size_t at = name.find('#');
  if (at != std::string::npos) name.replace(at, 1, std::to_string(field.number));
  return name;
}
std::vector<FieldInfo> from_the_left(const Items<FieldInfo>& fields) {
  std::vector<FieldInfo> sorted(fields.begin(), fields.end());
  std::ranges::sort(sorted, std::ranges::greater{}, &FieldInfo::first_bit);
  return sorted;
}
std::string positions_of(const Items<FieldInfo>& fields) {
  std::string text;
  for (const FieldInfo& field : from_the_left(fields)) {
    if (!text.empty()) text += ' ';
    if (field.bits > 1) text += std::to_string(field.first_bit + field.bits - 1) + " ";
    text += std::to_string(field.first_bit);
  }
  return text;
}
std::string names_of(const Items<FieldInfo>& fields) {
  std::string text;
  for (const FieldInfo& field : from_the_left(fields)) {
    text += (text.empty() ? "" : " ") + full_name(field);
  }
  return text;
}

TEST(Cia447Figures, EachFieldStandsWhereItIsPrinted) {
  for (const Figure& figure : figures) {
    SCOPED_TRACE(testing::Message() << std::hex << figure.index << "h:" << figure.sub);
    const ObjectInfo* object = find_object(cia447::profile, figure.index);
    ASSERT_NE(object, nullptr);
    const EntryInfo* entry = find_entry(*object, figure.sub);
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(positions_of(entry->fields), figure.positions);
    EXPECT_EQ(names_of(entry->fields), figure.names);
  }
}

TEST(Cia447Figures, OnlyEntriesWithAFigureHaveFields) {
  std::size_t count = 0;
  for (const ObjectInfo* object : cia447::profile.objects) {
    for (const EntryInfo& entry : object->entries()) count += entry.fields.empty() ? 0U : 1U;
  }
  EXPECT_EQ(count, std::size(figures));
}

TEST(Cia447Figures, ReservedBitsAreSentAsOnes) {
  for (const ObjectInfo* object : cia447::profile.objects) {
    for (const EntryInfo& entry : object->entries()) {
      for (const FieldInfo& field : entry.fields) {
        if (field.name != "r") continue;
        ASSERT_EQ(field.value.names.size(), 1U) << object->name;
        EXPECT_EQ(field.value.names[0].first, (1 << field.bits) - 1) << object->name;
        EXPECT_EQ(field.value.names[0].meaning, Meaning::padding) << object->name;
      }
    }
  }
}

TEST(Cia447Readings, TheMonthMayStandAboveTheDay) {  // errata Z02, reading B
  const ReadingInfo& reading = cia447::profile.readings[0];
  EXPECT_EQ(reading.name, "month-above-day");
  ASSERT_EQ(reading.objects.size(), 2U);
  for (const ObjectInfo* object : reading.objects) {
    EXPECT_EQ(positions_of(object->entry.fields), "31 28 27 24 23 16 15 0");
    EXPECT_EQ(names_of(object->entry.fields), "r RTC date month RTC date day RTC date year");
  }
}

TEST(Cia447Readings, TheWarningsMayBeginAtBit1) {  // errata Z01, reading B
  const ReadingInfo& reading = cia447::profile.readings[1];
  EXPECT_EQ(reading.name, "warnings-from-bit-1");
  ASSERT_EQ(reading.objects.size(), 1U);
  EXPECT_EQ(reading.objects[0]->index, 0x60A1);
  EXPECT_EQ(positions_of(reading.objects[0]->entry.fields),
            "31 15 14 13 12 11 10 9 8 7 6 5 4 3 2 1 0");
  EXPECT_EQ(names_of(reading.objects[0]->entry.fields),
            "r fasi fasa fasce fesf feso fesa fesce bit 0");
}

}  // namespace
}  // namespace canvoy::figures_test
