// Power fails: totals are neither lost nor counted twice, whenever it does (CiA 447-3, 4.2.12.7).
#include <gtest/gtest.h>

#include <set>

#include "canvoy/can/testing/tries_all.hpp"

#include "canvoy/devices/cia447/taximeter/meter_bench_test.hpp"

namespace canvoy::cia447::taximeter_power_test {
namespace {

constexpr TariffLevel levels[] = {{.initial_fare = 3000, .distance_rate = 2000}};
constexpr TaximeterSettings settings = {
    .k = 100, .tariff = {.id = 1, .levels = levels}, .fastest_speed = 4000};

/// What must fit together after power-on.
struct Found {
  std::uint32_t hirings;
  std::uint32_t fare;
  std::uint32_t income;
  std::uint32_t shift_fare;
  Taximeter state;

  auto operator<=>(const Found&) const = default;
};

Found found_in(const SimulatedFlash::Bytes& bytes) {
  SimulatedFlash memory(MeterBench::geometry, bytes);
  MeterBench car(settings, &memory, MeterBench::noon + 3600);
  const TaximeterRecord& record = car.meter->record();
  EXPECT_TRUE(record.totals_are_known);
  return {record.total.hirings, record.total.fare, record.total.income, record.shift.fare,
          record.state};
}

/// A shift with two trips of 0,1 km, each 3,00 and 0,20, the second with a supplement of 0,50.
void shift(MeterBench& car) {
  car.begin_shift();
  for (unsigned trip = 0; trip < 2; ++trip) {
    car.meter->hire();
    car.drive(1, 10);
    if (trip == 1) car.meter->add_supplement(500);
    car.meter->stop();
    car.cable().run_for(10ms);
    car.meter->for_hire();
    car.cable().run_for(10ms);
  }
}

/// A meter that was turned on once, as makers do.
const SimulatedFlash::Bytes& of_a_new_meter() {
  static const SimulatedFlash::Bytes bytes = [] {
    SimulatedFlash memory(MeterBench::geometry);
    MeterBench car(settings, &memory);
    car.cable().run_for(1s);
    return memory.bytes;
  }();
  return bytes;
}

SimulatedFlash::Bytes after_cut(std::uint64_t cut, Tear tear, std::uint64_t* steps = nullptr) {
  SimulatedFlash memory(MeterBench::geometry, of_a_new_meter());
  memory.cut_after(cut, tear);
  MeterBench car(settings, &memory);
  car.turned = 0;
  shift(car);
  EXPECT_EQ(memory.violations, 0u);
  if (steps != nullptr) *steps = memory.steps();
  return memory.bytes;
}

/// A record of version 1, without kinds of supplements and the beginning of the shift.
class OldRecord {
 public:
  explicit OldRecord(const TaximeterRecord& record) {
    const TaximeterRecordBytes bytes = bytes_of(record);
    std::copy_n(bytes.begin(), bytes_.size(), bytes_.begin());
    bytes_.front() = 1;
  }
  /// As a meter of that time has written it.
  void write(const Flash& flash) {
    constexpr std::uint32_t kind = 0x4D58'4154;
    RecordPair pair(flash, {.address = 0, .slot_size = 512, .kind = kind});
    pair.sign(kind, 1U << 16 | TaximeterRecord::size_of_version_1);
    pair.find();
    pair.begin(
        {.rewind = callback<&OldRecord::rewind>(*this), .next = callback<&OldRecord::next>(*this)});
    while (pair.step() != RecordStep::done) {
    }
  }

 private:
  void rewind() { at_ = 0; }
  Result<std::size_t> next(std::span<std::uint8_t> bytes) {
    const std::size_t length = std::min(bytes.size(), bytes_.size() - at_);
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), length, bytes.begin());
    at_ += length;
    return length;
  }

  std::array<std::uint8_t, TaximeterRecord::size_of_version_1> bytes_{};
  std::size_t at_ = 0;
};

/// They are kept, regardless of readers (MI-007, 15.2).
TEST(TaximeterPower, TotalsOfAnOlderRecordAreKept) {
  SimulatedFlash memory(MeterBench::geometry);
  TaximeterRecord old;
  old.k = 100;
  old.tariff = 1;
  old.state = Taximeter::for_hire;
  old.total = {.distance = 7, .income = 3500, .hirings = 2, .supplements = 500, .fare = 3000};
  OldRecord(old).write(memory.flash);
  MeterBench car(settings, &memory);
  EXPECT_TRUE(car.meter->record().totals_are_known);
  EXPECT_EQ(car.meter->record().total.income, 3500u);
  EXPECT_EQ(car.meter->record().total.hirings, 2u);
  EXPECT_EQ(car.meter->record().state, Taximeter::for_hire);
  EXPECT_EQ(car.meter->record().shift_begin, no_time);
  car.meter->power_fails();
  MeterBench again(settings, &memory);
  EXPECT_EQ(again.meter->record().total.income, 3500u) << "it is of this version now";
}

