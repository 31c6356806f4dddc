// Place files, and errors of invalid ones.
#include "canvoy/tools/cli/place_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::place_file_test {
namespace {

class Places : public testing::Test {
 protected:
  ~Places() override { std::filesystem::remove(path); }
  void write(std::string_view text) { std::ofstream(path) << text; }
  std::string refusal() {
    try {
      const PlaceFile places(path);
    } catch (const Failure& failure) {
      return failure.what();
    }
    return "";
  }

  std::string path = std::filesystem::path(testing::TempDir()) /
                     (std::string("canvoy-places-") +
                      testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Places, AreReadLineByLine) {
  write(
      "# taxi ranks\n\n48.14 11.56 | Bahnhofplatz | Munich | Germany\r\n"
      "48.35 11.78 | Terminal 2 | Munich | Germany");
  const PlaceFile file(path);
  ASSERT_EQ(file.places().size(), 2u);
  EXPECT_EQ(file.places()[0].street, "Bahnhofplatz");
  EXPECT_EQ(file.places()[0].country, "Germany");
  EXPECT_EQ(file.places()[1].position.latitude, 48.35);
  EXPECT_EQ(cia447::Gazetteer(file.places()).nearest({48.351, 11.781})->street, "Terminal 2");
}

TEST_F(Places, AWrongLineIsNamed) {
  write("# a remark\n48.14 11.56 | a | b | c\n91 11.56 | a | b | c\n");
  EXPECT_EQ(refusal(), path + " line 3: the latitude has to be a number of degrees from -90 to 90");
}

TEST_F(Places, AFileWithoutPlacesIsRefused) {
  write("# nothing\n");
  EXPECT_EQ(refusal(), path +
                           ": there are no places; write one a line: "
                           "latitude longitude | street | city | country");
}

TEST_F(Places, AFileThatIsNotThereIsNamed) {
  EXPECT_NE(refusal().find(path), std::string::npos);
}

}  // namespace
}  // namespace canvoy::tools::place_file_test
