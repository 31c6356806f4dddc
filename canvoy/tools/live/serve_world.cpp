#include "canvoy/tools/live/serve_world.hpp"

#include <utility>

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/live/serve.hpp"

namespace canvoy::tools {

namespace {

/// A building is watched at ten times the speed of the clock: one sees cars go, and waits for none.
constexpr double usual_speed = 10;

}  // namespace

int serve_world(LiveWorldOptions world, const PlayOptions& play, const RunOptions& options) {
  if (options.json) throw UsageError("--json prints lines, and --web serves a page: take one");
  const std::unique_ptr<host::EventLoop> loop = value_or_throw(host::EventLoop::create());
  world.command = options.command;
  world.speed = play.speed > 0 ? play.speed : usual_speed;
  LiveWorld live(std::move(world), play, parse_write_permission(options.allow_write), *loop);
  return serve(live, *loop,
               {.address = options.web.value_or(""), .allow_write = options.allow_write});
}

}  // namespace canvoy::tools
