#include "canvoy/devices/cia407/diagnostics/diagnostics_unit.hpp"

#include <algorithm>

namespace canvoy::cia407 {

namespace {

/// Up to so many characters. substr() would link what throws, and with it a heap, on a board.
std::string_view beginning_of(std::string_view text, std::size_t length) {
  return {text.data(), std::min(text.size(), length)};
}

constexpr std::uint16_t short_index = short_diagnostic_error_field_object.index;
constexpr std::uint16_t file_index = extended_diagnostic_message_file_object.index;
constexpr std::uint16_t first_class_index = error_class_1_messages_object.index;
constexpr std::uint8_t flag_many_shorts = 1;
constexpr std::uint8_t flag_near_capacity = 2;
constexpr unsigned first_class_flag = 2;
constexpr char ascii_max = 0x7F;
/// As if this number of bytes had been written: nothing may follow a character.
constexpr std::size_t character_ends = sizeof(std::uint64_t);
/// As in 9.2.27.2 (errata 92).
constexpr std::string_view line_end = "\n\r";

template <std::size_t size>
class Line {
 public:
  void add(std::string_view text) {
    for (const char one : beginning_of(text, size - length_)) text_[length_++] = one;
  }
  void add_number(std::uint64_t number, unsigned digits, unsigned base = 10) {
    for (unsigned place = digits; place-- > 0; number /= base) {
      text_[length_ + place] = "0123456789ABCDEF"[number % base];
    }
    length_ += digits;
  }
  std::string_view text() const { return {text_.data(), length_}; }

 private:
  std::array<char, size> text_{};
  std::size_t length_ = 0;
};
using LongLine = Line<128>;

void add_time(LongLine& line, const CivilTime& time) {
  line.add_number(static_cast<std::uint64_t>(time.year), 4);
  line.add("-");
  line.add_number(time.month, 2);
  line.add("-");
  line.add_number(time.day, 2);
  line.add(" ");
  line.add_number(time.hour, 2);
  line.add(":");
  line.add_number(time.minute, 2);
  line.add(":");
  line.add_number(time.second, 2);
  line.add(" ");
}

bool is_ascii(std::span<const std::uint8_t> text) {
  return std::ranges::all_of(text, [](std::uint8_t byte) { return byte <= ascii_max; });
}

}  // namespace

constexpr AccessHandlers DiagnosticsUnit::hook_calls[] = {
    before_write<&DiagnosticsUnit::check_shorts, short_diagnostic_error_field_object>,
    before_write<&DiagnosticsUnit::check_messages, error_class_1_messages_object,
                 error_class_3_messages_object>,
    after_write<&DiagnosticsUnit::shorts_written, short_diagnostic_error_field_object>,
    after_write<&DiagnosticsUnit::messages_written, error_class_1_messages_object,
                error_class_3_messages_object>,
    before_read<&DiagnosticsUnit::about_to_be_read, error_class_1_messages_object,
                error_class_3_messages_object>};

DiagnosticsUnit::DiagnosticsUnit(VirtualDevice& device, const NoHardware& /*hardware*/,
                                 const DiagnosticsSettings& settings)
    : device_(device),
      settings_(settings),
      domain_{.open_read = callback<&DiagnosticsUnit::open_read>(*this),
              .read = Callback<Result<std::size_t>(
                  const Entry&, std::uint32_t,
                  std::span<std::uint8_t>)>::to<&DiagnosticsUnit::read>(*this),
              .open_write = callback<&DiagnosticsUnit::open_write>(*this),
              .write = callback<&DiagnosticsUnit::write>(*this),
              .close_write = callback<&DiagnosticsUnit::close_write>(*this)},
      hook_{.first = file_index, .last = file_index, .domain = &domain_} {
  device.on_reset = callback<&DiagnosticsUnit::reset>(*this);
  device.react(*this, hook_calls);
  device.node().dictionary().attach(hook_);
}

void DiagnosticsUnit::reset(ResetScope scope) {
  if (scope != ResetScope::node) return;
  report_shorts();
  for (unsigned i = 0; i < classes_.size(); ++i) {
    report_messages(static_cast<std::uint16_t>(first_class_index + i));
  }
}

DiagnosticsUnit::Messages* DiagnosticsUnit::messages_of(std::uint16_t index) {
  const bool is_class = index >= first_class_index && index < first_class_index + classes_.size();
  return is_class ? &classes_[index - first_class_index] : nullptr;
}

/// 0 alone, which deletes them.
AbortCode DiagnosticsUnit::check_shorts(const Entry& entry, std::span<const std::uint8_t> value) {
  return entry.sub == 0 && value[0] > 0 ? AbortCode::value_range : AbortCode::none;
}

/// Error code 0000h means no error of the device: there are 65,535 codes (9.2.27.1).
void DiagnosticsUnit::shorts_written(const Entry& entry) {
  constexpr std::uint32_t error_code = 0xFFFF;
  if (entry.sub == 1) {
    return (entry.word() & error_code) == 0 ? report_shorts() : add_short(entry.word());
  }
  if (entry.sub != 0) return;
  short_count_ = 0;
  report_shorts();
}

/// 0 deletes those that were read, 1 all.
AbortCode DiagnosticsUnit::check_messages(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.sub == 0) return value[0] > 1 ? AbortCode::value_range : AbortCode::none;
  if (!is_ascii(value)) return AbortCode::value_range;
  const bool is_full = messages_of(entry.index)->count == entries_max;
  return is_full ? AbortCode::cannot_store : AbortCode::none;
}

