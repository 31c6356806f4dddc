// Seats that move, store and recall, at the wire (CiA 447-3, 4.2.2.12 and 4.2.2.13). Fields from
// bit 0: six ways of 2 bits, recall and store of 3 bits, reserved; PDO 6 is 385h of node 5.
#include "canvoy/devices/cia447/ivn_gateway/car_seats.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/ivn_gateway/car_on_bench_test.hpp"

namespace canvoy::cia447::car_seats_test {
namespace {

struct CarSeatsUnit : testing::Test, CarOnBench {
  Cable& cable = bench.cable;

  std::string command(unsigned seat, const std::string& bytes) {
    return ask("27 18 60 0" + std::to_string(seat) + " " + bytes + " 00");
  }
  std::string status(unsigned seat) {
    return ask("40 19 60 0" + std::to_string(seat) + " 00 00 00 00").substr(12, 8);
  }
};

TEST_F(CarSeatsUnit, ACommandMovesASeatForHalfASecond) {
  command(1, "FC FF FF");  // forward
  EXPECT_EQ(cable.last(0x385), "385#FC 0F FC FF 0F FC");
  cable.run_for(499ms);
  EXPECT_EQ(status(1), "FC 0F FC");
  cable.run_for(1ms);
  EXPECT_EQ(status(1), "FF 0F FC") << "at rest there is no code but 3 (errata C1)";
  EXPECT_EQ(gateway().seats().position(1, CarSeats::length), 60);
  EXPECT_EQ(gateway().seats().position(2, CarSeats::length), 50);
}

TEST_F(CarSeatsUnit, ItStopsAtItsEnd) {
  for (int i = 0; i < 7; ++i) {
    command(2, "F7 FF FF");  // down
    cable.run_for(500ms);
  }
  EXPECT_EQ(gateway().seats().position(2, CarSeats::height), 0);
  command(2, "F7 FF FF");
  EXPECT_EQ(status(2), "FF 0F FC");
}

TEST_F(CarSeatsUnit, AMemoryBringsItBack) {
  command(1, "FC FF FF");
  cable.run_for(500ms);
  command(1, "FF FF FC");  // store memory 1: bits 17 to 15
  EXPECT_EQ(status(1), "FF 8F FC");
  command(1, "FD F7 FF");  // back, and the headrest (bits 11 and 10) down
  cable.run_for(500ms);
  EXPECT_EQ(status(1), "FF 0F FC") << "it is where nothing was stored";
  command(1, "FF 9F FF");  // recall memory 1: bits 14 to 12
  EXPECT_EQ(status(1), "FC 03 FC") << "forward and up at once";
  cable.run_for(499ms);
  EXPECT_EQ(status(1), "FC 03 FC");
  cable.run_for(1ms);
  EXPECT_EQ(status(1), "FF 1F FC") << "memory 1 recalled";
  EXPECT_EQ(gateway().seats().position(1, CarSeats::length), 60);
  EXPECT_EQ(gateway().seats().position(1, CarSeats::headrest), 50);
  EXPECT_EQ(status(2), "FF 0F FC");
}

TEST_F(CarSeatsUnit, FourMemoriesAreApart) {
  static constexpr const char* store[] = {"FF FF FC", "FF 7F FD", "FF FF FD", "FF 7F FE"};
  static constexpr const char* recall[] = {"FF 9F FF", "FF AF FF", "FF BF FF", "FF CF FF"};
  static constexpr const char* recalled[] = {"FF 1F FC", "FF 2F FC", "FF 3F FC", "FF 4F FC"};
  for (unsigned memory = 0; memory < 4; ++memory) {
    command(1, "FC FF FF");
    cable.run_for(500ms);
    EXPECT_EQ(command(1, store[memory]), "60 18 60 01 00 00 00 00");
  }
  for (unsigned memory = 0; memory < 4; ++memory) {
    command(1, recall[memory]);
    cable.run_for(3s);
    EXPECT_EQ(gateway().seats().position(1, CarSeats::length), 60 + 10 * static_cast<int>(memory));
    EXPECT_EQ(status(1), recalled[memory]);
  }
}

TEST_F(CarSeatsUnit, AnEmptyMemoryMovesNothing) {
  command(1, "FF AF FF");  // recall memory 2
  EXPECT_EQ(status(1), "FF 0F FC");
  cable.run_for(5s);
  EXPECT_EQ(status(1), "FF 0F FC");
}

class KeptMemories {
 public:
  SeatStore store() {
    return {.load = callback<&KeptMemories::load>(*this),
            .store = callback<&KeptMemories::keep>(*this)};
  }

