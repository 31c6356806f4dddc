// Parts of the boot-up procedure for other services: the check and update of a slave's software
// (1F52h to 1F58h, letters G, H and I) and of its configuration (1F22h, 1F26h, 1F27h against 1020h,
// letter J).
//
//     BootHooks hooks;
//     auto update = [&](const BootTask& task) {
//       if (nothing_to_do(task.slave)) return task.done({});
//       job = task;  // later: job.done(...), with BootError::configuration and the abort code
//     };
//     hooks.update_configuration = Callback<void(const BootTask&)>::of(update);
#pragma once

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/manager/boot_error.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// The task for one slave. Copy it to keep it: several slaves are booted at once, and each has a
/// task.
struct BootTask {
  NodeId slave;  ///< node-ID, 1 to 127
  /// Idle, and available to the task until it ends.
  SdoClient* client;
  /// To be called once, at once or later; the task must not be used afterwards.
  Callback<void(BootOutcome)> done;
  /// Resets the slave by this command, and calls back with none after its boot-up message, or with
  /// time_out. The client must be idle, and one restart must end before the next.
  Callback<void(NmtCommand, Callback<void(AbortCode)>)> restart = {};
};

/// Hooks. An empty hook does nothing: the procedure continues.
struct BootHooks {
  /// Called for slaves with a check of the software version (1F81h bit 5); bit 6 allows an update.
  Callback<void(const BootTask&)> update_program = {};
  /// Called for each slave that is booted.
  Callback<void(const BootTask&)> update_configuration = {};
  /// Called when the slave restarted, was lost, or the master was reset: its task ends; its `done`
  /// must not be called, and its client must not be used.
  Callback<void(NodeId)> abandon = {};
};

}  // namespace canvoy
