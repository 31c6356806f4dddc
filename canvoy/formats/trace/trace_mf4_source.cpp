#include "canvoy/formats/trace/trace_mf4_source.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "canvoy/formats/trace/trace_error.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"

namespace canvoy::formats {

namespace {

constexpr TraceStep mf4_frame{TraceItem::frame, 0, {}};

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t at = bytes.size(); at-- > 0;) {
    value = value << 8 | static_cast<std::uint8_t>(bytes[at]);
  }
  return value;
}

}  // namespace

Mf4Source::Mf4Source(Mf4File& file, const Mf4Block& block, const Mf4Start& start)
    : start_(start),
      id_size_(static_cast<unsigned>(file.number(block, 0, 1))),
      groups_(read_mf4_groups(file, block)),
      data_(file, file.link(block, 2), !start.is_finished) {
  for (Mf4Group& group : groups_) {
    if (group.kind == Mf4Kind::lengths) lengths_.push_back({group.at});
    const bool is_small = group.size <= trace_record_max;
    const bool is_read = group.kind == Mf4Kind::lengths ||
                         (group.time.is_there() && is_small &&
                          (group.identifier.is_there() || group.kind == Mf4Kind::error));
    if (!is_read) group.kind = Mf4Kind::other;
  }
  for (const Mf4Group& group : groups_) {
    const bool is_within =
        std::ranges::find(lengths_, group.data_link, &Lengths::group) != lengths_.end();
    if (group.data_link != 0 && group.kind != Mf4Kind::other && !is_within) {
      apart_.push_back(
          std::make_unique<Apart>(Apart{group.at, 0, Mf4Data(file, group.data_link, false)}));
    }
  }
}

bool Mf4Source::has_frames() const {
  return std::ranges::any_of(groups_, [](const Mf4Group& group) {
    return group.kind != Mf4Kind::other && group.kind != Mf4Kind::lengths;
  });
}

TraceStep Mf4Source::next(Mf4Frame& frame) {
  while (true) {
    const bool is_full = waiting_.size() > latest_max;
    if (!waiting_.empty() && (waiting_.front().group == 0 || is_full || is_over_)) {
      const Waiting first = waiting_.front();
      waiting_.pop_front();
      if (first.group != 0) return bad_record("the bytes of the frame are missing");
      frame = first.frame;
      return {frame.item, 0, {}};
    }
    if (is_over_) return {TraceItem::end, 0, {}};
    const TraceStep step = read_record();
    if (step.item == TraceItem::bad) return step;
    if (step.item != TraceItem::frame) continue;
    if (made_.group != 0 || !waiting_.empty()) {
      waiting_.push_back(made_);
      continue;
    }
    frame = made_.frame;
    return {frame.item, 0, {}};
  }
}

Mf4Group* Mf4Source::group_of(std::uint64_t id) {
  if (id_size_ == 0) return groups_.empty() ? nullptr : &groups_.front();
  const auto found = std::ranges::find(groups_, id, &Mf4Group::id);
  return found == groups_.end() ? nullptr : &*found;
}

TraceStep Mf4Source::end_of_data(bool is_within) {
  is_over_ = true;
  if (!data_.problem().empty()) return bad_record(data_.problem());
  if (is_within) return bad_record("the file ends within a frame");
  std::uint64_t wanted = 0;
  for (const Mf4Group& group : groups_) {
    if (group.kind != Mf4Kind::other && group.kind != Mf4Kind::lengths) wanted += group.count;
  }
  if (start_.is_finished && frames_ < wanted) {
    return bad_record("the file ends before the last of its frames");
  }
  return {};
}