void DiagnosticsUnit::messages_written(const Entry& entry) {
  if (entry.sub == 0) return remove_messages(entry.index, entry.word() == 1);
  if (entry.sub != 1) return;
  Message text{};
  const std::span<const std::uint8_t> bytes = entry.bytes();
  std::ranges::copy(bytes, text.begin());
  add_message(entry.index, std::span(text).first(bytes.size()));
}

void DiagnosticsUnit::about_to_be_read(const Entry& entry) {
  Messages& messages = *messages_of(entry.index);
  if (entry.sub != 0 && entry.sub <= messages.count) messages.is_read[entry.sub - 1U] = true;
}

void DiagnosticsUnit::report(std::uint16_t device_code, std::uint16_t error_code) {
  add_short(std::uint32_t{device_code} << 16 | error_code);
}

bool DiagnosticsUnit::report(ErrorClass error_class, std::string_view message) {
  const auto index =
      static_cast<std::uint16_t>(first_class_index + static_cast<unsigned>(error_class));
  const std::span text(reinterpret_cast<const std::uint8_t*>(message.data()), message.size());
  const bool has_room = messages_of(index)->count < entries_max;
  if (message.size() > message_size || !is_ascii(text) || !has_room) return false;
  add_message(index, text);
  return true;
}

void DiagnosticsUnit::add_short(std::uint32_t error) {
  std::shift_right(shorts_.begin(), shorts_.end(), 1);
  shorts_[0] = error;
  short_count_ = std::min(short_count_ + 1, entries_max);
  report_shorts();
  LongLine line;
  line.add_number(error >> 16, 4, 16);
  line.add(" ");
  line.add_number(error & 0xFFFF, 4, 16);
  add_line(line.text());
}

void DiagnosticsUnit::add_message(std::uint16_t index, std::span<const std::uint8_t> text) {
  Messages& messages = *messages_of(index);
  Message& made = messages.messages[messages.count];
  made = {};
  std::ranges::copy(text, made.begin());
  messages.is_read[messages.count++] = false;
  report_messages(index);
  const std::string_view whole(reinterpret_cast<const char*>(text.data()), text.size());
  add_line(beginning_of(whole, whole.find('\0')));
}

/// All messages, or those that were read.
void DiagnosticsUnit::remove_messages(std::uint16_t index, bool all) {
  Messages& messages = *messages_of(index);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < messages.count; ++i) {
    if (all || messages.is_read[i]) continue;
    messages.messages[kept] = messages.messages[i];
    messages.is_read[kept++] = false;
  }
  messages.count = kept;
  report_messages(index);
}

void DiagnosticsUnit::report_shorts() {
  Dictionary& dictionary = device_.node().dictionary();
  for (std::size_t i = 0; i < entries_max; ++i) {
    dictionary.set_number(short_index, static_cast<std::uint8_t>(i + 1),
                          i < short_count_ ? shorts_[i] : 0);
  }
  dictionary.set_number(short_index, 0, short_count_);
  report_events();
}

