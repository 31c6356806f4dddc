#include "canvoy/text/check/behaviour/stage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/data_type.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::size_t heard_max = 4096;
constexpr Duration poll_period = 20ms;
/// First index of a profile.
constexpr std::uint16_t first_of_profile = 0x6000;
/// Settling time after an NMT command.
constexpr Duration state_settles = 20ms;
/// First CAN-ID of the test for PDOs of behaviour cases.
constexpr std::uint32_t first_own_id = 0x6B3;
constexpr std::uint32_t last_own_id = 0x6BA;

std::string place_text(const Place& place) {
  return text::object_text(place.index(), place.sub);
}

bool is_as_wanted(const Step& step, std::uint64_t raw, unsigned bits) {
  return ((raw ^ static_cast<std::uint64_t>(step.number)) & step.mask & low_bits(bits)) == 0;
}

std::int64_t with_sign(const Place& place, std::uint64_t raw, unsigned bits) {
  const EntryInfo* const entry = place.entry();
  return number_of(raw, bits, entry != nullptr && is_signed(entry->type));
}

Verdict otherwise(const Step& step, const std::string& came) {
  return failed(fmt::format("{}: {}", step_text(step), came));
}

/// A missing or unreadable entry gives no verdict on the behaviour.
std::optional<Verdict> cannot_see(const Step& step, const Reply& reply) {
  if (reply.is_absent()) return cannot_set(place_text(step.place), reply);
  if (!reply.has_aborted(AbortCode::write_only)) return std::nullopt;
  return not_applicable(fmt::format("{} is not read: {}", place_text(step.place), reply.text()));
}

/// A refusal because of the present state gives no verdict on the behaviour.
bool says_not_here(const Reply& reply) {
  return reply.is_absent() || reply.has_aborted(AbortCode::read_only) ||
         reply.has_aborted(AbortCode::unsupported_access);
}

std::optional<PdoWay> way_of(const Step& step) {
  if (step.act == Act::feed) return PdoWay::receive;
  if (step.act == Act::tells || step.act == Act::is_silent) return PdoWay::transmit;
  return std::nullopt;
}

}  // namespace

Stage::Stage(Bench& bench)
    : bench_(bench), player_{.hears = [this](const Heard& heard) {
        if (heard_.size() < heard_max) heard_.push_back(heard);
      }} {
  bench_.join(player_);
}

Stage::~Stage() {
  bench_.leave(player_);
}

const Carrier* Stage::carrier_of(const Place& place, PdoWay way) const {
  for (std::size_t i = 0; i < carriers_.size(); ++i) {
    const bool is_same = carried_[i].index() == place.index() && carried_[i].sub == place.sub;
    if (is_same && carriers_[i].pdo.way == way) return &carriers_[i];
  }
  return nullptr;
}

std::optional<Verdict> Stage::prepare(const BehaviourRow& row) {
  for (const Step& step : row.steps) {
    if (step.act == Act::alarm || step.act == Act::no_alarm) emergencies_ = emergency_id(bench_);
    const auto way = way_of(step);
    if (!way || carrier_of(step.place, *way) != nullptr) continue;
    auto carrier = find_carrier(bench_, *way, step.place);
    if (!carrier) {
      return not_applicable(fmt::format(
          "no {} carries {}", *way == PdoWay::receive ? "RPDO" : "TPDO", place_text(step.place)));
    }
    // Another entry of the same PDO has prepared it.
    const auto same = std::ranges::find_if(carriers_, [&](const Carrier& each) {
      return each.pdo.parameter == carrier->pdo.parameter;
    });
    if (same != carriers_.end()) {
      carrier->pdo.can_id = same->pdo.can_id;
    } else {
      const auto own_id = static_cast<std::uint32_t>(first_own_id + carriers_.size());
      if (own_id > last_own_id) return not_applicable("more PDOs than the test has CAN-IDs for");
      if (auto cannot = make_ready(bench_, *carrier, own_id)) return cannot;
    }
    carriers_.push_back(*carrier);
    carried_.push_back(step.place);
  }
  return std::nullopt;
}

std::size_t Stage::length_of(const Place& place) {
  const EntryInfo* const entry = place.entry();
  return entry == nullptr ? 1 : std::max(1U, byte_length(entry->type));
}