TraceStep Mf4Source::read_record() {
  const std::string_view id = data_.show(id_size_);
  if (id.size() < id_size_) return end_of_data(!id.empty());
  Mf4Group* const group = group_of(little_endian(id));
  if (group == nullptr) {
    is_over_ = true;
    return bad_record("a record of a group that is not described");
  }
  const std::size_t id_size = id.size();
  if (group->kind == Mf4Kind::lengths) {
    data_.take(id_size);
    return read_lengths(*group);
  }
  if (group->kind == Mf4Kind::other) {
    const bool is_there = data_.take(id_size + std::max<std::uint64_t>(group->size, 1));
    return is_there ? TraceStep{} : end_of_data(true);
  }
  const std::size_t size = id_size + static_cast<std::size_t>(group->size);
  const std::string_view record = data_.show(size);
  if (record.size() < size) return end_of_data(record.size() > 0);
  if (id_size_ == 0 && start_.is_finished && frames_ == group->count) return end_of_data(false);
  ++frames_;
  const TraceStep step = read_frame(*group, record.substr(id_size));
  data_.take(size);
  return step;
}

TraceStep Mf4Source::read_lengths(const Mf4Group& group) {
  constexpr std::size_t length_size = 4;
  const std::string_view head = data_.show(length_size);
  if (head.size() < length_size) return end_of_data(true);
  const std::uint64_t length = little_endian(head);
  const std::uint64_t wanted = std::min<std::uint64_t>(length, 64);
  data_.take(length_size);
  const std::string bytes(data_.show(static_cast<std::size_t>(wanted)));
  if (!data_.take(length)) return end_of_data(true);
  const auto row = std::ranges::find(lengths_, group.at, &Lengths::group);
  for (Waiting& waiting : waiting_) {
    if (waiting.group != group.at || waiting.offset != row->end) continue;
    set_bytes(waiting, bytes);
    waiting.group = 0;
  }
  row->latest.emplace_back(row->end, bytes);
  if (row->latest.size() > latest_max) row->latest.pop_front();
  row->end += length_size + length;
  return {};
}

void Mf4Source::set_bytes(Waiting& made, std::string_view bytes) {
  TraceFrame& frame = made.frame.frame;
  const std::size_t count = std::min<std::size_t>(made.length, bytes.size());
  if (made.frame.item == TraceItem::fd) {
    frame.fd.length = static_cast<std::uint8_t>(std::min(count, frame.fd.data.size()));
    std::copy_n(bytes.data(), frame.fd.length, frame.fd.data.begin());
    return;
  }
  frame.frame.length = static_cast<std::uint8_t>(std::min<std::size_t>(count, Frame::length_max));
  std::copy_n(bytes.data(), frame.frame.length, frame.frame.data.begin());
}

/// Whether they have come by already.
bool Mf4Source::find_bytes(Waiting& made) {
  const auto row = std::ranges::find(lengths_, made.group, &Lengths::group);
  if (row == lengths_.end()) return false;
  const auto found =
      std::ranges::find(row->latest, made.offset, &std::pair<std::uint64_t, std::string>::first);
  if (found == row->latest.end()) return false;
  set_bytes(made, found->second);
  made.group = 0;
  return true;
}

/// From a block of their own, where they stand in the order of the frames.
bool Mf4Source::read_apart(const Mf4Group& group, Waiting& made) {
  constexpr std::size_t length_size = 4;
  for (const std::unique_ptr<Apart>& apart : apart_) {
    if (apart->group != group.at) continue;
    if (made.offset < apart->done || !apart->data.take(made.offset - apart->done)) return false;
    apart->done = made.offset;
    const std::string_view head = apart->data.show(length_size);
    if (head.size() < length_size) return false;
    const std::size_t wanted = std::min<std::size_t>(little_endian(head), 64);
    const std::string_view bytes = apart->data.show(length_size + wanted);
    if (bytes.size() < length_size + wanted) return false;
    set_bytes(made, bytes.substr(length_size));
    return true;
  }
  return false;
}

