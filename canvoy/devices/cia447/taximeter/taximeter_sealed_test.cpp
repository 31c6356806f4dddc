// A sealed taximeter at its wire: clients that may write its inputs, limits of a clock, pulses that
// are not from the wheels, the seal itself, and k by a drive (CiA 447-3, 4.2.4 and 4.2.12;
// Directive 2014/32/EU, annex IX). 0800 0021h: not by this client; 0800 0022h: not at present.
#include <gtest/gtest.h>

#include <string>

#include "canvoy/devices/cia447/taximeter/meter_bench_test.hpp"

namespace canvoy::cia447::taximeter_sealed_test {
namespace {

constexpr const char* emergency_free = "085#00 00 00 00 00 00 00 00";
constexpr std::uint32_t emergency = 0x085;

TaximeterSettings with_clock() {
  return {.clock_node = 7};
}

class Sealed : public testing::Test {
 protected:
  std::size_t recorded(AuditEvent what) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < car.meter->audit().size(); ++i) {
      if (car.meter->audit().newest(i)->what == what) ++count;
    }
    return count;
  }
  const AuditEntry& newest() const { return *car.meter->audit().newest(0); }
  /// Sent every 100 ms, with wheels that report this rpm, in 0,5/min.
  void send_counts(unsigned seconds, unsigned pulses_each, unsigned rpm) {
    for (unsigned cycle = 0; cycle < 10 * seconds; ++cycle) {
      car.cable().run_for(100ms);
      car.turned += pulses_each;
      car.send_count(car.turned % 65'536, 1, rpm);
    }
  }
  void seal_anew() {
    car.seal_is_open = true;
    EXPECT_TRUE(car.meter->enter_service());
    car.seal_is_open = false;
    EXPECT_TRUE(car.meter->leave_service());
    car.cable().run_for(0s);
  }

  MeterBench car{with_clock()};
};

// Clients.

/// All that it consumes, each with a value that can be: refused on the default channel, to all but
/// the provider, and each refusal recorded.
TEST_F(Sealed, NobodyButItsProviderWritesWhatItGoesBy) {
  struct Write {
    const char* request;
    unsigned provider;
    std::uint32_t place;  ///< index and sub-index
  };
  constexpr Write writes[] = {
      {"2B 50 60 00 E8 03 00 00", 1, 0x60'5000}, {"2B 53 60 00 64 00 00 00", 1, 0x60'5300},
      {"2F 54 60 00 02 00 00 00", 1, 0x60'5400}, {"27 55 60 00 F4 01 FD 00", 1, 0x60'5500},
      {"27 56 60 00 C8 00 FD 00", 1, 0x60'5600}, {"2F 57 60 00 30 00 00 00", 1, 0x60'5700},
      {"23 F0 60 00 EA 07 8C F1", 7, 0x60'F000}, {"23 F2 60 00 17 1E 00 00", 7, 0x60'F200},
      {"23 F4 60 00 11 01 CE FF", 7, 0x60'F400}};
  for (const Write& write : writes) {
    SCOPED_TRACE(write.request);
    const std::string object = std::string(write.request).substr(3, 8);
    const std::string before = car.ask("40 " + object + " 00 00 00 00");
    EXPECT_EQ(car.ask(write.request), "80 " + object + " 21 00 00 08");
    EXPECT_EQ(newest().what, AuditEvent::write_refused);
    EXPECT_EQ(newest().who, by_default_channel);
    EXPECT_EQ(newest().detail, write.place);
    for (unsigned client = 1; client <= 16; ++client) {
      if (client == write.provider || client == 5) continue;
      EXPECT_EQ(car.ask_as(client, write.request), "80 " + object + " 21 00 00 08") << client;
      EXPECT_EQ(newest().who, client);
    }
    EXPECT_EQ(car.ask("40 " + object + " 00 00 00 00"), before);
    EXPECT_EQ(car.ask_as(write.provider, write.request), "60 " + object + " 00 00 00 00");
  }
  EXPECT_EQ(car.get(0x5F20, 1), std::size(writes) * 15) << "the channel of all, and 14 clients";
}

/// 20 times 500 pulses of 8 a metre would be 1,25 km.
TEST_F(Sealed, PulsesByWritesAreNoDistance) {
  car.begin_shift();
  car.meter->hire();
  car.drive(10, 80);
  for (unsigned i = 1; i <= 20; ++i) {
    const unsigned count = (car.turned + 500 * i) % 65'536;
    char request[32];
    std::snprintf(request, sizeof request, "27 55 60 00 %02X %02X FD 00", count & 0xFF, count >> 8);
    car.cable().run_for(1s);
    EXPECT_EQ(car.ask(request).substr(0, 2), "80");
    EXPECT_EQ(car.ask_as(7, request).substr(0, 2), "80");
  }
  car.drive(10, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 200u);
  EXPECT_EQ(newest().times, 20u);
}

TEST_F(Sealed, AnOverrunValueOfAStrangerTakesNoDistance) {
  car.begin_shift();
  car.meter->hire();
  car.ask("27 56 60 00 C8 00 FD 00");  // 200
  car.ask_as(3, "27 56 60 00 C8 00 FD 00");
  car.drive(8, 80);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 80u);
}

TEST_F(Sealed, AStrangersClockChangesNeitherTariffNorTripNorWhatIsKept) {
  SimulatedFlash memory(MeterBench::geometry);
  {
    MeterBench other(with_clock(), &memory);
    other.begin_shift();
    other.meter->hire();
    for (const unsigned client : {0U, 3U}) {
      for (const char* request :
           {"23 F0 60 00 EA 07 9C F1", "23 F2 60 00 17 1E 00 00", "23 F4 60 00 11 01 80 FF"}) {
        const std::string answer = client == 0 ? other.ask(request) : other.ask_as(client, request);
        EXPECT_EQ(answer.substr(12), "21 00 00 08");
      }
    }
    other.cable().run_for(5s);
    EXPECT_EQ(other.get(0x60D3), 0x31u) << "by day";
    other.meter->power_fails();
  }
  SimulatedFlash same(MeterBench::geometry, memory.bytes);
  MeterBench back(with_clock(), &same, MeterBench::noon + 3600);
  back.meter->hire();
  EXPECT_EQ(back.get(0x60D2, 3), MeterBench::noon + 3600 - 3600);
}

TEST_F(Sealed, ASourceOfAStrangerKeepsNobodyFromRiding) {
  EXPECT_EQ(car.ask_as(1, "2F 54 60 00 05 00 00 00"), "60 54 60 00 00 00 00 00");
  car.begin_shift();
  EXPECT_EQ(car.ask("2F 54 60 00 02 00 00 00"), "80 54 60 00 21 00 00 08");
  EXPECT_EQ(car.ask_as(7, "2F 54 60 00 02 00 00 00"), "80 54 60 00 21 00 00 08");
  EXPECT_EQ(car.cable().count(emergency), 0u);
  EXPECT_TRUE(car.meter->hire());
}

/// 0609 0030h: impossible values, also from the provider.
TEST_F(Sealed, ReservedCodesAndDaysThatThereAreNotAreRefused) {
  struct Impossible {
    unsigned client;
    const char* request;
  };
  constexpr Impossible impossible[] = {
      {1, "2F 54 60 00 07 00 00 00"},   // reserved (4.2.4.5)
      {1, "2F 57 60 00 00 00 00 00"},   // from 1 on (4.2.4.8)
      {1, "2B 53 60 00 FF 3F 00 00"},   // 3FFFh to FFFDh
      {7, "23 F0 60 00 EA 07 F2 F1"},   // 2026-02-31: day in bits 27..20, month in 19..16
      {7, "23 F0 60 00 EA 07 D2 F1"},   // 2026-02-29
      {7, "23 F0 60 00 FD FF D2 F1"},   // 02-29 of FFFDh, the highest year, which is odd
      {7, "23 F0 60 00 EA 07 EB F1"},   // 2026-11-30 is one: see below
      {7, "23 F0 60 00 EA 07 FB F1"},   // 2026-11-31
      {7, "23 F0 60 00 EA 07 8D F1"},   // month 0Dh
      {7, "23 F2 60 00 18 00 00 00"},   // hour 24
      {7, "23 F2 60 00 00 3C 00 00"},   // minute 60
      {7, "23 F4 60 00 14 01 CE FF"}};  // source 04h
  for (const Impossible& each : impossible) {
    SCOPED_TRACE(each.request);
    const std::string object = std::string(each.request).substr(3, 8);
    const bool is_possible = std::string(each.request) == "23 F0 60 00 EA 07 EB F1";
    EXPECT_EQ(car.ask_as(each.client, each.request),
              is_possible ? "60 " + object + " 00 00 00 00" : "80 " + object + " 30 00 09 06");
  }
  EXPECT_EQ(car.ask_as(7, "23 F0 60 00 EC 07 D2 F1"), "60 F0 60 00 00 00 00 00") << "2028-02-29";
  EXPECT_EQ(car.ask_as(7, "23 F0 60 00 FF FF FF FF"), "60 F0 60 00 00 00 00 00")
      << "signal not available";
  EXPECT_EQ(recorded(AuditEvent::write_refused), 0u) << "who provides it is no stranger";
}

/// The senders of its inputs are behind the seal: channels and PDOs.
TEST_F(Sealed, ItsParametersAreWrittenInServiceModeOnly) {
  constexpr const char* requests[] = {
      "23 10 14 01 8B 02 00 80",   // RPDO 17 from another node
      "2F 10 14 02 01 00 00 00",   // with the SYNC
      "2F 10 16 00 00 00 00 00",   // its mapping
      "23 03 12 01 33 03 00 80",   // the SDO server for node 3
      "23 80 12 02 33 03 00 80"};  // the client that sends requests to the gateway
  for (const char* request : requests) {
    const std::string object = std::string(request).substr(3, 8);
    EXPECT_EQ(car.ask_as(1, request), "80 " + object + " 22 00 00 08") << request;
    EXPECT_EQ(newest().what, AuditEvent::settings_refused);
    EXPECT_EQ(newest().who, 1u);
  }
  car.seal_is_open = true;
  ASSERT_TRUE(car.meter->enter_service());
  EXPECT_EQ(car.ask_as(1, "2F 10 14 02 FE 00 00 00"), "60 10 14 02 00 00 00 00");
}

// Clocks.

class SealedClock : public Sealed {
 protected:
  /// Node 7 sends this local time of 2026-11-23, an hour ahead of UTC.
  void set_bus_clock(unsigned hour, unsigned minute, unsigned second = 0) {
    char request[32];
    EXPECT_EQ(car.ask_as(7, "23 F4 60 00 11 01 CD FF").substr(0, 2), "60");
    EXPECT_EQ(car.ask_as(7, "23 F0 60 00 EA 07 7B F1").substr(0, 2), "60");
    std::snprintf(request, sizeof request, "23 F2 60 00 %02X %02X %02X %02X", hour, minute,
                  second * 100 & 0xFF, second * 100 >> 8);
    EXPECT_EQ(car.ask_as(7, request).substr(0, 2), "60");
    car.cable().run_for(1s);
  }
};

TEST_F(SealedClock, AStepBetweenTwoTripsIsTakenAndRecorded) {
  set_bus_clock(12, 0, 0);
  EXPECT_EQ(recorded(AuditEvent::clock_step), 0u);
  set_bus_clock(22, 30);
  ASSERT_EQ(recorded(AuditEvent::clock_step), 1u);
  EXPECT_EQ(newest().who, 7u);
  EXPECT_NEAR(static_cast<double>(newest().value), 10.5 * 3600, 3);
  car.begin_shift();
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D3), 0x32u) << "at night";
}

