// A gateway of which the bus and the client are a pair of pipes: a frame a line, as candump -L has
// them, or `>` and what the client says, at the standard input; frames, and `<` and what the client
// is told, at the standard output. It ends with its input.
//
//     echo '>[1] 2 start' | canvoy_gateway_peer    # 000#0102 and <[1] OK
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/gateway/gateway.hpp"

namespace canvoy::gateway {
namespace {

Time now() {
  static const auto start = std::chrono::steady_clock::now();
  return Time(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - start));
}

bool put(void*, const Frame& frame) {
  const FrameText text(frame);
  std::printf("%.*s\n", static_cast<int>(text.view().size()), text.view().data());
  return true;
}

class Peer {
 public:
  Peer() : network_(1, {nullptr, &put, nullptr}, {.node_id = 9}), client_(gateway_.open()) {
    gateway_.add(network_);
  }

  void run() {
    network_.start(now());
    do {
      while (network_.deadline() <= now()) network_.advance(now());
      gateway_.settle(now());
      print();
    } while (is_waiting_over());
  }

 private:
  /// A line came, or a deadline. False at the end of the input.
  bool is_waiting_over() {
    const Time deadline = std::min(network_.deadline(), gateway_.deadline());
    const Duration left = std::clamp<Duration>(deadline - now(), 0ms, 1s);
    const auto left_ms = std::chrono::ceil<std::chrono::milliseconds>(left);
    pollfd input = {STDIN_FILENO, POLLIN, 0};
    return poll(&input, 1, static_cast<int>(left_ms.count())) == 0 || read_lines();
  }
  bool read_lines() {
    char bytes[4096];
    const auto count = ::read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0) return false;
    for (const char c : std::string_view(bytes, static_cast<std::size_t>(count))) {
      line_ += c;
      if (c != '\n') continue;
      take_line();
      line_.clear();
    }
    return true;
  }
  void take_line() {
    if (line_.starts_with('>')) return client_.receive(std::string_view(line_).substr(1));
    line_.pop_back();
    const ParsedFrame parsed = parse_frame(line_);
    if (parsed) network_.receive(parsed.frame, now());
  }
  void print() {
    bool begins = true;
    for (const char c : client_.output()) {
      if (begins) std::putchar('<');
      begins = c == '\n';
      if (c != '\r') std::putchar(c);
    }
    client_.consume(client_.output().size());
    std::fflush(stdout);
  }

  Network network_;
  Gateway gateway_;
  Session& client_;
  std::string line_;
};

}  // namespace
}  // namespace canvoy::gateway

int main() {
  canvoy::gateway::Peer().run();
}
