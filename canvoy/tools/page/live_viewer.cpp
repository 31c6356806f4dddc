#include "canvoy/tools/page/live_viewer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/page/api_routes.hpp"
#include "canvoy/tools/page/json_difference.hpp"

namespace canvoy::tools {

namespace {

constexpr std::size_t message_max = 256 * 1024;  ///< bytes, approximately
constexpr std::size_t events_at_once = 1000;
constexpr std::size_t answers_max = 200;

std::string dumped(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

LiveViewer::LiveViewer(LiveSource& source, const LiveLook& look, bool wants_values)
    : source_(source), newest_(look), wants_values_(wants_values) {}

void LiveViewer::add(std::string_view name, std::string_view json) {
  message_ += message_.empty() ? '{' : ',';
  message_.append("\"").append(name).append("\":").append(json);
}

void LiveViewer::begin_anew() {
  run_ = source_.run();
  told_ = {};
  event_ = source_.events().first();
  change_ = 0;
  Json hello = source_.description();
  hello["addresses"] = source_.reach().addresses;
  hello["is_local"] = source_.reach().is_local;
  add("hello", dumped(hello));
  if (frames_) frames_ = source_.watch(filter_, true);
}

void LiveViewer::add_state() {
  if (told_.state == newest_.state) return;
  if (!told_.state) {
    Json state = *newest_.state;
    state.update(*newest_.counts);
    add("state", dumped(state));
  } else {
    Json change = json_difference(*told_.state, *newest_.state);
    if (told_.counts != newest_.counts) {
      change.update(json_difference(*told_.counts, *newest_.counts));
    }
    if (!change.empty()) add("change", dumped(change));
  }
  told_ = newest_;
}

void LiveViewer::add_events() {
  const EventLines& events = source_.events();
  event_ = std::max(event_, events.first());
  std::string list;
  for (std::size_t i = 0; i < events_at_once && event_ < events.end(); ++i) {
    if (!list.empty()) list += ',';
    list += events.line(event_++);
  }
  if (!list.empty()) add("events", fmt::format("[{}]", list));
}

void LiveViewer::add_values() {
  if (!wants_values_) return;
  std::string members;
  source_.feed().append_values(members, change_);
  change_ = source_.feed().changes();
  if (!members.empty()) add("values", fmt::format("{{{}}}", members));
}

void LiveViewer::add_frames() {
  if (!frames_) return;
  std::string list;
  frames_->read(list, message_max);
  if (!list.empty()) add("frames", fmt::format("[{}]", list));
  const std::uint64_t lost = frames_->take_lost();
  if (lost != 0) add("frames_lost", std::to_string(lost));
  const double searched = frames_->is_full() ? -1 : frames_->searched();
  if (searched != told_searched_) add("frames_searched", fmt::format("{:.3f}", searched));
  told_searched_ = searched;
}

std::string LiveViewer::next() {
  message_.clear();
  if (run_ != source_.run()) begin_anew();
  add_state();
  add_events();
  add_values();
  add_frames();
  if (!answers_->empty()) {
    add("answers", fmt::format("[{}]", fmt::join(*answers_, ",")));
    answers_->clear();
  }
  if (!message_.empty()) message_ += '}';
  return std::move(message_);
}

bool LiveViewer::is_behind() const {
  return event_ < source_.events().end() || (frames_ && frames_->is_behind());
}

void LiveViewer::said(std::string_view message) {
  const Json request = Json::parse(message, nullptr, false);
  if (!request.is_object()) return;
  const auto id = request.find("id");
  Json answer_to = id != request.end() && id->is_number() ? *id : Json(nullptr);
  const auto done = [answers = std::weak_ptr(answers_), answer_to](Json answer) {
    const auto open = answers.lock();
    if (!open || answer_to.is_null() || open->size() >= answers_max) return;
    answer["id"] = answer_to;
    open->push_back(dumped(answer));
  };
  try {
    do_request(request, done);
  } catch (const Failure& failure) {
    done({{"error", failure.what()}});
  } catch (const nlohmann::json::exception&) {
    done({{"error", "a member of the request is of the wrong type"}});
  }
}

void LiveViewer::do_request(const Json& request, const LiveSource::Done& done) {
  const auto what = request.find("do");
  if (what == request.end() || !what->is_string()) {
    throw UsageError("do: say what is to be done");
  }
  if (*what == "frames") {
    watch_frames(request);
    return done({{"done", true}});
  }
  if (*what == "values") {
    wants_values_ = request.value("on", true);
    return done({{"done", true}});
  }
  const ApiRoute* const route = find_action(what->get<std::string_view>());
  if (route == nullptr) {
    throw UsageError(fmt::format("do: there is no '{}'", what->get<std::string_view>()));
  }
  constexpr std::array<std::string_view, 2> envelope = {"id", "do"};
  check_arguments(*route, request, envelope);
  source_.act(route->name, request, done);
}

/// `on`, and `filter` as on the command line.
void LiveViewer::watch_frames(const Json& request) {
  if (!request.value("on", true)) return frames_.reset();
  const std::string filter = request.value("filter", "");
  frames_ = source_.watch(filter, false);
  filter_ = filter;
  told_searched_ = 1;
}

}  // namespace canvoy::tools
