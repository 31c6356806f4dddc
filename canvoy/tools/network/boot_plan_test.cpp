#include "canvoy/tools/network/boot_plan.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "canvoy/can/host/temporary_file_test.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::boot_plan_test {
namespace {

SlavePlan parsed(std::string_view text) {
  BootPlan plan;
  add_slave(plan, text);
  return plan.slaves.front();
}

TEST(BootPlan, NeedsNothingOfASlaveButItsNodeId) {
  const SlavePlan slave = parsed("0x0A");
  EXPECT_EQ(slave.id, 10);
  EXPECT_EQ(slave.assignment(), 0x0000'0305U);
  EXPECT_EQ(slave.vendor_id, 0U);
  EXPECT_EQ(slave.heartbeat, Duration::zero());
}

TEST(BootPlan, TakesAllThatIsExpectedOfASlave) {
  const SlavePlan slave = parsed(
      "5:mandatory,keep-alive,name=main pump,device=0x000F0191,vendor=291,product=0x7,"
      "revision=65538,serial=0xDEADBEEF,heartbeat=1.5s,guard=200ms*5");
  EXPECT_EQ(slave.name, "main pump");
  EXPECT_EQ(slave.device_type, 0x000F'0191U);
  EXPECT_EQ(slave.vendor_id, 0x123U);
  EXPECT_EQ(slave.product_code, 7U);
  EXPECT_EQ(slave.revision_number, 0x0001'0002U);
  EXPECT_EQ(slave.serial_number, 0xDEAD'BEEFU);
  EXPECT_EQ(slave.heartbeat, 1500ms);
  EXPECT_EQ(slave.assignment(), 0x00C8'051DU);
}

TEST(BootPlan, MakesTheBitsOf1F81h) {
  EXPECT_EQ(parsed("5:mandatory").assignment() & 0xFF, 0x0DU);
  EXPECT_EQ(parsed("5:keep-alive").assignment() & 0xFF, 0x15U);
  EXPECT_EQ(parsed("5:watch-only").assignment() & 0xFF, 0x01U);
  EXPECT_EQ(parsed("5:mandatory=false").assignment() & 0xFF, 0x05U);
  EXPECT_EQ(parsed("5:guard=1ms").assignment(), 0x0001'0305U);
  EXPECT_EQ(parsed("5:guard=65535ms*255").assignment(), 0xFFFF'FF05U);
}

TEST(BootPlan, TakesWhatASlaveIsToGet) {
  const SlavePlan slave = parsed(
      "5:configuration-date=2026-11-21 12:00:00.250,restore=2,program-id=0x1234,"
      "program-date=1984-01-02 00:00:00");
  EXPECT_EQ(slave.configuration_date.days, 15'665U);
  EXPECT_EQ(slave.configuration_date.milliseconds, 43'200'250U);
  EXPECT_EQ(slave.restored_sub, 2);
  EXPECT_EQ(slave.program_id, 0x1234U);
  EXPECT_EQ(slave.program_date.days, 1U);
  EXPECT_EQ(slave.program_date.milliseconds, 0U);
  EXPECT_EQ(parsed("5:restore").restored_sub, 1) << "all parameters";
}

TEST(BootPlan, HasTheProgramCheckedWhereAnythingIsSaidOfOne) {
  EXPECT_EQ(parsed("5").assignment() & 0xE0, 0x00U);
  EXPECT_EQ(parsed("5:program-id=1").assignment() & 0xE0, 0x20U);
  EXPECT_EQ(parsed("5:program-date=2026-11-21 12:00:00").assignment() & 0xE0, 0x20U);
  EXPECT_EQ(parsed("5:update").assignment() & 0xE0, 0x60U);
  EXPECT_EQ(parsed("5:restore").assignment() & 0xE0, 0x80U);
}

TEST(BootPlan, MakesTheBitsOf1F80h) {
  BootPlan plan;
  EXPECT_EQ(plan.startup(), 0x01U);
  plan.start = parse_start("all");
  EXPECT_EQ(plan.startup(), 0x03U);
  plan.start = parse_start("none");
  EXPECT_EQ(plan.startup(), 0x09U);
}

TEST(BootPlan, RefusesWhatItDoesNotUnderstand) {
  for (const char* text : {"",
                           "0",
                           "128",
                           "pump",
                           "5:",
                           "5:urgent",
                           "5:vendor",
                           "5:vendor=",
                           "5:vendor=0x",
                           "5:vendor=-1",
                           "5:vendor=4294967296",
                           "5:vendor=12x",
                           "5:mandatory=1",
                           "5:heartbeat",
                           "5:heartbeat=0s",
                           "5:heartbeat=66s",
                           "5:heartbeat=500",
                           "5:guard=200ms*0",
                           "5:guard=200ms*256",
                           "5:guard=*3",
                           "5:configuration-date",
                           "5:configuration-date=1983-12-31 00:00:00",
                           "5:program-date=today",
                           "5:program-id=crc",
                           "5:restore=0",
                           "5:restore=255",
                           "5:update=1",
                           "5:mandatory,,vendor=1",
                           "5;mandatory"}) {
    BootPlan plan;
    if (std::string_view(text) == "5:") {
      EXPECT_NO_THROW(add_slave(plan, text)) << text;
    } else {
      EXPECT_THROW(add_slave(plan, text), UsageError) << text;
    }
  }
}

TEST(BootPlan, RefusesASlaveThatIsThereTwiceOrIsTheMaster) {
  BootPlan plan;
  add_slave(plan, "5");
  EXPECT_THROW(add_slave(plan, "0x05"), UsageError);
  plan.master = 5;
  EXPECT_THROW(check(plan), UsageError);
  EXPECT_THROW(check(BootPlan{}), UsageError);
}

using File = host::TemporaryFile;

/// Name as used in a file beside it.
std::string name_of(const File& file) {
  return std::filesystem::path(file.path()).filename().string();
}

TEST(BootPlan, IsReadFromAFile) {
  const File file(
      "[master]\nnode = 126\nboot-time = \"30s\"\nstart = \"all\"\ninhibit = \"10ms\"\nreset = "
      "false\n[[slave]]\nnode = 5\nname = \"pump\"\nmandatory = true\nvendor = 0x123\n"
      "[[slave]]\nnode = \"0x06\"\nguard = \"100ms*2\"\n");
  const BootPlan plan = read_boot_plan(file.path());
  EXPECT_EQ(plan.master, 126);
  EXPECT_EQ(plan.boot_time, 30s);
  EXPECT_EQ(plan.inhibit_time, 10ms);
  EXPECT_FALSE(plan.resets);
  EXPECT_EQ(plan.startup(), 0x03U);
  ASSERT_EQ(plan.slaves.size(), 2U);
  EXPECT_EQ(plan.slaves[0].name, "pump");
  EXPECT_EQ(plan.slaves[0].vendor_id, 0x123U);
  EXPECT_EQ(plan.slaves[0].assignment(), 0x0000'030DU);
  EXPECT_EQ(plan.slaves[1].id, 6);
  EXPECT_EQ(plan.slaves[1].assignment(), 0x0064'0205U);
}

TEST(BootPlan, FindsTheFilesOfASlaveBesideItself) {
  const File dcf("# a heartbeat\n1017 0 u16 500\n");
  const File program("123456789");
  const File file("[[slave]]\nnode = 5\nconfiguration = \"" + name_of(dcf) +
                  "\"\nconfiguration-date = 2026-11-21 12:00:00\nprogram = \"" + name_of(program) +
                  "\"\nupdate = true\n");
  const BootPlan plan = read_boot_plan(file.path());
  const SlavePlan& slave = plan.slaves.at(0);
  const std::vector<std::uint8_t> concise = {0x01, 0x00, 0x00, 0x00, 0x17, 0x10, 0x00,
                                             0x02, 0x00, 0x00, 0x00, 0xF4, 0x01};
  EXPECT_EQ(slave.concise_dcf, concise);
  EXPECT_EQ(slave.configuration_date.days, 15'665U);
  EXPECT_EQ(slave.configuration_date.milliseconds, 43'200'000U);
  EXPECT_EQ(slave.program.size(), 9U);
  EXPECT_EQ(slave.assignment() & 0xFF, 0x65U);
}

TEST(BootPlan, TellsOfAFileThatIsNotThere) {
  for (const char* text : {"5:configuration=/no/such/file", "5:program=/no/such/file"}) {
    BootPlan plan;
    EXPECT_THROW(add_slave(plan, text), Failure) << text;
    EXPECT_TRUE(plan.slaves.empty());
  }
}

TEST(BootPlan, TellsTheLineOfAFileThatIsWrong) {
  struct Wrong {
    const char* content;
    const char* line;
    const char* part;
  };
  for (const Wrong& wrong :
       {Wrong{"[master\n", "line 1", ""}, Wrong{"[master]\nnode = 128\n", "line 2", "128"},
        Wrong{"[master]\nspeed = 1\n", "line 2", "speed"},
        Wrong{"[master]\ninhibit = \"6554ms\"\n", "line 2", "102Ah holds 1ms to 6553ms"},
        Wrong{"[[slave]]\nnode = 5\n\nvendor = 1.5\n", "line 4", "vendor"},
        Wrong{"[[slave]]\nnode = 5\nvendor = -1\n", "line 3", "vendor=-1"},
        Wrong{"[[slave]]\nname = \"pump\"\n", "line 1", "node"},
        Wrong{"[[slave]]\nnode = 5\n[[slave]]\nnode = 5\n", "line 3", "twice"},
        Wrong{"[[slave]]\nnode = 5\nprogram = \"none.bin\"\n", "line 3", "none.bin"},
        Wrong{"[slave]\nnode = 5\n", "line 1", "[[slave]]"},
        Wrong{"[[slaves]]\nnode = 5\n", "line 1", "slaves"},
        Wrong{"node = 5\n", "line 1", "node"}}) {
    const File file(wrong.content);
    try {
      read_boot_plan(file.path());
      ADD_FAILURE() << wrong.content;
    } catch (const Failure& failure) {
      const std::string text = failure.what();
      EXPECT_NE(text.find(file.path() + " " + wrong.line), std::string::npos) << text;
      EXPECT_NE(text.find(wrong.part), std::string::npos) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
  }
  EXPECT_THROW(read_boot_plan("/no/such/file.toml"), Failure);
}

}  // namespace
}  // namespace canvoy::tools::boot_plan_test
