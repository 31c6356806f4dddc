#include "canvoy/tools/page/recorder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {
namespace {

class RecorderTest : public testing::Test {
 protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = testing::TempDir() + "canvoy_recorder_" + name;
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string text(const std::string& file) const {
    std::ifstream in(folder_ + "/" + file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::string folder_;
};

TEST_F(RecorderTest, NothingIsWrittenWithoutLeave) {
  Recorder recorder;
  EXPECT_THROW(recorder.begin({}), UsageError);
  EXPECT_THROW(recorder.allow(folder_ + "/none"), UsageError);
  EXPECT_FALSE(recorder.is_allowed());
}

TEST_F(RecorderTest, FramesBetweenBeginAndEndAreInTheLog) {
  Recorder recorder;
  recorder.allow(folder_);
  recorder.hear(Time{} + 1s, "can0", Frame::data_frame(0x701, {0x05}));
  recorder.begin(10s);
  recorder.hear(Time{} + 2s, "can0", Frame::data_frame(0x181, {0x1E, 0x2F}));
  EXPECT_EQ(recorder.json()["frames"], 1);
  EXPECT_EQ(recorder.json()["on"], true);
  recorder.end();
  recorder.hear(Time{} + 3s, "can0", Frame::data_frame(0x080, {0x00}));
  EXPECT_EQ(recorder.json()["on"], false);
  // In the format of candump -l of can-utils.
  EXPECT_EQ(text("canvoy-1.log"), "(0000000012.000000) can0 181#1E2F\n");
}

TEST_F(RecorderTest, NoFileIsWrittenOver) {
  std::ofstream(folder_ + "/canvoy-1.log") << "of yesterday\n";
  Recorder recorder;
  recorder.allow(folder_);
  recorder.begin({});
  recorder.hear(Time{}, "can0", Frame::data_frame(0x080, {0x00}));
  recorder.end();
  EXPECT_EQ(text("canvoy-1.log"), "of yesterday\n");
  EXPECT_EQ(text("canvoy-2.log"), "(0000000000.000000) can0 080#00\n");
  EXPECT_EQ(recorder.json()["file"], folder_ + "/canvoy-2.log");
}

TEST_F(RecorderTest, OneLogAtATime) {
  Recorder recorder;
  recorder.allow(folder_);
  recorder.begin({});
  EXPECT_THROW(recorder.begin({}), UsageError);
}

}  // namespace
}  // namespace canvoy::tools
