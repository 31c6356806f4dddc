// What was heard of all buses, for those who look on: the latest frames, the latest value of each
// object, and how many frames there were. Memory is bounded whatever comes.
//
//     FrameFeed feed({});
//     feed.add(time, "can0", frame);
//     FrameReader reader(feed, {"node=10"});
//     reader.read(lines, 256 * 1024);
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/tools/log/frame_printer.hpp"
#include "canvoy/words/frame_json.hpp"

namespace canvoy::tools {

class FrameFeed {
 public:
  struct Heard {
    Duration time{};
    Frame frame;
    std::uint8_t bus = 0;  ///< its place among buses()
  };
  /// Of one sort, since the last clear().
  struct Counts {
    std::uint64_t frames = 0;
    std::uint64_t bits = 0;  ///< on the wire
    Duration last{};         ///< when the last one came
  };
  struct BusCounts {
    Counts all;
    std::map<NodeId, Counts> nodes;
    std::map<std::string, Counts, std::less<>> services;
  };

  static constexpr std::size_t buses_max = 32;
  static constexpr std::size_t values_max = 20'000;
  static constexpr std::size_t frames_max = 200'000;

  /// Throws UsageError where an option makes no sense. Filters are those of readers, not of this.
  explicit FrameFeed(const FramePrinterOptions& options);
  FrameFeed(const FrameFeed&) = delete;
  FrameFeed& operator=(const FrameFeed&) = delete;

  /// Frames of more buses than buses_max are passed over.
  void add(Duration time, std::string_view bus, const Frame& frame);
  /// Forgets all: what comes next is of another run.
  void clear();

  const std::vector<std::string>& buses() const { return buses_; }
  const FramePrinterOptions& options() const { return options_; }
  /// How many were added; the oldest that is still there has the number first().
  std::uint64_t end() const { return first_ + frames_.size(); }
  std::uint64_t first() const { return first_; }
  const Heard& frame(std::uint64_t number) const { return frames_[number - first_]; }

  /// Grows with each value that changes.
  std::uint64_t changes() const { return changes_; }
  /// Members of a JSON object: `"sim0 10 6010:00":{"time":...}`, those that have changed since.
  void append_values(std::string& members, std::uint64_t since) const;
  const BusCounts& counts(std::size_t bus) const { return counts_[bus]; }
  /// The profile of a node, as far as it is known; CiA 301 where nothing is.
  const Profile& profile(std::string_view bus, NodeId node);

 private:
  struct Value {
    std::string member;  ///< of a JSON object, without the comma
    std::uint64_t version = 0;
    std::uint64_t changed = 0;
  };

  std::size_t number_of(std::string_view bus);
  void count(Duration time, std::size_t bus, const Frame& frame, const words::FrameWords& words);
  void note(Duration time, std::size_t bus, NodeId node, const decoder::DecodedValue& value);

  FramePrinterOptions options_;
  std::unique_ptr<FramePrinter> printer_;
  std::vector<std::string> buses_;
  std::deque<Heard> frames_;
  std::uint64_t first_ = 0;
  std::vector<BusCounts> counts_;
  std::unordered_map<std::uint64_t, Value> values_;
  std::uint64_t changes_ = 0;
  words::FrameJson json_;
  std::string line_;
};

/// One who looks on: what he has been told, by his own filter.
class FrameReader {
 public:
  /// All of it since then. Throws UsageError for a filter that makes no sense.
  FrameReader(const FrameFeed& feed, const std::string& filter, std::uint64_t since);

  /// Adds elements of a JSON array, at most about so many bytes; what it has not come to, comes
  /// next.
  void read(std::string& elements, std::size_t bytes_max);
  bool is_behind() const { return next_ < feed_.end(); }
  /// Frames that were gone before they could be told, since the last call.
  std::uint64_t take_lost() { return std::exchange(lost_, 0); }

 private:
  static constexpr std::size_t frames_at_once = 5000;

  const FrameFeed& feed_;
  FramePrinter printer_;
  std::uint64_t since_;  ///< those before are read to learn from them
  std::uint64_t next_;
  std::uint64_t lost_ = 0;
};

}  // namespace canvoy::tools
