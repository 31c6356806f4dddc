#include "canvoy/tools/play/play_world.hpp"

#include <fmt/format.h>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/page/report_page.hpp"
#include "canvoy/tools/page/serve.hpp"

namespace canvoy::tools {

namespace {

/// A building is watched at ten times the speed of the clock, so that cars move without long waits.
constexpr double usual_speed = 10;

}  // namespace

int play_world(LiveWorldOptions world, const PlayOptions& play_as, const RunOptions& options) {
  if (options.print) {
    fmt::print("{}", world.file(world.plan));
    return exit_done;
  }
  if (!options.is_watched()) {
    const MadeWorld made = world.make(world.plan);
    return play(*made.network, play_as);
  }
  if (options.json) throw UsageError("--json prints lines, and --web serves a page: take one");
  if (options.report && !play_as.real.empty()) {
    throw UsageError("a report is of a run that can be played again: leave real buses out");
  }
  const std::unique_ptr<host::EventLoop> loop = value_or_throw(host::EventLoop::create());
  world.command = options.command;
  world.speed = play_as.speed > 0 ? play_as.speed : usual_speed;
  LiveWorld live(std::move(world), play_as, parse_write_permission(options.allow_write), *loop);
  live.allow_recording(options.allow_record);
  if (options.report) return write_report(live, *options.report);
  return serve(live, *loop,
               {.address = options.web.value_or(""), .allow_write = options.allow_write});
}

}  // namespace canvoy::tools
