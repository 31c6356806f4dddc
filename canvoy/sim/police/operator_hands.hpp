// One of the crew at the shared terminal: wants something of a client, waits until its title is
// read on display 1, presses its keys, and reads what comes of each.
//
//     Operator partner(hands);
//     partner.want({Client::radio, {NumberPadKey::key_3}, {"status 3"}});
//     partner.step(now);
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"
#include "canvoy/sim/police/client.hpp"

namespace canvoy::police {

/// What hands and eyes of the crew find in the car.
struct TerminalHands {
  /// The client's own button, or the function key by which it is opened.
  std::function<void(Client)> open;
  /// For this client, as the display says.
  std::function<void(Client, cia447::NumberPadKey)> press;
  std::function<std::string()> title;
  std::function<std::string()> text;
};

/// Keys, and what is read after each of them.
struct TerminalTask {
  Client client = Client::radio;
  std::vector<cia447::NumberPadKey> keys{};
  std::vector<std::string> answers{};  ///< text 1 begins with it
};

class Operator {
 public:
  explicit Operator(TerminalHands hands) : hands_(std::move(hands)) {}

  /// Nobody keeps more than eight things in mind.
  void want(TerminalTask task) {
    if (tasks_.size() < 8) tasks_.push_back(std::move(task));
  }
  void give_up() { tasks_.clear(); }
  void step(Time now);

  bool is_idle() const { return tasks_.empty(); }
  /// Since when the one at the terminal waits for the client, or for what a key does; `now` where
  /// nobody waits.
  Time waits_since(Time now) const { return phase_ == Phase::idle ? now : since_; }
  unsigned done() const { return done_; }

 private:
  enum class Phase : std::uint8_t { idle, thinking, opening, typing };

  void begin(Time now);
  void type(Time now);

  TerminalHands hands_;
  std::deque<TerminalTask> tasks_;
  Phase phase_ = Phase::idle;
  std::size_t typed_ = 0;
  bool is_pressed_ = false;  ///< the next key was pressed, and its answer is looked for
  Time since_{};
  Time acted_{};  ///< when a hand was moved last
  unsigned done_ = 0;
};

}  // namespace canvoy::police
