#include "canvoy/text/frame_decoder.hpp"

#include <fmt/format.h>

#include "canvoy/canopen/manager/dynamic_sdo.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/text/car_text.hpp"
#include "canvoy/text/error_frame_text.hpp"
#include "canvoy/text/lss_text.hpp"
#include "canvoy/text/message_text.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/service_words.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"

namespace canvoy::text {

PdoWords::Words PdoWords::words(std::uint32_t can_id, const decoder::Decoded& decoded,
                                std::uint32_t generation) {
  Pdo& pdo = pdos_.at(can_id);
  const bool is_new = pdo.generation != generation;
  if (decoded.is_same && !is_new) return {pdo.service, pdo.text, &pdo.kept};
  if (is_new) {
    name(pdo, *decoded.pdo);
    pdo.generation = generation;
  }
  const bool has_changed = take_values(pdo, decoded.values);
  if (!is_new && !has_changed && pdo.count == decoded.values.size()) {
    return {pdo.service, pdo.text, &pdo.kept};
  }
  pdo.count = decoded.values.size();
  pdo.text = pdo.start;
  pdo.kept.clear();
  for (std::size_t i = 0; i < pdo.count; ++i) {
    if (i != 0) pdo.text += "; ";
    pdo.text += pdo.values[i].name;
    pdo.text += pdo.values[i].text;
  }
  return {pdo.service, pdo.text, &pdo.kept};
}

void PdoWords::name(Pdo& pdo, const decoder::PdoPlan& plan) {
  pdo.service = pdo_service(plan);
  pdo.start = plan.name.empty() ? "" : std::string(plan.name) + ": ";
  pdo.values.clear();
}

/// True if one of them has changed.
bool PdoWords::take_values(Pdo& pdo, std::span<const decoder::DecodedValue> values) {
  bool has_changed = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i == pdo.values.size()) pdo.values.push_back({0, object_name_text(values[i]) + " = ", {}});
    Value& known = pdo.values[i];
    // A multiplexed PDO has another object each time.
    const bool is_other = values[i].version == 0;
    if (is_other) known.name = object_name_text(values[i]) + " = ";
    if (known.version == values[i].version && !is_other) continue;
    known.version = values[i].version;
    known.text.clear();
    values_->append(known.text, values[i]);
    has_changed = true;
  }
  return has_changed;
}

namespace {

using decoder::Mark;

std::string_view reason_text(decoder::KnownBy by) {
  switch (by) {
    case decoder::KnownBy::product:
      return ", as others of its vendor-ID and product code";
    case decoder::KnownBy::sheet:
      return ", by the data sheet of its vendor-ID and product code";
    default:
      return "";
  }
}

}  // namespace

const FrameWords& FrameDecoder::decode(const Frame& frame) {
  words_ = {};
  transfer_ = nullptr;
  if (frame.is_error()) {
    words_.service = "error frame";
    say(error_frame_text(frame));
  } else if (frame.is_extended()) {
    words_.service = "29-bit frame";
  } else {
    const Decoded& decoded = objects_.decode(frame);
    words_.marks = decoded.marks;
    if (decoded.pdo != nullptr) {
      decode_pdo(frame, decoded);
    } else if (decoded.service != Decoded::Service::other) {
      decode_sdo(frame, decoded);
    } else {
      decode_other(frame, decoded);
    }
    if (decoded.news != nullptr) add_news(*decoded.news);
  }
  return words_;
}

void FrameDecoder::say(std::string text) {
  text_ = std::move(text);
  words_.text = text_;
}

void FrameDecoder::say_malformed(const Frame& frame) {
  words_.marks.add(Mark::wrong_length);
  say(malformed_text(frame));
}

// PDO

void FrameDecoder::decode_pdo(const Frame& frame, const Decoded& decoded) {
  const PdoWords::Words said = pdos_.words(frame.id, decoded, network().generation());
  words_.service = said.service;
  words_.text = said.text;
  words_.kept = said.kept;
  words_.node = decoded.pdo->node;
  words_.values = decoded.values;
}

// SDO

void FrameDecoder::decode_sdo(const Frame& frame, const Decoded& decoded) {
  const bool asks = decoded.service == Decoded::Service::sdo_request;
  words_.service = asks ? "SDO request" : "SDO response";
  words_.is_answer = !asks;
  words_.node = decoded.node;
  words_.client = decoded.client;
  words_.values = decoded.values;
  words_.about = decoded.about;
  if (frame.length != Frame::length_max) return say_malformed(frame);
  text_.clear();
  said_->sdos.append(text_, decoded.message, frame, network(), decoded.node, decoded.behind);
  words_.is_middle = decoded.transfer == nullptr && decoded.message != decoder::SdoMessage::abort;
  if (decoded.transfer != nullptr) say_transfer(*decoded.transfer);
  words_.text = text_;
}

