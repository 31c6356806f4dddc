// Performs the requests of a conformance test at a device and answers its questions: a person at
// the terminal, or a file with a command for each request.
//
//     CheckHands hands("hands.txt");
//     hands.answer({.words = "press the alarm key"});   // runs the command of that line
#pragma once

#include <functional>
#include <map>
#include <string>

#include "canvoy/text/check/bench/bench.hpp"

namespace canvoy::tools {

class CheckHands {
 public:
  /// `source` is `-` for a person, or a file of lines `request = command`; blanks around both are
  /// ignored, and a line that begins with # is a comment. `wait` returns when standard input is
  /// readable. Throws Failure if the file cannot be read, or a line is not valid.
  CheckHands(const std::string& source, std::function<void()> wait);

  /// Exit status of a command: 0 if done or true, 1 if not true. Any other status, or a request
  /// without a command, means not possible.
  conformance::HandAnswer answer(const conformance::HandRequest& request);

 private:
  conformance::HandAnswer ask_person(const conformance::HandRequest& request);

  bool is_person_;
  std::function<void()> wait_;
  std::map<std::string, std::string, std::less<>> commands_;
};

}  // namespace canvoy::tools
