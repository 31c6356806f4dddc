#include "canvoy/formats/gtfs/feed_archive.hpp"

#include <gtest/gtest.h>
#include <zip.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <utility>

namespace canvoy::gtfs::feed_archive_test {
namespace {

using Entry = std::pair<std::string, std::string>;

/// A zip archive as libzip makes it.
std::vector<std::uint8_t> zip_of(const std::vector<Entry>& entries) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(target);
  zip_t* const archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  for (const auto& [name, text] : entries) {
    zip_source_t* const content = zip_source_buffer(archive, text.data(), text.size(), 0);
    EXPECT_GE(zip_file_add(archive, name.c_str(), content, ZIP_FL_ENC_UTF_8), 0);
  }
  EXPECT_EQ(zip_close(archive), 0);
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(zip_source_open(target), 0);
  std::array<std::uint8_t, 4096> piece{};
  for (zip_int64_t count = 0; (count = zip_source_read(target, piece.data(), piece.size())) > 0;) {
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + count);
  }
  zip_source_close(target);
  zip_source_free(target);
  return bytes;
}

/// The content of a file, read in pieces of 7 bytes; or the error.
std::string content(const FeedArchive& archive, std::string_view name) {
  host::Result<FeedFile> file = archive.file(name);
  if (!file) return "error: " + file.error().line();
  if (!file->is_there()) return "not there";
  std::string text;
  std::array<char, 7> room{};
  while (true) {
    const host::Result<std::size_t> count = file->read(room);
    if (!count) return "error: " + count.error().line();
    if (*count == 0) return text;
    text.append(room.data(), *count);
  }
}

TEST(FeedArchive, AZipFileHasTheFilesThatWerePacked) {
  const std::vector<std::uint8_t> bytes =
      zip_of({{"stops.txt", "stop_id\n1\n"}, {"empty.txt", ""}});
  const host::Result<FeedArchive> archive = FeedArchive::of_zip(bytes, "feed.zip");
  ASSERT_TRUE(archive);
  EXPECT_EQ(content(*archive, "stops.txt"), "stop_id\n1\n");
  EXPECT_EQ(content(*archive, "empty.txt"), "");
  EXPECT_EQ(content(*archive, "shapes.txt"), "not there");
}

TEST(FeedArchive, AZipFileMayHoldTheFolder) {
  const std::vector<std::uint8_t> bytes = zip_of({{"my feed/stops.txt", "a\n"}});
  const host::Result<FeedArchive> archive = FeedArchive::of_zip(bytes, "feed.zip");
  ASSERT_TRUE(archive);
  EXPECT_EQ(content(*archive, "stops.txt"), "a\n");
}

TEST(FeedArchive, AByteThatIsWrongInAZipFileIsSeen) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += std::to_string(i * 7919) + "\n";
  std::vector<std::uint8_t> bytes = zip_of({{"stops.txt", text}});
  bytes[bytes.size() / 2] ^= 0x10U;
  const host::Result<FeedArchive> archive = FeedArchive::of_zip(bytes, "feed.zip");
  ASSERT_TRUE(archive);
  EXPECT_TRUE(content(*archive, "stops.txt").starts_with("error: feed.zip/stops.txt: "))
      << content(*archive, "stops.txt");
}

TEST(FeedArchive, WhatIsNoZipFileIsRefusedInOneLine) {
  const std::vector<std::uint8_t> bytes(100, 'x');
  const host::Result<FeedArchive> archive = FeedArchive::of_zip(bytes, "feed.zip");
  ASSERT_FALSE(archive);
  EXPECT_EQ(archive.error().line(),
            "feed.zip: no zip archive that can be read: Not a zip archive; give a folder or a zip "
            "file with the .txt files of a GTFS feed");
}

TEST(FeedArchive, FoldersAndFilesAreOpenedByTheirPaths) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "canvoy_feed_archive_test";
  std::filesystem::create_directories(folder / "trips.txt");
  std::ofstream(folder / "stops.txt") << "stop_id\n";
  const std::vector<std::uint8_t> bytes = zip_of({{"stops.txt", "zipped\n"}});
  std::ofstream(folder / "feed.zip", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));

  const host::Result<FeedArchive> archive = FeedArchive::open(folder.string());
  ASSERT_TRUE(archive);
  EXPECT_EQ(content(*archive, "stops.txt"), "stop_id\n");
  EXPECT_EQ(content(*archive, "shapes.txt"), "not there");
  EXPECT_EQ(content(*archive, "trips.txt"),
            "error: " + (folder / "trips.txt").string() + ": no plain file");
  const host::Result<FeedArchive> zipped = FeedArchive::open((folder / "feed.zip").string());
  ASSERT_TRUE(zipped);
  EXPECT_EQ(content(*zipped, "stops.txt"), "zipped\n");
  const host::Result<FeedArchive> missing = FeedArchive::open((folder / "none").string());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().line(), (folder / "none").string() + ": No such file or directory");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace canvoy::gtfs::feed_archive_test