TEST(TaximeterPower, TotalsAreOfOneMomentWhereverItIsCut) {
  // After each write in turn: nothing; signed on; hired (its initial fare, since the trip ends with
  // power); stopped or for hire; and again.
  using enum Taximeter;
  const Found moments[] = {{0, 0, 0, 0, signed_off},        {0, 0, 0, 0, for_hire},
                           {1, 3000, 3000, 3000, for_hire}, {1, 3200, 3200, 3200, for_hire},
                           {2, 6200, 6200, 6200, for_hire}, {2, 6400, 6900, 6400, for_hire}};
  std::uint64_t steps = 0;
  after_cut(SimulatedFlash::no_limit / 2, Tear::nothing, &steps);
  ASSERT_GT(steps, 5000u);
  std::size_t reached = 0;
  std::set<Found> seen;
  const std::uint64_t stride = tries_all() ? 1 : 3;
  for (std::uint64_t cut = 0; cut <= steps; cut += stride) {
    const Found found = found_in(after_cut(cut, Tear::nothing));
    seen.insert(found);
    const auto* place = std::find(std::begin(moments), std::end(moments), found);
    ASSERT_NE(place, std::end(moments)) << "cut at byte " << cut;
    const auto moment = static_cast<std::size_t>(place - std::begin(moments));
    ASSERT_GE(moment, reached) << "what was kept is lost at byte " << cut;
    reached = moment;
  }
  EXPECT_EQ(seen.size(), std::size(moments));
}

TEST(TaximeterPower, ATornByteIsNoDamageEither) {
  std::uint64_t steps = 0;
  after_cut(SimulatedFlash::no_limit / 2, Tear::nothing, &steps);
  const std::uint64_t stride = tries_all() ? 3 : 7;
  for (std::uint64_t cut = 0; cut <= steps; cut += stride) {
    const Found found = found_in(after_cut(cut, Tear::some_bits));
    ASSERT_TRUE(found.fare == 0 || found.fare == 3000 || found.fare == 3200 || found.fare == 6200 ||
                found.fare == 6400)
        << found.fare << " at byte " << cut;
  }
}

