// The slaves of an NMT master: progress of each, their order, and the reaction to restart, silence
// and missing answers (CiA 302-2).
//
// As many slaves are booted at once as there are slots; the others wait for their turn. Memory
// belongs to the owner.
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

/// Works between begin() and retire() only. Each step of each slave goes to the report of the
/// context; the report may call retire().
class SlaveBoots {
 public:
  /// Progress of a slave; none if it is not assigned.
  enum class State : std::uint8_t { none, waiting, booting, booted, failed };
  /// State of one slave.
  struct Record {
    Time due = never;  ///< of the next attempt, while it is waiting; of a start that found no room
    Time since{};      ///< begin of the boot time (1F89h)
    State state = State::none;          ///< see State
    BootError error = BootError::none;  ///< of the last attempt
    SlaveRestarts restarts{};           ///< without a command
    bool is_fresh = false;    ///< has sent a boot-up message, and nothing was changed since
    bool was_tried = false;   ///< an attempt has ended
    bool is_started = false;  ///< commanded into operational, or about to be
    /// A reset was commanded during its boot-up: the next boot-up message is no fault.
    bool is_told_reset = false;
  };
  /// Memory of the owner.
  struct Memory {
    std::span<Record, node_id_max> records;  ///< by node-ID, from 1
    std::span<BootSlave> slots;  ///< number of slaves booted at once; each needs a route
  };
  /// Callbacks of the owner.
  struct Owner {
    Callback<void(NodeId)> booted;  ///< a slave is booted: it may be started
    Callback<void()> changed;       ///< the state of a slave may have changed
  };

  /// Makes the object. All arguments must outlive it.
  SlaveBoots(BootContext& context, const Memory& memory, const Owner& owner);
  SlaveBoots(const SlaveBoots&) = delete;
  SlaveBoots& operator=(const SlaveBoots&) = delete;

  /// Record of a slave, 1 to 127.
  const Record& record(NodeId slave) const { return memory_.records[slave - std::size_t{1}]; }

  /// Makes all assigned slaves (1F81h) due at once.
  void begin();
  /// Resets the communication of all slaves, except those to be kept alive: the others wait for
  /// their boot-up message from the command on.
  void reset_all();
  /// Checks which slaves are due.
  void wake() { context_.node.timers().arm(timer_, context_.node.now()); }
  /// Makes work in progress begin again at the next wake().
  void rest();
  /// Stops the work without changing any node, and discards it.
  void retire();

  /// Assigns a slave, or ends its assignment, while the others are under way.
  void assign(NodeId slave, bool is_slave);
  /// Notes that a command to reset a slave, or all, is on the bus.
  void reset_sent(std::uint8_t slave_or_all);
  /// Starts a slave; later if there is no room for its command.
  void start(NodeId slave);
  /// Starts all that are booted.
  void start_all();

  /// Takes each error control message of each node.
  void heard(NodeId slave, RemoteState state);
  /// Takes a change of a node's state, lost included.
  void changed(NodeId slave, RemoteState state);
  /// Notes that a booted slave is silent.
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
  /// Wakes at `due`, or earlier.
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
