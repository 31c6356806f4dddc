#include "canvoy/text/check/bench/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::uint8_t abort_command = 0x80;
constexpr std::size_t expedited_max = 4;
constexpr std::size_t segment_max = 7;

/// Start of a transfer, eight bytes: command, index and sub-index.
std::array<std::uint8_t, 8> initiate(unsigned command, std::uint16_t index, std::uint8_t sub) {
  return {static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(index),
          static_cast<std::uint8_t>(index >> 8), sub};
}

Reply aborted_by(const Frame& answer) {
  return {Reply::Kind::aborted, AbortCode{load<std::uint32_t>(&answer.data[4])}, {}};
}

bool is_about(const Frame& answer, std::span<const std::uint8_t> request) {
  return std::equal(request.begin() + 1, request.begin() + 4, answer.data.begin() + 1);
}

}  // namespace

std::uint64_t Reply::number() const {
  return load_unsigned(std::span(value).first(std::min<std::size_t>(value.size(), 8)));
}

std::string Reply::text() const {
  switch (kind) {
    case Kind::done:
      return value.empty() ? "done" : text::bytes_text(value);
    case Kind::aborted:
      return fmt::format("abort {}", text::abort_text(abort));
    case Kind::silent:
      return "no answer";
    case Kind::malformed:
      break;
  }
  return "an answer that is none to this request";
}

Bench::Bench(Line line, NodeId node, BenchOptions options)
    : line_(std::move(line)), node_(node), options_(std::move(options)) {}

void Bench::note(const Heard& heard) {
  if (is_held_) return;
  frames_.push_back(heard);
  if (frames_.size() > frames_max) frames_.pop_front();
}

Time Bench::next_of_players(Time until) const {
  for (const Player* player : players_) {
    if (player->due) until = std::min(until, player->due());
  }
  return until;
}

/// True if any participant has acted.
bool Bench::let_players_act() {
  bool has_acted = false;
  for (const Player* player : players_) {
    if (is_broken_ || !player->due || player->due() > now()) continue;
    player->act(now());
    has_acted = true;
  }
  return has_acted;
}

std::optional<Heard> Bench::take(Time until) {
  while (!is_broken_) {
    std::optional<Heard> heard = line_.next(next_of_players(until));
    is_broken_ = is_broken_ || (!goes_on_ && is_interrupted());
    if (heard) {
      note(*heard);
      for (const Player* player : players_) {
        if (player->hears) player->hears(*heard);
      }
      return heard;
    }
    if (!let_players_act() && now() >= until) break;
  }
  return std::nullopt;
}

void Bench::drain() {
  const Time until = now();
  while (take(until)) {
  }
}

void Bench::send(const Frame& frame) {
  if (is_broken_) return;
  note({now(), frame});
  is_refused_ = !line_.send(frame);
  is_broken_ = is_refused_ || (!goes_on_ && is_interrupted());
}

void Bench::go_on() {
  const bool was_cut = is_cut();
  goes_on_ = true;
  is_broken_ = is_refused_;
  if (!was_cut) return;
  // Ends a transfer in progress: 0800 0000h, general error.
  send(Frame::data_frame(can_id::sdo_request + node_, {0x80, 0, 0, 0, 0, 0, 0, 0x08}));
  drain();
}

void Bench::command_node(NmtCommand command, NodeId node) {
  send(Frame::data_frame(can_id::nmt, {static_cast<std::uint8_t>(command), node}));
}

std::vector<Heard> Bench::listen(Duration duration) {
  std::vector<Heard> all;
  const Time until = now() + duration;
  while (const auto heard = take(until)) {
    if (heard->time <= until) all.push_back(*heard);
  }
  return all;
}

std::optional<Heard> Bench::await(std::uint32_t id, Duration duration) {
  const Time until = now() + duration;
  while (const auto heard = take(until)) {
    if (heard->frame.id == id && !heard->frame.is_error() && !heard->frame.is_extended()) {
      return heard;
    }
  }
  return std::nullopt;
}

std::optional<Frame> Bench::ask(std::span<const std::uint8_t> request) {
  drain();
  std::array<std::uint8_t, 8> bytes{};
  std::copy_n(request.begin(), std::min(request.size(), bytes.size()), bytes.begin());
  send(Frame::data_frame(can_id::sdo_request + node_, bytes));
  const auto answer = await(can_id::sdo_response + node_, options_.time_out);
  if (!answer) return std::nullopt;
  return answer->frame;
}

Reply Bench::read(std::uint16_t index, std::uint8_t sub) {
  const auto request = initiate(0x40, index, sub);
  const auto answer = ask(request);
  if (!answer) return {Reply::Kind::silent, {}, {}};
  const unsigned command = answer->data[0];
  if (answer->length != 8 || !is_about(*answer, request)) return {Reply::Kind::malformed, {}, {}};
  if (command == abort_command) return aborted_by(*answer);
  if ((command & 0xE0) != 0x40) return {Reply::Kind::malformed, {}, {}};
  const bool has_size = (command & 1) != 0;
  if ((command & 2) == 0) return read_segments(load<std::uint32_t>(&answer->data[4]), has_size);
  const std::size_t unused = has_size ? command >> 2 & 3 : 0;
  return {Reply::Kind::done, {}, Bytes(answer->data.begin() + 4, answer->data.end() - unused)};
}

