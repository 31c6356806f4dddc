#include "canvoy/tools/page/frame_feed.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/communication_text.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/value_text.hpp"

namespace canvoy::tools {

namespace {

std::uint64_t key_of(std::size_t bus, NodeId node, const decoder::DecodedValue& value) {
  return std::uint64_t{bus} << 40 | std::uint64_t{node} << 32 | std::uint64_t{value.index} << 8 |
         value.sub;
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

void FrameFeed::note(Duration time, std::size_t bus, NodeId node,
                     const decoder::DecodedValue& value) {
  const std::uint64_t key = key_of(bus, node, value);
  auto known = values_.find(key);
  if (known == values_.end()) {
    if (values_.size() == values_max) return;
    known = values_.emplace(key, Value{}).first;
  } else if (value.version != 0 && known->second.version == value.version) {
    return;
  }
  known->second.version = value.version;
  known->second.changed = ++changes_;
  std::string& member = known->second.member;
  member.clear();
  fmt::format_to(std::back_inserter(member), R"("{} {} {:04X}:{:02X}":)", bus, node, value.index,
                 value.sub);
  text::JsonLine json(member);
  json.begin_object();
  json.key("time").number(in_seconds(time));
  json.key("bus").text(buses_[bus]);
  json.key("node").number(node);
  const std::string words = text::communication_text(value.index, value.sub, value.bytes());
  json.key("text").text(words.empty() ? text::value_text(value.entry, value.bytes()) : words);
  json.key("values");
  json_.append_values(member, {&value, 1});
  json.end_object();
}

const Profile& FrameFeed::profile(std::string_view bus, NodeId node) {
  // Reading a bus makes it known, which must not happen for a bus that is only named.
  const bool is_known = std::ranges::find(buses_, bus) != buses_.end();
  return is_known ? printer_->profile(bus, node) : base_profile();
}

void FrameFeed::append_values(std::string& members, std::uint64_t since) const {
  if (since == changes_) return;
  for (const auto& [key, value] : values_) {
    if (value.changed <= since) continue;
    if (!members.empty()) members += ',';
    members += value.member;
  }
}

FrameReader::FrameReader(const FrameFeed& feed, const std::string& filter, std::uint64_t since)
    : feed_(feed),
      printer_(printed_as_json(feed.options(), filter)),
      since_(since),
      next_(feed.first()) {}

void FrameReader::read(std::string& elements, std::size_t bytes_max) {
  if (next_ < feed_.first()) {
    lost_ += feed_.first() - next_;
    next_ = feed_.first();
  }
  const std::uint64_t end = std::min(feed_.end(), next_ + frames_at_once);
  std::string line;
  for (; next_ < end && elements.size() < bytes_max; ++next_) {
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
