#include "canvoy/tools/network/lss_session.hpp"

#include <fmt/format.h>

#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/network/lss_argument.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

namespace {}  // namespace

LssSession::LssSession(std::string_view bus, AnswerTime time_out)
    : time_out_(time_out), loop_(value_or_throw(host::EventLoop::create())) {
  bus_ = value_or_throw(host::open_bus(*loop_, real_bus(bus)));
  attachment_ = std::make_unique<host::Attachment>(*loop_, *bus_);
  node_ = std::make_unique<Node>(
      no_dictionary, NodeMemory{.values = {}, .states = {}, .routes = routes_, .backlog = backlog_},
      attachment_->port(), node_id_unconfigured);
  master_ = std::make_unique<LssMaster>(*node_);
  master_->set_time_out(time_out.usual);
  attachment_->attach(*node_);
  bus_->on_frame([this](const host::BusFrame& heard) {
    const bool is_answer = heard.frame.id == can_id::lss_response && !heard.frame.is_extended();
    answers_ += is_answer ? 1 : 0;
  });
  ok_or_throw(loop_->stop_on_signals());
}

LssSession::~LssSession() = default;

void LssSession::run_until_stopped() {
  loop_->run();
  if (loop_->signal() != 0) throw Failure("interrupted");
}

void LssSession::finished(const LssMaster::Reply& reply) {
  reply_ = reply;
  loop_->stop();
}

LssMaster::Reply LssSession::ask(const std::function<bool(LssMaster::Done)>& begin) {
  node_->advance(loop_->now());
  if (!begin(LssMaster::Done::to<&LssSession::finished>(*this))) {
    throw Failure(fmt::format("{}: the frames were refused", bus_->name()));
  }
  run_until_stopped();
  return reply_;
}

LssMaster::Reply LssSession::ask_or_throw(lss::Command command,
                                          const std::function<bool(LssMaster::Done)>& begin) {
  const Duration limit = command == lss::Command::store ? time_out_.storing : time_out_.usual;
  master_->set_time_out(limit);
  const LssMaster::Reply reply = ask(begin);
  master_->set_time_out(time_out_.usual);
  if (reply.outcome == LssMaster::Outcome::refused) {
    throw Failure(lss_error_text(command, reply.error));
  }
  if (reply.outcome == LssMaster::Outcome::time_out) {
    throw Failure(
        fmt::format("no node answered within {}; is it on {}, with power, LSS and this address?",
                    text::duration_text(limit), bus_->name()));
  }
  return reply;
}

/// Without an answer: waits until the message is on the bus.
void LssSession::send(const std::function<bool()>& begin) {
  const std::uint64_t sent = bus_->counters().sent;
  node_->advance(loop_->now());
  const bool taken = begin();
  const Time until = loop_->now() + time_out_.usual;
  while (taken && bus_->counters().sent == sent && loop_->now() < until) {
    loop_->run_until(std::min(until, loop_->now() + Duration(1ms)));
  }
  if (bus_->counters().sent == sent) {
    throw Failure(fmt::format("{}: the frame did not get onto the bus; is it up?", bus_->name()));
  }
}

void LssSession::switch_global(LssState state) {
  send([&] { return master_->switch_global(state); });
}

void LssSession::activate_bit_timing(Duration delay) {
  send([&] { return master_->activate_bit_timing(delay); });
}

void LssSession::wait(Duration duration) {
  loop_->run_until(loop_->now() + duration);
  if (loop_->signal() != 0) throw Failure("interrupted");
}

void LssSession::select(const LssAddress& address) {
  ask_or_throw(lss::Command::select_serial,
               [&](LssMaster::Done done) { return master_->select(address, done); });
}

// Equal devices differ in the serial number.
void LssSession::require_one_node() {
  answers_ = 0;
  ask_or_throw(lss::Command::inquire_serial,
               [&](LssMaster::Done done) { return master_->inquire(LssAddress::serial, done); });
  wait(time_out_.usual / 4);
  if (answers_ == 1) return;
  throw Failure(
      "more than one node answers; name the one that is meant by --select (scan finds the "
      "addresses of nodes without node-ID, 1018h of a node tells its own)");
}

LssAddress LssSession::inquire_address() {
  LssAddress address;
  for (std::size_t part = 0; part < address.parts.size(); ++part) {
    address.parts[part] = ask_or_throw(lss::Command::inquire_vendor, [&](LssMaster::Done done) {
                            return master_->inquire(part, done);
                          }).value;
  }
  return address;
}

NodeId LssSession::inquire_node_id() {
  return static_cast<NodeId>(ask_or_throw(lss::Command::inquire_node_id, [&](LssMaster::Done done) {
                               return master_->inquire_node_id(done);
                             }).value);
}

void LssSession::configure_node_id(NodeId id) {
  ask_or_throw(lss::Command::configure_node_id,
               [&](LssMaster::Done done) { return master_->configure_node_id(id, done); });
}

void LssSession::configure_bit_timing(std::uint8_t index) {
  ask_or_throw(lss::Command::configure_bit_timing,
               [&](LssMaster::Done done) { return master_->configure_bit_timing(index, done); });
}

void LssSession::store() {
  ask_or_throw(lss::Command::store, [&](LssMaster::Done done) { return master_->store(done); });
}

bool LssSession::identify(const LssAddress& address) {
  return ask([&](LssMaster::Done done) {
           return master_->identify(LssRange::exactly(address), done);
         })
      .ok();
}

bool LssSession::identify_unconfigured() {
  return ask([&](LssMaster::Done done) { return master_->identify_unconfigured(done); }).ok();
}

LssScan::Outcome LssSession::scan(const LssScan::Options& options,
                                  const LssFastscan::Options& timing, const ScanCalls& calls) {
  std::array<LssAddress, node_id_max> memory;
  LssScan scan(*node_, *master_, memory, timing);
  scan.on_choose(calls.choose);
  scan.on_found(calls.found);
  LssScan::Outcome result = LssScan::Outcome::lost;
  auto done = [&](LssScan::Outcome outcome) {
    result = outcome;
    loop_->stop();
  };
  // The first frame shows whether the bus accepts frames: otherwise a scan would find and report no
  // node.
  switch_global(LssState::waiting);
  node_->advance(loop_->now());
  scan.start(options, LssScan::Done::of(done));
  while (true) {
    constexpr Duration period = 1s;
    if (loop_->run_until(loop_->now() + period) == host::EventLoop::End::stopped) break;
    if (calls.passed) calls.passed();
  }
  scan.cancel();
  switch_global(LssState::waiting);
  came_again_ = scan.came_again();
  if (loop_->signal() != 0) throw Failure("interrupted");
  return result;
}

}  // namespace canvoy::tools
