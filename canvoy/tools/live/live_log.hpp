// A log that people look at: all of it at once, or played as it was, or up to any time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/tools/live/heard_nodes.hpp"
#include "canvoy/tools/live/live_source.hpp"
#include "canvoy/tools/live/playback.hpp"

namespace canvoy::tools {

class LiveLog : public LiveSource {
 public:
  /// Of a longer log, the first so many frames.
  static constexpr std::size_t frames_max = 5'000'000;

  /// Throws Failure where it cannot be read, or has no frame.
  /// `once`: it is played from its beginning to its end, and not rewound. Then a log that is in the
  /// order of its times is read as it is played, in flat memory and of any length; else all of it
  /// is kept, up to frames_max.
  LiveLog(const std::string& path, const FramePrinterOptions& options, bool once = false);
  ~LiveLog() override;

  Json description() override;
  void advance(Time clock) override;
  Json state() override;
  void act(std::string_view what, const Json& arguments, const Done& done) override;
  int finish() override;
  std::uint64_t told_before() const override { return FrameFeed::frames_max; }

 private:
  struct Line {
    Time time{};
    Frame frame;
    std::uint8_t bus = 0;
  };

  void read(const std::string& path);
  bool survey();
  bool read_next();
  const Line* next_line();
  std::optional<std::uint8_t> bus_of(std::string_view channel);
  void begin_again();
  Time begin() const { return begin_; }
  void hear(const Line& line);

  std::string path_;
  std::vector<Line> lines_;                     ///< all that are kept
  std::optional<formats::TraceReader> stream_;  ///< in place of them
  std::optional<Line> streamed_;                ///< the next of the stream
  std::uint64_t frames_ = 0;
  Time begin_{};
  Time end_{};
  std::vector<std::string> buses_;
  std::unique_ptr<Playback> playback_;  ///< its time counts from the first frame
  std::unique_ptr<HeardNodes> nodes_;
  std::size_t next_ = 0;
  bool is_cut_ = false;
};

}  // namespace canvoy::tools
