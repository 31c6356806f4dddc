// Sentences of satellite receivers: well-known examples of NMEA 0183 with their checksums, and all
// that can be wrong with a line.
#include "canvoy/devices/cia447/gps/nmea.hpp"

#include <gtest/gtest.h>

#include <string>

#include "canvoy/can/random.hpp"

namespace canvoy::cia447::nmea_test {
namespace {

constexpr std::string_view rmc =
    "$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A\r\n";
constexpr std::string_view gga =
    "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n";
constexpr std::string_view gsa = "$GPGSA,A,3,04,05,,09,12,,,24,,,,,2.5,1.3,2.1*39\r\n";
constexpr std::string_view gsv =
    "$GPGSV,2,1,08,01,40,083,46,02,17,308,41,12,07,344,39,14,22,228,45*75\r\n";
constexpr std::string_view vtg = "$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\n";
constexpr std::string_view zda = "$GPZDA,201530.00,04,07,2002,00,00*60\r\n";

/// A sentence with its frame and its checksum.
std::string line(std::string_view sentence) {
  unsigned sum = 0;
  for (const char one : sentence) sum ^= static_cast<unsigned char>(one);
  char end[8];
  std::snprintf(end, sizeof end, "*%02X\r\n", sum);
  return "$" + std::string(sentence) + end;
}

TEST(Nmea, RmcSaysWhereHowFastAndWhen) {
  NmeaReceiver sut;
  sut.receive(rmc);
  const GpsReading reading = sut.reading();
  EXPECT_NEAR(*reading.latitude, 48 + 7.038 / 60, 1e-9);
  EXPECT_NEAR(*reading.longitude, 11 + 31.0 / 60, 1e-9);
  EXPECT_NEAR(*reading.velocity, 22.4 * 1852 / 3600, 1e-9);
  EXPECT_EQ(reading.heading, 84.4);
  EXPECT_EQ(reading.date, (GpsDate{1994, 3, 23}));
  EXPECT_EQ(reading.time, (GpsTime{12, 35, 19}));
  EXPECT_EQ(reading.fix, GpsFix::fix_2d) << "a position, and no word of the height";
  EXPECT_FALSE(reading.altitude);
  EXPECT_EQ(sut.counts(), (NmeaCounts{.accepted = 1}));
}

TEST(Nmea, GgaSaysHowHighAndByHowMany) {
  NmeaReceiver sut;
  sut.receive(gga);
  const GpsReading reading = sut.reading();
  EXPECT_NEAR(*reading.latitude, 48.1173, 1e-9);
  EXPECT_EQ(reading.altitude, 545.4);
  EXPECT_EQ(reading.tracked_satellites, 8u);
  EXPECT_EQ(reading.hdop, 0.9);
  EXPECT_FALSE(reading.date);
}

TEST(Nmea, GsaSaysHowGoodItIs) {
  NmeaReceiver sut;
  sut.receive(gsa);
  const GpsReading reading = sut.reading();
  EXPECT_EQ(reading.fix, GpsFix::fix_3d);
  EXPECT_EQ(reading.pdop, 2.5);
  EXPECT_EQ(reading.hdop, 1.3);
  EXPECT_EQ(reading.vdop, 2.1);
}

TEST(Nmea, GsvSaysHowManyThereAreOfEachSystem) {
  NmeaReceiver sut;
  sut.receive(gsv);
  EXPECT_EQ(sut.reading().visible_satellites, 8u);
  sut.receive(line("GLGSV,1,1,03,65,11,022,30"));
  sut.receive(line("GAGSV,1,1,02"));
  EXPECT_EQ(sut.reading().visible_satellites, 13u);
  sut.receive(line("GLGSV,1,1,00"));
  EXPECT_EQ(sut.reading().visible_satellites, 10u);
}

TEST(Nmea, VtgSaysTheMovement) {
  NmeaReceiver sut;
  sut.receive(vtg);
  EXPECT_EQ(sut.reading().heading, 54.7);
  EXPECT_NEAR(*sut.reading().velocity, 10.2 / 3.6, 1e-9);
  sut.receive(line("GPVTG,054.7,T,,M,005.5,N,,K"));
  EXPECT_NEAR(*sut.reading().velocity, 5.5 * 1852 / 3600, 1e-9) << "knots alone";
  sut.receive(line("GPVTG,,T,,M,,N,,K"));
  EXPECT_FALSE(sut.reading().velocity);
  EXPECT_FALSE(sut.reading().heading);
}

TEST(Nmea, ZdaSaysTheTime) {
  NmeaReceiver sut;
  sut.receive(zda);
  EXPECT_EQ(sut.reading().time, (GpsTime{20, 15, 30}));
  EXPECT_EQ(sut.reading().date, (GpsDate{2002, 7, 4}));
  sut.receive(line("GPZDA,,,,,,"));
  EXPECT_FALSE(sut.reading().time);
  EXPECT_FALSE(sut.reading().date);
}

TEST(Nmea, SouthAndWestAreBelowZero) {
  NmeaReceiver sut;
  sut.receive(line("GNRMC,000000.25,A,3351.5000,S,07038.2500,W,,,010100,,"));
  EXPECT_NEAR(*sut.reading().latitude, -(33 + 51.5 / 60), 1e-9);
  EXPECT_NEAR(*sut.reading().longitude, -(70 + 38.25 / 60), 1e-9);
  EXPECT_FALSE(sut.reading().velocity);
  EXPECT_EQ(sut.reading().time, (GpsTime{0, 0, 0.25}));
  EXPECT_EQ(sut.reading().date, (GpsDate{2000, 1, 1}));
}

TEST(Nmea, WithoutAFixThereIsNoPositionAndNoMovement) {
  NmeaReceiver sut;
  for (const std::string_view one : {rmc, gga, gsa}) sut.receive(one);
  EXPECT_EQ(sut.reading().fix, GpsFix::fix_3d);
  sut.receive(line("GPRMC,123520,V,4807.038,N,01131.000,E,022.4,084.4,230394,,"));
  const GpsReading lost = sut.reading();
  EXPECT_EQ(lost.fix, GpsFix::none);
  EXPECT_FALSE(lost.latitude || lost.longitude || lost.altitude || lost.velocity || lost.heading);
  EXPECT_EQ(lost.time, (GpsTime{12, 35, 20})) << "the clock goes on";
  sut.receive(gga);
  EXPECT_EQ(sut.reading().fix, GpsFix::fix_3d) << "found again";
  sut.receive(line("GPGGA,123521,,,,,0,00,99.99,,M,,M,,"));
  EXPECT_EQ(sut.reading().fix, GpsFix::none);
  EXPECT_EQ(sut.reading().tracked_satellites, 0u);
  sut.receive(rmc);
  sut.receive(line("GPGSA,A,1,,,,,,,,,,,,,,,"));
  EXPECT_EQ(sut.reading().fix, GpsFix::none);
  EXPECT_FALSE(sut.reading().pdop);
  sut.receive(line("GPGSA,A,2,,,,,,,,,,,,,3,2,"));
  EXPECT_EQ(sut.reading().fix, GpsFix::fix_2d);
  EXPECT_EQ(sut.reading().hdop, 2);
}

TEST(Nmea, AnyCutOfTheStreamWillDo) {
  const std::string all = std::string(rmc) + std::string(gga) + std::string(gsa) +
                          std::string(gsv) + std::string(vtg) + std::string(zda);
  NmeaReceiver whole;
  whole.receive(all);
  for (std::size_t cut = 0; cut <= all.size(); ++cut) {
    NmeaReceiver sut;
    sut.receive(all.substr(0, cut));
    sut.receive(all.substr(cut));
    ASSERT_EQ(sut.reading(), whole.reading()) << cut;
    ASSERT_EQ(sut.counts(), (NmeaCounts{.accepted = 6}));
  }
}

TEST(Nmea, ABitThatIsWrongAnywhereIsSeen) {
  for (std::size_t place = 0; place + 2 < rmc.size(); ++place) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string wrong(rmc);
      wrong[place] = static_cast<char>(wrong[place] ^ (1 << bit));
      NmeaReceiver sut;
      sut.receive(wrong);
      // 'A' and 'a' are the same digit of a checksum.
      const bool is_same_digit = place == rmc.size() - 3 && bit == 5;
      ASSERT_EQ(sut.counts().accepted, is_same_digit ? 1u : 0u) << place << " " << bit;
      ASSERT_EQ(sut.reading() == GpsReading{}, !is_same_digit);
    }
  }
}