/// Unreadable entries are written as well, though they cannot be restored.
Reply Stage::download(const Step& step) {
  const auto raw = static_cast<std::uint64_t>(step.number);
  const std::size_t bytes = length_of(step.place);
  Reply done = bench_.set(step.place.index(), step.place.sub, raw, bytes);
  if (!done.has_aborted(AbortCode::write_only)) return done;
  return bench_.write(step.place.index(), step.place.sub, raw, bytes);
}

std::optional<Verdict> Stage::put(const Step& step) {
  const Reply done = download(step);
  if (done) return std::nullopt;
  if (says_not_here(done)) return cannot_set(place_text(step.place), done);
  return otherwise(step, done.text());
}

std::optional<Verdict> Stage::refuse(const Step& step) {
  const std::uint16_t at = step.place.index();
  const Reply before = bench_.read(at, step.place.sub);
  const Reply done = download(step);
  if (done.is_absent()) return cannot_set(place_text(step.place), done);
  if (done.kind != Reply::Kind::aborted) return otherwise(step, done.text());
  if (!before) return std::nullopt;
  const Reply after = bench_.read(at, step.place.sub);
  if (after.value == before.value) return std::nullopt;
  return otherwise(step, fmt::format("it is aborted, and the value is {} in place of {}",
                                     after.text(), before.text()));
}

std::optional<Verdict> Stage::put_text(const Step& step, bool is_to_be_taken) {
  const std::uint16_t at = step.place.index();
  bench_.keep(at, step.place.sub);
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(step.words.data());
  const Reply done = bench_.write(at, step.place.sub, {bytes, step.words.size()});
  const bool is_not_here = is_to_be_taken ? says_not_here(done) : done.is_absent();
  if (is_not_here) return cannot_set(place_text(step.place), done);
  if (is_to_be_taken ? !done : done.kind != Reply::Kind::aborted) {
    return otherwise(step, done.text());
  }
  return std::nullopt;
}

std::optional<Verdict> Stage::wait_for_text(const Step& step) {
  const Time until = bench_.now() + step.time;
  for (;;) {
    const Reply came = bench_.read(step.place.index(), step.place.sub);
    if (came.is_absent()) return cannot_set(place_text(step.place), came);
    if (came && std::ranges::equal(came.value, step.words, {}, {},
                                   [](char each) { return static_cast<std::uint8_t>(each); })) {
      return std::nullopt;
    }
    if (bench_.is_broken() || bench_.now() >= until) return otherwise(step, came.text());
    bench_.listen(poll_period);
  }
}

std::optional<Verdict> Stage::feed(const Step& step) {
  const Carrier& carrier = *carrier_of(step.place, PdoWay::receive);
  std::array<std::uint8_t, 8> bytes{};
  unsigned bit = 0;
  bool is_served = bench_.has_services_by_sdo();
  for (const std::uint32_t mapped : carrier.pdo.mapped) {
    const unsigned bits = mapped & 0xFF;
    const Carrier other{.pdo = carrier.pdo, .first_bit = bit, .bits = bits};
    const auto index = static_cast<std::uint16_t>(mapped >> 16);
    const Reply value = is_served ? bench_.read(index, static_cast<std::uint8_t>(mapped >> 8))
                                  : Reply{.kind = Reply::Kind::silent};
    is_served = value.kind != Reply::Kind::silent;
    if (value && bits <= 64) other.put_into(bytes, value.number());
    bit += bits;
  }
  if (is_served) bench_.keep(step.place.index(), step.place.sub);
  carrier.put_into(bytes, static_cast<std::uint64_t>(step.number));
  const std::size_t length = (carrier.pdo.bits() + 7) / 8;
  heard_.clear();
  bench_.send(Frame::data_frame(carrier.pdo.can_id, std::span(bytes).first(length)));
  bench_.listen(1ms);
  return std::nullopt;
}

/// Uses the monitored node, if there is one: some devices require a certain node.
std::optional<Verdict> Stage::lose() {
  constexpr std::uint16_t at = object_index::heartbeat_consumers;
  const std::uint32_t watched = bench_.has(at) ? bench_.number(at, 1).value_or(0) : 0;
  const std::uint32_t node = watched >> 16 & 0xFF;
  const Duration time = std::chrono::milliseconds(watched & 0xFFFF);
  if (node == 0 || node > node_id_max || time == Duration{}) return lose_heartbeat(bench_).cannot;
  bench_.send(Frame::data_frame(can_id::error_control + node,
                                {static_cast<std::uint8_t>(NmtState::operational)}));
  bench_.listen(time);
  return std::nullopt;
}

