// One end of an SDO dialogue, on a bus that is a pair of pipes (pipe_node.hpp).
//
//     peer serve   node 5 with an SDO server: values, and a domain at 2030h
//     peer ask     writes 2030h of node 10 and reads it back: all kinds of transfer, many sizes;
//                  ends with status 0 where all came back as they went
#include <cstdio>
#include <cstring>
#include <vector>

#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace canvoy {
namespace {

struct Memory {
  std::vector<std::uint8_t> values = std::vector<std::uint8_t>(sdo_objects().value_bytes);
  std::vector<ObjectState> states = std::vector<ObjectState>(sdo_objects().objects.size());
  std::array<Router::Route, 8> routes;
  std::array<Frame, 200> backlog;
};

/// A client and a node with what it needs of memory.
class Client : private Memory {
 public:
  Node& node() { return node_; }
  SdoClient& sdo() { return sdo_; }

 private:
  Node node_{sdo_objects(), {values, states, routes, backlog}, pipe_port, 1};
  SdoClient sdo_{node_};
  SdoBlockClient blocks_{sdo_};
};

class Server : private Memory {
 public:
  Node& node() { return node_; }

 private:
  Node node_{sdo_objects(), {values, states, routes, backlog}, pipe_port, 5};
  std::array<std::uint8_t, 5000> buffer_{};
  SdoServer server_{node_, 0, buffer_};
  SdoBlockServer blocks_{server_};
  MemoryDomain domain_{node_, 0x2030};
};

class Asker {
 public:
  /// Whether what was written came back, in this kind of transfer.
  bool round(std::size_t size, SdoTransfer transfer) {
    const std::vector<std::uint8_t> sent = pattern(size, static_cast<std::uint8_t>(size));
    std::vector<std::uint8_t> received(size);
    pipe_.device.sdo().choose(transfer);
    const bool well = wait(pipe_.device.sdo().download(10, 0x2030, 0, sent, on_done_)) == size &&
                      wait(pipe_.device.sdo().upload(10, 0x2030, 0, received, on_done_)) == size &&
                      received == sent;
    std::fprintf(stderr, "%s: %zu bytes, %s\n", well ? "done" : "FAILED", size,
                 transfer == SdoTransfer::block ? "in blocks" : "in segments or one frame");
    return well;
  }

 private:
  void done(SdoClient::Outcome outcome) { outcome_ = outcome; }
  std::size_t wait(AbortCode started) {
    outcome_.reset();
    while (started == AbortCode::none && !outcome_ && pipe_.turn()) {
    }
    if (outcome_ && *outcome_) return **outcome_;
    const AbortCode code = outcome_ ? outcome_->abort() : started;
    std::fprintf(stderr, "abort %08X\n", static_cast<unsigned>(code));
    return SIZE_MAX;
  }

  PipeNode<Client> pipe_;
  SdoClient::Done on_done_ = SdoClient::Done::to<&Asker::done>(*this);
  std::optional<SdoClient::Outcome> outcome_;
};

int ask() {
  Asker asker;
  bool well = true;
  for (const std::size_t size : {1U, 4U, 5U, 7U, 8U, 889U, 890U, 1778U, 10'000U, 100'000U}) {
    for (const SdoTransfer transfer : {SdoTransfer::segmented, SdoTransfer::block}) {
      well = asker.round(size, transfer) && well;
    }
  }
  return well ? 0 : 1;
}

}  // namespace
}  // namespace canvoy

int main(int count, char** arguments) {
  if (count == 2 && std::strcmp(arguments[1], "ask") == 0) return canvoy::ask();
  if (count == 2 && std::strcmp(arguments[1], "serve") == 0) {
    canvoy::PipeNode<canvoy::Server>().run();
    return 0;
  }
  std::fprintf(stderr, "peer serve, or peer ask\n");
  return 2;
}
