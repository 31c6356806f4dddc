// Contents of a path while a file is written there, after it, and after a failure.
#include "canvoy/can/host/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

namespace canvoy::host::file_draft_test {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

class FileDraftTest : public testing::Test {
 protected:
  FileDraftTest() {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~FileDraftTest() override { fs::remove_all(folder); }

  static std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static Bytes bytes(std::string_view text) { return {text.begin(), text.end()}; }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder))
      found.push_back(entry.path().filename());
    std::ranges::sort(found);
    return found;
  }

  const fs::path folder = testing::TempDir() + "canvoy_draft_" + std::to_string(::getpid());
  const fs::path path = folder / "a.dcf";
};

TEST_F(FileDraftTest, TheOldFileIsThereUntilTheNewOneIs) {
  std::ofstream(path) << "old";
  Result<AtomicFile> draft = AtomicFile::begin(path);
  ASSERT_TRUE(draft);
  EXPECT_TRUE(draft->write(bytes("new")));
  EXPECT_EQ(content(path), "old");
  EXPECT_TRUE(draft->finish());
  EXPECT_EQ(content(path), "new");
  EXPECT_EQ(names(), std::vector<std::string>{"a.dcf"});
}

TEST_F(FileDraftTest, WhatIsSoonWrittenAnewIsThereWholeAsWell) {
  std::ofstream(path) << "old";
  Result<AtomicFile> draft = AtomicFile::begin(path);
  ASSERT_TRUE(draft && draft->write(bytes("new")));
  EXPECT_EQ(content(path), "old");
  EXPECT_TRUE(draft->replace());
  EXPECT_TRUE(draft->replace()) << "it is done";
  EXPECT_EQ(content(path), "new");
  EXPECT_EQ(names(), std::vector<std::string>{"a.dcf"});
}

TEST_F(FileDraftTest, WhatIsNotFinishedLeavesNothing) {
  {
    Result<AtomicFile> draft = AtomicFile::begin(path);
    ASSERT_TRUE(draft);
    EXPECT_TRUE(draft->write(bytes("half")));
  }
  EXPECT_EQ(names(), std::vector<std::string>());
}

TEST_F(FileDraftTest, TwoWritersDoNotMeet) {
  Result<AtomicFile> first = AtomicFile::begin(path);
  Result<AtomicFile> second = AtomicFile::begin(path);
  ASSERT_TRUE(first && second);
  EXPECT_TRUE(first->write(bytes("first")));
  EXPECT_TRUE(second->write(bytes("second, which is longer")));
  EXPECT_TRUE(second->finish());
  EXPECT_TRUE(first->finish());
  EXPECT_EQ(content(path), "first");
}

TEST_F(FileDraftTest, AFileOfSomebodyThatLooksLikeADraftStays) {
  const std::string mine = "a.dcf.part";
  std::ofstream(folder / mine) << "mine";
  Result<AtomicFile> draft = AtomicFile::begin(path);
  ASSERT_TRUE(draft && draft->finish());
  EXPECT_EQ(content(folder / mine), "mine");
}

TEST_F(FileDraftTest, KeepsTheRightsOfTheFileAndReplacesTheTargetOfALink) {
  std::ofstream(path) << "old";
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  fs::create_symlink("a.dcf", folder / "link.dcf");
  Result<AtomicFile> draft = AtomicFile::begin(folder / "link.dcf");
  ASSERT_TRUE(draft && draft->write(bytes("new")) && draft->finish());
  EXPECT_TRUE(fs::is_symlink(folder / "link.dcf"));
  EXPECT_EQ(content(path), "new");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0640));
}

TEST_F(FileDraftTest, ANameMayBeAsLongAsTheFileSystemHasThem) {
  const fs::path longest = folder / std::string(255, 'n');
  Result<AtomicFile> draft = AtomicFile::begin(longest);
  ASSERT_TRUE(draft && draft->finish());
  EXPECT_TRUE(fs::exists(longest));
}

TEST_F(FileDraftTest, WhatIsNoPlainFileIsWrittenDirectly) {
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string heard;
  std::thread reader([&] { heard = content(pipe); });
  {
    Result<AtomicFile> draft = AtomicFile::begin(pipe);
    EXPECT_TRUE(draft && draft->write(bytes("through")) && draft->finish());
  }
  reader.join();
  EXPECT_EQ(heard, "through");
  EXPECT_EQ(names(), std::vector<std::string>{"pipe"});
}

TEST_F(FileDraftTest, SaysWhereAndWhy) {
  const Result<AtomicFile> nowhere = AtomicFile::begin(folder / "none" / "a.dcf");
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().where, (folder / "none" / "a.dcf").string());
  EXPECT_NE(nowhere.error().what.find("No such file"), std::string::npos);
  EXPECT_FALSE(AtomicFile::begin(folder)) << "a folder";
}

}  // namespace
}  // namespace canvoy::host::file_draft_test
