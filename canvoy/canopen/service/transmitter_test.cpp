#include "canvoy/canopen/service/transmitter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <deque>
#include <functional>
#include <vector>

namespace canvoy::transmitter_test {
namespace {

/// A controller with room for a number of frames.
struct Controller {
  static bool send(void* context, const Frame& frame) {
    auto& self = *static_cast<Controller*>(context);
    if (self.room == 0) return false;
    --self.room;
    self.ids.push_back(frame.id);
    return true;
  }
  Port port() { return {this, &Controller::send, nullptr}; }

  std::size_t room = 0;
  std::vector<std::uint32_t> ids{};
};

Frame frame(std::uint32_t id) {
  return Frame::data_frame(id, {});
}

TEST(Transmitter, HandsFramesStraightToTheController) {
  Controller controller{.room = 1};
  const Port port = controller.port();
  Frame backlog[2];
  Transmitter sut(port, backlog);
  EXPECT_TRUE(sut.send(frame(1)));
  EXPECT_EQ(controller.ids, (std::vector<std::uint32_t>{1}));
  EXPECT_TRUE(sut.idle());
}

TEST(Transmitter, KeepsTheOrderWhileTheControllerIsFull) {
  Controller controller;
  const Port port = controller.port();
  Frame backlog[2];
  Transmitter sut(port, backlog);
  EXPECT_TRUE(sut.send(frame(1)));
  EXPECT_FALSE(sut.idle());
  controller.room = 9;
  EXPECT_TRUE(sut.send(frame(2))) << "does not overtake the first";
  EXPECT_TRUE(controller.ids.empty());
  sut.flush();
  EXPECT_EQ(controller.ids, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_TRUE(sut.idle());
}

TEST(Transmitter, LosesAndCountsWhatTheBacklogCannotHold) {
  Controller controller;
  const Port port = controller.port();
  Frame backlog[2];
  Transmitter sut(port, backlog);
  EXPECT_FALSE(sut.full());
  EXPECT_TRUE(sut.send(frame(1)));
  EXPECT_TRUE(sut.send(frame(2)));
  EXPECT_TRUE(sut.full());
  EXPECT_FALSE(sut.send(frame(3)));
  EXPECT_EQ(sut.lost(), 1U);
  controller.room = 9;
  sut.flush();
  EXPECT_EQ(controller.ids, (std::vector<std::uint32_t>{1, 2}));
}

TEST(Transmitter, IsCrowdedFromTheHalfOfItsBacklogOn) {
  for (const std::size_t size : {0U, 1U, 2U, 3U, 16U}) {
    Controller controller;
    const Port port = controller.port();
    std::vector<Frame> backlog(size);
    Transmitter sut(port, backlog);
    for (std::size_t waiting = 0; waiting <= size; ++waiting) {
      EXPECT_EQ(sut.crowded(), waiting != 0 && 2 * waiting >= size) << waiting << " of " << size;
      sut.send(frame(1));
    }
  }
}

TEST(Transmitter, WorksWithoutABacklog) {
  Controller controller{.room = 1};
  const Port port = controller.port();
  Transmitter sut(port, {});
  EXPECT_TRUE(sut.send(frame(1)));
  EXPECT_FALSE(sut.send(frame(2)));
  sut.flush();
  EXPECT_EQ(sut.lost(), 1U);
}

TEST(Transmitter, LosesAndCountsEachFrameThatIsRefusedWithoutABacklog) {
  Controller controller{.room = 0};
  const Port port = controller.port();
  Transmitter sut(port, {});
  for (std::uint32_t lost = 1; lost <= 3; ++lost) {
    EXPECT_FALSE(sut.send(frame(lost)));
    EXPECT_EQ(sut.lost(), lost);
    EXPECT_TRUE(sut.idle()) << "nothing waits";
    EXPECT_FALSE(sut.full()) << "services that ask before may try";
    EXPECT_FALSE(sut.crowded());
  }
  controller.room = 1;
  sut.flush();
  EXPECT_TRUE(sut.send(frame(4)));
  EXPECT_EQ(sut.lost(), 3U);
}

TEST(Transmitter, ForgetsWhatWaitsWhenItIsCleared) {
  Controller controller;
  const Port port = controller.port();
  Frame backlog[2];
  Transmitter sut(port, backlog);
  sut.send(frame(1));
  sut.clear();
  EXPECT_TRUE(sut.idle());
  controller.room = 9;
  sut.flush();
  EXPECT_TRUE(controller.ids.empty());
  sut.send(frame(2));
  EXPECT_EQ(controller.ids, (std::vector<std::uint32_t>{2}));
}

TEST(Transmitter, IsABoundedQueueInAnySequenceOfCalls) {
  const bool held = rc::check("like a deque", [] {
    Controller controller;
    const Port port = controller.port();
    std::vector<Frame> backlog(*rc::gen::inRange<std::size_t>(0, 5));
    Transmitter sut(port, backlog);
    std::deque<std::uint32_t> model;
    std::vector<std::uint32_t> arrived;
    std::uint32_t lost = 0;
    const auto drain = [&](std::size_t& room) {
      for (; room > 0 && !model.empty(); --room, model.pop_front())
        arrived.push_back(model.front());
    };
    const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 6));
    std::uint32_t id = 0;
    for (const int step : steps) {
      if (step == 0) {
        controller.room = id % 4;
        std::size_t room = controller.room;
        sut.flush();
        drain(room);
      } else {
        ++id;
        bool taken = true;
        if (model.empty() && controller.room > 0) {
          arrived.push_back(id);
        } else if (model.size() < backlog.size()) {
          model.push_back(id);
        } else {
          ++lost;
          taken = false;
        }
        RC_ASSERT(sut.send(frame(id)) == taken);
      }
      RC_ASSERT(controller.ids == arrived);
      RC_ASSERT(sut.lost() == lost);
      RC_ASSERT(sut.idle() == model.empty());
    }
  });
  EXPECT_TRUE(held);
}

/// A controller that delivers the answer to each frame at once.
struct EchoController {
  static bool send(void* context, const Frame& frame) {
    auto& self = *static_cast<EchoController*>(context);
    if (self.room == 0) return false;
    --self.room;
    self.ids.push_back(frame.id);
    self.answer(frame);
    return true;
  }
  Port port() { return {this, &EchoController::send, nullptr}; }

