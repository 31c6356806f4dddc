// The boot-up of a network in words: at which step a slave is, why it failed, what was expected and
// found, and what to do.
//
//     fmt::print("{}\n", boot_line(report, plan));
#pragma once

#include <string>
#include <string_view>

#include "canvoy/canopen/manager/boot_report.hpp"
#include "canvoy/canopen/manager/configuration_manager.hpp"

namespace canvoy::tools {

/// `reads its device type (1000h)`
std::string_view boot_step_text(BootStep step);
/// `device-type`, for programs.
std::string_view boot_step_word(BootStep step);
std::string_view boot_event_word(BootEvent event);
/// What a letter means: `another device type than expected (1000h)`.
std::string_view boot_error_text(BootError error);
/// What somebody at the machine can do about it.
std::string_view boot_advice(BootError error);
/// The reason with what was expected and found: `D: another vendor ... : expected 291 (00000123h),
/// found 292 (00000124h)`
std::string boot_reason(const BootReport& report);
/// All of it, without time and node: `is up`, `failed: D ...`.
std::string boot_line(const BootReport& report);
/// What became of a configuration: `has the expected configuration`, `1017h:00h was refused ...`.
std::string configuration_line(const ConfigurationOutcome& outcome);

}  // namespace canvoy::tools
