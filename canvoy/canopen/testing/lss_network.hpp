// An LSS master and many slaves on a simulated bus, with its timing and arbitration, for tests.
//
//     LssNetwork network;
//     network.add({{1, 2, 3, 4}}, {.latency = 2ms});
//     network.start();
//     network.run_until(Time(10s), [&] { return done; });
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>

#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/canopen/lss/lss_master.hpp"
#include "canvoy/canopen/testing/lss_node.hpp"

namespace canvoy {

class LssNetwork {
 public:
  struct MemberOptions {
    NodeId id = node_id_unconfigured;
    Duration latency{};  ///< from a frame on the bus to its processing by the node
  };

  /// A node on the bus: with an LSS slave, or that of the master.
  class Member : private WireMemory {
   public:
    Member(SimulatedBus& owner, const LssAddress& address, const MemberOptions& options)
        : WireMemory(lss_layout.tables()),
          latency(options.latency),
          controller(owner.attach({.listener = {.context = this,
                                                .on_frame = &Member::heard,
                                                .on_sent = &Member::has_room}})),
          node(lss_layout.tables(), spans(), owner.port(controller), options.id),
          address_(address) {
      identity_.reset = callback<&Member::set_identity>(*this);
      node.attach(identity_);
    }

    Time deadline() const {
      return inbox_.empty() ? node.deadline() : std::min(node.deadline(), inbox_.front().at);
    }
    void advance(Time until) {
      while (!inbox_.empty() && inbox_.front().at <= until) {
        const Frame frame = inbox_.front().frame;
        inbox_.pop_front();
        if (!deaf || !deaf(frame)) node.receive(frame, until);
      }
      while (node.deadline() <= until) node.advance(until);
    }

    std::function<bool(const Frame&)> deaf;  ///< frames that it does not receive
    Duration latency;
    ControllerId controller;
    Node node;
    std::optional<LssSlave> slave;

   private:
    struct Heard {
      Time at;
      Frame frame;
    };
    static void heard(void* context, Time at, const Frame& frame) {
      auto& self = *static_cast<Member*>(context);
      self.inbox_.push_back({at + self.latency, frame});
    }
    static void has_room(void* context, Time at, const Frame&) {
      static_cast<Member*>(context)->node.tx_ready(at);
    }
    void set_identity(ResetScope) {
      for (std::size_t part = 0; part < 4; ++part) {
        node.dictionary().set_number(0x1018, static_cast<std::uint8_t>(part + 1),
                                     address_.parts[part]);
      }
    }

    LssAddress address_;
    Service identity_;
    std::deque<Heard> inbox_;
  };

  explicit LssNetwork(std::uint32_t bit_rate = 125'000)
      : bus({.bit_rate = bit_rate}),
        master_(members_.emplace_back(bus, LssAddress{}, MemberOptions{})),
        master(master_.node) {
    bus.observe(
        {.context = this, .on_frame = [](void* context, Time, ControllerId, const Frame& frame) {
           static_cast<LssNetwork*>(context)->heard_.push_back(frame);
         }});
  }

  Member& add(const LssAddress& address, const MemberOptions& options) {
    Member& member = members_.emplace_back(bus, address, options);
    member.slave.emplace(member.node);
    return member;
  }
  Member& add(const LssAddress& address) { return add(address, MemberOptions{}); }

  void start() {
    for (Member& member : members_) {
      if (member.slave) member.node.start(now);
    }
  }
  /// Advances time. False if `done` is not true before `until`.
  bool run_until(Time until, const std::function<bool()>& done) {
    while (!done()) {
      Time next = bus.next_event();
      for (const Member& member : members_) next = std::min(next, member.deadline());
      if (next > until) return false;
      now = std::max(now, next);
      bus.advance(now);
      for (Member& member : members_) {
        if (member.deadline() <= now) member.advance(now);
      }
    }
    return true;
  }

  /// The master's node: its controller and its services.
  Member& master_member() { return master_; }
  Node& node() { return master_.node; }
  std::size_t boot_ups() const {
    return static_cast<std::size_t>(std::ranges::count_if(heard_, [](const Frame& frame) {
      return frame.id > 0x700 && frame.id <= 0x77F && frame.length == 1 && frame.data[0] == 0;
    }));
  }
  std::size_t frames() const { return heard_.size(); }
  /// Number of the master's requests with this command.
  std::size_t requests(std::uint8_t command) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        heard_, [=](const Frame& frame) { return frame.id == 0x7E5 && frame.data[0] == command; }));
  }
  std::deque<Member>& members() { return members_; }

  SimulatedBus bus;
  Time now{};

 private:
  std::deque<Member> members_;
  std::vector<Frame> heard_;
  Member& master_;

 public:
  LssMaster master;
};

}  // namespace canvoy
