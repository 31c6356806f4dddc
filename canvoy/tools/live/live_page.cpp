#include "canvoy/tools/live/live_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/live/live_viewer.hpp"
#include "canvoy/tools/live/write_permission.hpp"

namespace canvoy::tools {

namespace {

using Json = LivePage::Json;
using Segments = std::vector<std::string_view>;

web::WebResponse json_response(const Json& json, unsigned status = 200) {
  return {.status = status,
          .body = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"};
}

web::WebResponse refused(unsigned status, std::string_view why) {
  return json_response({{"error", why}}, status);
}

/// What somebody may ask the source for by HTTP.
struct Asked {
  std::string what;
  Json arguments = Json::object();
};

/// The whole text as a decimal number.
std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

Json body_of(const web::WebRequest& request) {
  Json body = Json::parse(request.body, nullptr, false);
  if (!body.is_object()) throw UsageError("the body is no JSON object");
  return body;
}

/// /api/networks/BUS/nodes/NODE/... To read an object is to send frames: a POST, as all that has an
/// effect.
std::optional<Asked> asked_of_node(const Segments& path, const web::WebRequest& request) {
  if (path.size() < 6 || path[1] != "networks" || path[3] != "nodes") return std::nullopt;
  const bool posts = request.method == "POST";
  Asked asked;
  if (posts) asked.arguments = body_of(request);
  const std::optional<std::uint64_t> node = whole_number(path[4]);
  if (!node || *node > node_id_max) {
    throw UsageError(fmt::format("'{}' is no node-ID", path[4]));
  }
  asked.arguments["bus"] = path[2];
  asked.arguments["node"] = *node;
  if (path.size() == 6 && path[5] == "nmt" && posts) {
    asked.what = "nmt";
  } else if (path.size() == 6 && path[5] == "objects" && !posts) {
    asked.what = "objects";
    asked.arguments["search"] = request.target.value("search").value_or("");
  } else if (path.size() == 7 && path[5] == "objects" && posts) {
    asked.what = "write";
    asked.arguments["object"] = path[6];
  } else if (path.size() == 8 && path[5] == "objects" && path[7] == "read" && posts) {
    asked.what = "read";
    asked.arguments["object"] = path[6];
  } else {
    return std::nullopt;
  }
  return asked;
}

/// /api/run/WHAT
std::optional<Asked> asked_of_run(const Segments& path, const web::WebRequest& request) {
  if (path.size() != 3 || path[1] != "run" || request.method != "POST") return std::nullopt;
  constexpr std::array all = {"pause", "speed", "step",    "seek",
                              "fault", "visit", "restart", "record"};
  if (std::ranges::find(all, path[2]) == all.end()) return std::nullopt;
  return Asked{.what = std::string(path[2]), .arguments = body_of(request)};
}

std::uint64_t since(const web::WebRequest& request) {
  const std::string_view text = request.target.value("since").value_or("0");
  const std::optional<std::uint64_t> number = whole_number(text);
  if (!number) throw UsageError(fmt::format("since: '{}' is no number of an event", text));
  return *number;
}

}  // namespace

LivePage::LivePage(LiveSource& source)
    : source_(source), state_(std::make_shared<const Json>(Json::object())) {}

void LivePage::look() {
  state_ = std::make_shared<const Json>(source_.state());
}

std::unique_ptr<web::LiveClient> LivePage::connect() {
  look();
  return std::make_unique<LiveViewer>(source_, state_);
}

void LivePage::answer(const web::WebRequest& request, Answer done) {
  try {
    const Segments path = request.target.segments();
    std::optional<Asked> asked = asked_of_node(path, request);
    if (!asked) asked = asked_of_run(path, request);
    if (!asked) return get(request, done);
    source_.act(asked->what, asked->arguments, [done](const Json& answer) {
      done(json_response(answer, answer.contains("error") ? 502 : 200));
    });
  } catch (const NotAllowed& failure) {
    done(refused(403, failure.what()));
  } catch (const Failure& failure) {
    done(refused(failure.status() == exit_usage ? 400 : 502, failure.what()));
  } catch (const nlohmann::json::exception&) {
    done(refused(400, "a member of the request is of the wrong type"));
  }
}

/// What is only looked at.
void LivePage::get(const web::WebRequest& request, const Answer& done) {
  const std::string& path = request.target.path;
  if (request.method != "GET") return done(refused(404, "nothing of this name can be done"));
  if (path.find("/objects/") != std::string::npos) {
    return done(
        refused(405, "to read an object is to ask the bus: POST {} to .../objects/OBJECT/read"));
  }
  look();
  if (path == "/api") return done(json_response(source_.description()));
  if (path == "/api/state") return done(json_response(*state_));
  if (path == "/api/networks") {
    Json all = Json::array();
    for (const std::string& bus : source_.feed().buses()) all.push_back({{"bus", bus}});
    return done(json_response(all));
  }
  if (path == "/api/nodes") {
    return done(
        json_response(state_->value("snapshot", Json::object()).value("nodes", Json::array())));
  }
  if (path == "/api/values") {
    std::string members;
    source_.feed().append_values(members, 0);
    return done({.body = fmt::format("{{{}}}\n", members)});
  }
  if (path == "/api/events") {
    const EventLines& events = source_.events();
    std::string list;
    for (std::uint64_t i = std::max(since(request), events.first()); i < events.end(); ++i) {
      list.append(list.empty() ? "" : ",").append(events.line(i));
    }
    return done({.body = fmt::format(R"({{"next":{},"events":[{}]}})", events.end(), list) + "\n"});
  }
  if (path == "/api/run.toml") {
    std::string file = source_.run_file();
    if (file.empty()) return done(refused(404, "this is no run that could be played again"));
    return done({.type = "application/toml", .body = std::move(file)});
  }
  if (path == "/api/frames.log") return done({.type = "text/plain", .body = log_text()});
  done(refused(404, "there is nothing of this name; /openapi.json says what there is"));
}

/// As candump -l writes them.
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
