// canvoy send, sync, time, emcy BUS ...: sends frames.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <memory>
#include <optional>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/canopen/sync/time_of_day.hpp"
#include "canvoy/text/message_text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/node/ask_options.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/session/sent_frame.hpp"

namespace canvoy::tools {

namespace {

/// Repetition.
struct SendOptions : AskOptions {
  std::string interval = {};
  std::uint64_t count = 0;

  void add_to(Verb& command) {
    command.add({
        {"--every", interval, "again and again, so long apart: 10ms, 1s"},
        {"--count", count, "with --every: how often (default: until interrupted)", above_zero},
    });
    add_json(command);
  }
  void check() const {
    if (count != 0 && interval.empty()) throw UsageError("--count is for --every");
    if (!interval.empty()) parse_duration_argument(interval);
  }
};

/// `next` gives the frames of each repetition.
template <class Next>
int send_in_turns(const SendOptions& options, Sessions& sessions, const Next& next) {
  Session& session = options.open(sessions);
  const bool repeats = !options.interval.empty();
  const Duration interval = repeats ? parse_duration_argument(options.interval) : Duration{};
  Time due = session.loop().now();
  for (std::uint64_t turn = 0;; ++turn) {
    for (const Frame& frame : next(turn)) {
      session.send(frame);
      if (options.json) print_sent(session, frame);
    }
    if (!repeats || turn + 1 == options.count) return exit_done;
    // Frames that a pause of the machine has delayed do not follow in a burst.
    due = std::max(due, session.loop().now() - interval) + interval;
    session.loop().run_until(due);
    if (session.loop().signal() != 0) return exit_done;
  }
}

// -- send

struct FrameOptions : SendOptions {
  std::vector<std::string> frames = {};
};

std::vector<Frame> parse_frames(const std::vector<std::string>& texts) {
  std::vector<Frame> frames;
  for (const std::string& text : texts) {
    const ParsedFrame parsed = parse_frame(text);
    if (!parsed) {
      throw UsageError(fmt::format("'{}' is no frame: {}; write 123#DEADBEEF or 123#R", text,
                                   describe(parsed.error)));
    }
    if (parsed.frame.is_error()) {
      throw UsageError(fmt::format("'{}' is an error frame, which only controllers send", text));
    }
    frames.push_back(parsed.frame);
  }
  return frames;
}

int send_frames(const FrameOptions& options, Sessions& sessions) {
  options.check();
  std::vector<Frame> frames = parse_frames(options.frames);
  return send_in_turns(options, sessions, [&frames](std::uint64_t) { return frames; });
}

// -- sync

struct SyncOptions : SendOptions {
  unsigned counter_max = 0;
};

int send_sync(const SyncOptions& options, Sessions& sessions) {
  options.check();
  return send_in_turns(options, sessions, [&options](std::uint64_t turn) {
    if (options.counter_max == 0) return std::vector{Frame::data_frame(can_id::sync, {})};
    const auto counter = static_cast<std::uint8_t>(turn % options.counter_max + 1);
    return std::vector{Frame::data_frame(can_id::sync, {counter})};
  });
}

// -- time

struct TimeOptions : SendOptions {
  std::string time = {};
};

TimeOfDay clock_time() {
  using namespace std::chrono;
  const auto now = floor<milliseconds>(system_clock::now());
  const auto day = floor<days>(now);
  constexpr sys_days epoch = 1984y / January / 1;
  TimeOfDay time;
  time.milliseconds = static_cast<std::uint32_t>((now - day).count());
  time.days = static_cast<std::uint16_t>((day - epoch).count());
  return time;
}

int send_time(const TimeOptions& options, Sessions& sessions) {
  options.check();
  std::optional<TimeOfDay> given;
  if (!options.time.empty()) {
    given = text::parse_time_of_day(options.time);
    if (!given) {
      throw UsageError(fmt::format("'{}' is no time: write 2026-11-21 12:00:00", options.time));
    }
  }
  return send_in_turns(options, sessions, [&given](std::uint64_t) {
    const TimeOfDayBytes bytes = encode_time(given ? *given : clock_time());
    return std::vector{Frame::data_frame(can_id::time, bytes)};
  });
}

// -- emcy

struct EmergencyOptions : SendOptions {
  std::string code = {};
  std::string error_register = {};
  std::string data = {};
};

/// Reads `8130`, `8130h` and `0x8130`, all hexadecimal, up to `most`.
unsigned parse_code(std::string_view given, unsigned most, std::string_view advice) {
  std::string_view digits = given;
  if (digits.starts_with("0x") || digits.starts_with("0X")) {
    digits.remove_prefix(2);
  } else if (digits.ends_with('h') || digits.ends_with('H')) {
    digits.remove_suffix(1);
  }
  unsigned code = 0;
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, code, 16);
  if (error == std::errc{} && end == last && code <= most) return code;
  throw UsageError(fmt::format("'{}' is {}", given, advice));
}

unsigned parse_error_code(std::string_view given) {
  return parse_code(given, 0xFFFF, "no error code: write 0000 to FFFF, as 8130 or 8130h");
}

unsigned parse_error_register(std::string_view given) {
  return parse_code(given, 0xFF, "no error register: write 00 to FF, as 11 or 11h");
}

std::vector<std::uint8_t> parse_manufacturer_bytes(const std::string& given) {
  try {
    return parse_value(EntryInfo{}, "hex:" + given);
  } catch (const UsageError&) {
    throw UsageError(fmt::format("--data: '{}' is none: write bytes as '01 02 AB'", given));
  }
}

Frame emergency_frame(const EmergencyOptions& options) {
  const unsigned code = parse_error_code(options.code);
  const bool is_given = !options.error_register.empty();
  const unsigned usual = code == 0 ? 0x00 : 0x01;
  const unsigned error_register = is_given ? parse_error_register(options.error_register) : usual;
  std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(code & 0xFFU),
                                     static_cast<std::uint8_t>(code >> 8),
                                     static_cast<std::uint8_t>(error_register)};
  const std::vector<std::uint8_t> data = parse_manufacturer_bytes(options.data);
  bytes.insert(bytes.end(), data.begin(), data.end());
  if (bytes.size() > Frame::length_max) {
    throw UsageError("--data: an emergency has five bytes of the manufacturer");
  }
  bytes.resize(Frame::length_max);
  return Frame::data_frame(can_id::emergency + options.node_id(), bytes);
}