/// An expedited message shows its value itself; the last message of other transfers shows the value
/// of the whole.
void FrameDecoder::say_transfer(const decoder::SdoTransfer& transfer) {
  words_.is_end = true;
  transfer_ = &transfer;
  const bool shows_itself = transfer.kind == decoder::SdoTransfer::Kind::expedited;
  if (shows_itself) return;
  text_ += ": ";
  said_->sdos.append_transfer(text_, transfer, words_.values.front());
}

std::string_view FrameDecoder::transfer_text() {
  transfer_text_.clear();
  if (transfer_ != nullptr)
    said_->sdos.append_transfer(transfer_text_, *transfer_, words_.values.front());
  return transfer_text_;
}

// Other services

void FrameDecoder::decode_other(const Frame& frame, const Decoded& decoded) {
  if (network().has_car() && decode_of_car(frame)) return;
  words_ = service_of(frame.id);
  words_.marks = services_.take(frame);
  if (frame.id > can_id::error_control && words_.node != 0) return decode_error_control(frame);
  if (frame.is_remote()) return say("remote request");
  if (frame.id == can_id::nmt) return decode_nmt(frame);
  if (frame.id == can_id::sync) return decode_sync(frame);
  if (frame.id == can_id::time) return decode_time(frame);
  if (frame.id == can_id::dynamic_sdo_request) return say("dynamic SDO request");
  if (frame.id == can_id::lss_request || frame.id == can_id::lss_response) {
    return decode_lss(frame, decoded);
  }
  if (is_flying_master(frame.id)) return say(flying_master_text(frame));
  if (words_.node != 0 && frame.id < can_id::time) return decode_emergency(frame);
  words_.is_unknown_pdo = frame.id >= can_id::tpdo1 && frame.id < can_id::sdo_response;
  say(bytes_text(frame.payload()));
}

/// Messages that only a network of CiA 447 has; false: another message.
bool FrameDecoder::decode_of_car(const Frame& frame) {
  const bool is_sleep = is_sleep_message(frame.id);
  const NodeId asked = iso_tp_node(frame.id);
  if (frame.is_remote() || (!is_sleep && asked == 0)) return false;
  if (asked != 0) {
    words_.service = "ISO-TP";
    words_.node = asked;
    say(iso_tp_text(frame));
    return true;
  }
  words_.service = "sleep";
  words_.node = sleeping_node(frame.id);
  if (frame.length != Frame::length_max) {
    say_malformed(frame);
    return true;
  }
  constexpr unsigned command_bits = 16;
  if (load<std::uint64_t>(frame.data.data()) >> command_bits != 0) words_.marks.add(Mark::reserved);
  say(sleep_text(frame));
  return true;
}

void FrameDecoder::decode_nmt(const Frame& frame) {
  constexpr std::uint8_t length = 2;
  if (frame.length != length) return say_malformed(frame);
  say(nmt_text(frame));
}

void FrameDecoder::decode_sync(const Frame& frame) {
  if (frame.length == 0) return;
  if (frame.length != 1) return say_malformed(frame);
  say(fmt::format("counter {}", frame.data[0]));
}

void FrameDecoder::decode_time(const Frame& frame) {
  const auto time =
      canvoy::decode_time<TimeOfDay>(std::span(frame.data).first<time_of_day_bytes>());
  if (frame.length != time_of_day_bytes) return say_malformed(frame);
  say(time.valid() ? time_text(time) : malformed_text(frame));
}

void FrameDecoder::decode_emergency(const Frame& frame) {
  if (frame.length != Frame::length_max) return say_malformed(frame);
  say(emergency_message_text(frame, network().profile(words_.node)));
}

void FrameDecoder::decode_lss(const Frame& frame, const Decoded& decoded) {
  if (frame.length != Frame::length_max) return say_malformed(frame);
  if (frame.id == can_id::lss_request) return say(lss_master_text(frame));
  say(lss_slave_text(frame));
  if (decoded.device == nullptr) return;
  const std::string device = lss_device_text(*decoded.device);
  if (!device.empty()) say(fmt::format("{}: {}", words_.text, device));
}

void FrameDecoder::decode_error_control(const Frame& frame) {
  if (frame.is_remote()) {
    words_.service = "guarding request";
    return;
  }
  if (frame.length != 1) return say_malformed(frame);
  if (frame.data[0] == 0) {
    words_.service = "boot-up";
    return say(identity_text(network().identity(words_.node)));
  }
  constexpr unsigned toggle_place = 7;
  const bool is_answer = services_.is_answer();
  words_.service = is_answer ? "guarding answer" : "heartbeat";
  words_.text = nmt_state_text(static_cast<NmtState>(frame.data[0] & 0x7F));
  if (is_answer) say(fmt::format("{}, toggle bit {}", words_.text, frame.data[0] >> toggle_place));
}

void FrameDecoder::add_news(const decoder::NodeNews& news) {
  if (news.profile_by == decoder::KnownBy::nothing) return;
  news_ = fmt::format("{} is of {}{}", node_text(news.node), network().profile(news.node).name,
                      reason_text(news.profile_by));
  words_.news = news_;
}

}  // namespace canvoy::text
