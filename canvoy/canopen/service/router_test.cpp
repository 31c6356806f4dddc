#include "canvoy/canopen/service/router.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace canvoy::router_test {
namespace {

using Kind = Router::Kind;
using Calls = std::vector<int>;

/// A router, receivers with numbers, and the calls of the acceptance filter.
struct Routed {
  struct Receiver {
    Receiver(Routed& routed, int receiver) : owner(routed), number(receiver) {}
    void receive(const Frame&, Time) {
      owner.calls.push_back(number);
      if (on_frame) on_frame();
    }
    Routed& owner;
    int number;
    std::function<void()> on_frame;
  };

  explicit Routed(std::size_t capacity, int receivers = 8) : table(capacity) {
    for (int i = 0; i < receivers; ++i) all.emplace_back(*this, i);
  }
  Router::Receiver operator[](std::size_t number) {
    return Router::Receiver::to<&Receiver::receive>(all[number]);
  }
  static void accept(void* context, std::uint16_t id, bool wanted) {
    auto& filter = static_cast<Routed*>(context)->filter;
    if (wanted) {
      filter.insert(id);
    } else {
      filter.erase(id);
    }
  }
  Calls dispatch(std::uint32_t id, bool remote = false) {
    calls.clear();
    taken = router.dispatch(remote ? Frame::remote_frame(id, 0) : Frame::data_frame(id, {}), {});
    return calls;
  }

