#include "canvoy/formats/sheet/stored_configurations.hpp"

#include <algorithm>
#include <string_view>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/sheet/sheet_configuration.hpp"

namespace canvoy::formats {

namespace {

constexpr std::uint8_t ascii = 0;

AbortCode check_concise(std::span<const std::uint8_t> bytes) {
  auto read = [&](std::uint32_t offset, std::span<std::uint8_t> piece) {
    std::ranges::copy(bytes.subspan(offset, piece.size()), piece.begin());
    return AbortCode::none;
  };
  const auto size = static_cast<std::uint32_t>(bytes.size());
  return check_concise_dcf({size, decltype(ByteSource::read)::of(read)}).abort();
}

}  // namespace

StoredConfigurations::StoredConfigurations(Node& node, const ConfigurationManager& manager,
                                           std::size_t bytes_max)
    : manager_(manager), bytes_max_(bytes_max) {
  using This = StoredConfigurations;
  domain_.open_read = decltype(Domain::open_read)::to<&This::open_read>(*this);
  domain_.read = decltype(Domain::read)::to<&This::read>(*this);
  domain_.open_write = decltype(Domain::open_write)::to<&This::open_write>(*this);
  domain_.write = decltype(Domain::write)::to<&This::write>(*this);
  domain_.close_write = decltype(Domain::close_write)::to<&This::close_write>(*this);
  const auto attach = [&node](Hook& hook, std::uint16_t index) {
    hook.first = hook.last = index;
    node.dictionary().attach(hook);
  };
  for (Hook* const hook : {&texts_, &concise_, &sheets_}) hook->domain = &domain_;
  for (Hook* const hook : {&text_formats_, &sheet_formats_}) {
    hook->before_write = decltype(Hook::before_write)::to<&This::check_format>(*this);
  }
  attach(texts_, object_index::dcf);
  attach(text_formats_, object_index::dcf + 1);
  attach(concise_, object_index::concise_dcf);
  attach(sheets_, object_index::slave_eds);
  attach(sheet_formats_, object_index::slave_eds + 1);
}

AbortCode StoredConfigurations::store(std::uint16_t index, NodeId slave,
                                      std::span<const std::uint8_t> bytes) {
  const Place place{index, slave};
  if (!may_change(place)) return AbortCode::device_state;
  if (!has_room_for(bytes.size())) return AbortCode::out_of_memory;
  Bytes copy(bytes.begin(), bytes.end());
  if (index == object_index::dcf) return take_dcf(slave, std::move(copy));
  if (index == object_index::concise_dcf) return take_concise_dcf(slave, std::move(copy));
  put(place, std::move(copy));
  return AbortCode::none;
}

std::span<const std::uint8_t> StoredConfigurations::content(std::uint16_t index,
                                                            NodeId slave) const {
  const auto found = contents_.find({index, slave});
  return found == contents_.end() ? std::span<const std::uint8_t>() : std::span(found->second);
}

Result<std::uint32_t> StoredConfigurations::open_read(const Entry& entry) {
  const auto bytes = content(entry.index, entry.sub);
  if (bytes.empty()) return AbortCode::no_data;
  new_.erase(place_of(entry));
  return static_cast<std::uint32_t>(bytes.size());
}

/// A content that is replaced during an upload is not mixed with the previous one.
Result<std::size_t> StoredConfigurations::read(const Entry& entry, std::uint32_t offset,
                                               std::span<std::uint8_t> bytes) {
  if (new_.contains(place_of(entry))) return AbortCode::device_state;
  const auto all = content(entry.index, entry.sub);
  if (offset > all.size() || bytes.size() > all.size() - offset) return AbortCode::general;
  std::ranges::copy(all.subspan(offset, bytes.size()), bytes.begin());
  return bytes.size();
}

AbortCode StoredConfigurations::open_write(const Entry& entry, std::uint32_t size) {
  if (!may_change(place_of(entry))) return AbortCode::device_state;
  if (!has_room_for(size)) return AbortCode::out_of_memory;
  arriving_.emplace(place_of(entry), Bytes());
  return AbortCode::none;
}

AbortCode StoredConfigurations::write(const Entry& entry, std::span<const std::uint8_t> bytes) {
  if (!has_room_for(bytes.size())) return AbortCode::out_of_memory;
  Bytes& arrived = arriving_[place_of(entry)];
  arrived.insert(arrived.end(), bytes.begin(), bytes.end());
  return AbortCode::none;
}

AbortCode StoredConfigurations::close_write(const Entry& entry, bool complete) {
  const auto arrived = arriving_.extract(place_of(entry));
  if (!complete || arrived.empty()) return AbortCode::none;
  const AbortCode answer = store(entry.index, entry.sub, arrived.mapped());
  if (answer == AbortCode::none && stored_) stored_(entry.index, entry.sub);
  return answer;
}

AbortCode StoredConfigurations::check_format(const Entry& entry,
                                             std::span<const std::uint8_t> value) {
  return entry.sub == 0 || value[0] == ascii ? AbortCode::none : AbortCode::value_range;
}

AbortCode StoredConfigurations::take_dcf(NodeId slave, Bytes text) {
  Bytes concise;
  if (!text.empty()) {
    Findings findings;
    const std::string_view characters(reinterpret_cast<const char*>(text.data()), text.size());
    const Configuration made = configuration_of(read_eds(characters, findings), slave);
    if (made.entries.empty() || !made.bad.empty()) return AbortCode::value_range;
    concise = concise_dcf_of(made.entries);
    if (!has_room_for(text.size() + concise.size())) return AbortCode::out_of_memory;
  }
  put({object_index::dcf, slave}, std::move(text));
  put({object_index::concise_dcf, slave}, std::move(concise));
  return AbortCode::none;
}

AbortCode StoredConfigurations::take_concise_dcf(NodeId slave, Bytes bytes) {
  const AbortCode malformed = bytes.empty() ? AbortCode::none : check_concise(bytes);
  if (malformed != AbortCode::none) return malformed;
  put({object_index::concise_dcf, slave}, std::move(bytes));
  put({object_index::dcf, slave}, {});
  return AbortCode::none;
}

bool StoredConfigurations::may_change(const Place& place) const {
  const bool is_eds = place.first == object_index::slave_eds;
  return !arriving_.contains(place) && (is_eds || !manager_.busy(place.second));
}

void StoredConfigurations::put(const Place& place, Bytes bytes) {
  new_.insert(place);
  if (bytes.empty()) {
    contents_.erase(place);
    return;
  }
  contents_[place] = std::move(bytes);
}

bool StoredConfigurations::has_room_for(std::size_t more) const {
  std::size_t sum = more;
  for (const Contents* const contents : {&contents_, &arriving_}) {
    for (const auto& [place, bytes] : *contents) sum += bytes.size();
  }
  return sum <= bytes_max_;
}

}  // namespace canvoy::formats
