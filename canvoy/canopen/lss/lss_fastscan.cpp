#include "canvoy/canopen/lss/lss_fastscan.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

namespace {

constexpr std::uint8_t top_bit = 31;
/// Number of requests to all slaves, each with twice the time-out, until none is assumed to be
/// present.
constexpr std::uint8_t silences_max = 3;
/// Limit of the questions whether any slave is there that a full controller does not take.
constexpr std::uint8_t unsent_max = 10;
/// Number of checks of one address, since its node may have left Fastscan already.
constexpr std::uint8_t checks_max = 2;
/// Factor from a measured time to the time used.
constexpr int margin = 2;
constexpr Duration settle_min = 1ms;

}  // namespace

void LssPace::measure(const LssMaster::Reply& reply, Duration max) {
  if (reply.answers == 0) return;
  const Duration spread = reply.last_answer - reply.first_answer;
  recent_time_out = std::max(recent_time_out, std::min(reply.last_answer * margin, max));
  recent_settle = std::max(recent_settle, std::min(spread * margin, max));
  time_out = std::max(time_out, recent_time_out);
  settle = std::max(settle, recent_settle);
}

void LssPace::lengthen(Duration max) {
  time_out = std::min(time_out * 2, max);
  settle = std::min(std::max(settle * 2, settle_min), max);
}

void LssPace::relax(Duration time_out_min) {
  time_out = std::max({time_out / 2, recent_time_out, time_out_min});
  settle = std::max(settle / 2, recent_settle);
  recent_time_out = recent_settle = {};
}

LssFastscan::LssFastscan(Node& node, LssMaster& master) : LssFastscan(node, master, Options{}) {}

LssFastscan::LssFastscan(Node& node, LssMaster& master, const Options& options)
    : node_(node),
      master_(master),
      options_(options),
      retry_(callback<&LssFastscan::unsent>(*this)),
      pace_{.time_out = options.time_out_min, .settle = {}} {}

bool LssFastscan::find(const LssPattern& pattern, Done done, bool others_in_configuration) {
  if (running_ || !master_.idle()) return false;
  running_ = true;
  pattern_ = pattern;
  done_ = done;
  others_in_configuration_ = others_in_configuration;
  result_ = {};
  for (std::size_t part = 0; part < guess_.parts.size(); ++part) {
    if (pattern.known[part]) guess_.parts[part] = pattern.address.parts[part];
    guessed_[part] = pattern.known[part] || (measured_ && part != LssAddress::serial);
  }
  attempts_ = 0;
  pace_.relax(options_.time_out_min);
  begin_anew();
  return true;
}

void LssFastscan::cancel() {
  if (!running_) return;
  running_ = false;
  master_.cancel();
  node_.timers().disarm(retry_);
}

// All slaves

void LssFastscan::begin_anew() {
  silences_ = unsent_ = 0;
  confirmed_ = alone_ = false;
  ask_anybody();
}

/// The first time of all, every answer is waited for, to measure the slowest.
void LssFastscan::ask_anybody() {
  step_ = &LssFastscan::anybody_answered;
  const Duration time_out = options_.first_time_out * (1 << silences_);
  ask({}, time_out, measured_ ? pace_.settle : time_out);
}

void LssFastscan::anybody_answered(const LssMaster::Reply& reply) {
  if (!reply.ok()) {
    if (++silences_ < silences_max) return ask_anybody();
    return finish(attempts_ == 0 ? Outcome::nobody : Outcome::lost);
  }
  measured_ = true;
  part_ = 0;
  begin_part();
}

// Bit by bit

/// A node that answers alone is the only one with all bits so far: from there on its own time
/// counts. Not after an earlier failure: the answers of two nodes may have been one frame.
void LssFastscan::note_company(const LssMaster::Reply& reply) {
  if (reply.answers != 1 || attempts_ > 0) return;
  alone_latency_ = alone_ ? std::max(alone_latency_, reply.last_answer) : reply.last_answer;
  alone_ = true;
}

Duration LssFastscan::next_time_out() const {
  return alone_ ? std::clamp(alone_latency_ * margin, options_.time_out_min, pace_.time_out)
                : pace_.time_out;
}

Duration LssFastscan::next_settle() const {
  return alone_ ? Duration::zero() : pace_.settle;
}

void LssFastscan::begin_part() {
  check_invariant(part_ <= LssAddress::serial);
  trying_guess_ = guessed_[part_];
  number_ = trying_guess_ ? guess_.parts[part_] : 0;
  bit_ = trying_guess_ ? 0 : top_bit;
  trying_guess_ ? confirm() : ask_bit();
}