int send_emergency(const EmergencyOptions& options, Sessions& sessions) {
  options.check();
  const Frame frame = emergency_frame(options);
  return send_in_turns(options, sessions, [&frame](std::uint64_t) { return std::vector{frame}; });
}

template <class Options, class Run>
void on_chosen(Verb& command, Sessions& sessions, const std::shared_ptr<Options>& options,
               Run run) {
  command.runs([options, &sessions, run] { return run(*options, sessions); });
}

}  // namespace

void add_send(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<FrameOptions>();
  Verb& command = app.add_verb("send", "Send frames, as cansend does");
  options->add_bus(command);
  command.add({
      {"frame", options->frames, "123#DEADBEEF, 123#R, 123#R4, 00000123#11.22; or several",
       required},
  });
  options->add_to(command);
  command.add_examples(
      "  canvoy send can0 123#DEADBEEF\n"
      "  canvoy send can0 70A#R 00000123#11.22.33\n"
      "  canvoy send can0 18A#A000 --every 100ms --count 3 --json");
  on_chosen(command, sessions, options, send_frames);
}

void add_sync(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<SyncOptions>();
  Verb& command = app.add_verb("sync", "Send SYNC, once or as its producer");
  options->add_bus(command);
  command.add({
      {"--counter", options->counter_max,
       "count from 1 to this number in it (1019h; default: no counter)", between(2U, 240U)},
  });
  options->add_to(command);
  command.add_examples(
      "  canvoy sync can0\n"
      "  canvoy sync can0 --every 20ms --count 5 --counter 4");
  on_chosen(command, sessions, options, send_sync);
}

void add_time(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<TimeOptions>();
  Verb& command = app.add_verb("time", "Send TIME: the date and the time of day");
  options->add_bus(command);
  command.add({
      {"time", options->time, "2026-11-21 12:00:00 (default: that of this machine, UTC)"},
  });
  options->add_to(command);
  command.add_examples(
      "  canvoy time can0\n"
      "  canvoy time can0 '2026-11-21 12:00:00' --json");
  on_chosen(command, sessions, options, send_time);
}

void add_emcy(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<EmergencyOptions>();
  Verb& command = app.add_verb("emcy", "Send an emergency in the name of a node");
  options->add_bus(command);
  options->add_node(command);
  command.add({
      {"code", options->code, "8130 or 8130h; 0: no error any more", required},
      {"register", options->error_register,
       "error register (1001h), as 11 (default 01, and 00 with code 0)"},
      {"--data", options->data, "of the manufacturer, up to 5 bytes: '01 02'"},
  });
  options->add_to(command);
  command.add_examples(
      "  canvoy emcy can0 10 8130h\n"
      "  canvoy emcy can0 10 0x5000 11 --data '01 02 03 04 05' --json\n"
      "  canvoy emcy can0 10 0");
  on_chosen(command, sessions, options, send_emergency);
}

}  // namespace canvoy::tools
