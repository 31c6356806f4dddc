// Pictures of the displays of a bus: one for each change.
#include "canvoy/tools/play/display_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "canvoy/profiles/cia407/passenger_information.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::display_folder_test {
namespace {

class DisplayPictures : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove_all(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::size_t pictures_of(const std::string& name) const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      count += entry.path().filename().string().starts_with(name + "-") ? 1U : 0U;
    }
    return count;
  }
  std::string bytes_of(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void look_until(Time until) {
    for (; at_ <= until; at_ += DisplayFolder::period) {
      network_.run_until(at_);
      displays_->look(network_);
    }
  }

  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                  (std::string("canvoy-displays-") +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
  bus_line::BusNetwork network_{{}};
  std::optional<DisplayFolder> displays_;
  Time at_{};
};

TEST_F(DisplayPictures, OneForEachThingThatIsRead) {
  displays_.emplace(folder_.string());
  look_until(Time(4min));
  // Dark until boot-up, and then the stop at which the bus stands.
  EXPECT_EQ(pictures_of("next-stop"), 2u);
  EXPECT_EQ(pictures_of("second-next-stop"), 2u);
  EXPECT_EQ(displays_->written(), 12u) << "six displays";
  EXPECT_NE(bytes_of("next-stop-0001.png"), bytes_of("next-stop-0002.png"));
  EXPECT_EQ(bytes_of("next-stop-0001.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
}

/// 6203h:02h with the flash speed "fast" in the format byte, and its update by sub-index 01h (CiA
/// 407, 9.2.8.4).
TEST_F(DisplayPictures, WhatFlashesIsLitAndDarkInTurn) {
  displays_.emplace(folder_.string());
  look_until(Time(4min));
  const bus_line::BusNode& node = network_.node(bus_line::next_stop_id);
  const ControllerId somebody = network_.world().bus(node.bus()).attach({});
  const auto write = [&](std::uint8_t sub, std::uint32_t value) {
    Frame frame = Frame::data_frame(0x605, {0x23, 0x03, 0x62, sub, 0, 0, 0, 0});
    for (unsigned i = 0; i < 4; ++i) frame.data[4 + i] = static_cast<std::uint8_t>(value >> 8 * i);
    network_.world().bus(node.bus()).send(somebody, frame);
    network_.run_until(network_.now() + 10ms);
  };
  constexpr std::uint32_t fast = 3U << 6;
  const Dictionary& has = network_.node(bus_line::next_stop_id).node().dictionary();
  write(2, has.word(cia407::display_mapping_object.index, 2) |
               fast << cia407::display_by_bit_number.format);
  write(1, 1);
  const std::size_t before = pictures_of("next-stop");
  look_until(Time(4min + 2s));
  EXPECT_EQ(pictures_of("next-stop") - before, 7u)
      << "of eight looks the first finds it lit, as it was";
}

TEST_F(DisplayPictures, AFolderWithPicturesIsRefused) {
  std::filesystem::create_directories(folder_);
  std::ofstream(folder_ / "old.png") << "x";
  EXPECT_THROW(DisplayFolder(folder_.string()), UsageError);
}

}  // namespace
}  // namespace canvoy::tools::display_folder_test