TEST(Nmea, LinesThatAreNoSentencesAreCounted) {
  NmeaReceiver sut;
  sut.receive("\r\n\n\r");
  EXPECT_EQ(sut.counts(), NmeaCounts{}) << "empty lines are nothing";
  sut.receive("hello\r\n");
  EXPECT_EQ(sut.counts(), (NmeaCounts{.garbage = 1}));
  sut.receive("$GPRMC,1235$GPRMC,12\n");
  EXPECT_EQ(sut.counts(), (NmeaCounts{.wrong_checksum = 1, .garbage = 2}));
  sut.receive("\x01$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\n");
  EXPECT_EQ(sut.counts(), (NmeaCounts{.accepted = 1, .wrong_checksum = 1, .garbage = 3}));
  sut.receive("$" + std::string(200, 'x') + "\n");
  EXPECT_EQ(sut.counts().garbage, 4u);
  sut.receive("$\n$*\n$*00\n");
  EXPECT_EQ(sut.counts().wrong_checksum, 3u);
  EXPECT_EQ(sut.counts().not_wanted, 1u) << "an empty sentence has the checksum 00";
  sut.receive(vtg);
  EXPECT_EQ(sut.counts().accepted, 2u) << "and the next line is as good as ever";
}

/// 20h to 7Eh.
TEST(Nmea, WhatIsNoCharacterMakesALineGarbageWhateverItsChecksumSays) {
  for (const char wrong : {'\x01', '\x1F', '\x7F', '\xC3'}) {
    NmeaReceiver sut;
    sut.receive(line("GPVTG,054.7,T,034.4,M,005.5,N,010.2,K," + std::string(1, wrong)));
    EXPECT_EQ(sut.counts(), (NmeaCounts{.garbage = 1})) << int{wrong};
  }
  for (const char right : {' ', '~'}) {
    NmeaReceiver sut;
    sut.receive(line("GPVTG,054.7,T,034.4,M,005.5,N,010.2,K," + std::string(1, right)));
    EXPECT_EQ(sut.counts(), (NmeaCounts{.accepted = 1})) << int{right};
  }
}