TEST_F(SealedClock, AStepOfMoreThanTwoMinutesInATripIsNone) {
  set_bus_clock(21, 50);
  car.begin_shift();
  car.meter->hire();
  const std::uint64_t start = car.get(0x60D2, 3);
  set_bus_clock(22, 30);
  set_bus_clock(23, 30);
  EXPECT_EQ(car.get(0x60D3), 0x31u) << "by day";
  EXPECT_EQ(recorded(AuditEvent::clock_refused), 1u) << "once in a trip";
  EXPECT_EQ(newest().who, 7u);
  car.meter->stop();
  EXPECT_LE(car.get(0x60D2, 4) - start, 3u) << "the finish is by the time that went on";
  car.meter->for_hire();
  car.cable().run_for(1s);
  car.meter->hire();
  EXPECT_EQ(car.get(0x60D3), 0x32u) << "the next trip";
  EXPECT_EQ(recorded(AuditEvent::clock_step), 2u) << "to 21:50, and to 23:30";
}

TEST_F(SealedClock, StepsOfLessAddUpToTwoMinutesAtMost) {
  set_bus_clock(21, 50);
  car.begin_shift();
  car.meter->hire();
  set_bus_clock(21, 51);
  EXPECT_EQ(recorded(AuditEvent::clock_refused), 0u);
  set_bus_clock(21, 52, 50);
  EXPECT_EQ(recorded(AuditEvent::clock_refused), 1u);
}