  SeatMemories kept;
  unsigned stored = 0;

 private:
  SeatMemories load() { return kept; }
  void keep(const SeatMemories& memories) {
    kept = memories;
    ++stored;
  }
};

TEST_F(CarSeatsUnit, AMemoryOutlivesALossOfPower) {
  KeptMemories memories;
  gateway().seats().keep_in(memories.store());
  command(2, "FC FF FF");
  cable.run_for(500ms);
  command(2, "FF 7F FD");  // store memory 2
  EXPECT_EQ(memories.stored, 1u);
  CarOnBench again;
  again.gateway().seats().keep_in(memories.store());
  again.ask("27 18 60 02 FF AF FF 00");  // recall memory 2
  again.bench.cable.run_for(500ms);
  EXPECT_EQ(again.gateway().seats().position(2, CarSeats::length), 60);
  EXPECT_EQ(again.gateway().seats().position(1, CarSeats::length), 50);
  EXPECT_EQ(again.ask("40 19 60 02 00 00 00 00").substr(12, 8), "FF 2F FC");
  EXPECT_EQ(memories.stored, 1u) << "a recall changes no memory";
}

TEST_F(CarSeatsUnit, WhatWasKeptBeyondTheEndIsTheEnd) {
  KeptMemories memories;
  memories.kept.of_seat[0][0] = {true, {255, 101, 100, 0, 50, 50}};
  gateway().seats().keep_in(memories.store());
  command(1, "FF 9F FF");
  cable.run_for(5s);
  EXPECT_EQ(status(1), "FF 1F FC");
  EXPECT_EQ(gateway().seats().position(1, CarSeats::length), 100);
  EXPECT_EQ(gateway().seats().position(1, CarSeats::height), 100);
  EXPECT_EQ(gateway().seats().position(1, CarSeats::tight_support), 0);
}

TEST_F(CarSeatsUnit, RecallNoMemoryStopsARecall) {
  command(1, "FF FF FC");
  command(1, "FC FF FF");
  cable.run_for(500ms);
  command(1, "FF 9F FF");
  cable.run_for(250ms);
  command(1, "FF 8F FF");
  EXPECT_EQ(status(1), "FF 0F FC");
  EXPECT_EQ(gateway().seats().position(1, CarSeats::length), 55);
}

TEST_F(CarSeatsUnit, AHandOnTheSwitchEndsARecall) {
  command(1, "FF FF FC");
  command(1, "FC FF FF");
  cable.run_for(500ms);
  command(1, "FF 9F FF");
  cable.run_for(250ms);
  command(1, "F3 FF FF");  // up
  EXPECT_EQ(status(1), "F3 0F FC");
  cable.run_for(5s);
  EXPECT_EQ(gateway().seats().position(1, CarSeats::length), 55);
  EXPECT_EQ(gateway().seats().position(1, CarSeats::height), 60);
  EXPECT_EQ(status(1), "FF 0F FC");
}

TEST_F(CarSeatsUnit, WhatTheHardwareReportsOfASeatIsTold) {
  gateway().report(seat_adjustment_status_up_down, SeatHeight::down);
  FieldPlace stored = place_of(seat_adjustment_status_store_memory);
  stored.sub = 2;
  gateway().report(stored, 6);
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x385), "385#F7 0F FC FF 0F FF") << "down (1); memory fails (6, errata A9)";
}

TEST_F(CarSeatsUnit, ReservedCodesAreRefused) {
  EXPECT_EQ(command(1, "FE FF FF"), "80 18 60 01 30 00 09 06");
  EXPECT_EQ(command(1, "FF DF FF"), "80 18 60 01 30 00 09 06") << "recall memory 5";
  EXPECT_EQ(command(2, "FF FF FE"), "80 18 60 02 30 00 09 06") << "store memory 5";
  EXPECT_EQ(command(2, "FF EF FF"), "80 18 60 02 30 00 09 06");
  EXPECT_EQ(status(1), "FF 0F FC");
}

}  // namespace
}  // namespace canvoy::cia447::car_seats_test