TEST(Nmea, OtherSentencesAndTalkersAreNotWanted) {
  NmeaReceiver sut;
  for (const std::string_view other :
       {"GPGLL,4916.45,N,12311.12,W,225444,A", "BDRMC,123519,A,,,,,,,,,", "PMTK001,604,3", "GPXXX,",
        "PGRMC,123519,A,,,,,,,,,", "GP", "NGRMC,123519,A,,,,,,,,,"}) {
    sut.receive(line(other));
  }
  EXPECT_EQ(sut.counts(), (NmeaCounts{.not_wanted = 7}));
  EXPECT_EQ(sut.reading(), GpsReading{});
}

TEST(Nmea, ASentenceWithOneBadFieldIsNotTakenAtAll) {
  for (const std::string_view bad : {"GPRMC,1235,A,,,,,,,,,",
                                     "GPRMC,246060,A,,,,,,,,,",
                                     "GPRMC,123519,X,,,,,,,,,",
                                     "GPRMC,126019,A,,,,,,,,,",
                                     "GPRMC,123561,A,,,,,,,,,",
                                     "GPRMC,12351x,A,,,,,,,,,",
                                     "GPRMC,123519,A,4807.038,N,,,,,,,",
                                     "GPRMC,123519,A,9000.001,N,01131.000,E,,,,,",
                                     "GPRMC,123519,A,4860.000,N,01131.000,E,,,,,",
                                     "GPRMC,123519,A,4807.038,E,01131.000,E,,,,,",
                                     "GPRMC,123519,A,4807.038,N,18000.001,E,,,,,",
                                     "GPRMC,123519,A,4807.038,,01131.000,E,,,,,",
                                     "GPRMC,123519,A,48,N,01131.000,E,,,,,",
                                     "GPRMC,123519,A,,,,,-1,,,,",
                                     "GPRMC,123519,A,,,,,1.2.3,,,,",
                                     "GPRMC,123519,A,,,,,,361,,,",
                                     "GPRMC,123519,A,,,,,,,320194,,",
                                     "GPRMC,123519,A,,,,,,,001394,,",
                                     "GPRMC,123519,A,,,,,,,2303,,",
                                     "GPGGA,123519,,,,,,08,,,,,,,",
                                     "GPGGA,123519,,,,,9,08,,,,,,,",
                                     "GPGGA,123519,,,,,1,x,,,,,,,",
                                     "GPGGA,123519,,,,,1,08,,545.4,F,,,,",
                                     "GPGGA,123519,,,,,1,08,,high,M,,,,",
                                     "GPGSA,A,4,,,,,,",
                                     "GPGSA,A,,,,,",
                                     "GPGSA,A,3,,,,,,,,,,,,,x,,",
                                     "GPGSV,2,3,08",
                                     "GPGSV,2,0,08",
                                     "GPGSV,2,1,",
                                     "GPGSV,2,1,ab",
                                     "GPVTG,1e9,T,,M,,N,,K",
                                     "GPVTG,,T,,M,.,N,,K",
                                     "GPZDA,201530,32,07,2002,,",
                                     "GPZDA,201530,04,13,2002,,",
                                     "GPZDA,201530,04,07,02,,",
                                     "GPZDA,201530,04,,2002,,",
                                     "GPVTG,1234567890123456,T,,M,,N,,K"}) {
    NmeaReceiver sut;
    sut.receive(line(bad));
    EXPECT_EQ(sut.counts(), (NmeaCounts{.malformed = 1})) << bad;
    EXPECT_EQ(sut.reading(), GpsReading{}) << bad;
  }
}

