#include "canvoy/tools/page/live_bus.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/page/refusal.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

LiveBus::LiveBus(const std::string& address, std::string record, const FramePrinterOptions& options,
                 WritePermission permission, host::EventLoop& loop)
    : LiveNetwork(options, std::move(permission)),
      loop_(loop),
      bus_(value_or_throw(host::open_bus(loop, real_bus(address)))),
      attachment_(loop, *bus_),
      desk_(attachment_.port()),
      nodes_(feed_, [this](ReportedEvent event) { events_.add(std::move(event)); }),
      record_(std::move(record)) {
  counted_at_ = loop_.now();
  attachment_.attach(desk_.node());
  bus_->on_frame([this](const host::BusFrame& heard) { hear(heard); });
  bus_->on_state([this](BusState state, Time) {
    const bool is_active = state == BusState::error_active;
    const bool is_back = is_active && !trouble_.empty();
    if (is_active) trouble_.clear();
    tell(is_back ? "bus-back" : "can-state",
         is_back ? "the bus is back" : fmt::format("the bus is {}", text::bus_state_text(state)));
  });
  bus_->on_trouble([this](const host::Error& error) {
    trouble_ = error.line();
    tell("bus-lost", fmt::format("the bus is lost: {}", trouble_));
    print_message(fmt::format("canvoy: {}", trouble_));
  });
}

LiveBus::~LiveBus() = default;

void LiveBus::begin_log() {
  if (record_.empty()) return;
  log_.emplace(value_or_throw(LogWriter::create(record_, loop_.epoch())));
}

void LiveBus::hear(const host::BusFrame& heard) {
  const Duration time = loop_.epoch() + heard.time.time_since_epoch();
  ++heard_;
  feed_.add(time, bus_->name(), heard.frame);
  nodes_.hear(time, bus_->name(), heard.frame);
  recorder().hear(heard.time, bus_->name(), heard.frame);
  if (!log_) return;
  const host::Result<void> written = log_->write(heard.time, bus_->name(), heard.frame);
  if (!written) failure_ = written.error().line();
}

LiveSource::Json LiveBus::description() {
  return {{"kind", "bus"},
          {"time_is", "clock"},
          {"source", bus_->name()},
          {"command", feed_.options().view_line(std::string(bus_->name()))},
          {"buses", Json::array({std::string(bus_->name())})},
          {"can",
           {{"play", false},
            {"replay", false},
            {"visit", false},
            {"read", !permission().is_empty()},
            {"record", recorder().is_allowed()},
            {"write", permission().text()},
            {"nmt", permission().allows_nmt()}}}};
}

void LiveBus::tell(std::string_view event, const std::string& text) {
  const Time now = Time{} + loop_.epoch() + loop_.now().time_since_epoch();
  events_.add(
      reported_at(now, Told(text, {{"event", event}, {"bus", bus_->name()}, {"text", text}})));
}

void LiveBus::look_back() {
  const Time now = loop_.now();
  const Duration passed = now - counted_at_;
  if (passed < 1s) return;
  frames_per_second_ =
      static_cast<double>(heard_ - std::exchange(counted_, heard_)) / in_seconds(passed);
  counted_at_ = now;
  if (trend_.is_due(now)) trend_.add(now, {{"frames_per_second", frames_per_second_}});
  nodes_.look(loop_.epoch() + now.time_since_epoch());
  const std::uint64_t lost = bus_->counters().carrier.overrun;
  if (lost != lost_) {
    tell("frames-lost", fmt::format("{} frames were lost before they reached this program",
                                    lost - std::exchange(lost_, lost)));
  }
}

void LiveBus::advance(Time clock) {
  look_back();
  recorder().flush_each_second(clock);
  if (log_) ok_or_throw(log_->flush_each_second(clock));
  if (failure_) throw Failure(*failure_);
}

LiveSource::Json LiveBus::state() {
  const Duration now = loop_.epoch() + loop_.now().time_since_epoch();
  // The loop goes on evenly: neither a clock that is set nor a machine that sleeps moves it.
  const Duration clock =
      std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch());
  return {{"time", in_seconds(now)},
          {"snapshot",
           {{"bus_state", text::bus_state_text(bus_->state())},
            {"trouble", trouble_},
            {"frames_lost", bus_->counters().carrier.overrun},
            {"clock_ahead_s", std::round(in_seconds(clock - now))},
            {"frames_per_second", frames_per_second_},
            {"unknown_pdos", feed_.unknown_pdos({.is_counted = false})},
            {"nodes", nodes_.nodes_json(now)}}},
          {"record", recorder().json()}};
}

/// Looking on sends nothing: a request is a frame on the bus too.
void LiveBus::act(std::string_view what, const Json& arguments, const Done& done) {
  if (what == "read" && permission().is_empty()) {
    throw NotAllowed(
        "a question is a frame on the bus: start the command with --allow-write, if only of one "
        "object");
  }
  if (what == "trend") {
    Json told = trend_.json(listed_names(text_of(arguments, "names")));
    for (Json& time : told["times"]) time = in_seconds(loop_.epoch()) + time.get<double>();
    return done(std::move(told));
  }
  LiveNetwork::act(what, arguments, done);
}

void LiveBus::request(const BusRequest& request, const SdoRequests::Done& done) {
  if (request.bus != bus_->name()) throw NotThere(fmt::format("there is no bus '{}'", request.bus));
  // It would wait for the bus to come back, and be carried out then.
  if (!trouble_.empty() && bus_->state() == BusState::bus_off) {
    throw NotNow(fmt::format("the bus is lost: {}", trouble_));
  }
  if (request.kind == BusRequest::Kind::nmt) {
    const Port port = attachment_.port();
    if (!port.send(port.context, Frame::data_frame(0x000, {request.bytes[0], request.node}))) {
      throw Failure("the frame was refused: is the bus up?");
    }
    return;
  }
  desk_.node().advance(loop_.now());
  if (request.kind == BusRequest::Kind::read) {
    desk_.read(request.node, request.index, request.sub, done);
  } else {
    desk_.write(request.node, request.index, request.sub, request.bytes, done);
  }
  loop_.wake();
}

int LiveBus::finish() {
  if (log_) ok_or_throw(log_->finish());
  recorder().end();
  if (failure_) throw Failure(*failure_);
  return exit_done;
}

}  // namespace canvoy::tools
