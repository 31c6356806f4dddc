#include "canvoy/can/host/msgpack_frame.hpp"

#include <algorithm>
#include <bit>
#include <optional>

namespace canvoy::host {

namespace {

// First bytes of the types of msgpack, as far as used here.
constexpr std::uint8_t fixmap = 0x80;
constexpr std::uint8_t fixmap_mask = 0xF0;
constexpr std::uint8_t fixstr = 0xA0;
constexpr std::uint8_t fixstr_mask = 0xE0;
constexpr std::uint8_t positive_fixint_max = 0x7F;
constexpr std::uint8_t nil = 0xC0;
constexpr std::uint8_t false_value = 0xC2;
constexpr std::uint8_t true_value = 0xC3;
constexpr std::uint8_t bin8 = 0xC4;
constexpr std::uint8_t float32 = 0xCA;
constexpr std::uint8_t float64 = 0xCB;
constexpr std::uint8_t uint8 = 0xCC;
constexpr std::uint8_t uint16 = 0xCD;
constexpr std::uint8_t uint32 = 0xCE;
constexpr std::uint8_t uint64 = 0xCF;
constexpr std::uint8_t str8 = 0xD9;

constexpr std::uint32_t fd_length_max = 64;

// In the order in which python-can sends them.
enum class Key : std::uint8_t {
  timestamp,
  arbitration_id,
  is_extended_id,
  is_remote_frame,
  is_error_frame,
  channel,
  dlc,
  data,
  is_fd,
  bitrate_switch,
  error_state_indicator,
};
constexpr std::array<std::string_view, 11> key_names{"timestamp",
                                                     "arbitration_id",
                                                     "is_extended_id",
                                                     "is_remote_frame",
                                                     "is_error_frame",
                                                     "channel",
                                                     "dlc",
                                                     "data",
                                                     "is_fd",
                                                     "bitrate_switch",
                                                     "error_state_indicator"};

constexpr std::uint32_t bit_of(Key key) {
  return 1U << static_cast<unsigned>(key);
}

// Reads msgpack values from the front. After a failure it returns nothing more.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  bool empty() const { return rest_.empty(); }
  std::optional<std::uint64_t> big_endian(std::size_t size) {
    const std::optional<std::span<const std::uint8_t>> bytes = take(size);
    if (!bytes) return std::nullopt;
    std::uint64_t value = 0;
    for (const std::uint8_t byte : *bytes) value = value << 8 | byte;
    return value;
  }
  std::optional<std::span<const std::uint8_t>> take(std::size_t size) {
    if (size > rest_.size()) return std::nullopt;
    const std::span<const std::uint8_t> bytes = rest_.first(size);
    rest_ = rest_.subspan(size);
    return bytes;
  }

  std::optional<std::uint64_t> unsigned_number() {
    const std::optional<std::uint64_t> type = big_endian(1);
    if (!type || *type <= positive_fixint_max) return type;
    if (*type < uint8 || *type > uint64) return std::nullopt;
    return big_endian(std::size_t{1} << (*type - uint8));
  }
  std::optional<bool> boolean() {
    const std::optional<std::uint64_t> type = big_endian(1);
    if (type != false_value && type != true_value) return std::nullopt;
    return *type == true_value;
  }
  std::optional<std::string_view> string() {
    const std::optional<std::uint64_t> type = big_endian(1);
    std::optional<std::uint64_t> size;
    if (type == str8) size = big_endian(1);
    if (type && (*type & fixstr_mask) == fixstr) size = *type & ~std::uint64_t{fixstr_mask};
    const std::optional<std::span<const std::uint8_t>> bytes = size ? take(*size) : std::nullopt;
    if (!bytes) return std::nullopt;
    return std::string_view(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  }
  std::optional<std::span<const std::uint8_t>> binary() {
    const std::optional<std::uint64_t> size = big_endian(1) == bin8 ? big_endian(1) : std::nullopt;
    return size ? take(*size) : std::nullopt;
  }
  bool skip_number() {
    if (rest_.empty()) return false;
    if (rest_[0] == float64) return take(9).has_value();
    if (rest_[0] == float32) return take(5).has_value();
    return unsigned_number().has_value();
  }
  bool skip_channel() {
    if (!rest_.empty() && rest_[0] == nil) return take(1).has_value();
    if (!rest_.empty() && (rest_[0] <= positive_fixint_max || rest_[0] >= uint8) &&
        rest_[0] <= uint64) {
      return unsigned_number().has_value();
    }
    return string().has_value();
  }

 private:
  std::span<const std::uint8_t> rest_;
};

// Values of the map, before their check as a frame.
struct Message {
  std::uint32_t seen = 0;   // bit_of() the keys that were present
  std::uint32_t flags = 0;  // bit_of() the keys that were true
  std::uint64_t id = 0;
  std::uint64_t dlc = 0;
  std::span<const std::uint8_t> data;

