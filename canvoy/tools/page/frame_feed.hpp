// Keeps for viewers what was heard on all buses: the latest frames, the latest value of each
// object, and frame counts. Memory is bounded for any input.
//
//     FrameFeed feed({});
//     feed.add(time, "can0", frame);
//     FrameReader reader(feed, {"node=10"});
//     reader.read(lines, 256 * 1024);
#pragma once

#include <algorithm>
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
#include "canvoy/text/frame_json.hpp"
#include "canvoy/tools/page/value_history.hpp"
#include "canvoy/tools/watch/frame_printer.hpp"

namespace canvoy::tools {

class FrameFeed {
 public:
  struct Heard {
    Duration time{};
    Frame frame;
    std::uint8_t bus = 0;  ///< index in buses()
  };
  /// Counts of one kind of frame, since the last clear().
  struct Counts {
    std::uint64_t frames = 0;
    std::uint64_t bits = 0;  ///< on the wire
    Duration last{};         ///< time of the last frame
  };
  struct BusCounts {
    Counts all;
    std::map<NodeId, Counts> nodes;
    std::map<std::string, Counts, std::less<>> services;
  };

  static constexpr std::size_t buses_max = 32;
  static constexpr std::size_t values_max = 20'000;
  static constexpr std::size_t frames_max = 200'000;
  /// Number of values of which the past is kept, 24 kB each at most.
  static constexpr std::size_t histories_max = 500;

  /// Throws UsageError if an option is not valid. Filters belong to readers and are not used here.
  explicit FrameFeed(const FramePrinterOptions& options);
  FrameFeed(const FrameFeed&) = delete;
  FrameFeed& operator=(const FrameFeed&) = delete;

  /// Adds a frame; ignores frames of more than buses_max buses.
  void add(Duration time, std::string_view bus, const Frame& frame);
  /// Discards everything: what follows belongs to another run.
  void clear();

  const std::vector<std::string>& buses() const { return buses_; }
  const FramePrinterOptions& options() const { return options_; }
  /// Number of frames added; first() is the number of the oldest frame kept.
  std::uint64_t end() const { return first_ + frames_.size(); }
  std::uint64_t first() const { return first_; }
  const Heard& frame(std::uint64_t number) const { return frames_[number - first_]; }

  /// Increases with each value that changes.
  std::uint64_t changes() const { return changes_; }
  /// Appends members of a JSON object for values that have changed since then: `"sim0 10
  /// 6010:00":{"time":...}`.
  void append_values(std::string& members, std::uint64_t since);
  /// The past of a value of an application or profile; empty if there is none.
  const ValueHistory& history(std::string_view bus, NodeId node, std::uint16_t index,
                              std::uint8_t sub) const;
  const BusCounts& counts(std::size_t bus) const { return counts_[bus]; }
  /// As FramePrinter::unknown_pdos(), of all frames that were added.
  std::vector<std::string> unknown_pdos(text::UnknownPdosWords words) {
    return printer_->unknown_pdos(words);
  }
  /// The profile of a node, as far as known; CiA 301 if nothing is.
  const Profile& profile(std::string_view bus, NodeId node);

 private:
  struct Value {
    decoder::DecodedValue last;  ///< of an SDO transfer, with its bytes in `bytes`
    std::vector<std::uint8_t> bytes;
    Duration time{};
    std::uint8_t bus = 0;  ///< index in buses()
    NodeId node = 0;
    std::uint64_t version = 0;
    std::uint64_t changed = 0;
    std::uint64_t written = 0;  ///< `changed` of what `member` has
    std::string member;         ///< of a JSON object, without the comma
  };

  std::size_t number_of(std::string_view bus);
  void count(Duration time, std::size_t bus, const Frame& frame, const text::FrameWords& words);
  const std::string& member_of(Value& value);
  void remember(std::uint64_t key, Duration time, const decoder::DecodedValue& value);
  void note(Duration time, std::size_t bus, NodeId node, const decoder::DecodedValue& value);

  FramePrinterOptions options_;
  std::unique_ptr<FramePrinter> printer_;
  std::vector<std::string> buses_;
  std::deque<Heard> frames_;
  std::uint64_t first_ = 0;
  std::vector<BusCounts> counts_;
  std::unordered_map<std::uint64_t, Value> values_;
  std::unordered_map<std::uint64_t, ValueHistory> histories_;
  std::uint64_t changes_ = 0;
  text::FrameJson json_;
};

/// The frames for one viewer, through the filter of that viewer.
class FrameStream {
 public:
  FrameStream() = default;
  virtual ~FrameStream() = default;
  FrameStream(const FrameStream&) = delete;
  FrameStream& operator=(const FrameStream&) = delete;

  /// Appends elements of a JSON array, about this many bytes at most; the rest comes with the next
  /// call.
  virtual void read(std::string& elements, std::size_t bytes_max) = 0;
  virtual bool is_behind() const = 0;
  /// Number of frames lost before they were read, since the last call.
  virtual std::uint64_t take_lost() { return 0; }
  /// Part of the frames that a filter has tested, from 0 to 1.
  virtual double searched() const { return 1; }
  /// True if more frames pass the filter than are reported.
  virtual bool is_full() const { return false; }
};

/// Frames one after the other, by their numbers.
class FrameWalk : public FrameStream {
 public:
  /// Number of frames before the one that is read first, which are followed to know what it means.
  static constexpr std::uint64_t learned_before = 20'000;

  /// Number of the frame that is read next.
  virtual std::uint64_t next() const = 0;
  /// Number of the frame after the last one that there is, or at which it ends.
  virtual std::uint64_t end() const = 0;
  /// Goes on with this frame.
  virtual void begin_at(std::uint64_t number) = 0;
  /// Ends before this frame.
  virtual void end_at(std::uint64_t number) = 0;
};

/// Options to print frames as JSON with one filter; empty: all frames.
FramePrinterOptions printed_as_json(FramePrinterOptions options, const std::string& filter);

/// Reads the frames of a feed, which keeps the latest ones.
class FrameReader : public FrameWalk {
 public:
  /// Reads all frames from `since` on. Throws UsageError for an invalid filter.
  FrameReader(const FrameFeed& feed, const std::string& filter, std::uint64_t since);

  void read(std::string& elements, std::size_t bytes_max) override;
  bool is_behind() const override { return next_ < end(); }
  std::uint64_t take_lost() override { return std::exchange(lost_, 0); }
  std::uint64_t next() const override { return std::max(next_, since_); }
  std::uint64_t end() const override { return std::min(feed_.end(), limit_); }
  void begin_at(std::uint64_t number) override {
    since_ = number;
    next_ = number - std::min(number, learned_before);
    // What is no longer there is lost only from the first frame on that was to be read.
    if (next_ < feed_.first()) next_ = std::min(feed_.first(), since_);
  }
  void end_at(std::uint64_t number) override { limit_ = number; }

 private:
  static constexpr std::size_t frames_at_once = 5000;

  const FrameFeed& feed_;
  FramePrinter printer_;
  std::uint64_t since_;  ///< earlier frames are only decoded
  std::uint64_t next_;
  std::uint64_t limit_ = ~std::uint64_t{0};  ///< number of the first frame that is not read
  std::uint64_t lost_ = 0;
};

}  // namespace canvoy::tools