  std::vector<Router::Route> table;
  std::deque<Receiver> all;
  Calls calls;
  bool taken = false;
  std::set<std::uint16_t> filter;
  Port port{this, nullptr, &Routed::accept};
  Router router{table, port};
};

TEST(Router, KnowsNobodyAtFirst) {
  Routed sut(4);
  EXPECT_EQ(sut.dispatch(0x123), Calls{});
  EXPECT_FALSE(sut.taken);
}

/// On a small machine as well, where it has no route.
TEST(Router, AServiceThatListensToAnotherCanIdNoLongerWantsTheFormer) {
  Routed sut(4);
  using Filter = std::set<std::uint16_t>;
  const auto listen = [&sut](std::uint16_t present, std::uint16_t wanted) {
    return sut.router.listen<&Routed::Receiver::receive>(sut.all[0], present, wanted);
  };
  EXPECT_TRUE(listen(0, 0x185));
  EXPECT_EQ(sut.filter, Filter{0x185});
  EXPECT_TRUE(listen(0x185, 0x186));
  EXPECT_EQ(sut.filter, Filter{0x186});
  EXPECT_FALSE(listen(0x186, 0));
  EXPECT_EQ(sut.filter, Filter{});
  sut.router.add(0x185, sut[1]);
  listen(0, 0x185);
  listen(0x185, 0);
  EXPECT_EQ(sut.filter, Filter{0x185}) << "another one wants it";
}

TEST(Router, HandsAFrameToWhoWantsItAndToNobodyElse) {
  Routed sut(4);
  EXPECT_TRUE(sut.router.add(0x123, sut[0]));
  EXPECT_TRUE(sut.router.add(0x7FF, sut[1]));
  EXPECT_TRUE(sut.router.add(0x000, sut[2]));
  EXPECT_EQ(sut.dispatch(0x123), Calls{0});
  EXPECT_TRUE(sut.taken);
  EXPECT_EQ(sut.dispatch(0x7FF), Calls{1});
  EXPECT_EQ(sut.dispatch(0x000), Calls{2});
  for (const std::uint32_t id : {0x001U, 0x122U, 0x124U, 0x7FEU}) {
    EXPECT_EQ(sut.dispatch(id), Calls{});
    EXPECT_FALSE(sut.taken);
  }
}

TEST(Router, CallsAllWhoWantAFrameInTheOrderInWhichTheyWereAdded) {
  Routed sut(8);
  for (const std::size_t receiver : {2U, 0U, 1U}) {
    sut.router.add(0x200, sut[receiver]);
    sut.router.add(0x100, sut[receiver]);
  }
  EXPECT_EQ(sut.dispatch(0x200), (Calls{2, 0, 1}));
  sut.router.remove(0x200, sut[2]);
  sut.router.add(0x200, sut[2]);
  EXPECT_EQ(sut.dispatch(0x200), (Calls{0, 1, 2}));
}

TEST(Router, KeepsRemoteFramesApart) {
  Routed sut(4);
  sut.router.add(0x181, sut[0]);
  sut.router.add(0x181, sut[1], Kind::remote);
  sut.router.add(0x000, sut[2], Kind::remote);
  EXPECT_EQ(sut.dispatch(0x181), Calls{0});
  EXPECT_EQ(sut.dispatch(0x181, true), Calls{1});
  EXPECT_EQ(sut.dispatch(0x000, true), Calls{2});
  EXPECT_EQ(sut.dispatch(0x000), Calls{});
  EXPECT_EQ(sut.dispatch(0x7FF), Calls{});
}

TEST(Router, RefusesWhatItsTableCannotHold) {
  Routed sut(2);
  EXPECT_FALSE(sut.router.full());
  EXPECT_TRUE(sut.router.add(0x100, sut[0]));
  EXPECT_TRUE(sut.router.add(0x200, sut[1]));
  EXPECT_TRUE(sut.router.full());
  EXPECT_FALSE(sut.router.add(0x050, sut[2]));
  EXPECT_EQ(sut.dispatch(0x050), Calls{});
  EXPECT_EQ(sut.dispatch(0x100), Calls{0});
  EXPECT_EQ(sut.dispatch(0x200), Calls{1});
  EXPECT_FALSE(sut.filter.contains(0x050));
  sut.router.remove(0x100, sut[0]);
  EXPECT_TRUE(sut.router.add(0x050, sut[2]));
}

TEST(Router, RefusesCanIdsThatDoNotExist) {
  Routed sut(2);
  EXPECT_FALSE(sut.router.add(0x800, sut[0]));
  EXPECT_FALSE(sut.router.add(0xFFFF, sut[0]));
  EXPECT_EQ(sut.dispatch(0x000, true), Calls{});
}

TEST(Router, DoesNothingWhenARouteIsRemovedThatDoesNotExist) {
  Routed sut(4);
  sut.router.add(0x100, sut[0]);
  sut.router.remove(0x100, sut[1]);
  sut.router.remove(0x101, sut[0]);
  sut.router.remove(0x100, sut[0], Kind::remote);
  EXPECT_EQ(sut.dispatch(0x100), Calls{0});
}

TEST(Router, TellsTheAcceptanceFilterWhatIsWanted) {
  Routed sut(4);
  sut.router.add(0x100, sut[0]);
  sut.router.add(0x100, sut[1]);
  sut.router.add(0x100, sut[2], Kind::remote);
  EXPECT_EQ(sut.filter, std::set<std::uint16_t>{0x100});
  sut.router.remove(0x100, sut[0]);
  sut.router.remove(0x100, sut[1]);
  EXPECT_EQ(sut.filter, std::set<std::uint16_t>{0x100}) << "remote frames are still wanted";
  sut.router.remove(0x100, sut[2], Kind::remote);
  EXPECT_EQ(sut.filter, std::set<std::uint16_t>{});
}

TEST(Router, WorksWithoutAnAcceptanceFilter) {
  Router::Route table[1];
  const Port port{};
  Router sut(table, port);
  EXPECT_TRUE(sut.add(0x100, {}));
  sut.remove(0x100, {});
  EXPECT_TRUE(sut.add(0x101, {}));
}

// Changes of routes during a dispatch

TEST(Router, DoesNotCallWhatIsAddedForTheFrameUnderWay) {
  Routed sut(8);
  sut.router.add(0x100, sut[0]);
  sut.router.add(0x100, sut[1]);
  sut.all[0].on_frame = [&] { sut.router.add(0x100, sut[2]); };
  EXPECT_EQ(sut.dispatch(0x100), (Calls{0, 1}));
  sut.all[0].on_frame = nullptr;
  EXPECT_EQ(sut.dispatch(0x100), (Calls{0, 1, 2}));
}

TEST(Router, DoesNotCallWhatWasRemovedBeforeItsTurn) {
  Routed sut(8);
  for (std::size_t i = 0; i < 4; ++i) sut.router.add(0x100, sut[i]);
  sut.all[0].on_frame = [&] {
    sut.router.remove(0x100, sut[0]);
    sut.router.remove(0x100, sut[2]);
  };
  EXPECT_EQ(sut.dispatch(0x100), (Calls{0, 1, 3}));
  EXPECT_EQ(sut.dispatch(0x100), (Calls{1, 3}));
}

TEST(Router, CallsTheOthersWhenOneMovesItselfBehindThem) {
  Routed sut(8);
  for (std::size_t i = 0; i < 3; ++i) sut.router.add(0x100, sut[i]);
  sut.all[0].on_frame = [&] {
    sut.router.remove(0x100, sut[0]);
    sut.router.add(0x100, sut[0]);
  };
  EXPECT_EQ(sut.dispatch(0x100), (Calls{0, 1, 2}));
  EXPECT_EQ(sut.dispatch(0x100), (Calls{1, 2, 0}));
}

TEST(Router, CallsAllWhenOneOpensRoutesInFrontOfThem) {
  Routed sut(8);
  for (std::size_t i = 0; i < 3; ++i) sut.router.add(0x700, sut[i]);
  sut.all[0].on_frame = [&] {
    sut.router.add(0x180, sut[3]);
    sut.router.add(0x280, sut[3]);
  };
  EXPECT_EQ(sut.dispatch(0x700), (Calls{0, 1, 2}));
}

TEST(Router, LeadsADispatchPastTheChangesOfOneWithinIt) {
  Routed sut(8);
  for (std::size_t i = 0; i < 3; ++i) sut.router.add(0x100, sut[i]);
  bool nested = false;
  sut.all[0].on_frame = [&] {
    if (!std::exchange(nested, true)) sut.router.dispatch(Frame::data_frame(0x100, {}), {});
  };
  sut.all[1].on_frame = [&] {
    sut.router.remove(0x100, sut[1]);
    sut.router.add(0x080, sut[4]);
    sut.router.add(0x100, sut[3]);
  };
  EXPECT_EQ(sut.dispatch(0x100), (Calls{0, 0, 1, 2, 2}));
  sut.all[1].on_frame = nullptr;
  EXPECT_EQ(sut.dispatch(0x100), (Calls{0, 2, 3}));
}

/// Routes as a list for each key.
struct Model {
  using Key = std::pair<std::uint16_t, bool>;
  std::map<Key, Calls> routes;
  std::size_t size = 0;

