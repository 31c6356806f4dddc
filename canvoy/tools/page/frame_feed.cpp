#include "canvoy/tools/page/frame_feed.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/profiles/model/physical.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/communication_text.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/value_text.hpp"

namespace canvoy::tools {

namespace {

/// Below it are communication parameters (CiA 301, 7.4.1), which make no curve.
constexpr std::uint16_t first_own_index = 0x2000;

std::uint64_t key_of(std::size_t bus, NodeId node, std::uint16_t index, std::uint8_t sub) {
  return std::uint64_t{bus} << 40 | std::uint64_t{node} << 32 | std::uint64_t{index} << 8 | sub;
}

void add_to(FrameFeed::Counts& counts, std::uint64_t bits, Duration time) {
  ++counts.frames;
  counts.bits += bits;
  counts.last = time;
}

}  // namespace

FramePrinterOptions printed_as_json(FramePrinterOptions options, const std::string& filter) {
  options.filters.clear();
  if (!filter.empty()) options.filters.push_back(filter);
  options.json = true;
  return options;
}

FrameFeed::FrameFeed(const FramePrinterOptions& options)
    : options_(options), printer_(std::make_unique<FramePrinter>(printed_as_json(options, ""))) {}

void FrameFeed::clear() {
  printer_ = std::make_unique<FramePrinter>(printed_as_json(options_, ""));
  first_ = end();
  frames_.clear();
  counts_.assign(buses_.size(), {});
  values_.clear();
  histories_.clear();
}

std::size_t FrameFeed::number_of(std::string_view bus) {
  const auto found = std::ranges::find(buses_, bus);
  if (found != buses_.end()) return static_cast<std::size_t>(found - buses_.begin());
  if (buses_.size() == buses_max) return buses_max;
  buses_.emplace_back(bus);
  counts_.emplace_back();
  return buses_.size() - 1;
}

void FrameFeed::add(Duration time, std::string_view bus, const Frame& frame) {
  const std::size_t number = number_of(bus);
  if (number == buses_max) return;
  if (frames_.size() == frames_max) {
    frames_.pop_front();
    ++first_;
  }
  frames_.push_back({time, frame, static_cast<std::uint8_t>(number)});
  const text::FrameWords& words = printer_->decode(bus, frame);
  count(time, number, frame, words);
  for (const decoder::DecodedValue& value : words.values) note(time, number, words.node, value);
}

void FrameFeed::count(Duration time, std::size_t bus, const Frame& frame,
                      const text::FrameWords& words) {
  const std::uint64_t bits = frame.is_error() ? 0 : frame_bits(frame);
  BusCounts& counts = counts_[bus];
  add_to(counts.all, bits, time);
  add_to(counts.nodes[words.node], bits, time);
  const auto known = counts.services.find(words.service);
  add_to(
      known != counts.services.end() ? known->second : counts.services[std::string(words.service)],
      bits, time);
}

void FrameFeed::remember(std::uint64_t key, Duration time, const decoder::DecodedValue& value) {
  if (value.index < first_own_index || value.entry == nullptr) return;
  auto known = histories_.find(key);
  if (known == histories_.end()) {
    if (histories_.size() == histories_max) return;
    known = histories_.emplace(key, ValueHistory{}).first;
  }
  const FieldInfo* const only = only_field(*value.entry);
  if (only == nullptr && !value.entry->fields.empty()) return;
  const Reading reading = only == nullptr ? read_value(*value.entry, value.bytes())
                                          : read_field(*value.entry, *only, value.bytes());
  // A state of a quantity is one of its numbers: a closed door has a width of 0 mm.
  const bool is_quantity = reading.kind == Reading::Kind::name &&
                           reading.named->meaning == Meaning::state &&
                           reading.value->unit != Unit::none;
  if (reading.kind == Reading::Kind::number || is_quantity) {
    known->second.add(in_seconds(time), reading.number);
  } else if (reading.kind == Reading::Kind::name) {
    known->second.add(in_seconds(time), reading.named->name);
  }
}

void FrameFeed::note(Duration time, std::size_t bus, NodeId node,
                     const decoder::DecodedValue& value) {
  const std::uint64_t key = key_of(bus, node, value.index, value.sub);
  auto known = values_.find(key);
  if (known == values_.end()) {
    if (values_.size() == values_max) return;
    known = values_.emplace(key, Value{}).first;
  } else if (value.version != 0 && known->second.version == value.version) {
    return;
  }
  remember(key, time, value);
  known->second.version = value.version;
  known->second.changed = ++changes_;
  known->second.time = time;
  known->second.bus = static_cast<std::uint8_t>(bus);
  known->second.node = node;
  known->second.last = value;
  if (value.transferred.data() == nullptr) return;
  known->second.bytes.assign(value.transferred.begin(), value.transferred.end());
  known->second.last.transferred = known->second.bytes;
}

/// Written only if a viewer wants it: most values change again before that.
const std::string& FrameFeed::member_of(Value& value) {
  if (value.written == value.changed) return value.member;
  value.written = value.changed;
  const decoder::DecodedValue& last = value.last;
  value.member.clear();
  fmt::format_to(std::back_inserter(value.member), R"("{} {} {:04X}:{:02X}":)", value.bus,
                 value.node, last.index, last.sub);
  text::JsonLine json(value.member);
  json.begin_object();
  json.key("time").number(in_seconds(value.time));
  json.key("bus").text(buses_[value.bus]);
  json.key("node").number(value.node);
  const std::string words = text::communication_text(last.index, last.sub, last.bytes());
  json.key("text").text(words.empty() ? text::value_text(last.entry, last.bytes()) : words);
  json.key("values");
  json_.append_values(value.member, {&last, 1});
  json.end_object();
  return value.member;
}

const ValueHistory& FrameFeed::history(std::string_view bus, NodeId node, std::uint16_t index,
                                       std::uint8_t sub) const {
  static const ValueHistory none;
  const auto number = static_cast<std::size_t>(std::ranges::find(buses_, bus) - buses_.begin());
  const auto known = histories_.find(key_of(number, node, index, sub));
  return known == histories_.end() ? none : known->second;
}

const Profile& FrameFeed::profile(std::string_view bus, NodeId node) {
  // Reading a bus makes it known, which must not happen for a bus that is only named.
  const bool is_known = std::ranges::find(buses_, bus) != buses_.end();
  return is_known ? printer_->profile(bus, node) : base_profile();
}

void FrameFeed::append_values(std::string& members, std::uint64_t since) {
  if (since == changes_) return;
  for (auto& [key, value] : values_) {
    if (value.changed <= since) continue;
    if (!members.empty()) members += ',';
    members += member_of(value);
  }
}

FrameReader::FrameReader(const FrameFeed& feed, const std::string& filter, std::uint64_t since)
    : feed_(feed),
      printer_(printed_as_json(feed.options(), filter)),
      since_(since),
      next_(feed.first()) {}

void FrameReader::read(std::string& elements, std::size_t bytes_max) {
  const std::uint64_t first = std::min(feed_.first(), limit_);
  if (next_ < first) {
    lost_ += first - next_;
    next_ = first;
  }
  const std::uint64_t last = std::min(end(), next_ + frames_at_once);
  std::string line;
  for (; next_ < last && elements.size() < bytes_max; ++next_) {
    const FrameFeed::Heard& heard = feed_.frame(next_);
    line.clear();
    const bool is_wanted = printer_.append(line, heard.time, feed_.buses()[heard.bus], heard.frame);
    if (!is_wanted || next_ < since_) continue;
    line.pop_back();  // the line break
    if (!elements.empty()) elements += ',';
    elements += line;
  }
}

}  // namespace canvoy::tools