TEST_F(SealedClock, SummerTimeEndsInATrip) {
  set_bus_clock(12, 0);
  car.begin_shift();
  car.meter->hire();
  // An hour back, and the offset from UTC too: 30h, 0 hours.
  EXPECT_EQ(car.ask_as(7, "23 F4 60 00 11 01 CC FF").substr(0, 2), "60");
  EXPECT_EQ(car.ask_as(7, "23 F2 60 00 0B 00 64 00").substr(0, 2), "60");
  car.cable().run_for(1s);
  EXPECT_EQ(recorded(AuditEvent::clock_refused), 0u);
}

// Pulses.

TEST_F(Sealed, PulsesWhileTheWheelsStandAreNoneOfThem) {
  car.begin_shift();
  car.meter->hire();
  send_counts(10, 8, 600);
  send_counts(1, 0, 0);
  const std::uint64_t driven = car.get(0x60D1);
  // 32 pulses are 4 m.
  send_counts(1, 3, 0);
  EXPECT_EQ(car.cable().count(emergency), 0u);
  send_counts(1, 3, 0);
  EXPECT_EQ(car.cable().last(emergency), "085#00 FF 21 05 00 00 00 00");
  EXPECT_EQ(recorded(AuditEvent::error), 1u);
  send_counts(1, 8, 600);
  EXPECT_EQ(car.cable().last(emergency), emergency_free);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), driven + 10) << "those of the last second alone";
}

