// A line of JSON that reports an event: an object with `event` and further members (docs/json.md).
//
//     JsonEvent event("written");
//     event->key("file").text(path);
//     event.print();  // {"event":"written","file":"node10.dcf"}
#pragma once

#include <string>
#include <string_view>

#include "canvoy/text/json_line.hpp"

namespace canvoy::tools {

class JsonEvent {
 public:
  explicit JsonEvent(std::string_view event);
  JsonEvent(const JsonEvent&) = delete;
  JsonEvent& operator=(const JsonEvent&) = delete;

  text::JsonLine& operator*() { return json_; }
  text::JsonLine* operator->() { return &json_; }

  /// Prints the line, at most once: nothing can be added afterwards. The output is flushed on
  /// return.
  void print();

 private:
  std::string line_;
  text::JsonLine json_{line_};
};

}  // namespace canvoy::tools
