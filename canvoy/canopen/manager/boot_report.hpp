// Reports of the boot-up procedure while it runs, so that no slave is waited for without a report
// (CiA 302-2).
//
//     manager.on_report(Callback<void(const BootReport&)>::to<&App::slave_is_booted>(app));
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/manager/boot_error.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

/// The steps for a slave, in their order.
enum class BootStep : std::uint8_t {
  waiting,      ///< for the boot-up message, for a slot, or for the next attempt
  device_type,  ///< reads 1000h
  vendor_id,    ///< reads 1018h:01h, if one is expected; likewise for the steps that follow
  product_code,
  revision_number,
  serial_number,
  node_state,     ///< for a slave to be kept alive: waits for a heartbeat or guarding answer
  reset,          ///< command sent; waits for the boot-up message
  program,        ///< checks the software version, and updates it
  configuration,  ///< checks the configuration, and downloads it
  error_control,  ///< waits for the first heartbeat
  done,
};

/// What happened.
enum class BootEvent : std::uint8_t {
  step,        ///< a step begins
  no_boot_up,  ///< no boot-up message after a reset: 1000h is requested again
  restarted,   ///< an unexpected boot-up message: it begins again
  retried,     ///< the attempt failed, and another one follows
  failed,      ///< final, unless it sends a boot-up message
  booted,      ///< error L: it was operational, and was left in that state
  started,     ///< commanded into operational, alone or with all
  lost,        ///< no heartbeat or guarding answer in time
  slowed,      ///< repeated restarts: the next attempt comes after `delay`
  given_up,    ///< further restarts: final, unless it sends another boot-up message
  unknown,     ///< a boot-up message of a node that is not a slave (A)
};

/// A step or an event of one slave.
struct BootReport {
  NodeId slave = 0;                   ///< node-ID, 1 to 127
  BootEvent event = BootEvent::step;  ///< what happened
  BootStep step = BootStep::waiting;  ///< step that begins, or in which the event occurred
  BootOutcome outcome = {};           ///< of an attempt that failed, or was left (L)
  std::uint32_t expected = 0;         ///< of a step with a comparison
  std::uint32_t found = 0;            ///< of a step with a comparison
  Duration delay{};                   ///< of `slowed`
};

/// State of the network as a whole.
enum class NetworkBoot : std::uint8_t {
  idle,  ///< this device is not the NMT master, or not yet
  booting,
  failed,    ///< a mandatory slave did not boot; the manager still waits for it
  complete,  ///< all mandatory slaves are up
};

}  // namespace canvoy
