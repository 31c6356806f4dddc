// A log for viewers: as a whole, played in real time, or up to any time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/tools/page/frame_store.hpp"
#include "canvoy/tools/page/heard_nodes.hpp"
#include "canvoy/tools/page/live_source.hpp"
#include "canvoy/tools/page/playback.hpp"

namespace canvoy::tools {

class LiveLog : public LiveSource {
 public:
  /// Throws Failure if the log cannot be read, or has no frame.
  LiveLog(const std::string& path, const FramePrinterOptions& options);
  ~LiveLog() override;

  Json description() override;
  void advance(Time clock) override;
  Json state() override;
  void act(std::string_view what, const Json& arguments, const Done& done) override;
  int finish() override;

 private:
  std::unique_ptr<FrameWalk> walk(const std::string& filter, bool is_anew) const override;
  void read(const std::string& path);
  std::optional<std::uint8_t> bus_of(std::string_view channel);
  void begin_again();
  Time begin() const { return begin_; }
  void hear(const StoredFrame& heard);
  /// Those of `names` that a log has, over all of it, in the form of Trend::json().
  Json trend(const std::vector<std::string>& names);
  void count_rates();
  std::uint64_t frames_between(Time from, Time to) const;

  std::string path_;
  FrameStore frames_;
  FrameCursor cursor_{frames_};
  Time begin_{};
  Time end_{};
  std::vector<std::string> buses_;
  std::unique_ptr<Playback> playback_;  ///< with times from the first frame
  std::unique_ptr<HeardNodes> nodes_;
  std::uint64_t next_ = 0;
  std::vector<std::pair<double, double>> rates_;  ///< end of a part in seconds, frames a second
  std::uint64_t last_second_ = 0;                 ///< frames before counted_at_
  Time counted_at_{};
  std::uint64_t unreadable_ = 0;      ///< lines or blocks
  std::string unreadable_at_;         ///< the first of them, and why
  std::uint64_t of_other_buses_ = 0;  ///< frames of more buses than are shown
};

}  // namespace canvoy::tools
