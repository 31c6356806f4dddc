// A simulated network as a WebAssembly module: what `canvoy run --web` serves, for one page,
// without a server. playground/worker.js calls it. Texts go by a buffer each way, as UTF-8:
//
//     canvoy_begin(put("run lift --lifts 2"))   // the length of a line that says what is wrong, or
//     0 canvoy_connect(true); canvoy_advance(performance.now() * 1000); // now and then, and then,
//     until it gives 0: canvoy_next()                             // the length of a message of the
//     WebSocket
//
// As the command: the words are those of the command line, and each fault, deed and seek is as
// there.
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/page/live_page.hpp"
#include "canvoy/tools/page/live_viewer.hpp"
#include "canvoy/tools/page/live_world.hpp"
#include "canvoy/tools/play/play_world.hpp"
#include "canvoy/web/request_target.hpp"

#define CANVOY_EXPORT extern "C" __attribute__((visibility("default"), used))

namespace canvoy::tools {

namespace {

/// Of what is played, and who looks on.
struct Played {
  Played(LiveWorldOptions options, const PlayOptions& play)
      : world(std::move(options), play, parse_write_permission("all"), *loop), page(world) {
    world.set_reach({.addresses = {}, .is_local = false});
  }

  std::unique_ptr<host::EventLoop> loop = value_or_throw(host::EventLoop::create());
  LiveWorld world;
  LivePage page;
  std::unique_ptr<web::LiveClient> client;
};

std::unique_ptr<Played> played;
std::string input;   ///< what the page says
std::string output;  ///< what it is told

std::string_view said(std::size_t length) {
  return std::string_view(input).substr(0, length);
}

std::size_t told(std::string text) {
  output = std::move(text);
  return output.size();
}

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (end != 0) words.emplace_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

/// What is wrong with the command, or nothing.
std::string begin(std::string_view command) {
  CommandLine line("Canvoy in a browser: simulated CANopen networks", "canvoy");
  add_run(line);
  CommandLine::Outcome outcome = line.parse(words_of(command));
  if (outcome.kind != CommandLine::Outcome::Kind::understood) return std::move(outcome.text);
  line.run();
  return played ? "" : "the command plays nothing";
}

}  // namespace

/// In place of a terminal, a server or a report: the page.
int play_world(LiveWorldOptions world, const PlayOptions& play_as, const RunOptions& options) {
  constexpr double usual_speed = 10;
  if (!play_as.real.empty()) throw UsageError("a browser has no real buses");
  if (!play_as.log.empty())
    throw UsageError("--log: a browser has no files; Share saves the frames");
  if (options.print) throw UsageError("--print: Share saves the network as a file");
  world.command = options.command;
  world.speed = play_as.speed > 0 ? play_as.speed : usual_speed;
  played = std::make_unique<Played>(std::move(world), play_as);
  return exit_done;
}

/// Room for so many bytes of what is said next.
CANVOY_EXPORT char* canvoy_input(std::size_t size) {
  input.resize(size);
  return input.data();
}

CANVOY_EXPORT const char* canvoy_output() {
  return output.data();
}

/// Plays what a command line without its first word says. What was played before is gone.
CANVOY_EXPORT std::size_t canvoy_begin(std::size_t length) {
  played.reset();
  try {
    return told(begin(said(length)));
  } catch (const Failure& failure) {
    return told(failure.what());
  }
}

/// Who looks on begins again.
CANVOY_EXPORT void canvoy_connect(bool wants_values) {
  web::RequestTarget target{.path = "/live"};
  if (!wants_values) target.query.emplace_back("values", "off");
  played->client = played->page.connect(target);
}

/// `clock` in microseconds.
CANVOY_EXPORT void canvoy_advance(double clock) {
  played->world.advance(Time(Duration(static_cast<Duration::rep>(clock))));
  played->page.look();
}

CANVOY_EXPORT std::size_t canvoy_next() {
  return told(played->client->next());
}

/// There is more to be told at once.
CANVOY_EXPORT bool canvoy_is_behind() {
  return played->client->is_behind();
}

CANVOY_EXPORT void canvoy_said(std::size_t length) {
  played->client->said(said(length));
}

/// The body of what GET gives of a path of the API.
CANVOY_EXPORT std::size_t canvoy_get(std::size_t length) {
  std::string body;
  const auto target = web::parse_target(said(length));
  if (!target) return told("");
  played->page.answer({.method = "GET", .target = *target, .body = {}},
                      [&body](web::WebResponse response) { body = std::move(response.body); });
  return told(std::move(body));
}

}  // namespace canvoy::tools