void LssFastscan::ask_bit() {
  step_ = &LssFastscan::bit_answered;
  ask({.id_number = number_, .bit_checked = bit_, .sub = part_, .next = part_}, next_time_out(),
      next_settle());
}

void LssFastscan::bit_answered(const LssMaster::Reply& reply) {
  check_invariant((number_ >> bit_ & 1) == 0);
  if (!reply.ok()) number_ |= 1U << bit_;
  note_company(reply);
  if (bit_ == 0) return confirm();
  --bit_;
  ask_bit();
}

/// The last confirmation waits for all answers: more than one means that several nodes have the
/// address.
void LssFastscan::confirm() {
  const bool last = part_ == LssAddress::serial;
  step_ = &LssFastscan::part_confirmed;
  ask({.id_number = number_,
       .bit_checked = 0,
       .sub = part_,
       .next = last ? std::uint8_t{0} : static_cast<std::uint8_t>(part_ + 1)},
      last ? pace_.time_out : next_time_out(), last ? pace_.time_out : next_settle());
}

void LssFastscan::part_confirmed(const LssMaster::Reply& reply) {
  result_.address.parts[part_] = number_;
  confirmed_ = reply.ok();
  if (part_ == LssAddress::serial) {
    result_.duplicate = reply.answers > 1;
    checks_ = 0;
    return check_address();
  }
  if (!reply.ok()) return not_confirmed();
  note_company(reply);
  guess_.parts[part_] = number_;
  guessed_[part_] = true;
  ++part_;
  begin_part();
}

/// Either a guess was wrong, or the address found does not exist: then a message was lost, or an
/// answer was late and counted for the next bit. The node may have reached state configuration
/// nevertheless, where Fastscan does not find it: it is sent back.
void LssFastscan::not_confirmed() {
  if (trying_guess_ && !pattern_.known[part_]) {
    for (std::size_t part = part_; part < guessed_.size(); ++part) {
      guessed_[part] = pattern_.known[part];
    }
    return begin_part();
  }
  if (pattern_.known[part_] && attempts_ > 0) {
    return finish(confirmed_ ? Outcome::lost : Outcome::nobody);
  }
  if (++attempts_ >= options_.attempts_max) return finish(Outcome::lost);
  pace_.lengthen(options_.time_out_max);
  if (!others_in_configuration_) master_.switch_global(LssState::waiting);
  begin_anew();
}

// Checks that the whole address is that of a node: also if its last answer was lost, or belonged to
// an earlier message. The node is in state configuration: if it is alone there it reports its
// serial number. Otherwise it can only be identified, which not all slaves support.

void LssFastscan::check_address() {
  step_ = &LssFastscan::address_checked;
  const bool sent = others_in_configuration_
                        ? master_.identify(LssRange::exactly(result_.address), answered())
                        : master_.inquire(LssAddress::serial, answered());
  if (!sent) give_up_request();
}

void LssFastscan::address_checked(const LssMaster::Reply& reply) {
  if (!reply.ok() && ++checks_ < checks_max) return check_address();
  const bool is_there =
      others_in_configuration_ ? reply.ok() || confirmed_ : reply.ok() && reply.value == number_;
  if (!is_there) return not_confirmed();
  guess_ = result_.address;
  result_.checked = reply.ok();
  if (confirmed_ || !others_in_configuration_) return finish(Outcome::found);
  step_ = &LssFastscan::selected;
  if (!master_.select(result_.address, answered())) give_up_request();
}

/// A node that is in state configuration already does not answer.
void LssFastscan::selected(const LssMaster::Reply&) {
  finish(Outcome::found);
}

// Requests

void LssFastscan::ask(const lss::FastscanRequest& request, Duration time_out, Duration settle) {
  ++requests_;
  if (!master_.fastscan(request, time_out, settle, answered())) give_up_request();
}

/// Treats a full controller as if no slave had answered.
void LssFastscan::give_up_request() {
  node_.timers().arm(retry_, node_.now() + options_.first_time_out);
}

void LssFastscan::unsent(Time) {
  // Whether a node is there is unknown if none was asked.
  if (step_ == &LssFastscan::anybody_answered) {
    return ++unsent_ < unsent_max ? ask_anybody() : finish(Outcome::lost);
  }
  (this->*step_)({});
}

void LssFastscan::take_reply(const LssMaster::Reply& reply) {
  if (step_ != &LssFastscan::address_checked && step_ != &LssFastscan::selected) {
    pace_.measure(reply, options_.time_out_max);
  }
  (this->*step_)(reply);
}

void LssFastscan::finish(Outcome outcome) {
  running_ = false;
  result_.outcome = outcome;
  const Result result = result_;
  done_(result);
}

}  // namespace canvoy
