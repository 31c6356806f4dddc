// Arbitrary bytes from a client of the gateway, and arbitrary frames as answers: every line is
// answered or is none, and an accepted value is written and read back unchanged.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "canvoy/gateway/gateway.hpp"

namespace {

using namespace canvoy;
using namespace canvoy::gateway;

void check_value(const Request& request) {
  if (request.command != Command::write) return;
  const auto text = value_text(request.type, request.value, Version::v3_0);
  if (!text) std::abort();
  const auto words = split(*text);
  if (!words) std::abort();
  const auto again = parse_value(request.type, *words);
  // NaN has many patterns and one text.
  const bool is_nan = text->find("nan") != std::string::npos && is_real(request.type.type);
  if (!is_nan && again != request.value) std::abort();
}

/// The requested command, or none.
Command check_line(std::string_view line) {
  const Parsed parsed = parse_request(line);
  if (parsed.error != ErrorCode::none) return Command::none;
  check_value(parsed.request);
  return parsed.request.command;
}

/// True if the command does not change the network.
bool leaves_no_trace(Command command) {
  return command == Command::none || command == Command::read || command == Command::write ||
         command == Command::info_version || command >= Command::lss_switch_global;
}

/// A network that answers each frame with bytes of the input.
class World {
 public:
  World() : network_(1, {this, &World::take, nullptr}, {.node_id = 9}) {
    network_.start(now_);
    gateway_.add(network_);
  }

  void play(std::string_view input) {
    input_ = input;
    Session& session = gateway_.open();
    session.receive(input);
    session.end_input();
    gateway_.settle(now_);
    for (int turn = 0; turn < 64 && !session.idle(); ++turn) {
      check_output(session);
      answer();
      now_ += 100ms;
      while (network_.deadline() <= now_) network_.advance(now_);
      gateway_.settle(now_);
    }
    gateway_.close(session);
  }

 private:
  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<World*>(context);
    self.asked_ = frame.id;
    return true;
  }
  static void check_output(Session& session) {
    if (!session.output().empty() && !session.output().ends_with("\r\n")) std::abort();
    session.consume(session.output().size());
  }
  void answer() {
    const std::size_t length = std::min<std::size_t>(input_.size(), 8);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(input_.data());
    const std::uint32_t id = asked_ >= 0x600 && asked_ < 0x680 ? asked_ - 0x80 : asked_;
    network_.receive(Frame::data_frame(id == 0x7E5 ? 0x7E4 : id, std::span(bytes, length)), now_);
    input_.remove_prefix(length);
  }

  Time now_{};
  std::string_view input_;
  std::uint32_t asked_ = 0;
  Network network_;
  Gateway gateway_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  LineReader reader(4096);
  reader.append(input);
  bool leaves_trace = false;
  while (const auto line = reader.next()) {
    leaves_trace = !leaves_no_trace(check_line(line->text)) || leaves_trace;
  }
  // Shared by all inputs, since it is large, and made again only after a change.
  static const auto world = std::make_unique<World>();
  world->play(input);
  if (leaves_trace) world->play("[0] set id 9\n[0] init 0\n");
  return 0;
}