/// Time, bus and direction.
TraceStep Mf4Source::read_head(const Mf4Group& group, std::string_view record) {
  constexpr double seconds_max = 1e11;
  const double seconds = group.time.value(record);
  if (!(std::abs(seconds) < seconds_max)) return bad_record("its time is no number");
  made_ = {};
  made_.frame.item = TraceItem::frame;
  TraceFrame& frame = made_.frame.frame;
  frame.time = Time{start_.time + Duration{std::llround(seconds * 1e6)}};
  if (frame.time < Time{}) return bad_record("its time is before 1970");
  const std::uint64_t bus = group.bus.number(record);
  if (bus >= TraceChannel::number_max) return bad_record("the channel is above 254");
  made_.frame.bus = static_cast<std::int64_t>(bus);
  if (group.direction.is_there()) {
    frame.direction =
        group.direction.number(record) == 0 ? TraceDirection::received : TraceDirection::sent;
  }
  return mf4_frame;
}

TraceStep Mf4Source::read_frame(const Mf4Group& group, std::string_view record) {
  const TraceStep head = read_head(group, record);
  if (head.item == TraceItem::bad) return head;
  if (group.kind == Mf4Kind::error) return read_error(group, record);
  Frame& frame = made_.frame.frame.frame;
  const std::uint64_t id = group.identifier.number(record);
  const bool is_extended =
      group.extended.is_there() ? group.extended.number(record) != 0 : (id & extended_flag) != 0;
  frame.id = static_cast<std::uint32_t>(id) & Frame::extended_id_max;
  frame.flags = is_extended ? FrameFlags::extended : FrameFlags::none;
  if (!is_extended && frame.id > Frame::id_max) {
    return bad_record("the identifier has more bits than there are");
  }
  const auto code = static_cast<std::uint32_t>(group.code.number(record));
  if (group.kind == Mf4Kind::remote) {
    frame.flags = frame.flags | FrameFlags::remote;
    frame.length = static_cast<std::uint8_t>(std::min<std::uint32_t>(code, Frame::length_max));
    return mf4_frame;
  }
  const std::uint64_t length =
      group.length.is_there() ? group.length.number(record) : fd_length(code);
  made_.length = static_cast<std::uint8_t>(std::min<std::uint64_t>(length, 64));
  if (group.fd.number(record) != 0 || length > Frame::length_max) {
    made_.frame.item = TraceItem::fd;
    const bool has_switch = group.bit_rate.number(record) != 0;
    const bool has_state = group.state.number(record) != 0;
    made_.frame.frame.fd.flags =
        static_cast<std::uint8_t>((has_switch ? TraceFdContent::bit_rate_switch : 0) |
                                  (has_state ? TraceFdContent::error_state : 0));
  }
  return read_bytes(group, record);
}

TraceStep Mf4Source::read_bytes(const Mf4Group& group, std::string_view record) {
  if (!group.data_offset.is_there()) {
    if (made_.length > group.data_size) return bad_record("it has less data than its length says");
    set_bytes(made_, record.substr(group.data_byte, group.data_size));
    return mf4_frame;
  }
  made_.offset = group.data_offset.number(record);
  if (std::ranges::find(lengths_, group.data_link, &Lengths::group) != lengths_.end()) {
    made_.group = group.data_link;
    find_bytes(made_);
    return mf4_frame;
  }
  return read_apart(group, made_) ? mf4_frame : bad_record("the bytes of the frame are missing");
}

// Who has written as SocketCAN tells of errors has its class in the identifier.
TraceStep Mf4Source::read_error(const Mf4Group& group, std::string_view record) {
  Frame& frame = made_.frame.frame.frame;
  frame = trace_error_frame();
  made_.frame.frame.direction = TraceDirection::unknown;
  const std::uint64_t id = group.identifier.number(record);
  const std::uint64_t length = group.length.number(record);
  const bool is_told = start_.has_socketcan_errors && id != 0 && id <= Frame::extended_id_max &&
                       length >= Frame::length_max && group.data_size >= Frame::length_max;
  if (!is_told) return mf4_frame;
  frame.id = static_cast<std::uint32_t>(id);
  made_.length = Frame::length_max;
  set_bytes(made_, record.substr(group.data_byte, Frame::length_max));
  return mf4_frame;
}

}  // namespace canvoy::formats