std::optional<Verdict> Stage::ask_hand(const Step& step) {
  const auto& hand = bench_.options().hand;
  const bool is_question = step.act == Act::see;
  const HandAnswer answer = hand({step.words, is_question});
  if (answer == HandAnswer::done) return std::nullopt;
  if (answer == HandAnswer::no && is_question) return otherwise(step, "it is not so");
  return not_applicable(
      fmt::format("nobody could {}: {}", is_question ? "see" : "do it", step.words));
}

std::optional<Verdict> Stage::wait_until_it_is(const Step& step) {
  const Time until = bench_.now() + step.time;
  for (;;) {
    const Reply came = bench_.read(step.place.index(), step.place.sub);
    if (auto cannot = cannot_see(step, came)) return cannot;
    const auto bits = static_cast<unsigned>(came.value.size() * 8);
    if (came && is_as_wanted(step, came.number(), bits)) return std::nullopt;
    if (bench_.is_broken() || bench_.now() >= until) {
      if (!came) return otherwise(step, came.text());
      const std::string is = number_text(step.place, with_sign(step.place, came.number(), bits));
      return otherwise(step, fmt::format("it is {}", is));
    }
    bench_.listen(std::min<Duration>(poll_period, until - bench_.now()));
  }
}

std::optional<Verdict> Stage::watch_whether_it_stays(const Step& step) {
  const Time until = bench_.now() + step.time;
  Step at_once = step;
  at_once.time = Duration{};
  for (;;) {
    if (auto other = wait_until_it_is(at_once)) return other;
    if (bench_.is_broken() || bench_.now() >= until) return std::nullopt;
    bench_.listen(std::min<Duration>(poll_period, until - bench_.now()));
  }
}

/// Checks the received frames, and those that come in time, until `is_it` is true.
template <class Check>
bool Stage::hears(Duration time, Check is_it) {
  const Time until = bench_.now() + time;
  for (std::size_t next = 0;;) {
    for (; next < heard_.size(); ++next) {
      const Frame& frame = heard_[next].frame;
      if (frame.is_plain() && is_it(frame)) return true;
    }
    if (bench_.is_broken() || bench_.now() >= until) return false;
    bench_.listen(std::min<Duration>(poll_period, until - bench_.now()));
  }
}

std::optional<Verdict> Stage::wait_for_pdo(const Step& step) {
  const Carrier& carrier = *carrier_of(step.place, PdoWay::transmit);
  std::optional<std::uint64_t> last;
  const bool came = hears(step.time, [&](const Frame& frame) {
    if (frame.id != carrier.pdo.can_id) return false;
    last = carrier.value_in(frame);
    return last && is_as_wanted(step, *last, carrier.bits);
  });
  if (came) return std::nullopt;
  if (!last) return otherwise(step, "none comes");
  return otherwise(
      step, fmt::format("the last one has {}",
                        number_text(step.place, with_sign(step.place, *last, carrier.bits))));
}

std::optional<Verdict> Stage::wait_for_none(const Step& step) {
  const std::uint32_t id = carrier_of(step.place, PdoWay::transmit)->pdo.can_id;
  bench_.listen(step.time);
  const auto came = std::ranges::count_if(
      heard_, [id](const Heard& each) { return each.frame.id == id && each.frame.is_plain(); });
  if (came == 0) return std::nullopt;
  return otherwise(step, fmt::format("{} come", came));
}

bool Stage::is_emergency(const Frame& frame) const {
  return frame.id == emergencies_ && frame.is_plain() && frame.length == 8;
}

std::optional<Verdict> Stage::wait_for_alarm(const Step& step) {
  std::string last = "none comes";
  const bool came = hears(step.time, [&](const Frame& frame) {
    if (!is_emergency(frame)) return false;
    last = fmt::format("EMCY {:04X}h", error_code(frame));
    return is_as_wanted(step, error_code(frame), 16);
  });
  return came ? std::nullopt : std::optional(otherwise(step, last));
}

std::optional<Verdict> Stage::wait_for_no_alarm(const Step& step) {
  bench_.listen(step.time);
  const bool came = std::ranges::any_of(heard_, [&](const Heard& each) {
    return is_emergency(each.frame) && is_as_wanted(step, error_code(each.frame), 16);
  });
  return came ? std::optional(otherwise(step, "one comes")) : std::nullopt;
}

