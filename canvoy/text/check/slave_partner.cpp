#include "canvoy/text/check/slave_partner.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::uint32_t place_of(std::uint16_t index, std::uint8_t sub) {
  return std::uint32_t{index} << 8 | sub;
}

constexpr Duration look_period = 20ms;

// SDO, the first byte (CiA 301, 7.2.4.3).
constexpr unsigned download = 1;  ///< client command in its upper three bits
constexpr unsigned upload = 2;
constexpr unsigned is_expedited = 0x02;
constexpr unsigned has_size = 0x01;
constexpr std::uint8_t upload_answer = 0x43;
constexpr std::uint8_t download_answer = 0x60;
constexpr std::uint8_t abort_answer = 0x80;

}  // namespace

SlavePartner::SlavePartner(Bench& bench)
    : bench_(bench),
      node_(played_node(bench)),
      player_{.hears = [this](const Heard& heard) { hear(heard.frame); }},
      values_{{place_of(object_index::device_type, 0), device_type},
              {place_of(object_index::identity, 1), vendor},
              {place_of(object_index::identity, 2), 1},
              {place_of(object_index::identity, 3), 1},
              {place_of(object_index::identity, 4), 1}} {
  bench_.join(player_);
}

SlavePartner::~SlavePartner() {
  bench_.leave(player_);
}

void SlavePartner::boot_up() {
  bench_.send(Frame::data_frame(can_id::error_control + node_, {0}));
}

bool SlavePartner::wait_for(NmtCommand command, Duration time) {
  const Time until = bench_.now() + time;
  for (;;) {
    if (std::ranges::find(commands_, command) != commands_.end()) return true;
    if (bench_.is_broken() || bench_.now() >= until) return false;
    bench_.listen(std::min<Duration>(look_period, until - bench_.now()));
  }
}

void SlavePartner::hear(const Frame& frame) {
  if (!frame.is_plain()) return;
  const bool is_command = frame.id == can_id::nmt && frame.length == 2 &&
                          (frame.data[1] == node_ || frame.data[1] == 0);
  if (is_command) commands_.push_back(static_cast<NmtCommand>(frame.data[0]));
  if (frame.id == can_id::sdo_request + std::uint32_t{node_} && frame.length == 8) answer(frame);
}

void SlavePartner::reply(std::uint8_t command, const Frame& request, std::uint32_t value) {
  Frame frame = Frame::data_frame(can_id::sdo_response + node_,
                                  {command, request.data[1], request.data[2], request.data[3]});
  frame.length = 8;
  store(&frame.data[4], value);
  bench_.send(frame);
}

void SlavePartner::answer(const Frame& request) {
  const unsigned command = request.data[0] >> 5;
  const auto index = load<std::uint16_t>(&request.data[1]);
  const std::uint8_t sub = request.data[3];
  const auto refuse = [&](AbortCode code) {
    reply(abort_answer, request, static_cast<std::uint32_t>(code));
  };
  if (command == upload) {
    was_identified_ = was_identified_ || index == object_index::device_type;
    const auto found = values_.find(place_of(index, sub));
    if (found == values_.end()) return refuse(AbortCode::no_object);
    return reply(upload_answer, request, found->second);
  }
  if (command != download || (request.data[0] & is_expedited) == 0) {
    return refuse(AbortCode::command_specifier);
  }
  const unsigned unused = (request.data[0] & has_size) != 0 ? request.data[0] >> 2 & 3U : 0U;
  const auto* const first = &request.data[4];
  written_.push_back({index, sub, Bytes(first, first + (4 - unused))});
  reply(download_answer, request, 0);
}

}  // namespace canvoy::conformance
