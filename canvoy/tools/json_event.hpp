// A line of JSON that says what happened: an object with `event` and whatever else there is to say
// (docs/json.md).
//
//     JsonEvent event("written");
//     event->key("file").text(path);
//     event.print();  // {"event":"written","file":"node10.dcf"}
#pragma once

#include <string>
#include <string_view>

#include "canvoy/words/json_line.hpp"

namespace canvoy::tools {

class JsonEvent {
 public:
  explicit JsonEvent(std::string_view event);
  JsonEvent(const JsonEvent&) = delete;
  JsonEvent& operator=(const JsonEvent&) = delete;

  words::JsonLine& operator*() { return json_; }
  words::JsonLine* operator->() { return &json_; }

  /// At most once: nothing can be added behind it. It is on its way when this returns, as in a
  /// pipe.
  void print();

 private:
  std::string line_;
  words::JsonLine json_{line_};
};

}  // namespace canvoy::tools
