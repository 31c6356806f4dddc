// Three real flying masters on a bus with the timing of a real one: nodes that act at the same
// moment do so in lockstep, and yet one of them becomes the NMT master, and the others detect it
// (CiA 302-2).
#include <gtest/gtest.h>

#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/canopen/manager/flying_master.hpp"
#include "canvoy/canopen/manager/master_node.hpp"
#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::flying_lockstep_test {
namespace {

using State = FlyingMaster::State;

inline constexpr auto flying_layout =
    partial(lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                              {.index = 0x1016, .entry_count = 2},
                                              {.index = 0x1017, .entry_count = 1},
                                              {.index = 0x1F80, .entry_count = 1},
                                              {.index = 0x1F81, .entry_count = 2},
                                              {.index = 0x1F90, .entry_count = 2}}),
                    std::to_array<EntryRow>({
                        detail::boot_entries(0, 0, DataType::unsigned32, Access::const_),
                        detail::boot_count(127),
                        detail::boot_entries(1, 127, DataType::unsigned32),
                        detail::boot_entries(0, 0, DataType::unsigned16),
                        detail::boot_entries(0, 0, DataType::unsigned32),
                        detail::boot_count(127),
                        detail::boot_entries(1, 127, DataType::unsigned32),
                        detail::boot_count(6),
                        detail::boot_entries(1, 6, DataType::unsigned16),
                    })));

/// Sends a heartbeat every 100 ms, and monitors the two others.
class Candidate {
 public:
  Candidate(SimulatedBus& bus, NodeId id, std::uint32_t priority)
      : controller(bus.attach({.listener = {.context = this,
                                            .on_frame = &Candidate::receive,
                                            .on_sent = &Candidate::sent}})),
        master(bus.port(controller), id),
        stored(master.node()),
        flying(master.node(), master.commands(), master.boot_manager()) {
    const std::uint32_t timing[] = {100, 500, priority, 1500, 10, 4000};
    for (std::uint8_t sub = 1; sub <= 6; ++sub) stored.store(0x1F90, sub, timing[sub - 1]);
    stored.store(0x1F80, 0, 0x21);
    stored.store(0x1017, 0, 100);
  }
  void watch(std::uint8_t sub, NodeId other) {
    stored.store(0x1016, sub, static_cast<std::uint32_t>(other) << 16 | 300);
  }

  const ControllerId controller;
  MasterNode<flying_layout, MasterSize{.own_routes = 6}> master;
  StoredValues stored;
  FlyingMaster flying;

 private:
  static void receive(void* context, Time now, const Frame& frame) {
    static_cast<Candidate*>(context)->master.node().receive(frame, now);
  }
  static void sent(void* context, Time now, const Frame&) {
    static_cast<Candidate*>(context)->master.node().tx_ready(now);
  }
};

struct Trial {
  std::array<NodeId, 3> ids;
  std::array<std::uint32_t, 3> priorities;
  std::size_t best;  ///< lowest priority value, and lowest node-ID of these
};

const std::vector<Trial> trials = {{{5, 7, 9}, {1, 1, 1}, 0}, {{9, 7, 5}, {1, 1, 1}, 2},
                                   {{7, 5, 9}, {1, 1, 1}, 1}, {{5, 7, 9}, {2, 1, 0}, 2},
                                   {{5, 7, 9}, {0, 1, 2}, 0}, {{5, 7, 9}, {1, 0, 0}, 1},
                                   {{1, 2, 3}, {0, 0, 0}, 0}, {{127, 126, 125}, {1, 1, 1}, 2}};

class Trio {
 public:
  explicit Trio(const Trial& trial) : best(trial.best), ids(trial.ids) {
    bus.observe({.context = this, .on_frame = &Trio::heard});
    for (std::size_t i = 0; i < 3; ++i) {
      all.push_back(std::make_unique<Candidate>(bus, trial.ids[i], trial.priorities[i]));
      all[i]->watch(1, trial.ids[(i + 1) % 3]);
      all[i]->watch(2, trial.ids[(i + 2) % 3]);
    }
  }
  void start(std::array<Duration, 3> after) {
    std::array<bool, 3> started{};
    for (;;) {
      Time next = never;
      for (std::size_t i = 0; i < 3; ++i) {
        if (!started[i]) next = std::min(next, Time(after[i]));
      }
      if (next == never) return;
      run_until(next);
      for (std::size_t i = 0; i < 3; ++i) {
        if (started[i] || Time(after[i]) > bus.now()) continue;
        started[i] = true;
        all[i]->master.node().start(bus.now());
      }
    }
  }
  void run_until(Time until) {
    for (;;) {
      Time next = bus.next_event();
      for (const auto& candidate : all) {
        next = std::min(next, candidate->master.node().deadline());
      }
      if (next > until) break;
      next = std::max(next, bus.now());
      bus.advance(next);
      for (const auto& candidate : all) {
        while (candidate->master.node().deadline() <= next) candidate->master.node().advance(next);
      }
    }
    bus.advance(until);
  }
  void run_for(Duration duration) { run_until(bus.now() + duration); }

