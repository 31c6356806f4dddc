// Tells by the first line of a client whether it speaks another protocol: a web page can have a
// browser send a request to any port of its machine, and the lines of its body would be commands.
//
//     FirstLine first;
//     if (!first.append(bytes).empty()) drop(client);
#pragma once

#include <string>
#include <string_view>

namespace canvoy::gateway {

class FirstLine {
 public:
  /// What the client sent, cut anywhere, before any of it is carried out. The name of the other
  /// protocol (HTTP, TLS), as soon as it is known; empty while it is none.
  std::string_view append(std::string_view bytes);

 private:
  /// A line of CiA 309-3 that is longer begins with its sequence, which is looked at before.
  static constexpr std::size_t length_max = 1024;

  std::string text_;
  bool ended_ = false;
};

}  // namespace canvoy::gateway
