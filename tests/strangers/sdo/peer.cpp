// One end of an SDO dialogue: frames go in and out as lines, `605#4000100000000000`.
//
//     peer serve   node 5 with an SDO server: values, and a domain at 2030h
//     peer ask     writes 2030h of node 10 and reads it back: all kinds of transfer, many sizes;
//                  ends with status 0 where all came back as they went
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/canopen/sdo_block_client.hpp"
#include "canvoy/canopen/sdo_block_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"

namespace canvoy {
namespace {

bool write_line(void*, const Frame& frame) {
  std::string line(FrameText(frame).view());
  line += '\n';
  return ::write(STDOUT_FILENO, line.data(), line.size()) == static_cast<ssize_t>(line.size());
}

struct Memory {
  std::vector<std::uint8_t> values = std::vector<std::uint8_t>(sdo_objects().value_bytes);
  std::vector<ObjectState> states = std::vector<ObjectState>(sdo_objects().objects.size());
  std::array<Router::Route, 8> routes;
  std::array<Frame, 200> backlog;
};

/// A node whose bus are two pipes.
class PipeNode : private Memory {
 public:
  explicit PipeNode(NodeId id)
      : node(sdo_objects(), {values, states, routes, backlog}, {nullptr, &write_line, nullptr},
             id) {}

  static Time now() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return Time(std::chrono::duration_cast<Duration>(since));
  }
  /// One turn; false at the end of the input.
  bool turn() {
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (::poll(&input, 1, 10) > 0 && !receive()) return false;
    while (node.deadline() <= now()) node.advance(now());
    return true;
  }

  Node node;

 private:
  bool receive() {
    std::array<char, 4096> piece;
    const ssize_t size = ::read(STDIN_FILENO, piece.data(), piece.size());
    if (size <= 0) return false;
    text_.append(piece.data(), static_cast<std::size_t>(size));
    for (std::size_t end = 0; (end = text_.find('\n')) != std::string::npos;) {
      const ParsedFrame parsed = parse_frame(std::string_view(text_).substr(0, end));
      text_.erase(0, end + 1);
      if (parsed.error == FrameTextError::none) node.receive(parsed.frame, now());
    }
    return true;
  }

  std::string text_;
};

int serve() {
  PipeNode pipe(5);
  std::array<std::uint8_t, 5000> buffer{};
  SdoServer server(pipe.node, 0, buffer);
  const SdoBlockServer blocks(server);
  const MemoryDomain domain(pipe.node, 0x2030);
  pipe.node.start(PipeNode::now());
  while (pipe.turn()) {
  }
  return 0;
}

class Asker {
 public:
  Asker() { pipe_.node.start(PipeNode::now()); }
  /// Whether what was written came back, in this kind of transfer.
  bool round(std::size_t size, SdoTransfer transfer) {
    const std::vector<std::uint8_t> sent = pattern(size, static_cast<std::uint8_t>(size));
    std::vector<std::uint8_t> received(size);
    client_.choose(transfer);
    const bool well = wait(client_.download(10, 0x2030, 0, sent, on_done_)) == size &&
                      wait(client_.upload(10, 0x2030, 0, received, on_done_)) == size &&
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

  PipeNode pipe_{1};
  SdoClient client_{pipe_.node};
  SdoBlockClient blocks_{client_};
  SdoClient::Done on_done_ = SdoClient::Done::to<&Asker::done>(*this);
  std::optional<SdoClient::Outcome> outcome_;
};

int ask() {
  Asker asker;
  bool well = true;
  for (const std::size_t size : {1U, 4U, 5U, 7U, 8U, 889U, 890U, 1778U, 10'000U}) {
    for (const SdoTransfer transfer : {SdoTransfer::segmented, SdoTransfer::block}) {
      well = asker.round(size, transfer) && well;
    }
  }
  return well ? 0 : 1;
}

}  // namespace
}  // namespace canvoy

int main(int count, char** arguments) {
  if (count == 2 && std::strcmp(arguments[1], "serve") == 0) return canvoy::serve();
  if (count == 2 && std::strcmp(arguments[1], "ask") == 0) return canvoy::ask();
  std::fprintf(stderr, "peer serve, or peer ask\n");
  return 2;
}
