// The boot-up of one slave, step by step: is it present, is it the right one, may it be reset, has
// it the right software and configuration, does its error control work? (CiA 302-2, "boot NMT
// slave")
//
// SlaveBoots determines the order of slaves, and assigns each to one of these. All of them work at
// once.
//
//     BootSlave slots[4] = {BootSlave(node), BootSlave(node), BootSlave(node), BootSlave(node)};
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/manager/boot_hooks.hpp"
#include "canvoy/canopen/manager/boot_report.hpp"
#include "canvoy/canopen/manager/guarding_hooks.hpp"
#include "canvoy/canopen/manager/nmt_queue.hpp"
#include "canvoy/canopen/manager/nmt_startup.hpp"
#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// Times of the boot-up that no object of the dictionary sets.
struct BootOptions {
  /// Time for the boot-up message of a slave after its reset.
  Duration boot_up_time_out = 1s;
  /// Limit for each answer of a slave.
  Duration sdo_time_out = SdoClient::default_time_out;
  /// Time from an attempt without an answer to the next one.
  Duration retry_interval = 1s;
  /// Whether the communication of all slaves is reset when the boot-up of the network begins.
  bool resets_slaves = true;
};

/// Common data of all slots of a master.
struct BootContext {
  Node& node;                                ///< of the master
  NmtMaster& master;                         ///< states of all nodes
  NmtQueue& commands;                        ///< NMT commands leave in order
  BootHooks hooks;                           ///< software and configuration
  GuardingHooks guarding;                    ///< node guarding
  BootOptions options;                       ///< times and resets
  Callback<void(const BootReport&)> report;  ///< of each step and event
};

/// A slot: boots one slave at a time, by an SDO client of its own, which needs a route.
class BootSlave {
 public:
  /// Makes an idle slot. `node` must outlive it.
  explicit BootSlave(Node& node);
  BootSlave(const BootSlave&) = delete;
  BootSlave& operator=(const BootSlave&) = delete;

  /// True while a slave is being booted here.
  bool busy() const { return slave_ != 0; }
  /// Slave in this slot; 0 while it is idle.
  NodeId slave() const { return slave_; }

 private:
  friend class SlaveBoots;

  using Finished = Callback<void(BootSlave&, BootOutcome)>;

  // Interface for SlaveBoots
  void prepare(BootContext& context, Finished finished);
  /// Begins the boot-up of a slave; `is_fresh`: it has just booted, and need not be reset.
  void begin(NodeId slave, bool is_fresh);
  /// Ends the work without an outcome.
  void abandon();
  /// True if a boot-up message is expected.
  bool expects_boot_up() const;
  void booted_up();
  void heard(RemoteState state);
  void reset_sent();
  BootReport report_of(BootEvent event) const;
  /// Frees the slot, since its slave needs no further work.
  void release() { slave_ = 0; }

  // Is it present, and the right one?
  void ask(BootStep step);
  bool is_asked_for(BootStep step) const;
  void answered(SdoClient::Outcome outcome);

  // May it be reset?
  void ask_for_state();
  void state_known(RemoteState state);
  void reset();

  // Software, configuration, error control
  void update_program();
  void program_updated(BootOutcome outcome);
  void update_configuration();
  void configuration_updated(BootOutcome outcome);
  void restart(NmtCommand command, Callback<void(AbortCode)> restarted);
  void end_restart(AbortCode answer);
  bool watch();
  void start_error_control();

  [[nodiscard]] bool enter(BootStep step);
  void wait(Duration duration);
  void expired(Time now);
  void finish(BootOutcome outcome);
  SlaveAssignment assignment() const;

  SdoClient client_;
  BootContext* context_ = nullptr;
  Finished finished_;
  Callback<void(AbortCode)> restarted_;  ///< callback of a hook
  Timer timer_;
  std::uint32_t expected_ = 0;
  std::uint32_t found_ = 0;
  std::array<std::uint8_t, 4> value_{};
  NodeId slave_ = 0;
  BootStep step_ = BootStep::waiting;
  bool is_fresh_ = false;
  bool was_reset_ = false;      ///< in this attempt, and the time for it is over
  bool has_task_ = false;       ///< a hook is working
  bool is_restarting_ = false;  ///< for a hook
};

}  // namespace canvoy
