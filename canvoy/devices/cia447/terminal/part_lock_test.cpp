// Holder of a part of the terminal: the codes of the tables of 4.2.9.
#include "canvoy/devices/cia447/terminal/part_lock.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia447::part_lock_test {
namespace {

constexpr unsigned code(const PartLock& lock) {
  return static_cast<unsigned>(lock.access());
}

TEST(PartLock, IsTheVehiclesAtFirst) {
  const PartLock sut;
  EXPECT_FALSE(sut.is_held());
  EXPECT_FALSE(sut.is_held_by(0)) << "nobody is no holder";
  EXPECT_EQ(code(sut), 0x01u);
}

TEST(PartLock, TheStatusTellsWhichOfTheSixteenDevicesHasIt) {
  for (unsigned node_id = 1; node_id <= 16; ++node_id) {
    PartLock sut;
    EXPECT_EQ(sut.command(AccessCommand::lock, node_id), AbortCode::none);
    EXPECT_EQ(code(sut), 0x01u + node_id) << "02h is device 1, 11h is device 16";
    EXPECT_TRUE(sut.is_held_by(node_id));
  }
}

TEST(PartLock, HasNoCodeForOtherNodes) {
  for (const unsigned node_id : {0u, 17u, 127u, 255u}) {
    PartLock sut;
    EXPECT_EQ(sut.command(AccessCommand::lock, node_id), AbortCode::device_state) << node_id;
    EXPECT_EQ(code(sut), 0x01u);
    EXPECT_EQ(sut.command(AccessCommand::release, node_id), AbortCode::none) << "held by nobody";
  }
}

TEST(PartLock, RefusesAnotherOneWhileItIsHeld) {
  PartLock sut;
  sut.command(AccessCommand::lock, 4);
  for (const AccessCommand command :
       {AccessCommand::lock, AccessCommand::lock_for_iso_tp, AccessCommand::release}) {
    EXPECT_EQ(sut.command(command, 7), AbortCode::device_state);
    EXPECT_TRUE(sut.is_held_by(4));
  }
  EXPECT_EQ(sut.command(AccessCommand::do_not_care, 7), AbortCode::none);
  EXPECT_TRUE(sut.is_held_by(4));
}

TEST(PartLock, TheHolderMayLockAgainAndLetGo) {
  PartLock sut;
  sut.command(AccessCommand::lock, 4);
  EXPECT_EQ(sut.command(AccessCommand::lock, 4), AbortCode::none);
  EXPECT_EQ(sut.command(AccessCommand::do_not_care, 4), AbortCode::none);
  EXPECT_TRUE(sut.is_held_by(4));
  EXPECT_EQ(sut.command(AccessCommand::release, 4), AbortCode::none);
  EXPECT_FALSE(sut.is_held());
  EXPECT_EQ(sut.command(AccessCommand::lock_for_iso_tp, 7), AbortCode::none);
  EXPECT_EQ(code(sut), 0x08u);
}

TEST(PartLock, AHolderThatDiesLosesIt) {
  PartLock sut;
  EXPECT_FALSE(sut.lose(4));
  EXPECT_FALSE(sut.lose(0)) << "nobody holds it, and nobody loses it";
  sut.command(AccessCommand::lock, 4);
  EXPECT_FALSE(sut.lose(7));
  EXPECT_TRUE(sut.is_held_by(4));
  EXPECT_TRUE(sut.lose(4));
  EXPECT_EQ(code(sut), 0x01u);
}

TEST(PartLock, CheckingChangesNothing) {
  PartLock sut;
  EXPECT_EQ(sut.check(AccessCommand::lock, 4), AbortCode::none);
  EXPECT_FALSE(sut.is_held());
}

}  // namespace
}  // namespace canvoy::cia447::part_lock_test