TEST_F(Sealed, WheelsThatStopHaveTheLastOfTheirPulses) {
  car.begin_shift();
  car.meter->hire();
  send_counts(10, 8, 600);
  // 6053h reports it half a second before 6055h does.
  for (unsigned cycle = 0; cycle < 5; ++cycle) {
    car.cable().run_for(100ms);
    car.turned += 8;
    car.send_count(car.turned % 65'536, 1, 0);
  }
  send_counts(5, 0, 0);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D1), 105u);
  EXPECT_EQ(car.cable().count(emergency), 0u);
}

TEST_F(Sealed, ATwentiethMoreForATurnThanBeforeIsAnError) {
  car.begin_shift();
  send_counts(20, 20, 600);
  EXPECT_EQ(car.cable().count(emergency), 0u);
  send_counts(40, 20, 570);
  EXPECT_EQ(car.cable().count(emergency), 1u) << "20 / 570 is 5,3 % more than 20 / 600";
  EXPECT_EQ(car.cable().last(emergency), "085#00 FF 21 05 00 00 00 00");
}

TEST_F(Sealed, AnEngineThatStandsIsRecorded) {
  car.begin_shift();
  const auto drive = [this](unsigned seconds, const char* engine) {
    for (unsigned cycle = 0; cycle < 10 * seconds; ++cycle) {
      car.cable().run_for(100ms);
      car.turned += 8;
      char frame[48];
      std::snprintf(frame, sizeof frame, "187#%s FF FF %02X %02X FD", engine, car.turned & 0xFF,
                    car.turned >> 8 & 0xFF);
      car.cable().send(frame);
    }
  };
  drive(60, "00 00");
  EXPECT_EQ(recorded(AuditEvent::engine_stands), 0u) << "an electric car";
  drive(1, "E8 03");
  // A tenth of a kilometre is 800 pulses: 10 s.
  drive(9, "00 00");
  EXPECT_EQ(recorded(AuditEvent::engine_stands), 0u);
  drive(2, "00 00");
  EXPECT_EQ(recorded(AuditEvent::engine_stands), 1u);
  EXPECT_EQ(car.cable().count(emergency), 0u);
}

