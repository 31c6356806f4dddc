#include "canvoy/devices/cia447/kit/object_reader.hpp"

namespace canvoy::cia447 {

constexpr ServiceHandlers ObjectReader::service_calls = {.reset = method<&ObjectReader::reset>};

ObjectReader::ObjectReader(CarNetwork& network, const Settings& settings)
    : network_(network),
      settings_(settings),
      client_(network.node(), mesh_channel_to(settings.server)),
      timer_(callback<&ObjectReader::begin>(*this)) {
  if (settings.server == 0) return;
  network.node().attach(service_);
}

void ObjectReader::reset(ResetScope /*scope*/) {
  network_.node().timers().arm(timer_, network_.node().now() + first_request);
}

void ObjectReader::begin(Time now) {
  network_.node().timers().arm(timer_, now + settings_.period);
  if (client_.busy() || network_.node().id() == settings_.server) return;
  position_ = 0;
  ask();
}

void ObjectReader::ask() {
  for (; position_ < settings_.indices.size(); ++position_) {
    const std::uint16_t index = settings_.indices[position_];
    const Result<Entry> entry = network_.node().dictionary().find(index, 0);
    const bool is_consumed = entry && allows(entry->row->access, Access::sdo_write);
    if (!is_consumed) continue;
    client_.upload(settings_.server, index, 0, value_,
                   SdoClient::Done::to<&ObjectReader::answered>(*this));
    return;
  }
}

/// A node that does not answer is not read until the next round; one that lacks an object may have
/// others.
void ObjectReader::answered(SdoClient::Outcome outcome) {
  if (outcome.is_silence()) return;
  const std::uint16_t index = settings_.indices[position_++];
  Dictionary& dictionary = network_.node().dictionary();
  const Result<Entry> entry = dictionary.find(index, 0);
  if (outcome && entry && entry->bytes().size() == *outcome) {
    dictionary.set(*entry, std::span(value_).first(*outcome));
    settings_.came(index);
  }
  ask();
}

}  // namespace canvoy::cia447
