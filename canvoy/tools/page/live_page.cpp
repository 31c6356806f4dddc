#include "canvoy/tools/page/live_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/page/api_description.hpp"
#include "canvoy/tools/page/refusal.hpp"

namespace canvoy::tools {

namespace {

using Json = LivePage::Json;

constexpr std::string_view description_path = "/openapi.json";

web::WebResponse json_response(const Json& json, unsigned status = 200) {
  return {.status = status,
          .body = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"};
}

web::WebResponse refused(unsigned status, std::string_view why) {
  return json_response({{"error", why}}, status);
}

unsigned status_of(const Failure& failure) {
  if (dynamic_cast<const NotAsDescribed*>(&failure) != nullptr) return 400;
  if (dynamic_cast<const NotAllowed*>(&failure) != nullptr) return 403;
  if (dynamic_cast<const NotThere*>(&failure) != nullptr) return 404;
  if (dynamic_cast<const NotNow*>(&failure) != nullptr) return 409;
  return failure.status() == exit_usage ? 422 : 502;
}

}  // namespace

LivePage::LivePage(LiveSource& source)
    : source_(source),
      look_{.state = std::make_shared<const Json>(Json::object()),
            .counts = std::make_shared<const Json>(Json::object())} {}

void LivePage::look() {
  constexpr std::uint64_t counted_each = 10;
  Json state = source_.state();
  const Json time = state["time"];
  look_.state = std::make_shared<const Json>(std::move(state));
  if (looks_++ % counted_each != 0 && counted_run_ == source_.run()) return;
  look_.counts = std::make_shared<const Json>(counts_at(time));
  counted_run_ = source_.run();
}

std::unique_ptr<web::LiveClient> LivePage::connect(const web::RequestTarget& target) {
  look();
  return std::make_unique<LiveViewer>(source_, look_, target.value("values") != "off");
}

std::string LivePage::methods(std::string_view path) const {
  return path == description_path ? "GET, HEAD" : methods_of(path);
}

void LivePage::answer(const web::WebRequest& request, Answer done) {
  if (request.target.path == description_path) return done(json_response(api_description()));
  try {
    const ApiMatch match = find_route(request.method, request.target.path);
    if (match.route == nullptr) throw NotThere("there is nothing of this name");
    const Json arguments = arguments_of(match, request.target.query, request.body);
    if (match.route->action != ApiAction::act) return done(told(*match.route, arguments));
    source_.act(match.route->name, arguments, [done](const Json& answer) {
      done(json_response(answer, answer.contains("error") ? 502 : 200));
    });
  } catch (const Failure& failure) {
    done(refused(status_of(failure), failure.what()));
  }
}

/// Requests that only read.
web::WebResponse LivePage::told(const ApiRoute& route, const Json& arguments) {
  switch (route.action) {
    case ApiAction::act:
      break;
    case ApiAction::description:
      return json_response(source_.description());
    case ApiAction::state:
      return json_response(whole_state());
    case ApiAction::networks:
      return json_response(networks());
    case ApiAction::nodes:
      return json_response(
          source_.state().value("snapshot", Json::object()).value("nodes", Json::array()));
    case ApiAction::values: {
      std::string members;
      source_.feed().append_values(members, 0);
      return {.body = fmt::format("{{{}}}\n", members)};
    }
    case ApiAction::events:
      return {.body = events_since(arguments.value("since", std::uint64_t{0}))};
    case ApiAction::frames:
      return {.type = std::string(route.type), .body = log_text()};
    case ApiAction::run_file: {
      std::string file = source_.run_file();
      if (file.empty()) throw NotThere("this is no run that could be played again");
      return {.type = std::string(route.type), .body = std::move(file)};
    }
  }
  return refused(404, "there is nothing of this name");
}

LivePage::Json LivePage::counts_at(const Json& time) const {
  return {{"counts", source_.counts()}, {"counted", time}};
}

LivePage::Json LivePage::whole_state() {
  Json state = source_.state();
  state.update(counts_at(state["time"]));
  return state;
}

LivePage::Json LivePage::networks() const {
  Json all = Json::array();
  for (const std::string& bus : source_.feed().buses()) all.push_back({{"bus", bus}});
  return all;
}

std::string LivePage::events_since(std::uint64_t since) const {
  const EventLines& events = source_.events();
  std::string list;
  for (std::uint64_t i = std::max(since, events.first()); i < events.end(); ++i) {
    list.append(list.empty() ? "" : ",").append(events.line(i));
  }
  return fmt::format(R"({{"next":{},"events":[{}]}})", events.end(), list) + "\n";
}

/// In the format of candump -l.
std::string LivePage::log_text() const {
  const FrameFeed& feed = source_.feed();
  std::string text;
  for (std::uint64_t i = feed.first(); i < feed.end(); ++i) {
    const FrameFeed::Heard& heard = feed.frame(i);
    const std::int64_t microseconds = heard.time.count();
    fmt::format_to(std::back_inserter(text), "({:010}.{:06}) {} {}\n", microseconds / 1'000'000,
                   microseconds % 1'000'000, feed.buses()[heard.bus],
                   FrameText(heard.frame).view());
  }
  return text;
}

}  // namespace canvoy::tools
