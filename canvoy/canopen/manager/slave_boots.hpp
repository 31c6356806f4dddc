// The slaves of an NMT master (CiA 302-2): how far each has come, whose turn it is, and what is
// done where one restarts, falls silent or does not answer.
//
// As many are booted at once as there are slots; the others wait for their turn. Memory belongs to
// the owner.
//
//     SlaveBoots slaves(context, {records, slots}, {.booted = booted, .changed = changed});
//     slaves.begin();
//     if (slaves.record(5).state == SlaveBoots::State::booted) ...
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/manager/boot_slave.hpp"
#include "canvoy/canopen/manager/slave_restarts.hpp"

namespace canvoy {

/// It does nothing between retire() and begin(). Each step of each slave goes to the report of the
/// context; whoever is told may retire it.
class SlaveBoots {
 public:
  enum class State : std::uint8_t { none, waiting, booting, booted, failed };
  /// What is known of one slave.
  struct Record {
    Time due = never;  ///< of its next attempt, while it is waiting; of a start that found no room
    Time since{};      ///< begin of the boot time (1F89h)
    State state = State::none;
    BootError error = BootError::none;
    SlaveRestarts restarts{};
    bool is_fresh = false;       ///< has sent a boot-up message, and nothing was changed since
    bool was_tried = false;      ///< an attempt has ended
    bool is_started = false;     ///< commanded into operational, or about to be
    bool is_told_reset = false;  ///< while it was booted: its next boot-up message is no fault
  };
  struct Memory {
    std::span<Record, node_id_max> records;
    std::span<BootSlave> slots;  ///< as many slaves are booted at once; each needs a route
  };
  struct Owner {
    Callback<void(NodeId)> booted;  ///< a slave is up: it may be started
    Callback<void()> changed;       ///< the state of a slave may be another one
  };

  /// All of it must outlive this.
  SlaveBoots(BootContext& context, const Memory& memory, const Owner& owner);
  SlaveBoots(const SlaveBoots&) = delete;
  SlaveBoots& operator=(const SlaveBoots&) = delete;

  const Record& record(NodeId slave) const { return memory_.records[slave - std::size_t{1}]; }

  /// All that are assigned (1F81h) are due at once.
  void begin();
  /// Resets the communication of all, but of those that are to be kept alive: these wait for their
  /// boot-up message from when the command is sent.
  void reset_all();
  /// Looks who is due.
  void wake() { context_.node.timers().arm(timer_, context_.node.now()); }
  /// What is under way begins anew at the next wake().
  void rest();
  /// Leaves everything as it is, and forgets it.
  void retire();

  /// Assigned, or no longer so, while the others are under way.
  void assign(NodeId slave, bool is_slave);
  /// A command to reset it is on the bus, or all are reset.
  void reset_sent(std::uint8_t slave_or_all);
  /// Later where there is no room for its command.
  void start(NodeId slave);
  /// Those that are up.
  void start_all();

  /// Each error control message of each node.
  void heard(NodeId slave, RemoteState state);
  void changed(NodeId slave, RemoteState state);
  /// Of a slave that is up nothing is heard any more.
  void lost(NodeId slave);

 private:
  static constexpr NodeId nobody = 0;

  void booted_up(NodeId slave);
  void restarted(NodeId slave, BootReport restart);
  void give_up(NodeId slave, BootReport restart);
  void queue(NodeId slave, Time due);
  void forget(NodeId slave);
  void run_due(Time now);
  void boot_next(Time now);
  /// Not later than that.
  void wake_at(Time due) {
    if (due < timer_.at()) context_.node.timers().arm(timer_, due);
  }
  void start_late(Time now);
  static bool starts_late(const Record& record) {
    return record.state == State::booted && !record.is_started && record.due != never;
  }
  NodeId find_due(Time now) const;
  BootSlave* find_slot(NodeId slave);
  void finished(BootSlave& slot, BootOutcome outcome);
  void try_again(NodeId slave, BootReport end);
  void report(const BootReport& report) { context_.report(report); }

  Record& at(NodeId slave) { return memory_.records[slave - std::size_t{1}]; }
  Time now() const { return context_.node.now(); }
  SlaveAssignment assignment(NodeId slave) const {
    return slave_assignment(context_.node.dictionary(), slave);
  }

  BootContext& context_;
  Memory memory_;
  Owner owner_;
  Timer timer_;
  bool is_active_ = false;
};

}  // namespace canvoy
