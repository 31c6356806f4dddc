// Assigns node-IDs to a whole network: finds all nodes without node-ID by Fastscan, one after the
// other, and gives each a node-ID (CiA 305).
//
//     LssAddress memory[127];
//     LssScan scan(node, master, memory);
//     scan.on_choose(LssScan::Choose::to<&Tool::choose>(tool));
//     scan.start({.store = true}, LssScan::Done::to<&Tool::done>(tool));
#pragma once

#include <span>

#include "canvoy/canopen/lss/lss_tree.hpp"

namespace canvoy {

/// A node that gets a node-ID boots at once. After the first node that gets none, nodes are
/// identified only: they stay in state configuration, where Fastscan does not find them again, and
/// return to waiting at the end.
///
/// Two faults of slaves are tolerated. A slave that answers Fastscan although it has a node-ID is
/// left in state configuration when it is found again; for the next assignment all are sent to
/// waiting, and the new one alone is selected. A slave that answers every Fastscan message in state
/// configuration hides all others from then on, which shows in an address without a node: then all
/// return to waiting, and LssTree finds the rest.
class LssScan {
 public:
  /// What to look for, and what to do with it.
  struct Options {
    LssPattern pattern;  ///< only nodes with this pattern
    bool store = false;  ///< each node stores its node-ID
  };
  /// How a scan ended.
  enum class Outcome : std::uint8_t {
    complete,  ///< no further node answers
    /// An address was found again with its node in state configuration: two nodes have it.
    duplicate,
    /// A node answers for others even if all are waiting, or it remains uncertain for another
    /// reason whether all were found.
    hidden,
    /// A node could not be identified, as in LssFastscan, or a callback began another service of
    /// the master.
    lost,
    full,  ///< there is no memory for further addresses
  };
  /// A node that was found, and what was done with it.
  struct Found {
    LssAddress address;                ///< its identity
    NodeId id = node_id_unconfigured;  ///< the node-ID that it took
    bool duplicate = false;            ///< several nodes answered to this address
    LssMaster::Reply configured;       ///< if it was given an id
    LssMaster::Reply stored;           ///< if it had to store it
  };
  /// Returns the node-ID for a node, or node_id_unconfigured.
  using Choose = Callback<NodeId(const LssAddress&)>;
  /// Called for each node.
  using Report = Callback<void(const Found&)>;
  /// Called at the end of a scan.
  using Done = Callback<void(Outcome)>;

  /// Makes the scan. `addresses` holds the addresses found; it must outlive the scan.
  LssScan(Node& node, LssMaster& master, std::span<LssAddress> addresses);
  /// Makes the scan with other times of Fastscan. `addresses` must outlive the scan.
  LssScan(Node& node, LssMaster& master, std::span<LssAddress> addresses,
          const LssFastscan::Options& options);
  LssScan(const LssScan&) = delete;
  LssScan& operator=(const LssScan&) = delete;

  /// Sets the callback that chooses node-IDs; without it, nodes are identified only.
  void on_choose(Choose choose) { choose_ = choose; }
  /// Sets the callback for each node, called when its configuration has ended.
  void on_found(Report report) { report_ = report; }

  /// Starts a scan. False if a scan or a service of the master is under way.
  bool start(const Options& options, Done done);
  /// Stops the scan, without a call of `done`; also allowed in the callbacks.
  void cancel();

  /// Addresses found by the present or last scan, in the order of discovery.
  std::span<const LssAddress> found() const { return addresses_.first(count_); }
  /// The node that was found last, also if it ended the scan.
  const Found& last() const { return found_; }
  /// True if an address was found again that has its node-ID: a slave that answers Fastscan with
  /// one, or a second node with this address.
  bool came_again() const { return came_again_; }
  /// The search, for its measured times and number of requests.
  const LssFastscan& fastscan() const { return fastscan_; }

 private:
  using Step = void (LssScan::*)();

  void next();
  void node_found(const LssFastscan::Result& result);
  bool came_before(const LssFastscan::Result& result);
  void walk();
  void walked(const LssTree::Result& result);
  void selected(const LssMaster::Reply& reply);
  void take();
  void name();
  bool select();
  /// True if nodes that were found are in state configuration.
  bool others_in_configuration() const { return identifying_only_ || parked_ != 0; }
  void configure();
  void configured(const LssMaster::Reply& reply);
  void store();
  void stored(const LssMaster::Reply& reply);
  void report();
  void finish(Outcome outcome);
  void end();
  void later(Step step);
  void configuration_unsent() { configured({}); }
  void store_unsent() { stored({}); }
  void retry(Time) { (this->*step_)(); }
  /// After a callback: true if it has neither cancelled this run nor begun another one.
  bool goes_on(std::uint32_t run) const { return running_ && run == run_; }

  Node& node_;
  LssMaster& master_;
  LssFastscan fastscan_;
  LssTree tree_;
  Timer retry_;
  Step step_ = nullptr;  ///< called when the controller may have room
  std::span<LssAddress> addresses_;
  std::size_t count_ = 0;
  std::size_t count_before_ = 0;  ///< at the beginning of the present walk; 0 for the first
  std::size_t parked_ = 0;        ///< found again, and in state configuration
  Options options_;
  Choose choose_;
  Report report_;
  Done done_;
  Found found_;
  NodeId chosen_ = node_id_unconfigured;
  Outcome outcome_ = Outcome::complete;
  std::uint32_t run_ = 0;  ///< counts the runs
  std::uint8_t attempts_ = 0;
  bool running_ = false;
  bool identifying_only_ = false;
  bool came_again_ = false;
  bool is_doubtful_ = false;  ///< uncertain whether the found node exists
};

}  // namespace canvoy
