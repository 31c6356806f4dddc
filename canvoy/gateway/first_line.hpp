// Detects from the first line of a client that it speaks another protocol: a web page can make a
// browser send a request to any port of its machine, and the lines of the body would be commands.
//
//     FirstLine first;
//     if (!first.append(bytes).empty()) drop(client);
#pragma once

#include <string>
#include <string_view>

namespace canvoy::gateway {

class FirstLine {
 public:
  /// Appends what the client sent, in pieces of any size, before any of it is carried out. Returns
  /// the name of the other protocol (HTTP, TLS) as soon as it is detected, otherwise an empty text.
  std::string_view append(std::string_view bytes);

 private:
  /// A longer line of CiA 309-3 begins with its sequence number, which is checked before.
  static constexpr std::size_t length_max = 1024;

  std::string text_;
  bool ended_ = false;
};

}  // namespace canvoy::gateway
