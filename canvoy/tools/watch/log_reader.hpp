// A log for verbs: of a long file, a thread reads and parses the next frames while the last ones
// are processed. Its interface is that of a TraceReader.
//
//     LogReader log(value_or_throw(formats::TraceReader::open("bus.asc")));
//     formats::TraceFrame heard;
//     while (log.next(heard) != formats::TraceRead::end) decode(heard);
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "canvoy/formats/trace/trace.hpp"

namespace canvoy::tools {

/// Counts and positions are those of what next() has returned, however far the thread has read.
class LogReader {
 public:
  /// Size from which a file is read ahead: frames of a pipe are delivered as they come.
  static constexpr std::uint64_t long_file = 1'000'000;

  explicit LogReader(formats::TraceReader trace, std::uint64_t ahead_from = long_file);
  LogReader(const LogReader&) = delete;
  LogReader& operator=(const LogReader&) = delete;
  ~LogReader();

  formats::TraceRead next(formats::TraceFrame& frame);

  const formats::TraceFormat& format() const { return trace_.format(); }
  std::string where() const { return worker_.joinable() ? bad_place_.where : trace_.where(); }
  std::string_view problem() const {
    return worker_.joinable() ? bad_place_.problem : trace_.problem();
  }
  std::uint64_t frames() const { return counts_.frames; }
  std::uint64_t bad() const { return counts_.bad; }
  std::uint64_t fd_frames() const { return counts_.fd_frames; }
  /// Number of bytes read so far; approximate for a file that is read ahead.
  std::uint64_t position() const;
  std::uint64_t size() const { return size_; }

 private:
  static constexpr std::size_t batch_size = 4096;
  static constexpr std::size_t batches_max = 4;

  struct Item {
    Time time{};
    Frame frame;
    formats::TraceRead read = formats::TraceRead::end;
    formats::TraceDirection direction = formats::TraceDirection::unknown;
    std::uint32_t channel = 0;  ///< index in Batch::channels
  };
  struct BadPlace {
    std::string where = {};
    std::string_view problem = {};
  };
  /// Items read by the thread at once; rare ones are stored separately, in the order of the items.
  struct Batch {
    std::vector<Item> items;
    std::vector<std::string> channels;
    std::vector<formats::TraceFdContent> fds;
    std::vector<BadPlace> bad;
    std::uint64_t position = 0;

    void clear();
    void add(formats::TraceRead read, const formats::TraceFrame& heard,
             const formats::TraceReader& trace);
  };
  struct Counts {
    std::uint64_t frames = 0;
    std::uint64_t bad = 0;
    std::uint64_t fd_frames = 0;
  };

  void read_all();
  /// Called by the thread: an empty batch, or null if reading is to end.
  std::unique_ptr<Batch> take_free();
  void pass_on(std::unique_ptr<Batch> batch);
  void take_batch();
  formats::TraceRead take_item(formats::TraceFrame& frame);

  formats::TraceReader trace_;  ///< used only by the thread, if there is one
  std::uint64_t size_;
  Counts counts_;

  std::unique_ptr<Batch> batch_;  ///< the current batch of next()
  std::size_t item_ = 0;
  std::size_t fd_ = 0;
  std::size_t bad_ = 0;
  BadPlace bad_place_;
  std::uint64_t position_ = 0;  ///< at the start of the batch

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::unique_ptr<Batch>> free_;
  std::vector<std::unique_ptr<Batch>> full_;  ///< oldest first
  bool is_over_ = false;                      ///< reading is to end
  std::thread worker_;
};

}  // namespace canvoy::tools
