// Node guarding over a cable that loses any requests and answers: both ends detect exactly what a
// separate model of CiA 301, 7.2.8.3.2.1, detects, and nothing else.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/nmt/node_guarding_master.hpp"
#include "canvoy/canopen/nmt/node_guarding_slave.hpp"
#include "canvoy/canopen/testing/cable.hpp"

namespace canvoy::node_guarding_property_test {
namespace {

using Texts = std::vector<std::string>;

constexpr int guard_time_ms = 100;
constexpr int master_life_time_ms = 300;
// Not a multiple of the guard time, so that it never ends at the moment of a request.
constexpr int slave_life_time_ms = 350;

constexpr auto layout = lay_out(
    std::to_array<ObjectRow>(
        {{.index = 0x100C, .entry_count = 1}, {.index = 0x100D, .entry_count = 1}}),
    std::to_array<EntryRow>(
        {{.type = DataType::unsigned16, .access = Access::rw, .initial = slave_life_time_ms},
         {.access = Access::rw, .initial = 1}}));
constexpr DictionaryTables tables = layout.tables();

/// Message lost in the n-th guard time.
enum class Loss { nothing, request, answer };

std::string note(const char* who, int at_ms, bool occurs) {
  return who + std::string(occurs ? " occurred @" : " resolved @") + std::to_string(at_ms);
}

/// Events of both ends, by the model.
Texts expected(const std::vector<Loss>& losses) {
  Texts log;
  bool toggle = false;           // of the slave's next answer
  bool expected_toggle = false;  // by the master
  int heard = 0;                 // by the master
  bool master_lost = false;
  int asked = -1;  // time of the last request to the slave; negative: never
  bool slave_lost = false;
  for (int now = 0; const Loss loss : losses) {
    const int over = asked + slave_life_time_ms;
    if (asked >= 0 && !slave_lost && over < now) {
      slave_lost = true;
      log.push_back(note("slave", over, true));
    }
    if (!master_lost && now >= heard + master_life_time_ms) {
      master_lost = true;
      log.push_back(note("master", now, true));
    }
    if (loss != Loss::request) {
      if (slave_lost) log.push_back(note("slave", now, false));
      slave_lost = false;
      asked = now;
      if (loss != Loss::answer && toggle == expected_toggle) {
        if (master_lost) log.push_back(note("master", now, false));
        master_lost = false;
        heard = now;
        expected_toggle = !expected_toggle;
      }
      toggle = !toggle;
    }
    now += guard_time_ms;
  }
  return log;
}

/// A master and a slave, and the events that they detect.
struct LossyGuarding {
  explicit LossyGuarding(const std::vector<Loss>& losses) : losses_(losses) {
    guarding.on_event(callback<&LossyGuarding::master_noticed>(*this));
    service.error_changed = callback<&LossyGuarding::slave_noticed>(*this);
    slave.attach(service);
    cable.connect(0, master);
    cable.connect(1, slave);
    cable.start_all();
    cable.filter = [this](const Frame& frame) { return passes(frame); };
    guarding.guard(10, 1ms * guard_time_ms, master_life_time_ms / guard_time_ms);
    cable.run_until(Time((static_cast<int>(losses.size()) - 1) * guard_time_ms * 1ms));
  }

  bool passes(const Frame& frame) {
    const auto number =
        static_cast<std::size_t>(cable.now.time_since_epoch() / 1ms / guard_time_ms);
    const Loss lost = frame.is_remote() ? Loss::request : Loss::answer;
    return losses_.at(number) != lost;
  }
  int now_ms() const { return static_cast<int>(cable.now.time_since_epoch() / 1ms); }
  void master_noticed(NodeId, NodeGuardingEvent, bool occurs) {
    log.push_back(note("master", now_ms(), occurs));
  }
  void slave_noticed(const Error&, bool present) {
    log.push_back(note("slave", now_ms(), present));
  }

  std::vector<Loss> losses_;
  Texts log;
  Cable cable;
  WireMemory master_memory{tables};
  WireMemory slave_memory{tables};
  Node master{tables, master_memory.spans(), cable.port(0), 1};
  Node slave{tables, slave_memory.spans(), cable.port(1), 10};
  NodeGuardingMaster::Slot slots[1];
  NodeGuardingMaster guarding{master, slots};
  NodeGuardingSlave guarded{slave};
  Service service;
};

RC_GTEST_PROP(NodeGuarding, NoticesAtBothEndsWhatAnyLossesMean, ()) {
  auto losses = *rc::gen::container<std::vector<Loss>>(
      rc::gen::weightedElement<Loss>({{3, Loss::nothing}, {2, Loss::request}, {2, Loss::answer}}));
  losses.insert(losses.end(), 5, Loss::nothing);
  const LossyGuarding sut(losses);
  RC_ASSERT(sut.log == expected(losses));
  RC_ASSERT(sut.guarding.state(10) == RemoteState::pre_operational);
  RC_ASSERT(!sut.guarded.is_master_lost());
}

TEST(NodeGuarding, CountsAnAnswerBehindALostOneAsNoneSinceItsToggleBitDidNotChange) {
  const LossyGuarding sut({Loss::nothing, Loss::answer, Loss::nothing, Loss::nothing});
  EXPECT_EQ(sut.log, Texts({"master occurred @300", "master resolved @300"}));
}

TEST(NodeGuarding, TakesALostRequestForNothingMore) {
  const LossyGuarding sut({Loss::nothing, Loss::request, Loss::nothing, Loss::nothing});
  EXPECT_EQ(sut.log, Texts());
}

}  // namespace
}  // namespace canvoy::node_guarding_property_test
