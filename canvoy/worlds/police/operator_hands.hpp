// A crew member at the shared terminal, who requests a client, waits until its title is on display
// 1, presses its keys, and reads the result of each.
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
#include "canvoy/worlds/police/client.hpp"

namespace canvoy::police {

/// Hands and eyes of the crew in the car.
struct TerminalHands {
  /// Presses the client's own button, or the function key that opens it.
  std::function<void(Client)> open;
  /// Presses a key for this client, as shown on the display.
  std::function<void(Client, cia447::NumberPadKey)> press;
  std::function<std::string()> title;  ///< title on display 1
  std::function<std::string()> text;   ///< text 1 on display 1
};

/// Keys, and the text that is read after each of them.
struct TerminalTask {
  Client client = Client::radio;             ///< whose keys they are
  std::vector<cia447::NumberPadKey> keys{};  ///< in this order
  std::vector<std::string> answers{};        ///< text 1 begins with the answer
};

/// A person who does one task after another at the terminal.
class Operator {
 public:
  /// A person without a task.
  explicit Operator(TerminalHands hands) : hands_(std::move(hands)) {}

  /// Adds a task; a person remembers at most eight.
  void want(TerminalTask task) {
    if (tasks_.size() < 8) tasks_.push_back(std::move(task));
  }
  /// Forgets all tasks.
  void give_up() { tasks_.clear(); }
  /// Looks at the display, and acts; call it in each step.
  void step(Time now);

  /// True without a task.
  bool is_idle() const { return tasks_.empty(); }
  /// Time since when the person at the terminal waits for the client, or for the effect of a key;
  /// `now` without a waiting person.
  Time waits_since(Time now) const { return phase_ == Phase::idle ? now : since_; }
  /// Number of tasks that were done.
  unsigned done() const { return done_; }

 private:
  enum class Phase : std::uint8_t { idle, thinking, opening, typing };

  void begin(Time now);
  void type(Time now);

  TerminalHands hands_;
  std::deque<TerminalTask> tasks_;
  Phase phase_ = Phase::idle;
  std::size_t typed_ = 0;
  bool is_pressed_ = false;  ///< the next key was pressed, and its answer is awaited
  Time since_{};
  Time acted_{};  ///< last motion of a hand
  unsigned done_ = 0;
};

}  // namespace canvoy::police