void DiagnosticsUnit::report_messages(std::uint16_t index) {
  const Messages& messages = *messages_of(index);
  Dictionary& dictionary = device_.node().dictionary();
  for (std::size_t i = 0; i < entries_max; ++i) {
    const Result<Entry> entry = dictionary.find(index, static_cast<std::uint8_t>(i + 1));
    const bool is_there = i < messages.count;
    const std::span<const std::uint8_t> text(messages.messages[i]);
    if (entry) dictionary.set(*entry, is_there ? text : text.first(0));
  }
  dictionary.set_number(index, 0, messages.count);
  report_events();
}

void DiagnosticsUnit::report_events() {
  device_.signal(flag_many_shorts, short_count_ > many);
  device_.signal(flag_near_capacity, short_count_ >= settings_.close_to_limit);
  for (unsigned i = 0; i < classes_.size(); ++i) {
    device_.signal(static_cast<std::uint8_t>(1U << (first_class_flag + i)),
                   classes_[i].count > many);
  }
}

void DiagnosticsUnit::add_line(std::string_view text) {
  LongLine line;
  if (const auto time = local_time(device_.values())) add_time(line, *time);
  for (const char one : text) {
    // A message of several lines would look like several messages.
    line.add(one == '\n' || one == '\r' ? " " : std::string_view(&one, 1));
  }
  line.add(line_end);
  drop_lines(line.text().size());
  std::ranges::copy(line.text(), file_.begin() + static_cast<std::ptrdiff_t>(file_length_));
  file_length_ += line.text().size();
}

void DiagnosticsUnit::drop_lines(std::size_t needed) {
  if (file_length_ + needed <= file_size) return;
  std::size_t dropped = 0;
  while (file_length_ - dropped + needed > file_size) {
    dropped = file().find(line_end, dropped) + line_end.size();
  }
  drop(dropped);
}

/// Drops this number of bytes at the beginning.
void DiagnosticsUnit::drop(std::size_t length) {
  std::shift_left(file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(file_length_),
                  static_cast<std::ptrdiff_t>(length));
  file_length_ -= length;
  dropped_ += static_cast<std::uint32_t>(length);
}

Result<std::uint32_t> DiagnosticsUnit::open_read(const Entry& /*entry*/) {
  read_from_ = dropped_;
  read_length_ = static_cast<std::uint32_t>(file_length_);
  return read_length_;
}

/// Reads the file as it was when it was opened. Lines dropped since then have been read, or the
/// whole file does not exist any more.
Result<std::size_t> DiagnosticsUnit::read(const Entry& /*entry*/, std::uint32_t offset,
                                          std::span<std::uint8_t> bytes) {
  const std::uint32_t gone = dropped_ - read_from_;
  const std::size_t left = read_length_ - std::min(offset, read_length_);
  if (left != 0 && offset < gone) return AbortCode::device_state;
  const std::size_t count = std::min(left, bytes.size());
  for (std::size_t i = 0; i < count; ++i) {
    bytes[i] = static_cast<std::uint8_t>(file_[offset - gone + i]);
  }
  return count;
}

/// Only a zero may be written (errata 91): it erases the file. It is a character, or a number of
/// any size: a client may write an Unsigned32, or leave the size of an expedited transfer
/// undefined.
AbortCode DiagnosticsUnit::open_write(const Entry& /*entry*/, std::uint32_t /*size*/) {
  written_ = 0;
  return AbortCode::none;
}

AbortCode DiagnosticsUnit::write(const Entry& /*entry*/, std::span<const std::uint8_t> bytes) {
  const bool is_character = written_ == 0 && bytes.size() == 1 && bytes[0] == '0';
  const bool is_number = written_ + bytes.size() <= sizeof(std::uint64_t) &&
                         std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; });
  written_ += is_character ? character_ends : bytes.size();
  return is_character || is_number ? AbortCode::none : AbortCode::value_range;
}

AbortCode DiagnosticsUnit::close_write(const Entry& /*entry*/, bool complete) {
  if (complete && written_ != 0) drop(file_length_);
  written_ = 0;
  return AbortCode::none;
}

}  // namespace canvoy::cia407