TEST(TaximeterPower, ATripGoesOnAfterAShortCut) {
  SimulatedFlash memory(MeterBench::geometry);
  {
    MeterBench car(settings, &memory);
    car.begin_shift();
    car.meter->hire();
    car.drive(10, 100);
    car.meter->add_supplement(100);
    car.meter->power_fails();
  }
  SimulatedFlash same(MeterBench::geometry, memory.bytes);
  MeterBench car(settings, &same, MeterBench::noon + 40);
  EXPECT_EQ(car.meter->state(), Taximeter::hired);
  EXPECT_EQ(car.get(0x60D0, 1), 3000u + 20'000u) << "10 km at 2,00: nothing for the cut";
  EXPECT_EQ(car.get(0x60D0, 2), 100u);
  EXPECT_EQ(car.get(0x60D2, 1), 10u);
  EXPECT_EQ(car.get(0x60D2, 3), MeterBench::noon - 3600);
  car.turned = 0;
  car.send_count(0);
  car.drive(10, 100);
  car.meter->stop();
  EXPECT_EQ(car.get(0x60D0, 1), 3000u + 40'000u);
  EXPECT_EQ(car.get(0x60D9, 7), 1u);
}

TEST(TaximeterPower, ATripEndsWithALongCutAsItWas) {
  SimulatedFlash memory(MeterBench::geometry);
  {
    MeterBench car(settings, &memory);
    car.begin_shift();
    car.meter->hire();
    car.drive(10, 100);
    car.meter->power_fails();
  }
  SimulatedFlash same(MeterBench::geometry, memory.bytes);
  MeterBench car(settings, &same, MeterBench::noon + 41);
  EXPECT_EQ(car.meter->state(), Taximeter::for_hire);
  EXPECT_EQ(car.get(0x60D0, 1), 23'000u);
  EXPECT_EQ(car.get(0x60D2, 4), MeterBench::noon - 3600 + 10) << "when power failed";
  EXPECT_EQ(car.get(0x60D9, 0x0B), 23'000u);
  EXPECT_EQ(car.get(0x60D9, 1), 10'000u);
}

/// Power comes back, the trip has ended, and while that is written power fails again, and again.
TEST(TaximeterPower, ATripThatEndsWithACutIsAddedOnceHoweverOftenPowerFails) {
  SimulatedFlash memory(MeterBench::geometry, of_a_new_meter());
  {
    MeterBench car(settings, &memory);
    car.begin_shift();
    car.meter->hire();
    car.drive(10, 100);
    car.meter->add_supplement(700);
    car.meter->power_fails();
  }
  const Found expected = {1, 23'000, 23'700, 23'000, Taximeter::for_hire};
  for (std::uint64_t cut = 0; cut <= 1200; ++cut) {
    for (const Tear tear : {Tear::nothing, Tear::some_bits}) {
      SimulatedFlash::Bytes bytes = memory.bytes;
      for (unsigned time = 0; time < 2; ++time) {
        SimulatedFlash same(MeterBench::geometry, bytes);
        same.cut_after(cut, tear);
        MeterBench car(settings, &same, MeterBench::noon + 3600);
        car.cable().run_for(10ms);
        bytes = same.bytes;
      }
      ASSERT_EQ(found_in(bytes), expected) << "cut at byte " << cut;
    }
  }
}

TEST(TaximeterPower, WithoutAClockACutIsALongOne) {
  SimulatedFlash memory(MeterBench::geometry);
  {
    MeterBench car(settings, &memory, std::nullopt);
    car.begin_shift();
    car.meter->hire();
    car.drive(1, 100);
    car.meter->power_fails();
  }
  SimulatedFlash same(MeterBench::geometry, memory.bytes);
  MeterBench car(settings, &same, std::nullopt);
  EXPECT_EQ(car.meter->state(), Taximeter::for_hire);
  EXPECT_EQ(car.get(0x60D9, 0x0B), 5000u);
}

TEST(TaximeterPower, WithoutAWarningAMinuteAtMostIsMissing) {
  SimulatedFlash memory(MeterBench::geometry);
  {
    MeterBench car(settings, &memory);
    car.begin_shift();
    car.drive(150, 100);
  }
  SimulatedFlash same(MeterBench::geometry, memory.bytes);
  MeterBench car(settings, &same);
  EXPECT_GE(car.get(0x60D9, 1), 90'000u);
  EXPECT_LE(car.get(0x60D9, 1), 150'000u);
}

TEST(TaximeterPower, WhatIsBehindTheSealIsKept) {
  SimulatedFlash memory(MeterBench::geometry);
  {
    MeterBench car(settings, &memory);
    car.send_count(0);
    car.ask_as(1, "2F 54 60 00 02 00 00 00");
    car.seal_is_open = true;
    car.meter->enter_service();
    car.meter->set_k(1234);
    car.seal_is_open = false;
    car.meter->leave_service();
    car.cable().run_for(1s);
  }
  SimulatedFlash same(MeterBench::geometry, memory.bytes);
  MeterBench car(settings, &same);
  EXPECT_EQ(car.get(0x60DA, 1), 1234u);
  EXPECT_EQ(car.get(0x60DA, 6), MeterBench::noon - 3600);
  car.ask_as(1, "2F 54 60 00 03 00 00 00");
  EXPECT_EQ(car.cable().last(0x085), "085#00 FF 21 01 02 03 00 00");
  car.cable().run_for(1s);
  SimulatedFlash again(MeterBench::geometry, same.bytes);
  MeterBench later(settings, &again);
  later.meter->sign_on();
  EXPECT_FALSE(later.meter->hire()) << "power does not mend it";
}

TEST(TaximeterPower, DamagedTotalsAreAFailureUntilItIsSealedAnew) {
  SimulatedFlash::Bytes bytes = after_cut(SimulatedFlash::no_limit / 2, Tear::nothing);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(byte & 0x7F);
  SimulatedFlash memory(MeterBench::geometry, bytes);
  MeterBench car(settings, &memory);
  EXPECT_EQ(car.get(0x60D9, 1), 0xFFFF'FFFEu);
  EXPECT_EQ(car.get(0x60D9, 0x0C), 0xFFFF'FFFEu);
  car.cable().run_for(5s);
  EXPECT_EQ(car.get(0x60D9, 1), 0xFFFF'FFFEu);
  car.seal_is_open = true;
  car.meter->enter_service();
  car.seal_is_open = false;
  car.meter->leave_service();
  EXPECT_EQ(car.get(0x60D9, 1), 0u);
}

TEST(TaximeterPower, AMemoryThatDoesNotTakeItIsAnError) {
  SimulatedFlash memory(MeterBench::geometry);
  MeterBench car(settings, &memory);
  memory.fail_erase = true;
  car.begin_shift();
  car.cable().run_for(1s);
  EXPECT_EQ(car.cable().last(0x085), "085#00 FF 21 04 00 00 00 00");
  memory.fail_erase = false;
  car.meter->hire();
  car.cable().run_for(1s);
  EXPECT_EQ(car.cable().last(0x085), "085#00 00 00 00 00 00 00 00");
}

TEST(TaximeterPower, NobodyWaitsForASlowFlash) {
  SimulatedFlash memory(MeterBench::geometry);
  memory.busy_polls = 20;
  MeterBench car(settings, &memory);
  car.begin_shift();
  car.meter->hire();
  car.drive(1, 10);
  car.meter->stop();
  car.meter->for_hire();
  car.cable().run_for(5s);
  EXPECT_EQ(memory.violations, 0u);
  EXPECT_EQ(found_in(memory.bytes), (Found{1, 3200, 3200, 3200, Taximeter::for_hire}));
}

}  // namespace
}  // namespace canvoy::cia447::taximeter_power_test