std::optional<Verdict> Stage::act(const Step& step) {
  if (step.act == Act::put || step.act == Act::put_text || step.act == Act::enter ||
      step.act == Act::hand || step.act == Act::lose) {
    heard_.clear();
  }
  switch (step.act) {
    case Act::none:
      return std::nullopt;
    case Act::enter:
      bench_.command(static_cast<NmtCommand>(step.number));
      bench_.listen(state_settles);
      return std::nullopt;
    case Act::put:
      return put(step);
    case Act::feed:
      return feed(step);
    case Act::lose:
      return lose();
    case Act::hand:
    case Act::see:
      return ask_hand(step);
    case Act::wait:
      bench_.listen(step.time);
      return std::nullopt;
    case Act::refuse:
      return refuse(step);
    case Act::put_text:
      return put_text(step, true);
    case Act::refuse_text:
      return put_text(step, false);
    case Act::is_text:
      return wait_for_text(step);
    case Act::is:
      return wait_until_it_is(step);
    case Act::stays:
      return watch_whether_it_stays(step);
    case Act::tells:
      return wait_for_pdo(step);
    case Act::is_silent:
      return wait_for_none(step);
    case Act::alarm:
      return wait_for_alarm(step);
    case Act::no_alarm:
      return wait_for_no_alarm(step);
  }
  return std::nullopt;
}

namespace {

bool has(Bench& bench, const Place& place) {
  return place.object == nullptr || bench.has(place.index(), place.sub);
}
template <class Row, class Visit>
void for_each_place(Row& row, Visit visit) {
  for (auto& step : row.steps) visit(step.place);
  for (auto& place : row.needs) visit(place);
}
bool has_all(Bench& bench, const BehaviourRow& row) {
  bool is_there = true;
  for_each_place(row, [&](const Place& place) { is_there = is_there && has(bench, place); });
  return is_there;
}

/// The row with the objects of the device in the n-th block of a profile with several blocks (lift
/// n of CiA 417), counted from 0. Nothing if the device has none of them there.
std::optional<BehaviourRow> in_block(Bench& bench, const BehaviourRow& row, unsigned block) {
  const unsigned distance = block * bench.options().profile->block_pitch;
  BehaviourRow moved = row;
  bool is_moved = false;
  for_each_place(moved, [&](Place& place) {
    if (place.object == nullptr || place.index() < first_of_profile) return;
    const auto index = static_cast<std::uint16_t>(place.index() + distance);
    if (!bench.has(index, place.sub)) return;
    place.above = static_cast<std::uint16_t>(place.above + distance);
    is_moved = true;
  });
  if (!is_moved || !has_all(bench, moved)) return std::nullopt;
  return moved;
}

/// The row, or the row moved to the first block in which the device has all that it needs.
BehaviourRow in_block_of_device(Bench& bench, const BehaviourRow& row) {
  const Profile* const profile = bench.options().profile;
  if (profile == nullptr || has_all(bench, row)) return row;
  for (unsigned block = 1; block < profile->block_count; ++block) {
    if (auto moved = in_block(bench, row, block)) return *moved;
  }
  return row;
}

}  // namespace

Verdict play(Bench& bench, const BehaviourRow& described) {
  const BehaviourRow row = in_block_of_device(bench, described);
  for (const Place& place : row.needs) {
    if (has(bench, place)) continue;
    return not_applicable(fmt::format("the device has no {}", place_text(place)));
  }
  const bool needs_hand = std::ranges::any_of(
      row.steps, [](const Step& step) { return step.act == Act::hand || step.act == Act::see; });
  if (needs_hand && !bench.options().hand) {
    return not_applicable("it needs somebody at the device: --hands");
  }
  for (const Step& step : row.steps) {
    if (has(bench, step.place)) continue;
    return not_applicable(fmt::format("the device has no {}", place_text(step.place)));
  }
  if (moves(row) && !bench.options().moves) {
    return not_applicable("objects are written with --moves only");
  }
  Stage stage(bench);
  if (auto cannot = stage.prepare(row)) return *cannot;
  for (const Step& step : row.steps) {
    if (auto other = stage.act(step)) return *other;
    if (bench.is_broken()) break;
  }
  return passed();
}

}  // namespace canvoy::conformance
