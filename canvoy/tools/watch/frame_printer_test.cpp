// Options on the nodes of one bus, with any name of the bus.
#include "canvoy/tools/watch/frame_printer.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::frame_printer_test {
namespace {

const std::string udp = "udp:239.74.163.2:43113?ttl=1";

/// A data sheet of CiA 418 in a file with this name.
std::string sheet_file(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(path) << "[1000]\nParameterName=Device type\nDataType=7\nAccessType=ro\n"
                         "DefaultValue=0x1A2\n";
  return path.string();
}

unsigned number(FramePrinter& sut, const std::string& bus, NodeId node) {
  return sut.profile(bus, node).number;
}

TEST(FramePrinter, ABusWithASignInItsNameHasNodesAndAProfile) {
  for (const std::string& bus : {udp, std::string("can1"), std::string("a=b=c")}) {
    FramePrinter sut({.nodes = {bus + ":10=418"}, .profiles = {bus + "=447-3"}});
    EXPECT_EQ(number(sut, bus, 10), 418U) << bus;
    EXPECT_EQ(number(sut, bus, 5), 447U) << bus;
    EXPECT_EQ(number(sut, "can0", 10), base_profile().number) << bus;
    EXPECT_EQ(number(sut, "can0", 5), base_profile().number) << bus;
  }
}

TEST(FramePrinter, ADataSheetIsOfANodeOnSuchABus) {
  for (const char* name : {"frame_printer.eds", "frame=printer.eds", "bus:5=9.eds"}) {
    const std::string file = sheet_file(name);
    FramePrinter sut({.sheets = {udp + ":10=" + file}});
    EXPECT_EQ(sut.profile(udp, 10).base->number, 418U) << name;
    EXPECT_EQ(number(sut, "can0", 10), base_profile().number) << name;
    FramePrinter all({.sheets = {"10=" + file}});
    EXPECT_EQ(all.profile("can0", 10).base->number, 418U) << name;
  }
}

/// Most PDOs say again what the last one has said: what differs is told all the same.
TEST(FramePrinter, AMessageThatSaysTheSameHasTheSameLineAndItsOwnMarks) {
  FramePrinter sut({.nodes = {"10=418"}});
  const auto words = [&sut](std::string_view frame) {
    std::string line;
    sut.append(line, Duration(1s), "can0", parse_frame(frame).frame);
    return line.substr(line.find(" TPDO1"));
  };
  const std::string warm =
      " TPDO1            node 10 (0Ah): temperature = 20.000 °C; battery_status = ready\n";
  EXPECT_EQ(words("18A#A00001"), warm);
  EXPECT_EQ(words("18A#A00001"), warm);
  EXPECT_EQ(words("18A#A0000100"), warm.substr(0, warm.size() - 1) + " [!] wrong length\n");
  EXPECT_EQ(words("18A#A00001"), warm);
  EXPECT_EQ(words("18A#A000"),
            " TPDO1            node 10 (0Ah): temperature = 20.000 °C [!] wrong length\n");
  EXPECT_EQ(words("18A#A00001"), warm);
  EXPECT_EQ(words("18A#A80001"),
            " TPDO1            node 10 (0Ah): temperature = 21.000 °C; battery_status = ready\n");
}

TEST(FramePrinter, RefusesWhatNamesNoNodeOrNothing) {
  const auto with = [](const FramePrinterOptions& options) { FramePrinter sut(options); };
  for (const char* text : {"=418", "10=", "10", "can1:=418", "udp:239.74.163.2?ttl=418"}) {
    EXPECT_THROW(with({.nodes = {text}}), UsageError) << text;
  }
  EXPECT_THROW(with({.sheets = {udp + "=nothing.eds"}}), UsageError);
  EXPECT_THROW(with({.profiles = {udp + "="}}), UsageError);
}

}  // namespace
}  // namespace canvoy::tools::frame_printer_test
