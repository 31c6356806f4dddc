// The audit log of a taximeter: kind, time and origin; limited in size; kept without power; read by
// SDO (5F20h, 5F21h: our own, since CiA 447-3 has no object for it).
#include <gtest/gtest.h>

#include <string>

#include "canvoy/devices/cia447/taximeter/meter_bench_test.hpp"

namespace canvoy::cia447::taximeter_audit_test {
namespace {

AuditEntry entry_of(AuditEvent what, std::uint8_t who = by_meter, std::uint32_t detail = 0) {
  return {.at = 100, .what = what, .who = who, .detail = detail};
}

TEST(AuditLog, TheNewestComesFirst) {
  AuditLog log;
  log.note(entry_of(AuditEvent::seal_opened));
  log.note(entry_of(AuditEvent::service_entered));
  EXPECT_EQ(log.newest(0)->what, AuditEvent::service_entered);
  EXPECT_EQ(log.newest(1)->what, AuditEvent::seal_opened);
  EXPECT_EQ(log.newest(2), nullptr);
}

TEST(AuditLog, WhatIsRefusedAgainIsCounted) {
  AuditLog log;
  AuditEntry entry = entry_of(AuditEvent::write_refused, 7, 0x60'5500);
  EXPECT_EQ(log.note(entry).times, 1u);
  entry.at = 200;
  EXPECT_EQ(log.note(entry).times, 2u);
  EXPECT_EQ(log.size(), 1u);
  EXPECT_EQ(log.newest(0)->at, 100u);
  EXPECT_EQ(log.newest(0)->until, 200u);
  for (unsigned i = 0; i < 70'000; ++i) log.note(entry);
  EXPECT_EQ(log.newest(0)->times, 0xFFFFu) << "no more fit";
  EXPECT_EQ(log.events(), 70'002u);
  EXPECT_EQ(log.lost(), 0u);
}

TEST(AuditLog, EachStepOfAClockHasItsEntry) {
  AuditLog log;
  log.note(entry_of(AuditEvent::clock_step, 7));
  log.note(entry_of(AuditEvent::clock_step, 7));
  EXPECT_EQ(log.size(), 2u);
}

TEST(AuditLog, AStrangerWhoWritesAllDayDoesNotPushOutWhoOpenedTheSeal) {
  AuditLog log;
  log.note(entry_of(AuditEvent::seal_opened));
  for (std::uint32_t i = 0; i < 1000; ++i) {
    log.note(entry_of(AuditEvent::write_refused, static_cast<std::uint8_t>(i % 16), i));
    log.note(entry_of(AuditEvent::clock_step, 7));
    log.note(entry_of(AuditEvent::error, by_meter, i));
  }
  EXPECT_EQ(log.newest(log.size() - 1)->what, AuditEvent::seal_opened);
  EXPECT_EQ(log.newest(0)->detail, 999u);
  EXPECT_EQ(log.lost() + log.size(), 3001u);
  EXPECT_LE(log.size(), AuditLog::capacity);
}

TEST(AuditText, SaysWhatWhenAndByWhom) {
  // 2026-11-23 11:00:00 UTC.
  AuditEntry entry = {.at = 1'795'431'600,
                      .until = 1'795'431'603,
                      .what = AuditEvent::write_refused,
                      .who = 7,
                      .times = 20,
                      .detail = 0x60'5500,
                      .value = 0x1F4};
  EXPECT_EQ(audit_text(entry).view(),
            "2026-11-23 11:00:00 UTC: write refused, node 7, 6055h:00h = 1F4h; 20 times until "
            "2026-11-23 11:00:03 UTC");
  entry = {.what = AuditEvent::clock_step, .who = by_default_channel, .value = 0xFFFF'FF88};
  EXPECT_EQ(audit_text(entry).view(), "no time: clock set, default channel, -120 s");
  entry = {.what = AuditEvent::k_set, .detail = 8000, .value = 24'000};
  EXPECT_EQ(audit_text(entry).view(), "no time: k set, 8000 to 24000");
  entry = {.what = static_cast<AuditEvent>(200)};
  EXPECT_EQ(audit_text(entry).view(), "no time: unknown");
}

class Audit : public testing::Test {
 protected:
  /// Two for the totals, four for two logs of 1024 bytes.
  static constexpr SimulatedFlash::Geometry geometry = {
      .sector_size = 512, .sectors = 6, .unit = 8};
  static TaximeterSettings settings() {
    return {.memory = {.address = 0, .slot_size = 512},
            .audit_memory = {.address = 1024, .slot_size = 1024}};
  }
  /// A line, by segments of 7 bytes: 60h and 70h in turn.
  static std::string line(MeterBench& car, unsigned number) {
    char request[32];
    std::snprintf(request, sizeof request, "40 21 5F %02X 00 00 00 00", number);
    std::string answer = car.ask(request);
    std::string text;
    if (answer.substr(0, 2) != "41") return answer;
    for (bool toggle = false;; toggle = !toggle) {
      answer = car.ask(toggle ? "70 00 00 00 00 00 00 00" : "60 00 00 00 00 00 00 00");
      if (answer.size() != 23) return answer;
      const auto head = static_cast<unsigned>(std::stoul(answer.substr(0, 2), nullptr, 16));
      const unsigned bytes = 7 - (head >> 1 & 7);
      for (unsigned i = 0; i < bytes; ++i) {
        text += static_cast<char>(std::stoul(answer.substr(3 + 3 * i, 2), nullptr, 16));
      }
      if ((head & 1) != 0) return text;
    }
  }
};

TEST_F(Audit, IsReadBySdo) {
  MeterBench car(settings());
  EXPECT_EQ(car.ask("40 20 5F 00 00 00 00 00"), "4F 20 5F 00 03 00 00 00");
  EXPECT_EQ(car.ask("40 21 5F 00 00 00 00 00"), "4F 21 5F 00 20 00 00 00");
  EXPECT_EQ(car.get(0x5F20, 1), 0u);
  car.cable().run_for(2s);
  car.ask_as(3, "27 55 60 00 F4 01 FD 00");
  car.cable().run_for(1s);
  car.ask_as(3, "27 55 60 00 F4 02 FD 00");
  car.ask("2F 54 60 00 01 00 00 00");
  EXPECT_EQ(car.get(0x5F20, 1), 3u) << "events";
  EXPECT_EQ(car.get(0x5F20, 2), 2u) << "entries";
  EXPECT_EQ(car.get(0x5F20, 3), 0u) << "lost";
  EXPECT_EQ(line(car, 1),
            "2026-11-23 11:00:03 UTC: write refused, default channel, 6054h:00h = 1h");
  EXPECT_EQ(line(car, 2),
            "2026-11-23 11:00:02 UTC: write refused, node 3, 6055h:00h = FD01F4h; 2 times until "
            "2026-11-23 11:00:03 UTC");
  EXPECT_EQ(line(car, 32), "");
  EXPECT_EQ(car.ask("2F 20 5F 01 00 00 00 00").substr(12), "02 00 01 06") << "nobody writes it";
  EXPECT_EQ(car.ask("22 21 5F 01 20 00 00 00").substr(12), "02 00 01 06");
}

TEST_F(Audit, RecordsWhatIsDoneBehindTheSeal) {
  MeterBench car(settings());
  car.seal_is_open = true;
  car.cable().run_for(0s);
  ASSERT_TRUE(car.meter->enter_service());
  car.meter->set_k(9000);
  car.seal_is_open = false;
  ASSERT_TRUE(car.meter->leave_service());
  const char* expected[] = {"sealed, k 9000", "seal closed", "k set, 8000 to 9000",
                            "service mode entered", "seal opened"};
  for (unsigned i = 0; i < std::size(expected); ++i) {
    EXPECT_EQ(line(car, i + 1), std::string("2026-11-23 11:00:00 UTC: ") + expected[i]);
  }
}

TEST_F(Audit, OutlastsALossOfPowerWithTheTotals) {
  SimulatedFlash memory(geometry);
  {
    MeterBench car(settings(), &memory);
    car.ask_as(3, "27 55 60 00 F4 01 FD 00");
    car.cable().run_for(1s);  // it is kept within a second
  }
  SimulatedFlash same(geometry, memory.bytes);
  MeterBench back(settings(), &same, MeterBench::noon + 100);
  EXPECT_EQ(back.meter->audit().size(), 1u);
  EXPECT_EQ(back.meter->audit().newest(0)->who, 3u);
  EXPECT_EQ(line(back, 1), "2026-11-23 11:00:00 UTC: write refused, node 3, 6055h:00h = FD01F4h");
  EXPECT_TRUE(back.meter->record().totals_are_known);
  EXPECT_EQ(same.violations, 0u);
}

TEST_F(Audit, ATripThatALossOfPowerHasEndedIsRecorded) {
  SimulatedFlash memory(geometry);
  {
    MeterBench car(settings(), &memory);
    car.begin_shift();
    car.meter->hire();
    car.meter->power_fails();
  }
  SimulatedFlash same(geometry, memory.bytes);
  MeterBench back(settings(), &same, MeterBench::noon + 3600);
  EXPECT_EQ(line(back, 1), "2026-11-23 12:00:00 UTC: trip ended by loss of power, 3900");
}

/// Refused writes do not wear the flash out: their number is kept once a minute.
TEST_F(Audit, AWriteThatIsRefusedAgainAndAgainIsNotWrittenEachTime) {
  SimulatedFlash memory(geometry);
  MeterBench car(settings(), &memory);
  car.ask_as(3, "27 55 60 00 F4 01 FD 00");
  car.cable().run_for(2s);
  const std::uint64_t steps = memory.steps();
  for (unsigned i = 0; i < 500; ++i) {
    car.ask_as(3, "27 55 60 00 F4 01 FD 00");
    car.cable().run_for(100ms);
  }
  EXPECT_EQ(memory.steps(), steps) << "50 s";
  car.cable().run_for(60s);
  EXPECT_GT(memory.steps(), steps);
  SimulatedFlash same(geometry, memory.bytes);
  MeterBench back(settings(), &same);
  EXPECT_EQ(back.meter->audit().newest(0)->times, 501u);
}

TEST_F(Audit, WhatIsDamagedBeginsAnewAndTheTotalsStay) {
  SimulatedFlash memory(geometry);
  {
    MeterBench car(settings(), &memory);
    car.begin_shift();
    car.drive(10, 80);
    car.ask_as(3, "27 55 60 00 F4 01 FD 00");
    car.meter->power_fails();
  }
  SimulatedFlash::Bytes bytes = memory.bytes;
  for (std::size_t i = 1024 + 64; i < bytes.size(); ++i) bytes[i] &= 0x7F;
  SimulatedFlash same(geometry, bytes);
  MeterBench back(settings(), &same);
  EXPECT_EQ(back.meter->audit().size(), 0u);
  EXPECT_EQ(back.get(0x60D9, 1), 100u);
}

}  // namespace
}  // namespace canvoy::cia447::taximeter_audit_test
