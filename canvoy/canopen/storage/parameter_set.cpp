#include "canvoy/canopen/storage/parameter_set.hpp"

#include <algorithm>

#include "canvoy/canopen/sdo/sdo_channel.hpp"

namespace canvoy {

namespace {

/// A default that follows the node-ID continues to follow it: it is not stored as a number, which
/// would be wrong when the node-ID changes.
bool follows_node_id(const Dictionary& dictionary, const Entry& entry, std::uint8_t node_id) {
  const EntryShape& row = *entry.row;
  if (!has(row.traits, EntryTraits::plus_node_id)) return false;
  std::uint8_t bytes[8];
  store(bytes, dictionary.default_number(entry) + node_id);
  return std::ranges::equal(entry.bytes(), std::span(bytes).first(row.capacity));
}

/// Stored value of an SDO channel that ends with its connection: not valid (bit 31).
constexpr std::uint8_t no_channel[] = {0, 0, 0, 0x80};

}  // namespace

StoredHead::Bytes StoredHead::bytes() const {
  Bytes bytes;
  store(bytes.data(), index);
  bytes[2] = sub;
  store(bytes.data() + 3, length);
  return bytes;
}

StoredHead StoredHead::from(const Bytes& bytes) {
  return {.index = load<std::uint16_t>(bytes.data()),
          .sub = bytes[2],
          .length = load<std::uint32_t>(bytes.data() + 3)};
}

bool fits(const StoredHead& head, const Dictionary& dictionary) {
  const Result<Entry> entry = dictionary.find(head.index, head.sub);
  if (!entry || !is_parameter(head.index, *entry->row)) return false;
  const std::uint32_t capacity = entry->row->capacity;
  return is_string(entry->row->type) ? head.length <= capacity : head.length == capacity;
}

std::uint32_t stored_size_max(const Dictionary& dictionary) {
  std::uint32_t size = StoredWalk::first_entry;
  Entry entry;
  for (ParameterWalk walk(dictionary); walk.next(entry);) {
    size += StoredHead::size + entry.row->capacity;
  }
  return size;
}

bool StoredWalk::next(StoredHead& head) {
  StoredHead::Bytes bytes;
  if (!record_->read(offset_, bytes)) return false;
  head = StoredHead::from(bytes);
  const std::uint32_t behind = offset_ + StoredHead::size;
  if (head.length > record_->length() - behind) return false;
  length_ = head.length;
  offset_ = behind + length_;
  ++count_;
  return true;
}

bool StoredWalk::is_whole() const {
  std::array<std::uint8_t, first_entry> count;
  return record_->read(0, count) && load<std::uint32_t>(count.data()) == count_ &&
         offset_ == record_->length();
}

RecordSource ParameterSet::cook(const Recipe& recipe) {
  recipe_ = recipe;
  return {.rewind = callback<&ParameterSet::rewind>(*this),
          .next = callback<&ParameterSet::next>(*this)};
}

void ParameterSet::begin() {
  own_ = ParameterWalk(dictionary_);
  old_ = StoredWalk(record_);
  torn_ = false;
}

/// The number of entries comes first, so they are counted before they are written.
void ParameterSet::rewind() {
  begin();
  std::uint32_t count = 0;
  while (next_entry()) ++count;
  const bool torn = torn_;
  begin();
  torn_ = torn;
  store(head_.data(), count);
  head_size_ = sizeof count;
  length_ = 0;
  given_ = 0;
}

Result<std::size_t> ParameterSet::next(std::span<std::uint8_t> bytes) {
  std::size_t size = 0;
  do {
    size += give(bytes.subspan(size));
  } while (size < bytes.size() && next_entry());
  if (torn_) return AbortCode::hardware;
  return size;
}

/// Writes the rest of the present entry, as far as there is room.
std::size_t ParameterSet::give(std::span<std::uint8_t> bytes) {
  std::size_t size = 0;
  for (; size < bytes.size() && given_ < head_size_; ++size) bytes[size] = head_[given_++];
  if (given_ < head_size_) return size;
  const std::uint32_t offset = given_ - head_size_;
  const auto rest =
      bytes.subspan(size, std::min<std::size_t>(bytes.size() - size, length_ - offset));
  if (rest.empty()) return size;
  if (value_ != nullptr) {
    std::copy_n(value_ + offset, rest.size(), rest.begin());
  } else if (!record_.read(at_ + offset, rest)) {
    torn_ = true;
  }
  given_ += static_cast<std::uint32_t>(rest.size());
  return size + rest.size();
}

bool ParameterSet::next_entry() {
  given_ = 0;
  head_size_ = StoredHead::size;
  if ((recipe_.store && next_own()) || (recipe_.keep && next_old())) return true;
  head_size_ = length_ = 0;
  return false;
}

bool ParameterSet::next_own() {
  Entry entry;
  do {
    if (!own_.next(entry)) return false;
  } while (!wanted(entry));
  const auto bytes = entry.bytes();
  value_ = is_dynamic_channel(entry.index, bytes) ? no_channel : bytes.data();
  length_ = static_cast<std::uint32_t>(bytes.size());
  head_ = StoredHead{.index = entry.index, .sub = entry.sub, .length = length_}.bytes();
  return true;
}

bool ParameterSet::wanted(const Entry& entry) const {
  return is_in_group(entry.index, recipe_.group, groups_) &&
         !follows_node_id(dictionary_, entry, recipe_.node_id);
}

bool ParameterSet::next_old() {
  StoredHead head;
  do {
    if (!old_.next(head)) {
      torn_ = torn_ || !old_.is_whole();
      return false;
    }
  } while (is_in_group(head.index, recipe_.group, groups_) || !fits(head, dictionary_));
  value_ = nullptr;
  at_ = old_.value();
  length_ = head.length;
  head_ = head.bytes();
  return true;
}

}  // namespace canvoy
