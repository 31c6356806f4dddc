// PNG files, read back by libpng.
#include "canvoy/tools/cli/png_file.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <filesystem>
#include <fstream>

#include "canvoy/devices/cia447/printer/print_stream.hpp"
#include "canvoy/sim/plants/paper_picture.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::png_file_test {
namespace {

struct ReadBack {
  unsigned width = 0;
  unsigned height = 0;
  std::vector<std::uint8_t> bytes;
};
ReadBack read_back(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ReadBack read;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return read;
  EXPECT_EQ(image.format & PNG_FORMAT_FLAG_ALPHA, 0u);
  image.format = PNG_FORMAT_RGB;
  read.width = image.width;
  read.height = image.height;
  read.bytes.resize(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, read.bytes.data(), 0, nullptr), 0);
  return read;
}

class PngFile : public testing::Test {
 protected:
  PngFile() { std::filesystem::create_directories(folder); }
  ~PngFile() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) /
      (std::string("canvoy-png-") + testing::UnitTest::GetInstance()->current_test_info()->name());
  std::string path = folder / "receipt.png";
};

TEST_F(PngFile, EachDotComesBack) {
  Picture picture(3);
  picture.grow(2);
  picture.darken(0, 0, {.red = 0x12, .green = 0x34, .blue = 0x56});
  picture.darken(2, 1, {.red = 0xFF, .green = 0x00, .blue = 0x80});
  write_png(path, picture);
  const ReadBack read = read_back(path);
  EXPECT_EQ(read.width, 3u);
  EXPECT_EQ(read.height, 2u);
  EXPECT_EQ(read.bytes,
            (std::vector<std::uint8_t>{0x12, 0x34, 0x56, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF,
                                       0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0x80}));
}

TEST_F(PngFile, AReceiptComesBack) {
  PaperPicture paper(384);
  cia447::PrintStream stream(paper.paper(), {.dots_per_line = 384});
  for (const char byte : std::string_view("TAXI\n12,40 €\n\x04")) {
    stream.write(static_cast<std::uint8_t>(byte));
  }
  write_png(path, paper.receipts().front());
  const ReadBack read = read_back(path);
  EXPECT_EQ(read.width, 384u);
  EXPECT_EQ(read.height, 32u);
  EXPECT_EQ(read.bytes, paper.receipts().front().bytes());
}

TEST_F(PngFile, NoiseIsLongerThanItWasAndComesBack) {
  Picture picture(64);
  picture.grow(64);
  std::uint32_t noise = 1;
  const auto next = [&noise] {
    noise = noise * 1'664'525 + 1'013'904'223;
    return static_cast<std::uint8_t>(noise >> 24);
  };
  for (std::size_t y = 0; y < 64; ++y) {
    for (std::size_t x = 0; x < 64; ++x) picture.darken(x, y, {next(), next(), next()});
  }
  write_png(path, picture);
  EXPECT_EQ(read_back(path).bytes, picture.bytes());
}

TEST_F(PngFile, AnEmptyPictureIsNoFile) {
  EXPECT_THROW(write_png(path, Picture(384)), Failure);
  EXPECT_THROW(write_png(path, Picture(0)), Failure);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(PngFile, WhereItCannotBeWrittenTheUserIsToldWhere) {
  const std::string nowhere = folder / "missing" / "receipt.png";
  Picture picture(1);
  picture.grow(1);
  try {
    write_png(nowhere, picture);
    FAIL() << "there is no such folder";
  } catch (const Failure& failure) {
    EXPECT_NE(std::string(failure.what()).find(nowhere), std::string::npos) << failure.what();
  }
}

}  // namespace
}  // namespace canvoy::tools::png_file_test
