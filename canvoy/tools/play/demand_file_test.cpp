// Files of counted passengers: what is read, and why others are refused.
#include "canvoy/tools/play/demand_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::demand_file_test {
namespace {

class DemandFile : public testing::Test {
 protected:
  DemandFile() : folder_(std::filesystem::path(testing::TempDir()) / "canvoy-demand") {
    std::filesystem::create_directories(folder_);
  }
  ~DemandFile() override { std::filesystem::remove_all(folder_); }

  bus_line::Demand read(const std::string& text) {
    std::ofstream(folder_ / "counts.csv") << text;
    return read_demand((folder_ / "counts.csv").string(), bus_line::built_in_line());
  }
  bus_line::Delays read_late(const std::string& text) {
    std::ofstream(folder_ / "counts.csv") << text;
    return read_delays((folder_ / "counts.csv").string(), bus_line::built_in_line());
  }
  /// After the name of the folder.
  std::string refusal(const std::string& text, bool is_of_delays = false) {
    try {
      static_cast<void>(is_of_delays ? void(read_late(text)) : void(read(text)));
    } catch (const Failure& failure) {
      const std::string what = failure.what();
      const std::string prefix = folder_.string() + "/";
      return what.starts_with(prefix) ? what.substr(prefix.size()) : what;
    }
    return "";
  }

  std::filesystem::path folder_;
};

TEST_F(DemandFile, SaysWhoGetsInAndOutWhereAndWhen) {
  const bus_line::Demand demand = read(
      "boarding,stop,hour,direction,alighting\n"
      "4.5,MARKET,7,0,0.5\n"
      "1,Market Square,,,\n"
      "2,HARBOUR,25,1,\n");
  // Stops of the built-in line: MARKET is its second one, HARBOUR the last.
  EXPECT_EQ(demand.at(1, false, 7).boarding, 4.5);
  EXPECT_EQ(demand.at(1, false, 7).alighting, 0.5);
  EXPECT_EQ(demand.at(1, true, 7).boarding, 1);
  EXPECT_EQ(demand.at(1, false, 8).boarding, 1);
  EXPECT_EQ(demand.at(7, true, 25).boarding, 2);
  EXPECT_EQ(demand.at(7, false, 25).boarding, 0);
}

TEST_F(DemandFile, SaysHowLateTheBusIs) {
  const bus_line::Delays delays = read_late("stop,hour,delay\nHARBOUR,8,90\nHARBOUR,,-12.5\n");
  EXPECT_EQ(delays.at(7, true, 8), 90s);
  EXPECT_EQ(delays.at(7, true, 9), -12500ms);
  EXPECT_EQ(delays.at(6, true, 8), 0s);
  EXPECT_EQ(refusal("stop,delay\nMARKET,\n", true), "counts.csv line 2: delay: empty");
  EXPECT_EQ(refusal("stop,delay\nMARKET,1min\n", true),
            "counts.csv line 2: delay: '1min' is no number from -600 to 7200");
}

TEST_F(DemandFile, IsRefusedWithFileLineAndColumn) {
  EXPECT_EQ(refusal("stop,boarding\nZOO,1\n"),
            "counts.csv line 2: stop: 'ZOO' is no stop of the line");
  EXPECT_EQ(refusal("stop,boarding\nMARKET,-1\n"),
            "counts.csv line 2: boarding: '-1' is no number from 0 to 200");
  EXPECT_EQ(refusal("stop,boarding\nMARKET,nan\n"),
            "counts.csv line 2: boarding: 'nan' is no number from 0 to 200");
  EXPECT_EQ(refusal("stop,boarding\nMARKET,\n"), "counts.csv line 2: boarding: empty");
  EXPECT_EQ(refusal("stop,hour\nMARKET,7\n"), "counts.csv line 2: boarding: the column is missing");
  EXPECT_EQ(refusal("stop,hour,boarding\nMARKET,48,1\n"),
            "counts.csv line 2: hour: '48' is no whole number from 0 to 47");
  EXPECT_EQ(refusal("stop,direction,boarding\nMARKET,2,1\n"),
            "counts.csv line 2: direction: '2' is no whole number from 0 to 1");
  EXPECT_EQ(refusal("stop,boarding\nMARKET,1\nMarket Square,2\n"),
            "counts.csv line 3: stop: there is a row of this stop, direction and hour already");
  EXPECT_EQ(refusal(""), "counts.csv line 1: empty; the names of its columns are missing");
  EXPECT_THROW(read_demand((folder_ / "none.csv").string(), bus_line::built_in_line()), Failure);
  EXPECT_THROW(read_demand("/nowhere/none.csv", bus_line::built_in_line()), Failure);
}

}  // namespace
}  // namespace canvoy::tools::demand_file_test