  /// The first device that claims to be master.
  std::size_t leader() const {
    std::size_t found = 0;
    while (found < 2 && all[found]->flying.state() != State::master) ++found;
    return found;
  }
  /// Checks that one is master, and that all present devices have its node-ID.
  void expect_master(std::size_t leader, std::vector<std::size_t> there = {0, 1, 2}) {
    for (const std::size_t i : there) {
      EXPECT_EQ(all[i]->flying.state(), i == leader ? State::master : State::slave)
          << "node " << unsigned{ids[i]};
      EXPECT_EQ(all[i]->flying.active_master(), ids[leader]) << "node " << unsigned{ids[i]};
      EXPECT_EQ(all[i]->master.boot_manager().is_active(), i == leader)
          << "node " << unsigned{ids[i]};
    }
  }
  /// Checks that it stays so: no device negotiates, and none is reset.
  void expect_quiet() {
    negotiations = resets = 0;
    run_for(30s);
    EXPECT_EQ(negotiations, 0);
    EXPECT_EQ(resets, 0);
  }

  SimulatedBus bus{{.bit_rate = 125'000}};
  std::vector<std::unique_ptr<Candidate>> all;
  std::size_t best;
  std::array<NodeId, 3> ids;
  int negotiations = 0;
  int resets = 0;

 private:
  static void heard(void* context, Time, ControllerId, const Frame& frame) {
    Trio& self = *static_cast<Trio*>(context);
    if (frame.id == 0x072) ++self.negotiations;
    if (frame.id == 0x000 && frame.data[0] >= 0x81) ++self.resets;
  }
};

TEST(FlyingLockstep, OfThreeThatStartAtOnceTheFirstBySlotLeads) {
  for (const Trial& trial : trials) {
    SCOPED_TRACE(testing::Message() << "nodes " << unsigned{trial.ids[0]} << " to "
                                    << unsigned{trial.ids[2]} << ", best " << trial.best);
    Trio sut(trial);
    sut.start({});
    sut.run_until(Time(12s));
    sut.expect_master(trial.best);
    EXPECT_LE(sut.resets, 5);
    sut.expect_quiet();
    if (HasFailure()) return;
  }
}

TEST(FlyingLockstep, OfThreeThatStartOneAfterTheOtherOneLeads) {
  std::size_t tries = 0;
  for (const Trial& trial : trials) {
    for (const Duration second :
         std::initializer_list<Duration>{1us, 1ms, 100ms, 499ms, 550ms, 600ms, 601ms, 1100ms, 3s}) {
      for (const Duration third : std::initializer_list<Duration>{1us, 600ms, 601ms, 2s, 10s}) {
        if (tries++ % 3 != 0 && !tries_all()) continue;
        SCOPED_TRACE(testing::Message()
                     << "nodes " << unsigned{trial.ids[0]} << " to " << unsigned{trial.ids[2]}
                     << ", " << second / 1us << " and " << third / 1us << " us later");
        Trio sut(trial);
        sut.start({0us, second, second + third});
        sut.run_for(15s);
        sut.expect_master(sut.leader());
        sut.expect_quiet();
        if (HasFailure()) return;
      }
    }
  }
}

TEST(FlyingLockstep, OfThreeThatLedAPieceOfTheCableEachOneLeadsWhenItIsMended) {
  for (const Trial& trial : trials) {
    SCOPED_TRACE(testing::Message()
                 << "nodes " << unsigned{trial.ids[0]} << " to " << unsigned{trial.ids[2]});
    Trio sut(trial);
    for (const auto& candidate : sut.all) sut.bus.unplug(candidate->controller);
    sut.start({});
    sut.run_until(Time(10s));
    for (const auto& candidate : sut.all) sut.bus.plug(candidate->controller);
    sut.run_for(20s);
    sut.expect_master(sut.leader());
    sut.expect_quiet();
    if (HasFailure()) return;
  }
}

TEST(FlyingLockstep, OfTwoThatMissTheFirstOneLeads) {
  for (const Trial& trial : trials) {
    SCOPED_TRACE(testing::Message()
                 << "nodes " << unsigned{trial.ids[0]} << " to " << unsigned{trial.ids[2]});
    Trio sut(trial);
    sut.start({});
    sut.run_until(Time(10s));
    sut.bus.power(sut.all[trial.best]->controller, false);
    sut.run_for(10s);
    std::vector<std::size_t> there;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i != trial.best) there.push_back(i);
    }
    const std::size_t leader =
        sut.all[there[0]]->flying.state() == State::master ? there[0] : there[1];
    sut.expect_master(leader, there);
    sut.expect_quiet();
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace canvoy::flying_lockstep_test
