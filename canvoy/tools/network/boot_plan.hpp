// The network that `canvoy boot` boots: slaves, what is expected of each, and settings of the
// master, from the command line and from a TOML file.
//
//     BootPlan plan = read_boot_plan("network.toml");
//     add_slave(plan, "5:mandatory,vendor=0x123,heartbeat=500ms");
//
//     [master]
//     node = 127
//     boot-time = "10s"
//     start = "each"           # all: by one command; none
//     [[slave]]
//     node = 5
//     name = "pump"
//     mandatory = true
//     vendor = 0x123
//     heartbeat = "500ms"
//     configuration = "pump.cdcf"      # files are looked for beside this one
//     configuration-date = 2026-11-21 12:00:00
//     program = "pump.bin"
//     program-id = 0x1234
//     update = true
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy::tools {

struct SlavePlan {
  NodeId id = 0;
  std::string name = {};
  bool is_mandatory = false;
  bool is_kept_alive = false;
  bool is_only_watched = false;   ///< neither booted nor started
  std::uint32_t device_type = 0;  ///< 0: any; likewise below
  std::uint32_t vendor_id = 0;
  std::uint32_t product_code = 0;
  std::uint32_t revision_number = 0;
  std::uint32_t serial_number = 0;
  Duration heartbeat{};   ///< maximum silence; zero: not monitored
  Duration guard_time{};  ///< zero: no node guarding
  std::uint8_t guard_factor = 3;

  /// A time as in 1020h and 1F52h: days since 1 January 1984, and ms since midnight; both 0: not
  /// compared.
  struct Date {
    std::uint32_t days = 0;
    std::uint32_t milliseconds = 0;
    bool is_given() const { return days != 0 || milliseconds != 0; }
  };
  std::vector<std::uint8_t> concise_dcf = {};
  Date configuration_date = {};
  std::uint8_t restored_sub = 0;  ///< sub-index of 1011h; 0: defaults are not restored
  std::vector<std::uint8_t> program = {};
  std::uint32_t program_id = 0;  ///< 0: not compared
  Date program_date = {};
  bool may_be_updated = false;

  bool has_checked_program() const {
    return program_id != 0 || program_date.is_given() || !program.empty() || may_be_updated;
  }

  /// Value of 1F81h.
  std::uint32_t assignment() const;
};

struct BootPlan {
  enum class Start : std::uint8_t { each, all, none };
  NodeId master = 127;
  Start start = Start::each;
  Duration boot_time = 10s;
  Duration inhibit_time{};
  bool resets = true;
  std::vector<SlavePlan> slaves;

  /// Value of 1F80h.
  std::uint32_t startup() const;
};

/// Adds a slave. Throws UsageError if the text is not valid, or the slave exists already; Failure
/// if one of its files cannot be read.
void add_slave(BootPlan& plan, std::string_view text);
BootPlan::Start parse_start(std::string_view text);
/// Throws Failure with the line of the file.
BootPlan read_boot_plan(const std::string& path);
/// Throws UsageError: no slaves, or a slave that is the master.
void check(const BootPlan& plan);

}  // namespace canvoy::tools
