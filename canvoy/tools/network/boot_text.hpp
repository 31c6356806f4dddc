// Text of the boot-up of a network: the step of a slave, why it failed, what was expected and
// found, and what to do.
//
//     fmt::print("{}\n", boot_line(report, plan));
#pragma once

#include <string>
#include <string_view>

#include "canvoy/canopen/manager/boot_report.hpp"
#include "canvoy/canopen/manager/configuration_manager.hpp"

namespace canvoy::tools {

/// Text of a step: `reads its device type (1000h)`.
std::string_view boot_step_text(BootStep step);
/// Word of a step for programs: `device-type`.
std::string_view boot_step_word(BootStep step);
std::string_view boot_event_word(BootEvent event);
/// Meaning of an error letter: `another device type than expected (1000h)`.
std::string_view boot_error_text(BootError error);
/// Advice for a person at the machine.
std::string_view boot_advice(BootError error);
/// The reason with expected and found values: `D: another vendor ... : expected 291 (00000123h),
/// found 292 (00000124h)`
std::string boot_reason(const BootReport& report);
/// The whole report, without time and node: `is up`, `failed: D ...`.
std::string boot_line(const BootReport& report);
/// Result of a configuration: `has the expected configuration`, `1017h:00h was refused ...`.
std::string configuration_line(const ConfigurationOutcome& outcome);

}  // namespace canvoy::tools
