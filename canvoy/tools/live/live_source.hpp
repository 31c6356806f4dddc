// What the page looks at: a network that is played, heard on a bus, or read from a log. All have
// frames and what is known from them; each adds its own.
#pragma once

#include <deque>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/tools/live/frame_feed.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

/// The latest of what has happened, each a JSON object in a line.
class EventLines {
 public:
  static constexpr std::size_t lines_max = 10'000;

  /// As JSON, with its `words`.
  void add(ToldEvent event);
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

class LiveSource {
 public:
  using Json = nlohmann::ordered_json;
  /// Called once, with what the request has come to: `error`, a line, where it was refused.
  using Done = std::function<void(Json)>;

  explicit LiveSource(const FramePrinterOptions& options) : feed_(options) {}
  virtual ~LiveSource() = default;
  LiveSource(const LiveSource&) = delete;
  LiveSource& operator=(const LiveSource&) = delete;

  /// What does not change while it is looked at: `kind`, `title`, and what may be done.
  virtual Json description() = 0;
  /// Begins the log of all frames, where one is wanted: once, before anything is heard, and when
  /// nothing else can be wrong any more, since the file of before is gone then. Throws Failure.
  virtual void begin_log() {}
  /// Goes on, for some milliseconds at most.
  virtual void advance(Time clock) = 0;
  /// As it is now: `time`, `snapshot`, and what else there is.
  virtual Json state() = 0;
  /// A file that `canvoy run FILE` plays as this is played; empty: it is no run.
  virtual std::string run_file() const { return {}; }
  /// Does what somebody asks for: a deed of the table of routes, with arguments that are as it
  /// says. Throws a refusal (refusal.hpp), UsageError where the words make no sense, else Failure.
  virtual void act(std::string_view what, const Json& arguments, const Done& done) = 0;
  /// What the run comes to, for the terminal; the exit status.
  virtual int finish() = 0;

  FrameFeed& feed() { return feed_; }
  const FrameFeed& feed() const { return feed_; }
  const EventLines& events() const { return events_; }
  /// Another number when all has begun anew, and nothing holds that was told before.
  std::uint64_t run() const { return run_; }
  /// Of the frames that were heard before somebody looks at them, so many are told.
  virtual std::uint64_t told_before() const { return 20'000; }

 protected:
  void begin_anew() {
    feed_.clear();
    events_.clear();
    ++run_;
  }
  /// What the profile of a node has: `profile`, `objects`; of `bus`, `node`, `search`. Throws
  /// NotThere.
  Json objects(const Json& arguments);
  /// Of each bus, what was on it until now.
  Json counts() const;

  FrameFeed feed_;
  EventLines events_;

 private:
  std::uint64_t run_ = 0;
};

}  // namespace canvoy::tools
