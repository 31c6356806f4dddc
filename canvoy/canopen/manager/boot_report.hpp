// What the boot-up procedure tells while it goes on, so that no slave is waited for without a word
// (CiA 302-2).
//
//     manager.on_report(Callback<void(const BootReport&)>::to<&App::slave_is_booted>(app));
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/manager/boot_error.hpp"

namespace canvoy {

/// The steps that a slave goes through, in their order.
enum class BootStep : std::uint8_t {
  waiting,      ///< for its boot-up message, for its turn, or for the next attempt
  device_type,  ///< reads 1000h
  vendor_id,    ///< reads 1018h:01h, where one is expected; and so on
  product_code,
  revision_number,
  serial_number,
  node_state,     ///< of a slave to be kept alive: waits for a heartbeat or guarding answer
  reset,          ///< commanded, and waits for the boot-up message
  program,        ///< checks its software version, and updates it
  configuration,  ///< checks its configuration, and downloads it
  error_control,  ///< waits for the first heartbeat
  done,
};

enum class BootEvent : std::uint8_t {
  step,        ///< a step begins
  no_boot_up,  ///< it was reset, and sent no boot-up message: it is asked for 1000h again
  restarted,   ///< it sent a boot-up message when none was expected: it begins anew
  retried,     ///< the attempt failed, and the next one will come
  failed,      ///< for good, unless it sends a boot-up message
  booted,      ///< error L: it was operational, and left so
  started,     ///< commanded into operational, by itself or with all
  lost,        ///< its heartbeat or guarding answer did not come in time
  slowed,      ///< it restarts again and again: the next attempt comes after `delay`
  given_up,    ///< it does so still: for good, unless it sends another boot-up message
  unknown,     ///< a boot-up message of a node that is no slave (A)
};

struct BootReport {
  NodeId slave = 0;
  BootEvent event = BootEvent::step;
  BootStep step = BootStep::waiting;  ///< that begins, or in which it happened
  BootOutcome outcome = {};
  std::uint32_t expected = 0;  ///< of a step that compares
  std::uint32_t found = 0;
  Duration delay{};  ///< of `slowed`
};

/// The network as a whole.
enum class NetworkBoot : std::uint8_t {
  idle,  ///< this device is not the NMT master, or not yet
  booting,
  failed,    ///< a mandatory slave did not come up; it is still waited for
  complete,  ///< all mandatory slaves are up
};

}  // namespace canvoy
