// The boot-up of one slave, step by step (CiA 302-2, "boot NMT slave"): is it there, is it the
// right one, may it be reset, has it the right software and configuration, does its error control
// work?
//
// SlaveBoots owns the order in which slaves come up, and hands each to one of these. As many as
// there are work at once.
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

struct BootOptions {
  /// How long after its reset a slave is given for its boot-up message.
  Duration boot_up_time_out = 1s;
  /// For each answer of a slave.
  Duration sdo_time_out = SdoClient::default_time_out;
  /// From an attempt that no slave answered to the next one.
  Duration retry_interval = 1s;
  /// The communication of all slaves is reset when the boot-up of the network begins.
  bool resets_slaves = true;
};

/// What all slots of a master work with.
struct BootContext {
  Node& node;
  NmtMaster& master;
  NmtQueue& commands;
  BootHooks hooks;
  GuardingHooks guarding;
  BootOptions options;
  Callback<void(const BootReport&)> report;
};

class BootSlave {
 public:
  explicit BootSlave(Node& node);
  BootSlave(const BootSlave&) = delete;
  BootSlave& operator=(const BootSlave&) = delete;

  bool busy() const { return slave_ != 0; }
  /// 0 while it is idle.
  NodeId slave() const { return slave_; }

 private:
  friend class SlaveBoots;

  using Finished = Callback<void(BootSlave&, BootOutcome)>;

  // What SlaveBoots asks for
  void prepare(BootContext& context, Finished finished);
  /// `is_fresh`: it has just booted, and need not be reset.
  void begin(NodeId slave, bool is_fresh);
  /// Ends the work without an outcome.
  void abandon();
  /// True where a boot-up message is no surprise.
  bool expects_boot_up() const;
  void booted_up();
  void heard(RemoteState state);
  void reset_sent();
  BootReport report_of(BootEvent event) const;
  /// Of its slave there is nothing more to do.
  void release() { slave_ = 0; }

  // Is it there, and the right one?
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
  Callback<void(AbortCode)> restarted_;  ///< of a hook
  Timer timer_;
  std::uint32_t expected_ = 0;
  std::uint32_t found_ = 0;
  std::array<std::uint8_t, 4> value_{};
  NodeId slave_ = 0;
  BootStep step_ = BootStep::waiting;
  bool is_fresh_ = false;
  bool was_reset_ = false;      ///< in this attempt, and was given its time
  bool has_task_ = false;       ///< a hook is at work
  bool is_restarting_ = false;  ///< for that hook
};

}  // namespace canvoy
