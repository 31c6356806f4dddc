#include "canvoy/canopen/host/file_flash.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "canvoy/canopen/storage/testing/storage_node.hpp"

namespace canvoy::host::file_flash_test {
namespace {

constexpr FileFlash::Geometry geometry{.sector_size = 512, .sectors = 2};
constexpr Storage::Settings settings{.slot_size = 512, .groups = stored_groups};

class FileFlashTest : public testing::Test {
 protected:
  FileFlashTest() {
    std::string name = testing::TempDir() + "canvoy_flash_XXXXXX";
    folder = ::mkdtemp(name.data());
    path = folder + "/device.store";
  }
  ~FileFlashTest() override { std::filesystem::remove_all(folder); }

  std::unique_ptr<FileFlash> open() {
    auto file = FileFlash::open(path, geometry);
    EXPECT_TRUE(file) << (file ? "" : file.error().line());
    return file ? *std::move(file) : nullptr;
  }
  std::string error() {
    auto file = FileFlash::open(path, geometry);
    return file ? "none" : file.error().line().substr(folder.size() + 1);
  }
  std::string content() const {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void write(const std::string& text) const { std::ofstream(path, std::ios::binary) << text; }

  /// A node like WireNode, on the file.
  struct Device {
    explicit Device(const Flash& flash)
        : wire(stored_layout.tables(), 5), storage(wire.node, flash, settings) {
      wire.start();
    }
    AbortCode store() {
      AbortCode answer = AbortCode::general;
      auto done = [&](AbortCode code) { answer = code; };
      EXPECT_EQ(storage.store(1, Storage::Done::of(done)), AbortCode::none);
      wire.settle();
      return answer;
    }
    std::uint64_t get(std::uint16_t index) { return wire.node.dictionary().number(index, 0); }
    void set(std::uint16_t index, std::uint64_t value) {
      wire.node.dictionary().set_number(index, 0, value);
    }
    WireNode wire;
    Storage storage;
  };

  std::string folder;
  std::string path;
};

TEST_F(FileFlashTest, ANewFileIsErased) {
  const auto file = open();
  std::vector<std::uint8_t> bytes(1024);
  ASSERT_TRUE(file->flash().read(0, bytes));
  EXPECT_EQ(bytes, std::vector<std::uint8_t>(1024, 0xFF));
  EXPECT_EQ(content().substr(0, 31), "canvoy flash 1: 2 x 512 bytes  ");
  EXPECT_EQ(content().size(), 64U + 1024);
}

TEST_F(FileFlashTest, NothingElseIsLeftInTheFolder) {
  open();
  const auto entries = std::filesystem::directory_iterator(folder);
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

TEST_F(FileFlashTest, WhatADeviceStoresIsThereForTheNext) {
  for (unsigned number = 0; number < 5; ++number) {
    const auto file = open();
    Device device(file->flash());
    EXPECT_EQ(device.get(0x6000), number == 0 ? 100 : 600 + number - 1);
    device.set(0x6000, 600 + number);
    EXPECT_EQ(device.store(), AbortCode::none);
  }
}

TEST_F(FileFlashTest, AFileOfSomebodyElseIsRefusedAndLeftAsItIs) {
  for (const std::string text : {"", "root:x:0:0:root:/root:/bin/bash\n",
                                 "canvoy flash 1: 2 x 512 bytes", "canvoy flash 2: 2 x 512"}) {
    write(text);
    EXPECT_EQ(error(),
              "device.store: it is no store of this kind of device, and is left as it is; give the "
              "name of a new file");
    EXPECT_EQ(content(), text);
  }
}

TEST_F(FileFlashTest, AFileOfAnotherGeometryIsRefused) {
  { const auto other = FileFlash::open(path, {.sector_size = 512, .sectors = 4}); }
  EXPECT_NE(error(), "none");
}

TEST_F(FileFlashTest, AFolderADeviceAndAMissingFolderAreRefused) {
  path = folder + "/";
  EXPECT_NE(error(), "none");
  path = "/dev/null";
  EXPECT_FALSE(FileFlash::open(path, geometry));
  path = folder + "/missing/device.store";
  EXPECT_EQ(error(),
            "missing/device.store: No such file or directory; give a file in a folder that is "
            "there and can be written");
}

TEST_F(FileFlashTest, TwoDevicesDoNotShareAFile) {
  const auto first = open();
  EXPECT_EQ(error(),
            "device.store: another device has it open; give each device a file of its own");
}

TEST_F(FileFlashTest, AFileThatWasCutShortIsADamagedSetAndCanBeStoredTo) {
  {
    const auto file = open();
    Device device(file->flash());
    device.set(0x6000, 600);
    device.store();
    device.set(0x6000, 601);
    device.store();
  }
  const std::string whole = content();
  for (const std::size_t size : {64U, 64U + 40U, 64U + 512U, 64U + 512U + 40U}) {
    std::filesystem::resize_file(path, size);
    const auto file = open();
    Device device(file->flash());
    EXPECT_TRUE(device.storage.state() == RecordState::damaged || device.get(0x6000) == 600)
        << size;
    device.set(0x6000, 700);
    EXPECT_EQ(device.store(), AbortCode::none);
    Device again(file->flash());
    EXPECT_EQ(again.get(0x6000), 700U);
  }
}

TEST_F(FileFlashTest, AccessesBeyondTheEndFail) {
  const auto file = open();
  const Flash& sut = file->flash();
  std::vector<std::uint8_t> bytes(8);
  EXPECT_FALSE(sut.read(1020, bytes));
  EXPECT_FALSE(sut.read(0xFFFF'FFFF, bytes));
  EXPECT_EQ(sut.program(1020, bytes), FlashState::failed);
  EXPECT_EQ(sut.erase(1024), FlashState::failed);
  EXPECT_EQ(content().size(), 64U + 1024);
}

// A process that may not write beyond some byte of the file, like on a full disk.
TEST_F(FileFlashTest, AWriteThatFailsIsAHardwareErrorAndTheOldSetStays) {
  {
    const auto file = open();
    Device device(file->flash());
    device.set(0x6000, 600);
    ASSERT_EQ(device.store(), AbortCode::none);
  }
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{64 + 512 + 100, 64 + 512 + 100};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto file = open();
    Device device(file->flash());
    device.set(0x6000, 601);
    ::_exit(device.store() == AbortCode::hardware ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  const auto file = open();
  Device device(file->flash());
  EXPECT_EQ(device.get(0x6000), 600U);
  EXPECT_EQ(device.storage.state(), RecordState::valid);
}

}  // namespace
}  // namespace canvoy::host::file_flash_test
