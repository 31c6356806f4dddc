#include "canvoy/tools/load/loaded_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "canvoy/can/frame.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

std::string id_text(const timing::BusMessage& message) {
  return fmt::format("{:0{}X}", message.id, message.is_extended ? 8 : 3);
}

std::string title(const LoadedMessage& message) {
  const std::string remote = message.timing.is_remote ? "R " : "";
  if (!message.name.empty()) return remote + message.name;
  if (message.node == 0) return remote + message.service;
  return fmt::format("{}{} {}", remote, message.service, message.node);
}

void complete(LoadedMessage& message) {
  timing::BusMessage& timing = message.timing;
  const unsigned data_bytes = timing.is_remote ? 0 : message.bytes;
  timing.bits = timing::longest_frame_bits(data_bytes, timing.is_extended);
  if (timing.deadline == Duration{}) timing.deadline = timing.period;
  if (message.frames == 0)
    message.bits_per_second = timing.bits * 1e6 / static_cast<double>(timing.period.count());
  if (!message.service.empty()) return;
  // A heartbeat of error control: only the first message, the boot-up, is a byte of 0.
  constexpr std::uint8_t operational = 5;
  const auto length = static_cast<std::uint8_t>(message.bytes);
  Frame frame{.id = timing.id, .length = length, .data = {operational}};
  if (timing.is_extended) frame.flags = frame.flags | FrameFlags::extended;
  if (timing.is_remote) frame.flags = frame.flags | FrameFlags::remote;
  text::FrameDecoder decoder;
  const text::FrameWords& words = decoder.decode(frame);
  message.service = words.service;
  if (message.node == 0) message.node = words.node;
}

timing::BusModel model_of(const LoadedBus& bus) {
  if (bus.bit_rate == 0) {
    throw UsageError(fmt::format(
        "the bit rate of {} is not known: say it in kbit/s, as --bit-rate 125", bus.name));
  }
  timing::BusModel model{.bit_rate = bus.bit_rate, .errors = bus.errors};
  for (const LoadedMessage& each : bus.messages) model.messages.push_back(each.timing);
  return model;
}

void add_messages(LoadedBus& bus, std::vector<LoadedMessage> more) {
  using Key = std::tuple<std::uint32_t, bool, bool>;
  const auto key_of = [](const LoadedMessage& message) {
    return Key{message.timing.id, message.timing.is_extended, message.timing.is_remote};
  };
  std::map<Key, std::string> known;
  for (const LoadedMessage& each : bus.messages) known[key_of(each)] = title(each);
  for (LoadedMessage& each : more) {
    const auto [other, is_new] = known.try_emplace(key_of(each), title(each));
    if (!is_new) {
      throw Failure(fmt::format("{}: {}h is sent twice: by {} and by {}", bus.name,
                                id_text(each.timing), other->second, title(each)));
    }
    bus.messages.push_back(std::move(each));
  }
  if (bus.messages.size() > messages_max) {
    throw Failure(fmt::format("{}: there are more than {} messages", bus.name, messages_max));
  }
}

}  // namespace canvoy::tools