  bool has(Key key) const { return (seen & bit_of(key)) != 0; }
  bool is(Key key) const { return (flags & bit_of(key)) != 0; }
};

template <class Value, class Field>
bool store(const std::optional<Value>& value, Field& field) {
  if (value) field = *value;
  return value.has_value();
}

bool read_value(Reader& reader, Key key, Message& message) {
  switch (key) {
    case Key::timestamp:
      return reader.skip_number();
    case Key::channel:
      return reader.skip_channel();
    case Key::arbitration_id:
      return store(reader.unsigned_number(), message.id);
    case Key::dlc:
      return store(reader.unsigned_number(), message.dlc);
    case Key::data:
      return store(reader.binary(), message.data);
    default:
      break;
  }
  const std::optional<bool> flag = reader.boolean();
  if (flag == true) message.flags |= bit_of(key);
  return flag.has_value();
}

bool read_entry(Reader& reader, Message& message) {
  const std::optional<std::string_view> name = reader.string();
  if (!name) return false;
  const auto found = std::ranges::find(key_names, *name);
  if (found == key_names.end()) return false;
  const Key key{static_cast<std::uint8_t>(found - key_names.begin())};
  if (message.has(key)) return false;
  message.seen |= bit_of(key);
  return read_value(reader, key, message);
}

std::optional<Message> read_message(std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  const std::optional<std::uint64_t> head = reader.big_endian(1);
  if (!head || (*head & fixmap_mask) != fixmap) return std::nullopt;
  Message message;
  for (std::uint64_t entries = *head & 0x0F; entries > 0; --entries) {
    if (!read_entry(reader, message)) return std::nullopt;
  }
  if (!reader.empty()) return std::nullopt;
  return message;
}

bool is_consistent(const Message& message) {
  if (!message.has(Key::arbitration_id) || !message.has(Key::is_extended_id)) return false;
  const bool wide = message.is(Key::is_extended_id) || message.is(Key::is_error_frame);
  if (message.id > (wide ? Frame::extended_id_max : Frame::id_max)) return false;
  if (message.is(Key::is_remote_frame)) {
    return message.data.empty() && !message.is(Key::is_error_frame) && !message.is(Key::is_fd) &&
           message.dlc <= Frame::length_max;
  }
  const std::uint32_t length_max = message.is(Key::is_fd) ? fd_length_max : Frame::length_max;
  return message.data.size() <= length_max &&
         (!message.has(Key::dlc) || message.dlc == message.data.size());
}

Frame frame_of(const Message& message) {
  Frame frame;
  frame.id = static_cast<std::uint32_t>(message.id);
  if (message.is(Key::is_extended_id)) frame.flags = FrameFlags::extended;
  if (message.is(Key::is_error_frame)) frame.flags = FrameFlags::error;
  if (message.is(Key::is_remote_frame)) {
    frame.flags = frame.flags | FrameFlags::remote;
    frame.length = static_cast<std::uint8_t>(message.dlc);
  } else {
    frame.length = static_cast<std::uint8_t>(message.data.size());
    std::ranges::copy(message.data, frame.data.begin());
  }
  return frame;
}

}  // namespace

MsgpackFrame::MsgpackFrame(const Frame& frame, double timestamp) {
  put(fixmap | static_cast<std::uint8_t>(key_names.size()));
  put_key("timestamp");
  put_float(timestamp);
  put_key("arbitration_id");
  put_unsigned(frame.id);
  put_flag("is_extended_id", frame.is_extended());
  put_flag("is_remote_frame", frame.is_remote());
  put_flag("is_error_frame", frame.is_error());
  put_key("channel");
  put(nil);
  put_key("dlc");
  put_unsigned(frame.length);
  put_key("data");
  put_data(frame.payload());
  put_flag("is_fd", false);
  put_flag("bitrate_switch", false);
  put_flag("error_state_indicator", false);
}

void MsgpackFrame::put_key(std::string_view key) {
  put(fixstr | static_cast<std::uint8_t>(key.size()));
  for (const char character : key) put(static_cast<std::uint8_t>(character));
}

void MsgpackFrame::put_big_endian(std::uint64_t value, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
    put(static_cast<std::uint8_t>(value >> shift));
}

void MsgpackFrame::put_unsigned(std::uint32_t value) {
  if (value <= positive_fixint_max) return put_big_endian(value, 1);
  if (value <= 0xFF) {
    put(uint8);
    put_big_endian(value, 1);
  } else if (value <= 0xFFFF) {
    put(uint16);
    put_big_endian(value, 2);
  } else {
    put(uint32);
    put_big_endian(value, 4);
  }
}

void MsgpackFrame::put_float(double value) {
  put(float64);
  put_big_endian(std::bit_cast<std::uint64_t>(value), 8);
}

void MsgpackFrame::put_data(std::span<const std::uint8_t> data) {
  put(bin8);
  put(static_cast<std::uint8_t>(data.size()));
  for (const std::uint8_t byte : data) put(byte);
}

void MsgpackFrame::put_flag(std::string_view key, bool value) {
  put_key(key);
  put(value ? true_value : false_value);
}

DecodedFrame decode_msgpack_frame(std::span<const std::uint8_t> bytes) {
  const std::optional<Message> message = read_message(bytes);
  if (!message || !is_consistent(*message)) return {};
  if (message->is(Key::is_fd)) return {FrameKind::fd, {}};
  return {FrameKind::classic, frame_of(*message)};
}

}  // namespace canvoy::host
