// What the boot-up procedure leaves to others: the check and update of a slave's software (1F52h to
// 1F58h, letters G, H and I) and of its configuration (1F22h, 1F26h, 1F27h against 1020h, letter
// J).
//
//     BootHooks hooks;
//     hooks.update_configuration =
//         Callback<void(const BootTask&)>::to<&ConfigurationManager::update>(manager);
//
//     void ConfigurationManager::update(const BootTask& task) {
//       if (nothing_to_do(task.slave)) return task.done({});
//       ...                                     // later: job.done({BootError::configuration,
//       code})
//     }
#pragma once

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/manager/boot_error.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// One slave's turn. Copy it to keep it: several slaves are booted at once, and each brings a task.
struct BootTask {
  NodeId slave;
  /// Idle, and at the disposal of the task until it ends.
  SdoClient* client;
  /// To be called once, at once or later; nothing of the task may be used afterwards.
  Callback<void(BootOutcome)> done;
  /// Resets the slave by this command, and calls back with none when its boot-up message came, or
  /// with time_out. The client must be idle, and one restart be over before the next.
  Callback<void(NmtCommand, Callback<void(AbortCode)>)> restart = {};
};

/// A hook that is empty has nothing to do: the procedure goes on.
struct BootHooks {
  /// Called for slaves of which 1F81h bit 5 asks for the check of the software version; bit 6
  /// allows an update.
  Callback<void(const BootTask&)> update_program = {};
  /// Called for each slave that is booted.
  Callback<void(const BootTask&)> update_configuration = {};
  /// The slave restarted, was lost, or the master was reset: its task ends here, its `done` must
  /// not be called any more, its client is no longer the task's.
  Callback<void(NodeId)> abandon = {};
};

}  // namespace canvoy
