// A simulated person at a device: performs the requests of a conformance test, and answers its
// questions.
//
//     Hands hands;
//     hands.learn("press the button", [&] { button = true; });
//     Check check(device.line(), device.node(), {.moves = true, .hand = hands.answer()});
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/text/check/bench/bench.hpp"

namespace canvoy::conformance {

struct Hands {
  /// Actions by request. False: not possible at this device.
  std::map<std::string, std::function<bool()>, std::less<>> does;
  std::map<std::string, std::function<bool()>, std::less<>> sees;
  /// Requests that are in neither map.
  std::vector<std::string> unknown;

  template <class Deed>
  void learn(const std::string& words, Deed deed) {
    does[words] = [deed = std::move(deed)] {
      deed();
      return true;
    };
  }
  /// Like the function above, but for a unit if the device has it; `unit` is set when the unit is
  /// made.
  template <class Unit, class Deed>
  void learn_at(Unit* const& unit, const std::string& words, Deed deed) {
    does[words] = [&unit, deed = std::move(deed)] {
      if (unit == nullptr) return false;
      deed();
      return true;
    };
  }

  std::function<HandAnswer(const HandRequest&)> answer() {
    return [this](const HandRequest& request) {
      if (request.is_question) {
        const auto found = sees.find(request.words);
        if (found != sees.end()) return found->second() ? HandAnswer::done : HandAnswer::no;
      } else if (const auto found = does.find(request.words); found != does.end()) {
        return found->second() ? HandAnswer::done : HandAnswer::cannot;
      }
      unknown.emplace_back(request.words);
      return HandAnswer::cannot;
    };
  }
};

}  // namespace canvoy::conformance