// The seal.

TEST_F(Sealed, ASealThatWasOpenedLetsNoTripBeginUntilItIsSealedAnew) {
  SimulatedFlash memory(MeterBench::geometry);
  {
    MeterBench other({}, &memory);
    other.begin_shift();
    other.meter->hire();
    other.seal_is_open = true;
    other.cable().run_for(1s);
    EXPECT_EQ(other.cable().last(emergency), "085#00 FF 21 06 00 00 00 00");
    other.seal_is_open = false;
    other.cable().run_for(1s);
    EXPECT_TRUE(other.meter->stop()) << "who rides arrives";
    EXPECT_TRUE(other.meter->for_hire());
    EXPECT_FALSE(other.meter->hire());
    other.meter->power_fails();
  }
  SimulatedFlash same(MeterBench::geometry, memory.bytes);
  MeterBench back({}, &same);
  EXPECT_FALSE(back.meter->hire()) << "power does not mend it";
  back.seal_is_open = true;
  EXPECT_TRUE(back.meter->enter_service());
  back.seal_is_open = false;
  EXPECT_TRUE(back.meter->leave_service());
  EXPECT_TRUE(back.meter->sign_on());
  EXPECT_TRUE(back.meter->hire());
}

/// 12 500 pulses on a kilometre; a pulse is 0,008 %.
TEST_F(Sealed, KIsWhatADriveOverAKnownDistanceGives) {
  EXPECT_FALSE(car.meter->begin_calibration()) << "behind the seal";
  car.seal_is_open = true;
  ASSERT_TRUE(car.meter->enter_service());
  EXPECT_FALSE(car.meter->end_calibration(1000)) << "none has begun";
  car.drive(1, 100);
  ASSERT_TRUE(car.meter->begin_calibration());
  car.drive(125, 100);
  EXPECT_TRUE(car.meter->end_calibration(1000));
  EXPECT_EQ(car.get(0x60DA, 1), 12'500u);
  EXPECT_EQ(newest().what, AuditEvent::calibrated);
  ASSERT_TRUE(car.meter->begin_calibration());
  car.drive(9, 100);
  EXPECT_FALSE(car.meter->end_calibration(100)) << "900 pulses are too few";
  EXPECT_FALSE(car.meter->end_calibration(100)) << "it is over";
  EXPECT_EQ(car.get(0x60DA, 1), 12'500u);
  car.seal_is_open = false;
  EXPECT_TRUE(car.meter->leave_service());
}

}  // namespace
}  // namespace canvoy::cia447::taximeter_sealed_test