  bool add(Key key, int receiver, std::size_t capacity) {
    if (size == capacity) return false;
    routes[key].push_back(receiver);
    ++size;
    return true;
  }
  void remove(Key key, int receiver) {
    Calls& list = routes[key];
    const auto found = std::ranges::find(list, receiver);
    if (found == list.end()) return;
    list.erase(found);
    --size;
  }
  std::set<std::uint16_t> wanted() const {
    std::set<std::uint16_t> ids;
    for (const auto& [key, list] : routes) {
      if (!list.empty()) ids.insert(key.first);
    }
    return ids;
  }
};

struct Step {
  int what;
  int id;
  int receiver;
  bool remote;
};

rc::Gen<std::vector<Step>> any_steps() {
  return rc::gen::container<std::vector<Step>>(
      rc::gen::construct<Step>(rc::gen::inRange(0, 5), rc::gen::inRange(0, 6),
                               rc::gen::inRange(0, 4), rc::gen::arbitrary<bool>()));
}

constexpr std::array<std::uint16_t, 6> ids = {0x000, 0x001, 0x180, 0x181, 0x7FE, 0x7FF};

TEST(Router, BehavesLikeAListForEachCanIdInAnySequenceOfCalls) {
  const bool held = rc::check("like a map of lists", [] {
    constexpr std::size_t capacity = 12;
    Routed sut(capacity);
    Model model;
    for (const Step& step : *any_steps()) {
      const std::uint16_t id = ids[static_cast<std::size_t>(step.id)];
      const Kind kind = step.remote ? Kind::remote : Kind::data;
      const Router::Receiver receiver = sut[static_cast<std::size_t>(step.receiver)];
      if (step.what <= 2) {
        RC_ASSERT(sut.router.add(id, receiver, kind) ==
                  model.add({id, step.remote}, step.receiver, capacity));
      } else {
        sut.router.remove(id, receiver, kind);
        model.remove({id, step.remote}, step.receiver);
      }
      for (const std::uint16_t probe : ids) {
        const Calls expected = model.routes[{probe, step.remote}];
        RC_ASSERT(sut.dispatch(probe, step.remote) == expected);
        RC_ASSERT(sut.taken == !expected.empty());
      }
      RC_ASSERT(sut.filter == model.wanted());
    }
  });
  EXPECT_TRUE(held);
}

TEST(Router, CallsWhoWasThereAndStillIsWhenRoutesChangeUnderWay) {
  const bool held = rc::check("dispatch with changes", [] {
    constexpr std::uint16_t id = 0x181;
    constexpr int count = 6;
    Routed sut(64, count);
    Calls present;
    for (int i = 0; i < count; ++i) {
      sut.router.add(id, sut[static_cast<std::size_t>(i)]);
      present.push_back(i);
    }
    // Each receiver makes one change when it is called.
    const auto changes = *rc::gen::container<std::vector<Step>>(
        count, rc::gen::construct<Step>(rc::gen::inRange(0, 3), rc::gen::inRange(0, 6),
                                        rc::gen::inRange(0, count), rc::gen::arbitrary<bool>()));
    std::set<int> gone;
    Calls expected;
    for (int i = 0; i < count; ++i) {
      const Step& change = changes[static_cast<std::size_t>(i)];
      const auto other = static_cast<std::size_t>(change.receiver);
      sut.all[static_cast<std::size_t>(i)].on_frame = [&sut, change, other] {
        if (change.what != 0) sut.router.remove(id, sut[other]);
        if (change.what != 1) sut.router.add(id, sut[other]);
        sut.router.add(ids[static_cast<std::size_t>(change.id)], sut[other], Kind::remote);
      };
      if (gone.contains(i)) continue;
      expected.push_back(i);
      if (change.what != 0) gone.insert(change.receiver);
    }
    RC_ASSERT(sut.dispatch(id) == expected);
  });
  EXPECT_TRUE(held);
}

}  // namespace
}  // namespace canvoy::router_test
