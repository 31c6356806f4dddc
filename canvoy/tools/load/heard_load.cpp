#include "canvoy/tools/load/heard_load.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/simulated/arbitration.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

void HeardLoad::add(Duration time, std::string_view bus, const Frame& frame) {
  if (is_empty_) first_ = last_ = time;
  is_empty_ = false;
  first_ = std::min(first_, time);
  last_ = std::max(last_, time);
  auto known = buses_.find(bus);
  if (known == buses_.end()) known = buses_.try_emplace(std::string(bus)).first;
  if (buses_.size() > buses_max)
    throw Failure(fmt::format("there are more than {} buses", buses_max));
  if (frame.is_error()) {
    ++known->second.error_frames;
    return;
  }
  auto& by_key = known->second.by_key;
  Heard& heard = by_key[arbitration_key(frame)];
  if (by_key.size() > messages_max) {
    throw Failure(fmt::format("{} has more than {} identifiers, which is no network",
                              formats::plain_text(bus), messages_max));
  }
  LoadedMessage& message = heard.message;
  message.timing.id = frame.id;
  message.timing.is_extended = frame.is_extended();
  message.timing.is_remote = frame.is_remote();
  message.bytes = std::max<unsigned>(message.bytes, frame.length);
  ++message.frames;
  heard.bits += frame_bits(frame) + intermission_bits;
  heard.arrivals.add(Time(time));
}

LoadedMessage HeardLoad::described(const Heard& heard, Duration listened) {
  LoadedMessage message = heard.message;
  heard.arrivals.describe(message.timing, listened);
  message.bits_per_second =
      static_cast<double>(heard.bits) * 1e6 / static_cast<double>(listened.count());
  complete(message);
  return message;
}

std::vector<LoadedBus> HeardLoad::buses(Duration listened) const {
  if (listened == Duration{}) listened = std::max(last_ - first_, one_moment);
  std::vector<LoadedBus> made;
  for (const auto& [name, bus] : buses_) {
    LoadedBus& each = made.emplace_back();
    each.name = formats::plain_text(name);
    each.heard = listened;
    each.error_frames = bus.error_frames;
    for (const auto& [key, heard] : bus.by_key) each.messages.push_back(described(heard, listened));
  }
  return made;
}

}  // namespace canvoy::tools