Reply Bench::read_segments(std::uint32_t announced, bool has_size) {
  Reply reply;
  for (unsigned toggle = 0;; toggle ^= 0x10) {
    const std::uint8_t request[] = {static_cast<std::uint8_t>(0x60 | toggle)};
    const auto answer = ask(request);
    if (!answer) return {Reply::Kind::silent, {}, {}};
    const unsigned command = answer->data[0];
    if (command == abort_command) return aborted_by(*answer);
    if (answer->length != 8 || (command & 0xF0) != toggle) return {Reply::Kind::malformed, {}, {}};
    const std::size_t unused = command >> 1 & 7;
    reply.value.insert(reply.value.end(), answer->data.begin() + 1, answer->data.end() - unused);
    if ((command & 1) != 0) break;
    if (reply.value.size() > value_max) return {Reply::Kind::malformed, {}, {}};
  }
  if (has_size && announced != reply.value.size()) reply.kind = Reply::Kind::malformed;
  return reply;
}

Reply Bench::write(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value) {
  const bool is_short = !value.empty() && value.size() <= expedited_max;
  auto request =
      initiate(is_short ? 0x23U | static_cast<unsigned>(expedited_max - value.size()) << 2 : 0x21U,
               index, sub);
  if (is_short) {
    std::ranges::copy(value, request.begin() + 4);
  } else {
    store(&request[4], static_cast<std::uint32_t>(value.size()));
  }
  const auto answer = ask(request);
  if (!answer) return {Reply::Kind::silent, {}, {}};
  if (answer->length != 8 || !is_about(*answer, request)) return {Reply::Kind::malformed, {}, {}};
  if (answer->data[0] == abort_command) return aborted_by(*answer);
  if (answer->data[0] != 0x60) return {Reply::Kind::malformed, {}, {}};
  return is_short ? Reply{} : write_segments(value);
}

Reply Bench::write_segments(std::span<const std::uint8_t> value) {
  unsigned toggle = 0;
  do {
    const std::size_t count = std::min(value.size(), segment_max);
    const bool is_last = count == value.size();
    std::array<std::uint8_t, 8> segment{
        static_cast<std::uint8_t>(toggle | (segment_max - count) << 1 | (is_last ? 1U : 0U))};
    std::copy_n(value.begin(), count, segment.begin() + 1);
    value = value.subspan(count);
    const auto answer = ask(segment);
    if (!answer) return {Reply::Kind::silent, {}, {}};
    if (answer->data[0] == abort_command) return aborted_by(*answer);
    if (answer->data[0] != (0x20 | toggle)) return {Reply::Kind::malformed, {}, {}};
    toggle ^= 0x10;
    if (is_last) break;
  } while (!is_broken_);
  return {};
}

Reply Bench::write(std::uint16_t index, std::uint8_t sub, std::uint64_t number, std::size_t bytes) {
  std::uint8_t value[8];
  store(value, number);
  return write(index, sub, std::span(value).first(bytes));
}

Reply Bench::set(std::uint16_t index, std::uint8_t sub, std::uint64_t number, std::size_t bytes) {
  Reply before = read(index, sub);
  if (!before) return before;
  Reply done = write(index, sub, number, bytes);
  if (done) changed_.push_back({index, sub, before.value});
  return done;
}

void Bench::keep(std::uint16_t index, std::uint8_t sub) {
  const Reply before = read(index, sub);
  if (before) changed_.push_back({index, sub, before.value, true});
}

bool Bench::has_services_by_sdo() {
  constexpr Duration answer_max = 300ms;
  drain();
  send(
      Frame::data_frame(can_id::sdo_request + node_, initiate(0x40, object_index::device_type, 0)));
  return await(can_id::sdo_response + node_, answer_max).has_value();
}

void Bench::restore() {
  for (; !changed_.empty(); changed_.pop_back()) {
    const Changed& last = changed_.back();
    const bool is_done = !is_broken_ && write(last.index, last.sub, last.before);
    if (is_cut()) return;
    if (!is_done && !last.may_be_refused)
      unrestored_.push_back(text::object_text(last.index, last.sub));
  }
}

std::optional<std::uint32_t> Bench::number(std::uint16_t index, std::uint8_t sub) {
  const Reply reply = read(index, sub);
  if (!reply || reply.value.empty() || reply.value.size() > 4) return std::nullopt;
  return static_cast<std::uint32_t>(reply.number());
}

bool Bench::has(std::uint16_t index, std::uint8_t sub) {
  const std::uint32_t place = std::uint32_t{index} << 8 | sub;
  const auto known = known_.find(place);
  if (known != known_.end()) return known->second;
  const Reply reply = read(index, sub);
  const bool is_there = reply || (reply.kind == Reply::Kind::aborted && !reply.is_absent());
  known_[place] = is_there;
  return is_there;
}

std::optional<NmtState> Bench::state() {
  const std::uint32_t id = can_id::error_control + node_;
  constexpr Duration heartbeat_max = 120ms;
  drain();
  const auto of = [](const std::optional<Heard>& heard) -> std::optional<NmtState> {
    if (!heard || heard->frame.is_remote() || heard->frame.length != 1) return std::nullopt;
    return static_cast<NmtState>(heard->frame.data[0] & 0x7F);
  };
  if (const auto beat = of(await(id, heartbeat_max))) return beat;
  send(Frame::remote_frame(id, 1));
  return of(await(id, heartbeat_max));
}

bool Bench::watch_state() {
  constexpr std::uint16_t often_ms = 50;
  if (set(object_index::heartbeat_producer, 0, often_ms, 2)) return true;
  return state().has_value();
}

}  // namespace canvoy::conformance
