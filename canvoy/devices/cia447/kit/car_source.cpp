#include "canvoy/devices/cia447/kit/car_source.hpp"

#include <algorithm>

namespace canvoy::cia447 {

namespace {

Items<std::uint32_t> mapping_of_pdo(unsigned number) {
  const auto* const pdo = std::ranges::find(predefined, number, &PdoInfo::number);
  return pdo == predefined.end() ? Items<std::uint32_t>{} : pdo->mapping;
}

}  // namespace

constexpr ServiceHandlers CarSource::service_calls = {.reset = method<&CarSource::reset>};

CarSource::CarSource(CarNetwork& network, const Settings& settings)
    : network_(network),
      settings_(settings),
      client_(network.node(), mesh_channel_to(0)),
      mapping_(mapping_of_pdo(settings.pdo_number)) {
  next_lost_ = network.on_lost(callback<&CarSource::node_lost>(*this));
  next_gap_ = network.on_gap(callback<&CarSource::missed>(*this));
  next_heard_ = network.on_heard(callback<&CarSource::node_heard>(*this));
  network.node().attach(service_);
}

void CarSource::came(Source source) {
  if (source == Source::pdo) came_from(network_.source_of(settings_.pdo_number));
}

void CarSource::came_from(NodeId source) {
  source_ = source;
  awaited_ = 0;
  network_.watch(source_);
}

void CarSource::reset(ResetScope /*scope*/) {
  if (source_ != 0) awaited_ = std::exchange(source_, NodeId{0});
}

void CarSource::node_lost(NodeId node) {
  if (next_lost_) next_lost_(node);
  if (node != source_) return;
  awaited_ = std::exchange(source_, NodeId{0});
  settings_.lost();
}

void CarSource::node_heard(NodeId node, std::uint8_t state) {
  if (next_heard_) next_heard_(node, state);
  const bool is_operational = state == static_cast<std::uint8_t>(NmtState::operational);
  if (node == awaited_ && is_operational) begin_reading();
}

/// Messages of the source may have been lost: its values hold until it has answered.
void CarSource::missed(NodeId node) {
  if (next_gap_) next_gap_(node);
  const bool is_meant = node == GapWatch::everyone || node == source_;
  if (!is_meant || source_ == 0 || !settings_.read) return;
  awaited_ = source_;
  begin_reading();
}

/// If that is not possible at present, the next heartbeat of the source starts it.
void CarSource::begin_reading() {
  if (awaited_ == 0 || !settings_.read || client_.busy()) return;
  client_.choose_channel(mesh_channel_to(awaited_));
  position_ = 0;
  read_next();
}

void CarSource::read_next() {
  for (; position_ < mapping_.size(); ++position_) {
    const MappingValue mapped(mapping_[position_]);
    const Result<Entry> entry = network_.node().dictionary().find(mapped.index, mapped.sub);
    const bool is_consumed = entry && allows(entry->row->access, Access::sdo_write);
    if (!is_consumed) continue;
    client_.upload(awaited_, mapped.index, mapped.sub, value_,
                   SdoClient::Done::to<&CarSource::answered>(*this));
    return;
  }
  came_from(awaited_);
  settings_.read();
}

/// A source that does not answer is read again with its next heartbeat; one that lacks an entry may
/// have others. If the PDO has come meanwhile, its values are newer.
void CarSource::answered(SdoClient::Outcome outcome) {
  if (awaited_ == 0) return;
  if (outcome.is_silence() || outcome.kind() == SdoEnd::Kind::cancelled) return;
  const MappingValue mapped(mapping_[position_++]);
  Dictionary& dictionary = network_.node().dictionary();
  const Result<Entry> entry = dictionary.find(mapped.index, mapped.sub);
  if (outcome && entry && entry->bytes().size() == *outcome) {
    dictionary.set(*entry, std::span(value_).first(*outcome));
  }
  read_next();
}

}  // namespace canvoy::cia447
