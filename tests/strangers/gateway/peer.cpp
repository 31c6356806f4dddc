// A gateway of which the bus and the client are a pair of pipes (pipe_node.hpp): `>` and what the
// client says come in, `<` and what the client is told go out.
//
//     echo '>[1] 2 start' | canvoy_gateway_peer    # 000#0102 and <[1] OK
#include <algorithm>
#include <string>
#include <string_view>

#include "canvoy/gateway/gateway.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace canvoy::gateway {
namespace {

/// Network and gateway; it acts as a node.
class World {
 public:
  World() : client_(gateway_.open()) { gateway_.add(network_); }

  World& node() { return *this; }
  void start(Time now) { network_.start(now); }
  Time deadline() const { return std::min(network_.deadline(), gateway_.deadline()); }
  void receive(const Frame& frame, Time now) {
    network_.receive(frame, now);
    settle(now);
  }
  void advance(Time now) {
    network_.advance(now);
    settle(now);
  }
  void obey(std::string_view line) {
    client_.receive(std::string(line.substr(1)) + "\n");
    settle(now_);
  }

 private:
  void settle(Time now) {
    now_ = now;
    gateway_.settle(now);
    print();
  }
  void print() {
    std::string_view rest = client_.output();
    while (!rest.empty()) {
      const std::size_t end = rest.find("\r\n");
      print_line("<" + std::string(rest.substr(0, end)));
      rest.remove_prefix(std::min(rest.size(), end + 2));
    }
    client_.consume(client_.output().size());
  }

  Network network_{1, pipe_port, {.node_id = 9}};
  Gateway gateway_;
  Session& client_;
  Time now_{};
};

}  // namespace
}  // namespace canvoy::gateway

int main() {
  canvoy::PipeNode<canvoy::gateway::World>().run();
}
