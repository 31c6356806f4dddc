// A client for tests of the web server, over a real socket.
#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <array>
#include <cerrno>
#include <string>
#include <string_view>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/gateway/tcp_address.hpp"

namespace canvoy::web::testing {

/// A client program that waits for at most ten seconds.
class Client {
 public:
  /// `address` as returned by a server, without a name.
  explicit Client(std::string_view address) {
    const timeval patience{.tv_sec = 10, .tv_usec = 0};
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    const auto parsed = gateway::parse_tcp_address(address);
    EXPECT_EQ(::connect(socket_.get(), parsed->get(), parsed->length), 0);
  }

  void say(std::string_view text) {
    EXPECT_EQ(::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(text.size()));
  }
  /// True if the text could be sent.
  bool try_say(std::string_view text) {
    return ::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(text.size());
  }
  /// Discards what was received so far.
  void forget_heard() {
    std::array<char, 4096> bytes;
    while (::recv(socket_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT) > 0) continue;
  }
  void end_output() { ::shutdown(socket_.get(), SHUT_WR); }
  /// Returns what was received, up to `end`; if that is empty, until the connection ends.
  std::string heard(std::string_view end = {}) {
    std::string text;
    std::array<char, 4096> bytes;
    while (end.empty() || text.find(end) == std::string::npos) {
      const ssize_t size = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
      if (size <= 0) return size == 0 || errno == ECONNRESET ? text : "timed out";
      text.append(bytes.data(), static_cast<std::size_t>(size));
    }
    return text;
  }

 private:
  host::Descriptor socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
};

}  // namespace canvoy::web::testing