TEST(Nmea, WhatStandsAtTheEdgesIsTaken) {
  NmeaReceiver sut;
  sut.receive(line("GPRMC,235960.5,A,9000.000,S,18000.000,W,0,360,311279,,"));
  EXPECT_EQ(sut.counts().accepted, 1u);
  EXPECT_EQ(sut.reading().latitude, -90.0);
  EXPECT_EQ(sut.reading().longitude, -180.0);
  EXPECT_EQ(sut.reading().date, (GpsDate{2079, 12, 31}));
  EXPECT_EQ(sut.reading().time, (GpsTime{23, 59, 60.5})) << "a second that is inserted";
  sut.receive(line("GPGGA,000000,0000.000,N,00000.000,E,8,00,0,-431.2,M,,,,"));
  EXPECT_EQ(sut.reading().altitude, -431.2) << "at the Dead Sea";
}

TEST(Nmea, AReceiverThatFellSilentIsForgotten) {
  NmeaReceiver sut;
  sut.receive(rmc);
  sut.receive("$GPVTG,0");
  sut.forget();
  EXPECT_EQ(sut.reading(), GpsReading{});
  EXPECT_EQ(sut.counts().accepted, 1u);
  sut.receive(vtg);
  EXPECT_EQ(sut.counts(), (NmeaCounts{.accepted = 2})) << "the half line is forgotten too";
}

bool is_sound(const GpsReading& reading) {
  const auto within = [](std::optional<double> value, double low, double high) {
    return !value || (*value >= low && *value <= high);
  };
  return within(reading.latitude, -90, 90) && within(reading.longitude, -180, 180) &&
         within(reading.heading, 0, 360) && within(reading.velocity, 0, 99999) &&
         within(reading.hdop, 0, 9999) && (!reading.date || reading.date->month <= 12) &&
         (!reading.time || reading.time->second < 61);
}

TEST(Nmea, NoiseIsSurvivedAndTheNextSentenceIsTaken) {
  Random random(447);
  NmeaReceiver sut;
  for (int round = 0; round < 20'000; ++round) {
    // Noise of the characters that sentences are made of, so that some of it goes far.
    constexpr std::string_view letters = "$GPRMCASVTZDN,.*0123456789EW-\r\n\x7F\x80 ";
    const auto length = random.next() % 90;
    for (std::uint64_t i = 0; i < length; ++i) sut.receive(letters[random.next() % letters.size()]);
    ASSERT_TRUE(is_sound(sut.reading()));
    sut.receive("\r\n");
    const std::uint32_t accepted = sut.counts().accepted;
    sut.receive(vtg);
    ASSERT_EQ(sut.counts().accepted, accepted + 1);
  }
}

TEST(Nmea, SentencesWithWrongFieldsAndRightChecksumsStaySound) {
  Random random(4210);
  NmeaReceiver sut;
  std::uint32_t sent = 0;
  for (int round = 0; round < 50'000; ++round) {
    constexpr std::string_view good[] = {rmc, gga, gsa, gsv, vtg, zda};
    std::string sentence(good[random.next() % std::size(good)]);
    sentence = sentence.substr(1, sentence.size() - 6);
    for (std::uint64_t wrong = random.next() % 4; wrong > 0; --wrong) {
      constexpr std::string_view letters = ",.0123456789-ANSEWM";
      sentence[random.next() % sentence.size()] = letters[random.next() % letters.size()];
    }
    sut.receive(line(sentence));
    ++sent;
    ASSERT_TRUE(is_sound(sut.reading())) << sentence;
  }
  const NmeaCounts& counts = sut.counts();
  EXPECT_EQ(counts.accepted + counts.malformed + counts.not_wanted, sent);
  EXPECT_GT(counts.accepted, 1000u);
  EXPECT_GT(counts.malformed, 1000u);
}

}  // namespace
}  // namespace canvoy::cia447::nmea_test
