#include "canvoy/decoder/sdo_follower.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/remote/remote_access.hpp"

namespace canvoy::decoder {

namespace {

/// Bits of the first byte that are always 0: in an initiate message with data or with their size
/// (CiA 301, 7.2.4.3),
constexpr unsigned reserved_in_initiate = 0x10;
constexpr unsigned unused_count = 0x0C;  ///< in an expedited message with a size only
/// in one without data, and in an abort,
constexpr unsigned reserved_without_data = 0x1F;
/// in a request for a segment, or its confirmation,
constexpr unsigned reserved_beside_toggle = 0x0F;
/// and in messages of block transfers: initiate, end of data, and all others.
constexpr unsigned reserved_in_block_initiate = 0x18;
constexpr unsigned reserved_in_block_end = 0x02;
constexpr unsigned reserved_in_block = 0x1C;

SdoBehind place_behind(const sdo::Message& message) {
  const auto bytes = message.bytes();
  return {load<std::uint16_t>(&bytes[1]), bytes[3]};
}
bool begins(SdoMessage message) {
  return message == SdoMessage::read || message == SdoMessage::write ||
         message == SdoMessage::block_upload || message == SdoMessage::block_download;
}
/// All other messages belong to the transfer in progress.
bool names_its_entry(SdoMessage message) {
  return begins(message) || message == SdoMessage::abort || message == SdoMessage::value ||
         message == SdoMessage::written || message == SdoMessage::block_upload_ready ||
         message == SdoMessage::block_download_ready;
}
bool goes_on(SdoMessage message) {
  return message != SdoMessage::unknown && message != SdoMessage::indication;
}
std::optional<sdo::Multiplexer> entry_of(SdoMessage kind, const sdo::Message& message,
                                         std::optional<sdo::Multiplexer> under_way) {
  if (names_its_entry(kind)) return message.multiplexer();
  return goes_on(kind) ? under_way : std::nullopt;
}
bool is_indication(const sdo::Message& message) {
  if (message.first_byte() != RemoteSettings{}.indication) return false;
  const auto [network, node] = place_behind(message);
  return is_node_id(node) && message == remote_indication({}, network, node);
}

}  // namespace

SdoStep SdoFollower::request(const Frame& frame) {
  marks_ = {};
  const auto under_way = transfer_entry();
  SdoStep step = take_request(sdo::Message(frame));
  step.entry = entry_of(step.message, sdo::Message(frame), under_way);
  const bool ends =
      step.message == SdoMessage::abort || step.message == SdoMessage::block_upload_done;
  if (begins(step.message)) behind_ = std::exchange(next_, {});
  const bool asks = begins(step.message) || step.message == SdoMessage::indication;
  if (asks && is_answer_due_ && overtaken_ < overtaken_max) ++overtaken_;
  is_answer_due_ = !ends;
  hears_client_ = true;
  heard_ = sdo::Message(frame);
  step.marks = marks_;
  step.behind = behind(step.message, sdo::Message(frame));
  return step;
}

SdoStep SdoFollower::response(const Frame& frame) {
  marks_ = {};
  const auto under_way = transfer_entry();
  SdoStep step = take_response(sdo::Message(frame));
  step.entry = entry_of(step.message, sdo::Message(frame), under_way);
  is_answer_due_ = false;
  hears_server_ = true;
  heard_ = sdo::Message(frame);
  const bool answers = step.message == SdoMessage::value || step.message == SdoMessage::written ||
                       step.message == SdoMessage::indication;
  if (answers && marks_.has(Mark::out_of_place) && overtaken_ > 0) {
    --overtaken_;
    marks_.remove(Mark::out_of_place);
  }
  step.marks = marks_;
  step.behind = behind(step.message, sdo::Message(frame));
  return step;
}

/// A request may have arrived before the boot-up message of the server was sent: its answer is in
/// place.
void SdoFollower::server_starts() {
  next_ = {};
  overtaken_ = 0;
  if (phase_ == Phase::asked) return;
  phase_ = Phase::idle;
  is_known_ = true;
  is_answer_due_ = false;
}

SdoStep SdoFollower::take_request(const sdo::Message& message) {
  if (message.first_byte() == sdo::command(sdo::Request::abort)) return abort(message);
  if (is_in(Phase::block, true)) return take_block_segment(message);
  if (is_indication(message)) {
    phase_ = Phase::idle;
    is_known_ = true;
    return {SdoMessage::indication};
  }
  switch (message.request()) {
    case sdo::Request::initiate_download:
      begin(true, SdoTransfer::Kind::expedited, message.multiplexer());
      initiate(message);
      return {SdoMessage::write};
    case sdo::Request::download_segment:
      return download_segment(message);
    case sdo::Request::initiate_upload:
      begin(false, SdoTransfer::Kind::expedited, message.multiplexer());
      expect_zero(message, reserved_without_data);
      return {SdoMessage::read};
    case sdo::Request::upload_segment:
      return upload_segment(message);
    case sdo::Request::block_upload:
      return block_upload_request(message);
    case sdo::Request::block_download:
      return block_download_request(message);
    case sdo::Request::abort:
      return abort(message);
  }
  marks_.add(Mark::unknown_command);
  return {};
}

SdoStep SdoFollower::take_response(const sdo::Message& message) {
  if (message.first_byte() == sdo::command(sdo::Response::abort)) return abort(message);
  if (is_in(Phase::block, false)) return take_block_segment(message);
  expect(is_answer_due_);
  if (is_indication(message)) {
    next_ = place_behind(message);
    return {SdoMessage::indication};
  }
  switch (message.response()) {
    case sdo::Response::initiate_upload:
      return initiate_upload(message);
    case sdo::Response::upload_segment:
      return upload_segment_response(message);
    case sdo::Response::initiate_download:
      return initiate_download_response(message);
    case sdo::Response::download_segment:
      return download_segment_response(message);
    case sdo::Response::block_upload:
      return block_upload_response(message);
    case sdo::Response::block_download:
      return block_download_response(message);
    case sdo::Response::abort:
      return abort(message);
  }
  marks_.add(Mark::unknown_command);
  return {};
}

SdoStep SdoFollower::abort(const sdo::Message& message) {
  expect_zero(message, reserved_without_data);
  phase_ = Phase::idle;
  is_known_ = true;
  return {SdoMessage::abort};
}

/// Nothing if no transfer is in progress, or its start was not heard.
std::optional<sdo::Multiplexer> SdoFollower::transfer_entry() const {
  if (phase_ == Phase::idle || !is_named_) return std::nullopt;
  return sdo::Multiplexer(transfer_.index, transfer_.sub);
}

SdoBehind SdoFollower::behind(SdoMessage kind, const sdo::Message& message) const {
  return kind == SdoMessage::indication ? place_behind(message) : behind_;
}

void SdoFollower::begin(bool is_write, SdoTransfer::Kind kind, sdo::Multiplexer multiplexer) {
  transfer_.is_write = is_write;
  transfer_.kind = kind;
  transfer_.index = multiplexer.index();
  transfer_.sub = multiplexer.sub();
  transfer_.bytes.clear();
  transfer_.size = 0;
  phase_ = Phase::asked;
  is_known_ = true;
  is_named_ = true;
  last_ = false;
  has_crc_ = false;
  toggle_ = 0;
  sequence_ = 0;
  block_size_ = sdo::block_size_max;
  announced_.reset();
}

const SdoTransfer* SdoFollower::finish() {
  phase_ = Phase::idle;
  return is_named_ && behind_.node == 0 ? &transfer_ : nullptr;
}

void SdoFollower::take(std::span<const std::uint8_t> bytes) {
  const std::size_t room = bytes_max - std::min(bytes_max, transfer_.bytes.size());
  const auto kept = bytes.first(std::min(room, bytes.size()));
  transfer_.bytes.insert(transfer_.bytes.end(), kept.begin(), kept.end());
  transfer_.size += bytes.size();
  check_invariant(transfer_.bytes.size() <= bytes_max && transfer_.bytes.size() <= transfer_.size);
}

// Expected messages

void SdoFollower::expect(bool is_in_place) {
  const bool knows = is_known_ && hears_client_ && hears_server_;
  if (!is_in_place && knows) marks_.add(Mark::out_of_place);
}

void SdoFollower::expect_zero(const sdo::Message& message, unsigned reserved_bits) {
  if ((message.first_byte() & reserved_bits) != 0) marks_.add(Mark::reserved);
}

/// The received toggle bit is the reference for the next one.
void SdoFollower::expect_toggle(const sdo::Message& message) {
  if (message.toggle() != toggle_) marks_.add(Mark::wrong_toggle);
  toggle_ = message.toggle();
}

void SdoFollower::expect_size(bool is_all) {
  if (!announced_) return;
  const bool is_right = is_all ? transfer_.size == *announced_ : transfer_.size <= *announced_;
  if (!is_right) marks_.add(Mark::wrong_length);
}

// Expedited and segmented

/// Takes the data of an expedited message, or the size of a segmented one.
void SdoFollower::initiate(const sdo::Message& message) {
  const bool tells_unused = message.is_expedited() && message.has_size();
  expect_zero(message, reserved_in_initiate | (tells_unused ? 0 : unused_count));
  if (message.is_expedited()) {
    const auto bytes = message.bytes();
    const std::size_t size = message.has_size() ? message.expedited_size() : sdo::expedited_max;
    return take(std::span(bytes).subspan(4, size));
  }
  transfer_.kind = SdoTransfer::Kind::segmented;
  if (message.has_size()) announced_ = message.value();
}

/// If the request was not heard, the answer gives the entry. A block upload may be answered like
/// this too, if there are few bytes.
SdoStep SdoFollower::initiate_upload(const sdo::Message& message) {
  expect(is_in(Phase::asked, false) && is_of(message));
  begin(false, SdoTransfer::Kind::expedited, message.multiplexer());
  initiate(message);
  if (transfer_.kind == SdoTransfer::Kind::expedited) return {SdoMessage::value, finish()};
  phase_ = Phase::segments;
  return {SdoMessage::value};
}

SdoStep SdoFollower::initiate_download_response(const sdo::Message& message) {
  expect_zero(message, reserved_without_data);
  const bool confirms =
      is_in(Phase::asked, true) && is_of(message) && transfer_.kind != SdoTransfer::Kind::block;
  expect(confirms);
  if (!confirms) return {SdoMessage::written};
  if (transfer_.kind == SdoTransfer::Kind::expedited) return {SdoMessage::written, finish()};
  phase_ = Phase::segments;
  return {SdoMessage::written};
}

void SdoFollower::take_segment(const sdo::Message& message) {
  const auto bytes = message.bytes();
  take(std::span(bytes).subspan(1, message.segment_size()));
  last_ = message.is_last();
  expect_size(last_);
}

/// Segments are taken even if the confirmation was not heard, and once where they are repeated.
SdoStep SdoFollower::download_segment(const sdo::Message& message) {
  expect(is_in(Phase::segments, true) && !last_ && !is_repeated(message));
  if (is_repeated(message)) return {SdoMessage::write_segment};
  if (is_asked(true, SdoTransfer::Kind::segmented)) phase_ = Phase::segments;
  if (is_in(Phase::segments, true)) {
    expect_toggle(message);
    take_segment(message);
  }
  return {SdoMessage::write_segment};
}

SdoStep SdoFollower::download_segment_response(const sdo::Message& message) {
  expect_zero(message, reserved_beside_toggle);
  expect(is_in(Phase::segments, true));
  if (!is_in(Phase::segments, true)) return {SdoMessage::segment_written};
  expect_toggle(message);
  toggle_ ^= sdo::toggle_bit;
  return {SdoMessage::segment_written, last_ ? finish() : nullptr};
}

SdoStep SdoFollower::upload_segment(const sdo::Message& message) {
  expect_zero(message, reserved_beside_toggle);
  expect(is_in(Phase::segments, false));
  if (is_in(Phase::segments, false)) expect_toggle(message);
  return {SdoMessage::read_segment};
}

SdoStep SdoFollower::upload_segment_response(const sdo::Message& message) {
  expect(is_in(Phase::segments, false));
  if (!is_in(Phase::segments, false) || is_repeated(message)) return {SdoMessage::segment};
  expect_toggle(message);
  toggle_ ^= sdo::toggle_bit;
  take_segment(message);
  return {SdoMessage::segment, last_ ? finish() : nullptr};
}

// Block

SdoStep SdoFollower::take_block_segment(const sdo::Message& message) {
  const unsigned number = message.sequence_number();
  if (number == 0 || number > block_size_) marks_.add(Mark::out_of_range);
  // Segments out of order are sent again.
  if (number == sequence_ + 1U) {
    ++sequence_;
    const auto bytes = message.bytes();
    take(std::span(bytes).subspan(1));
    last_ = message.is_block_last();
  }
  return {SdoMessage::block_segment};
}

void SdoFollower::set_block_size(unsigned segments) {
  if (segments == 0 || segments > sdo::block_size_max) marks_.add(Mark::out_of_range);
  block_size_ = static_cast<std::uint8_t>(segments);
}

void SdoFollower::acknowledge_block(const sdo::Message& message) {
  expect_zero(message, reserved_in_block);
  if (message.acknowledged() > sequence_) marks_.add(Mark::out_of_range);
  const unsigned got = std::min<unsigned>(message.acknowledged(), sequence_);
  const std::size_t again = (sequence_ - got) * sdo::segment_max;
  check_invariant(again <= transfer_.size);
  transfer_.size -= again;
  transfer_.bytes.resize(std::min(transfer_.bytes.size(), transfer_.size));
  if (again != 0) last_ = false;
  sequence_ = 0;
  // If no block follows, it has no size.
  if (last_) {
    phase_ = Phase::block_end;
  } else {
    set_block_size(message.next_block_size());
  }
}

void SdoFollower::end_block(const sdo::Message& message) {
  expect_zero(message, reserved_in_block_end);
  transfer_.size -= std::min(transfer_.size, message.block_unused());
  transfer_.bytes.resize(std::min(transfer_.bytes.size(), transfer_.size));
  expect_size(true);
  check_checksum(message);
}

void SdoFollower::check_checksum(const sdo::Message& message) {
  const bool is_kept = transfer_.bytes.size() == transfer_.size;
  if (!has_crc_ || !is_kept) return;
  if (crc16(transfer_.bytes) != message.crc()) marks_.add(Mark::wrong_checksum);
}

SdoStep SdoFollower::block_upload_request(const sdo::Message& message) {
  const unsigned command = message.block_command();
  if (command == sdo::block_initiate) {
    begin(false, SdoTransfer::Kind::block, message.multiplexer());
    expect_zero(message, reserved_in_block_initiate);
    has_crc_ = message.has_block_crc();
    set_block_size(message.block_size());
    return {SdoMessage::block_upload};
  }
  if (command == sdo::block_acknowledge) {
    expect(is_in(Phase::block, false));
    if (is_in(Phase::block, false)) acknowledge_block(message);
    return {SdoMessage::block_upload_got};
  }
  expect_zero(message, reserved_in_block);
  if (command == sdo::block_start) {
    start_block_upload();
    return {SdoMessage::block_upload_start};
  }
  expect(is_in(Phase::block_end, false));
  return {SdoMessage::block_upload_done, is_in(Phase::block_end, false) ? finish() : nullptr};
}

/// If listening started here, the entry of the segments is unknown.
void SdoFollower::start_block_upload() {
  const bool was_asked = is_asked(false, SdoTransfer::Kind::block);
  expect(was_asked && !is_answer_due_);
  if (!was_asked) {
    begin(false, SdoTransfer::Kind::block, {});
    is_named_ = false;
  }
  phase_ = Phase::block;
}

SdoStep SdoFollower::block_upload_response(const sdo::Message& message) {
  if (message.is_block_end()) {
    expect(is_in(Phase::block_end, false));
    if (is_in(Phase::block_end, false)) end_block(message);
    return {SdoMessage::block_upload_end};
  }
  expect_zero(message, reserved_in_block_initiate);
  const bool was_asked = is_asked(false, SdoTransfer::Kind::block) && is_of(message);
  expect(was_asked);
  has_crc_ = was_asked && has_crc_ && message.has_block_crc();
  if (was_asked && message.has_block_size()) announced_ = message.value();
  return {SdoMessage::block_upload_ready};
}

SdoStep SdoFollower::block_download_request(const sdo::Message& message) {
  if (message.is_block_end()) {
    expect(is_in(Phase::block_end, true));
    if (is_in(Phase::block_end, true)) end_block(message);
    return {SdoMessage::block_download_end};
  }
  begin(true, SdoTransfer::Kind::block, message.multiplexer());
  expect_zero(message, reserved_in_block_initiate);
  has_crc_ = message.has_block_crc();
  if (message.has_block_size()) announced_ = message.value();
  return {SdoMessage::block_download};
}

SdoStep SdoFollower::block_download_response(const sdo::Message& message) {
  const unsigned command = message.block_command();
  if (command == sdo::block_initiate) {
    // If the request was not heard, the answer gives the entry.
    const bool was_asked = is_asked(true, SdoTransfer::Kind::block) && is_of(message);
    expect(was_asked);
    if (!was_asked) begin(true, SdoTransfer::Kind::block, message.multiplexer());
    expect_zero(message, reserved_in_block_initiate);
    has_crc_ = has_crc_ && message.has_block_crc();
    set_block_size(message.block_size());
    phase_ = Phase::block;
    return {SdoMessage::block_download_ready};
  }
  if (command == sdo::block_acknowledge) {
    expect(is_in(Phase::block, true));
    if (is_in(Phase::block, true)) acknowledge_block(message);
    return {SdoMessage::block_download_got};
  }
  if (command != sdo::block_end) {
    marks_.add(Mark::unknown_command);
    return {};
  }
  expect_zero(message, reserved_in_block);
  expect(is_in(Phase::block_end, true));
  return {SdoMessage::block_download_done, is_in(Phase::block_end, true) ? finish() : nullptr};
}

}  // namespace canvoy::decoder
