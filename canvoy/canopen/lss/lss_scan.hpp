// Names a whole network: finds all nodes without node-ID by Fastscan, one after the other, and
// gives each a node-ID (CiA 305).
//
//     LssAddress memory[127];
//     LssScan scan(node, master, memory);
//     scan.on_choose(LssScan::Choose::to<&Tool::choose>(tool));
//     scan.start({.store = true}, LssScan::Done::to<&Tool::done>(tool));
#pragma once

#include <span>

#include "canvoy/canopen/lss/lss_tree.hpp"

namespace canvoy {

/// A node that was given a node-ID boots at once. From the first on that is given none, nodes are
/// identified only: they stay in state configuration, where Fastscan does not find them again, and
/// return to waiting at the end.
///
/// Two faults of others are borne with. A slave that answers Fastscan although it has a node-ID is
/// left in state configuration when it comes back; to name the next one all are sent to waiting,
/// and that one alone is selected. A slave that answers every Fastscan message in state
/// configuration hides all others from there on, and shows in an address that is nobody's: then all
/// go back to waiting, and LssTree finds the rest.
class LssScan {
 public:
  struct Options {
    LssPattern pattern;  ///< only nodes like this
    bool store = false;  ///< let each node keep its node-ID over the power
  };
  enum class Outcome : std::uint8_t {
    complete,   ///< no further node answers
    duplicate,  ///< an address came again while its node was in state configuration: two nodes
                ///< have it
    hidden,     ///< a node answers for others also where all are waiting, or it stays doubtful
                ///< for another reason whether all were found
    lost,       ///< a node could not be identified, as LssFastscan has it, or a callback began
                ///< another service of the master
    full,       ///< there is no memory for further addresses
  };
  struct Found {
    LssAddress address;
    NodeId id = node_id_unconfigured;  ///< that it took
    bool duplicate = false;            ///< several nodes answered that they have this address
    LssMaster::Reply configured;       ///< where an id was given to it
    LssMaster::Reply stored;           ///< where it was to be stored
  };
  /// The node-ID for a node, or node_id_unconfigured.
  using Choose = Callback<NodeId(const LssAddress&)>;
  using Report = Callback<void(const Found&)>;
  using Done = Callback<void(Outcome)>;

  /// `addresses` are those that were found; it must outlive the scan.
  LssScan(Node& node, LssMaster& master, std::span<LssAddress> addresses);
  LssScan(Node& node, LssMaster& master, std::span<LssAddress> addresses,
          const LssFastscan::Options& options);
  LssScan(const LssScan&) = delete;
  LssScan& operator=(const LssScan&) = delete;

  void on_choose(Choose choose) { choose_ = choose; }
  /// Called for each node, when its configuration has ended.
  void on_found(Report report) { report_ = report; }

  /// False where a scan or a service of the master is under way.
  bool start(const Options& options, Done done);
  /// Gives up, without a call of `done`; also from within the callbacks.
  void cancel();

  std::span<const LssAddress> found() const { return addresses_.first(count_); }
  /// The one that was found last, also where it ended the scan.
  const Found& last() const { return found_; }
  /// Whether an address came again that has its node-ID: of a slave that answers Fastscan with one,
  /// or of a second node with this address.
  bool came_again() const { return came_again_; }
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
  /// Nodes that were found are in state configuration.
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
  /// After a callback: whether it has neither cancelled this run nor begun another one.
  bool goes_on(std::uint32_t run) const { return running_ && run == run_; }

  Node& node_;
  LssMaster& master_;
  LssFastscan fastscan_;
  LssTree tree_;
  Timer retry_;
  Step step_ = nullptr;  ///< when there may be room for it in the controller
  std::span<LssAddress> addresses_;
  std::size_t count_ = 0;
  std::size_t count_before_ = 0;  ///< when the walk that is under way began; 0 for the first
  std::size_t parked_ = 0;        ///< that came back, and are in state configuration
  Options options_;
  Choose choose_;
  Report report_;
  Done done_;
  Found found_;
  NodeId chosen_ = node_id_unconfigured;
  Outcome outcome_ = Outcome::complete;
  std::uint32_t run_ = 0;  ///< counts those that were started
  std::uint8_t attempts_ = 0;
  bool running_ = false;
  bool identifying_only_ = false;
  bool came_again_ = false;
  bool is_doubtful_ = false;  ///< whether what was found is there
};

}  // namespace canvoy
