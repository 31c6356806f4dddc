#include "canvoy/canopen/lss/lss_tree.hpp"

#include <algorithm>
#include <bit>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

namespace {

/// As the lowest known bit: none.
constexpr std::uint8_t no_bit = 32;
constexpr std::uint8_t walks_max = 5;
/// Limit over all walks: a slave that always answers everything produces addresses without end.
constexpr std::uint8_t passed_over_max = 16;

}  // namespace

LssTree::LssTree(Node& node, LssMaster& master, const LssFastscan::Options& options)
    : node_(node), master_(master), options_(options), retry_(callback<&LssTree::unsent>(*this)) {}

void LssTree::begin(const LssPattern& pattern, const LssPace& pace, Done done) {
  pattern_ = pattern;
  pace_ = pace;
  done_ = done;
  walks_ = passed_over_ = 0;
  walking_ = true;
  walk();
}

void LssTree::cancel() {
  walking_ = false;
  node_.timers().disarm(retry_);
}

// From branch to branch

void LssTree::walk() {
  address_ = {};
  ones_ = {};
  part_ = 0;
  bit_ = no_bit;
  is_doubtful_ = false;
  seek();
}

/// Goes back to the last position where ones were answered as well as zeros.
void LssTree::next() {
  const auto place =
      std::find_if(ones_.rbegin(), ones_.rend(), [](auto bits) { return bits != 0; });
  if (place != ones_.rend()) {
    part_ = static_cast<std::uint8_t>(ones_.rend() - place - 1);
    bit_ = static_cast<std::uint8_t>(std::countr_zero(*place));
    *place &= *place - 1;
    address_.parts[part_] = (address_.parts[part_] >> bit_ | 1U) << bit_;
    std::fill(address_.parts.begin() + part_ + 1, address_.parts.end(), 0);
    return seek();
  }
  is_doubtful_ ? walk_again() : finish(Outcome::nobody);
}

void LssTree::pass_over() {
  is_doubtful_ = true;
  ++passed_over_ < passed_over_max ? next() : finish(Outcome::lost);
}

/// Called after a branch that ended before its last bit: a slave has left, or an answer was late,
/// and so were those after it.
void LssTree::walk_again() {
  pace_.lengthen(options_.time_out_max);
  ++walks_ < walks_max ? walk() : finish(Outcome::lost);
}

bool LssTree::is_at_root() const {
  return part_ == 0 && bit_ == no_bit;
}

/// Sends all slaves back to the first part, and those selected meanwhile back to waiting. At the
/// root all answers are waited for, to measure the slowest.
void LssTree::seek() {
  master_.switch_global(LssState::waiting);
  place_ = 0;
  if (!is_at_root()) return ask(&LssTree::anybody_answered, {});
  ask(&LssTree::anybody_answered, {}, options_.first_time_out, options_.first_time_out);
}

void LssTree::anybody_answered(const LssMaster::Reply& reply) {
  if (reply.ok()) return go_down();
  is_at_root() && !is_doubtful_ ? finish(Outcome::nobody) : walk_again();
}

/// Slaves that match all parts so far go to the requested part.
void LssTree::go_down() {
  check_invariant(place_ <= part_ && part_ <= LssAddress::serial);
  if (place_ == part_) return descend();
  ask(&LssTree::part_answered, {.id_number = address_.parts[place_],
                                .bit_checked = 0,
                                .sub = place_,
                                .next = static_cast<std::uint8_t>(place_ + 1)});
}

void LssTree::part_answered(const LssMaster::Reply& reply) {
  if (!reply.ok()) return pattern_.known[place_] ? next() : walk_again();
  ++place_;
  go_down();
}

// From bit to bit

void LssTree::descend() {
  if (bit_ == no_bit && pattern_.known[part_]) {
    address_.parts[part_] = pattern_.address.parts[part_];
    bit_ = 0;
  }
  const std::uint32_t number = address_.parts[part_];
  if (bit_ != 0) {
    --bit_;
    return ask(&LssTree::zero_answered,
               {.id_number = number, .bit_checked = bit_, .sub = part_, .next = part_});
  }
  if (part_ == LssAddress::serial) {
    return ask(&LssTree::address_answered,
               {.id_number = number, .bit_checked = 0, .sub = part_, .next = part_}, pace_.time_out,
               pace_.time_out);
  }
  ++part_;
  bit_ = no_bit;
  go_down();
}

void LssTree::zero_answered(const LssMaster::Reply& reply) {
  zero_answered_ = reply.ok();
  ask(&LssTree::one_answered, {.id_number = address_.parts[part_] | 1U << bit_,
                               .bit_checked = bit_,
                               .sub = part_,
                               .next = part_});
}

void LssTree::one_answered(const LssMaster::Reply& reply) {
  if (!reply.ok() && !zero_answered_) return walk_again();
  check_invariant(((address_.parts[part_] | ones_[part_]) >> bit_ & 1) == 0);
  if (reply.ok()) (zero_answered_ ? ones_ : address_.parts)[part_] |= 1U << bit_;
  descend();
}

/// All answers were waited for: more than one means that several slaves have the address.
void LssTree::address_answered(const LssMaster::Reply& reply) {
  if (!reply.ok()) return pattern_.known[part_] ? next() : walk_again();
  const Result result{
      .outcome = Outcome::found, .address = address_, .duplicate = reply.answers > 1};
  done_(result);
}

// Requests

void LssTree::ask(Step step, const lss::FastscanRequest& request) {
  ask(step, request, pace_.time_out, pace_.settle);
}

/// Treats a full controller as if no slave had answered: the walk has to be repeated.
void LssTree::ask(Step step, const lss::FastscanRequest& request, Duration time_out,
                  Duration settle) {
  step_ = step;
  const auto done = LssMaster::Done::to<&LssTree::take_reply>(*this);
  if (master_.fastscan(request, time_out, settle, done)) return;
  node_.timers().arm(retry_, node_.now() + options_.first_time_out);
}

void LssTree::unsent(Time) {
  is_doubtful_ = true;
  (this->*step_)({});
}

void LssTree::take_reply(const LssMaster::Reply& reply) {
  pace_.measure(reply, options_.time_out_max);
  (this->*step_)(reply);
}

void LssTree::finish(Outcome outcome) {
  walking_ = false;
  done_({.outcome = outcome, .address = {}, .duplicate = false});
}

}  // namespace canvoy
