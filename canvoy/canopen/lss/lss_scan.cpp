#include "canvoy/canopen/lss/lss_scan.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

namespace {

/// Number of attempts if a message is lost.
constexpr std::uint8_t attempts_max = 3;
/// Time from a message that the controller had no room for to the next attempt.
constexpr Duration retry_interval = 100ms;

}  // namespace

LssScan::LssScan(Node& node, LssMaster& master, std::span<LssAddress> addresses)
    : LssScan(node, master, addresses, LssFastscan::Options{}) {}

LssScan::LssScan(Node& node, LssMaster& master, std::span<LssAddress> addresses,
                 const LssFastscan::Options& options)
    : node_(node),
      master_(master),
      fastscan_(node, master, options),
      tree_(node, master, options),
      retry_(callback<&LssScan::retry>(*this)),
      addresses_(addresses) {}

bool LssScan::start(const Options& options, Done done) {
  if (running_ || !master_.idle()) return false;
  running_ = true;
  ++run_;
  options_ = options;
  done_ = done;
  count_ = count_before_ = parked_ = 0;
  came_again_ = false;
  identifying_only_ = false;
  master_.switch_global(LssState::waiting);
  next();
  return true;
}

void LssScan::cancel() {
  if (!running_) return;
  running_ = false;
  fastscan_.cancel();
  tree_.cancel();
  master_.cancel();
  node_.timers().disarm(retry_);
}

void LssScan::later(Step step) {
  step_ = step;
  node_.timers().arm(retry_, node_.now() + retry_interval);
}

void LssScan::next() {
  if (tree_.walking()) return master_.idle() ? tree_.next() : finish(Outcome::lost);
  const auto done = LssFastscan::Done::to<&LssScan::node_found>(*this);
  if (!fastscan_.find(options_.pattern, done, others_in_configuration())) finish(Outcome::lost);
}

void LssScan::node_found(const LssFastscan::Result& result) {
  if (result.outcome == LssFastscan::Outcome::nobody) return finish(Outcome::complete);
  if (result.outcome == LssFastscan::Outcome::lost) return finish(Outcome::lost);
  if (identifying_only_ && !result.checked) return walk();
  if (came_before(result)) {
    // Fastscan has left it in state configuration, where it is silent: once for each of them.
    came_again_ = true;
    return ++parked_ > count_ ? finish(Outcome::duplicate) : next();
  }
  // A slave that answers everything has zeros in all unknown bits.
  is_doubtful_ = others_in_configuration() && result.address.parts[LssAddress::serial] == 0;
  if (is_doubtful_ && !select()) return finish(Outcome::lost);
  if (!is_doubtful_) take();
}

bool LssScan::came_before(const LssFastscan::Result& result) {
  found_ = {};
  found_.address = result.address;
  found_.duplicate = result.duplicate;
  const auto known = found();
  return std::ranges::find(known, result.address) != known.end();
}

/// Among waiting slaves no slave answers for others. Until one is in state configuration, addresses
/// are checked by their own serial number: an address that fails belongs to a slave that answers
/// everything there, or that supports Fastscan only.
void LssScan::walk() {
  tree_.begin(options_.pattern, fastscan_.pace(), LssTree::Done::to<&LssScan::walked>(*this));
}

/// A lost message hides a branch: the search ends when a walk finds nothing new.
void LssScan::walked(const LssTree::Result& result) {
  if (result.outcome == LssTree::Outcome::nobody) {
    check_invariant(count_before_ <= count_);
    return std::exchange(count_before_, count_) == count_ ? finish(Outcome::complete) : walk();
  }
  if (result.outcome == LssTree::Outcome::lost) return finish(Outcome::hidden);
  if (came_before(result)) return tree_.next();
  is_doubtful_ = true;
  if (!select()) finish(Outcome::lost);
}

/// Selects one slave alone: all others return to waiting.
bool LssScan::select() {
  parked_ = 0;
  return master_.switch_global(LssState::waiting) &&
         master_.select(found_.address, LssMaster::Done::to<&LssScan::selected>(*this));
}

void LssScan::selected(const LssMaster::Reply& reply) {
  if (reply.ok()) return is_doubtful_ ? take() : configure();
  if (!is_doubtful_) return finish(Outcome::lost);
  tree_.walking() ? tree_.pass_over() : walk();
}

void LssScan::take() {
  if (count_ == addresses_.size()) return finish(Outcome::full);
  addresses_[count_++] = found_.address;
  const std::uint32_t run = run_;
  const NodeId chosen = identifying_only_ ? node_id_unconfigured : choose_(found_.address);
  if (!goes_on(run)) return;
  chosen_ = chosen;
  identifying_only_ = !is_node_id(chosen_);
  if (identifying_only_) return report();
  attempts_ = 0;
  name();
}

/// No other slave may be in state configuration, since both would get the node-ID.
void LssScan::name() {
  if (parked_ == 0) return configure();
  is_doubtful_ = false;
  if (!select()) finish(Outcome::lost);
}

void LssScan::configure() {
  if (master_.configure_node_id(chosen_, LssMaster::Done::to<&LssScan::configured>(*this))) return;
  master_.idle() ? later(&LssScan::configuration_unsent) : report();
}

void LssScan::configured(const LssMaster::Reply& reply) {
  found_.configured = reply;
  if (reply.outcome == LssMaster::Outcome::time_out && ++attempts_ < attempts_max) {
    return configure();
  }
  // Without a node-ID it stays in state configuration, and so must all that follow.
  identifying_only_ = !reply.ok();
  if (reply.ok()) found_.id = chosen_;
  attempts_ = 0;
  reply.ok() && options_.store ? store() : report();
}

void LssScan::store() {
  if (master_.store(LssMaster::Done::to<&LssScan::stored>(*this))) return;
  master_.idle() ? later(&LssScan::store_unsent) : report();
}

void LssScan::stored(const LssMaster::Reply& reply) {
  found_.stored = reply;
  if (reply.outcome == LssMaster::Outcome::time_out && ++attempts_ < attempts_max) return store();
  attempts_ = 0;
  report();
}

/// While a node is in state configuration, no other can get a node-ID, which would go to both.
void LssScan::report() {
  if (!identifying_only_ && !master_.switch_global(LssState::waiting)) {
    if (++attempts_ < attempts_max) return later(&LssScan::report);
    identifying_only_ = true;
  }
  if (!identifying_only_) parked_ = 0;
  const std::uint32_t run = run_;
  report_(found_);
  if (goes_on(run)) next();
}

void LssScan::finish(Outcome outcome) {
  tree_.cancel();
  outcome_ = outcome;
  attempts_ = 0;
  end();
}

void LssScan::end() {
  const bool sent = master_.switch_global(LssState::waiting);
  if (!sent && ++attempts_ < attempts_max) return later(&LssScan::end);
  running_ = false;
  done_(outcome_);
}

}  // namespace canvoy
