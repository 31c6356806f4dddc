// The source of the page: a network that is played, heard on a bus, or read from a log. All have
// frames and what is learned from them; each adds its own.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/tools/page/frame_feed.hpp"
#include "canvoy/tools/page/shared_frames.hpp"
#include "canvoy/tools/player/reported_event.hpp"

namespace canvoy::tools {

/// The latest events, each as a JSON object in a line.
class EventLines {
 public:
  static constexpr std::size_t lines_max = 10'000;

  /// Adds an event as JSON, with its `words`.
  void add(ReportedEvent event);
  void clear() {
    first_ += lines_.size();
    lines_.clear();
  }
  std::uint64_t first() const { return first_; }
  std::uint64_t end() const { return first_ + lines_.size(); }
  const std::string& line(std::uint64_t number) const { return lines_[number - first_]; }

 private:
  std::deque<std::string> lines_;
  std::uint64_t first_ = 0;
};

/// Addresses of a page, with its token.
struct PageReach {
  std::vector<std::string> addresses{};
  bool is_local = true;  ///< reachable from this machine only
};

class LiveSource {
 public:
  using Json = nlohmann::ordered_json;
  /// Called once with the result of the request: `error`, a line, if it was refused.
  using Done = std::function<void(Json)>;

  explicit LiveSource(const FramePrinterOptions& options) : feed_(options) {}
  virtual ~LiveSource() = default;
  LiveSource(const LiveSource&) = delete;
  LiveSource& operator=(const LiveSource&) = delete;

  /// Constant properties of the source: `kind`, `title`, and the possible actions.
  virtual Json description() = 0;
  /// Begins the log of all frames, if one was requested. Called once, before frames are heard and
  /// after all other checks, since an existing file is replaced. Throws Failure.
  virtual void begin_log() {}
  /// Continues for some milliseconds at most.
  virtual void advance(Time clock) = 0;
  /// The present state: `time`, `snapshot`, and further members.
  virtual Json state() = 0;
  /// Counts of each bus until now: `counts` of what viewers are told.
  Json counts() const;
  /// A file with which `canvoy run FILE` repeats this run; empty: not a run.
  virtual std::string run_file() const { return {}; }
  /// Performs an action of the table of routes, with checked arguments. Throws a refusal
  /// (refusal.hpp), UsageError if the words are not valid, else Failure.
  virtual void act(std::string_view what, const Json& arguments, const Done& done) = 0;
  /// Reports the result of the run on the terminal; returns the exit status.
  virtual int finish() = 0;

  /// Sets the addresses for viewers, for links to what they see.
  void set_reach(PageReach reach) { reach_ = std::move(reach); }
  const PageReach& reach() const { return reach_; }
  FrameFeed& feed() { return feed_; }
  const FrameFeed& feed() const { return feed_; }
  const EventLines& events() const { return events_; }
  /// Changes when everything starts again, and earlier content is void.
  std::uint64_t run() const { return run_; }
  /// Frames through a filter, for one viewer. Includes this many earlier frames, or all frames of a
  /// restarted run. Throws UsageError for an invalid filter.
  static constexpr std::uint64_t reported_before = 20'000;
  std::unique_ptr<FrameStream> watch(const std::string& filter, bool is_anew);

 protected:
  void begin_anew() {
    shared_.reset();
    feed_.clear();
    events_.clear();
    ++run_;
  }
  /// As watch(), for this viewer alone.
  virtual std::unique_ptr<FrameWalk> walk(const std::string& filter, bool is_anew) const;
  /// Objects of the profile of a node: `profile`, `objects`; from `bus`, `node`, `search`. Throws
  /// NotThere.
  Json objects(const Json& arguments);
  /// The past of a value; from `bus`, `node`, `object`. Throws NotThere.
  Json history(const Json& arguments);
  FrameFeed feed_;
  EventLines events_;

 private:
  /// A bus that was heard; else throws NotThere.
  std::string bus_in(const Json& arguments) const;

  PageReach reach_;
  std::uint64_t run_ = 0;
  std::weak_ptr<SharedFrames> shared_;  ///< of the viewers without a filter
};

}  // namespace canvoy::tools
