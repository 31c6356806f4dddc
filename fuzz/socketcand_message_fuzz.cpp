// Arbitrary bytes from a socketcand, in pieces of any size: the messages do not depend on the
// pieces, and each frame is written and read back unchanged.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/host/socketcand_message.hpp"

namespace {

using canvoy::host::SocketcandMessages;

std::vector<std::string> messages_of(std::string_view stream, std::size_t piece) {
  SocketcandMessages messages;
  std::vector<std::string> found;
  for (std::size_t at = 0; at < stream.size(); at += piece) {
    messages.add(stream.substr(at, piece));
    while (const auto message = messages.next()) found.emplace_back(*message);
  }
  return found;
}

/// The own message, as the server would pass it on.
void check_frame(const canvoy::Frame& frame) {
  if (frame.is_error()) return;
  std::string sent = canvoy::host::socketcand_send_message(frame);
  const bool is_remote = frame.is_remote();
  const std::size_t id = sent.find(' ', 2) + 1;
  const std::size_t length = sent.find(' ', id) + 1;
  const std::size_t end = sent.find(' ', length);
  const std::string heard =
      is_remote ? "rtr " + sent.substr(id, length - id) + "1.5 " + sent.substr(length, end - length)
                : "frame " + sent.substr(id, length - id) + "1.5" +
                      sent.substr(end, sent.size() - end - 2);
  const auto again = canvoy::host::parse_socketcand_frame(heard);
  if (!again || *again != frame) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view stream(reinterpret_cast<const char*>(data), size);
  // Which messages are too long depends on the moment of the check.
  if (size > SocketcandMessages::length_max) return 0;
  const std::vector<std::string> messages = messages_of(stream, size == 0 ? 1 : size);
  if (messages_of(stream, 1) != messages || messages_of(stream, 3) != messages) std::abort();
  for (const std::string& message : messages) {
    if (const auto frame = canvoy::host::parse_socketcand_frame(message)) check_frame(*frame);
  }
  return 0;
}
