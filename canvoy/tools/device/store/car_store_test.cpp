// The file of the gateway of a car.
#include "canvoy/tools/device/store/car_store.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace canvoy::tools::car_store_test {
namespace {

class CarStoreTest : public testing::Test {
 public:
  CarStoreTest() {
    std::string name = (std::filesystem::temp_directory_path() / "canvoy_XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  ~CarStoreTest() override { std::filesystem::remove_all(folder); }

  std::string path() const { return (folder / "gateway.store").string(); }
  cia447::KnownDevices load() {
    CarStore store(path());
    return store.memory().load();
  }
  void keep(const cia447::KnownDevices& known) {
    CarStore store(path());
    store.memory().load();
    store.memory().store(known);
  }

  std::filesystem::path folder;
};

cia447::KnownDevices two_devices() {
  cia447::KnownDevices known;
  known.is_known[0] = known.is_known[14] = true;
  known.addresses[0].parts = {1, 2, 3, 4};
  known.addresses[14].parts = {0xFFFFFFFF, 0x80000000, 0, 0x12345678};
  return known;
}

TEST_F(CarStoreTest, HasNobodyAtFirst) {
  EXPECT_EQ(load().find({{1, 2, 3, 4}}), std::nullopt);
}

TEST_F(CarStoreTest, KnowsTheNodeIdsThatWereGiven) {
  keep(two_devices());
  EXPECT_EQ(load().find({{1, 2, 3, 4}}), 2) << "the first add-on device is node 2";
  EXPECT_EQ(load().find({{0xFFFFFFFF, 0x80000000, 0, 0x12345678}}), 16);
  EXPECT_EQ(load().find({}), std::nullopt) << "a node-ID that nobody has";
}

TEST_F(CarStoreTest, TheLatestOneCounts) {
  keep(two_devices());
  cia447::KnownDevices known = two_devices();
  known.is_known[0] = false;
  keep(known);
  EXPECT_EQ(load().find({{1, 2, 3, 4}}), std::nullopt);
}

TEST_F(CarStoreTest, HasTheMemoriesOfSeatsBesideThem) {
  cia447::SeatMemories memories;
  memories.of_seat[0][3] = {true, {100, 0, 50, 1, 2, 3}};
  memories.of_seat[1][0] = {true, {6, 5, 4, 3, 2, 1}};
  EXPECT_EQ(CarStore(path()).seats().load(), cia447::SeatMemories{});
  keep(two_devices());
  CarStore(path()).seats().store(memories);
  EXPECT_EQ(CarStore(path()).seats().load(), memories);
  EXPECT_EQ(load().find({{1, 2, 3, 4}}), 2);
  memories.of_seat[0][0].is_used = true;
  CarStore(path()).seats().store(memories);
  CarStore(path()).seats().store(memories);
  EXPECT_EQ(CarStore(path()).seats().load(), memories) << "who has not read writes behind the last";
}

TEST_F(CarStoreTest, WhatIsDamagedIsAsIfNobodyHadBeenNamed) {
  keep(two_devices());
  std::fstream file(path(), std::ios::in | std::ios::out | std::ios::binary);
  // Part of the identity of node 2, after the heads of file and record.
  file.seekp(host::FileFlash::head_size + 4 * 4096 + 0x28);
  file.write("XXXX", 4);
  file.close();
  EXPECT_EQ(load().find({{1, 2, 3, 4}}), std::nullopt);
}

}  // namespace
}  // namespace canvoy::tools::car_store_test
