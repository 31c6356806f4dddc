#include "canvoy/worlds/bus_line/display_feed.hpp"

#include "canvoy/profiles/cia407/passenger_information.hpp"

namespace canvoy::bus_line {

namespace {

constexpr std::uint16_t mapping = cia407::display_mapping_object.index;
constexpr std::uint8_t update_sub = 1;
constexpr std::uint8_t first_mapped = 2;

std::vector<std::uint8_t> bytes_of(std::uint32_t number, std::size_t size) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < size; ++i)
    bytes.push_back(static_cast<std::uint8_t>(number >> 8 * i));
  return bytes;
}

DisplayFeed::Write write_of(const DisplayText& text) {
  return {text.index, text.sub, text.octets};
}

}  // namespace

void DisplayFeed::forget() {
  has_.clear();
  has_all_ = false;
  was_forgotten_ = is_busy();
}

bool DisplayFeed::is_missing(const Write& write) const {
  const auto known = has_.find({write.index, write.sub});
  return known == has_.end() || known->second != write.octets;
}

std::optional<DisplayFeed::Write> DisplayFeed::first_missing() const {
  if (view_.character_set != 0) {
    const Write set{cia407::character_set_object.index, 1, bytes_of(view_.character_set, 2)};
    if (is_missing(set)) return set;
  }
  for (const DisplayText& text : view_.shown) {
    if (is_missing(write_of(text))) return write_of(text);
  }
  std::uint8_t sub = first_mapped;
  for (const DisplayText& text : view_.shown) {
    const std::uint32_t entry = cia407::display_by_bit_number.show(text.index, text.sub) |
                                std::uint32_t{text.format} << cia407::display_by_bit_number.format;
    const Write mapped{mapping, sub++, bytes_of(entry, 4)};
    if (is_missing(mapped)) return mapped;
  }
  const Write update{mapping, update_sub,
                     bytes_of(static_cast<std::uint32_t>(view_.shown.size()), 4)};
  if (view_.has_mapping && is_missing(update)) return update;
  for (const DisplayText& text : view_.soon) {
    if (is_missing(write_of(text))) return write_of(text);
  }
  return std::nullopt;
}

std::optional<DisplayFeed::Write> DisplayFeed::next() {
  if (is_busy() || has_all_) return std::nullopt;
  under_way_ = first_missing();
  has_all_ = !under_way_;
  if (has_all_) return std::nullopt;
  has_.erase({under_way_->index, under_way_->sub});
  // What is shown changes: it needs an update afterwards.
  bool is_shown = under_way_->index == mapping;
  for (const DisplayText& text : view_.shown) {
    is_shown = is_shown || (text.index == under_way_->index && text.sub == under_way_->sub);
  }
  if (is_shown || under_way_->index == cia407::character_set_object.index) {
    has_.erase({mapping, update_sub});
  }
  return under_way_;
}

void DisplayFeed::done(bool has_arrived) {
  const std::optional<Write> write = std::exchange(under_way_, std::nullopt);
  if (!write) return;
  if (std::exchange(was_forgotten_, false)) return;
  if (!has_arrived) return forget();
  has_[{write->index, write->sub}] = write->octets;
}

}  // namespace canvoy::bus_line