  std::size_t room = 0;
  std::vector<std::uint32_t> ids{};
  std::function<void(const Frame&)> answer{};
};

TEST(Transmitter, MayBeClearedByAnAnswerThatComesAtOnce) {
  for (const std::size_t room : {1U, 9U}) {
    EchoController controller;
    const Port port = controller.port();
    Frame backlog[2];
    Transmitter sut(port, backlog);
    sut.send(frame(1));
    sut.send(frame(2));
    controller.answer = [&](const Frame& sent) {
      if (sent.id != 1) return;
      sut.clear();
      sut.send(frame(3));
    };
    controller.room = room;
    sut.flush();
    controller.room = 9;
    sut.flush();
    EXPECT_EQ(controller.ids, (std::vector<std::uint32_t>{1, 3}));
    EXPECT_TRUE(sut.idle());
  }
}

/// A controller that refuses a frame, and reports its state during the call.
struct RefusingController {
  static bool send(void* context, const Frame& frame) {
    auto& self = *static_cast<RefusingController*>(context);
    if (self.room == 0) {
      if (self.told) std::exchange(self.told, {})();
      return false;
    }
    --self.room;
    self.ids.push_back(frame.id);
    return true;
  }
  Port port() { return {this, &RefusingController::send, nullptr}; }

  std::size_t room = 0;
  std::vector<std::uint32_t> ids{};
  std::function<void()> told{};
};

TEST(Transmitter, KeepsAllFramesWhereAnotherIsSentWhileOneIsRefused) {
  RefusingController controller;
  const Port port = controller.port();
  Frame backlog[3];
  Transmitter sut(port, backlog);
  sut.send(frame(1));
  sut.send(frame(2));
  controller.told = [&] { EXPECT_TRUE(sut.send(frame(3))); };
  sut.flush();
  controller.room = 9;
  sut.flush();
  EXPECT_EQ(controller.ids, (std::vector<std::uint32_t>{1, 2, 3}));
}

TEST(Transmitter, LosesNoOlderFrameWhereOneIsSentIntoTheLastRoomWhileOneIsRefused) {
  RefusingController controller;
  const Port port = controller.port();
  Frame backlog[2];
  Transmitter sut(port, backlog);
  sut.send(frame(1));
  sut.send(frame(2));
  controller.told = [&] {
    EXPECT_TRUE(sut.full());
    EXPECT_FALSE(sut.send(frame(3)));
  };
  sut.flush();
  controller.room = 9;
  sut.flush();
  EXPECT_EQ(controller.ids, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(sut.lost(), 1U) << "the newest";
  EXPECT_TRUE(sut.idle());
}

TEST(Transmitter, StaysEmptyWhereItIsClearedWhileAFrameIsRefused) {
  RefusingController controller;
  const Port port = controller.port();
  Frame backlog[2];
  Transmitter sut(port, backlog);
  sut.send(frame(1));
  sut.send(frame(2));
  controller.told = [&] { sut.clear(); };
  sut.flush();
  controller.room = 9;
  sut.flush();
  EXPECT_TRUE(controller.ids.empty());
  EXPECT_TRUE(sut.idle());
}

TEST(Transmitter, MayBeFlushedByAnAnswerThatComesAtOnce) {
  EchoController controller;
  const Port port = controller.port();
  Frame backlog[3];
  Transmitter sut(port, backlog);
  for (const std::uint32_t id : {1U, 2U, 3U}) sut.send(frame(id));
  controller.answer = [&](const Frame&) { sut.flush(); };
  controller.room = 9;
  sut.flush();
  EXPECT_EQ(controller.ids, (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_TRUE(sut.idle());
}

}  // namespace
}  // namespace canvoy::transmitter_test
