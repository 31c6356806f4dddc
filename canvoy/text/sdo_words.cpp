#include "canvoy/text/sdo_words.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/value_text.hpp"

namespace canvoy::text {

namespace {

using decoder::SdoMessage;

void append_number(std::string& text, std::uint64_t number) {
  std::array<char, 20> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), end);
}

std::string object_words(const Profile& profile, sdo::Multiplexer multiplexer) {
  std::string text = object_text(multiplexer.index(), multiplexer.sub());
  const ObjectInfo* info = find_description(profile, multiplexer.index());
  if (info == nullptr) return text;
  const std::string name = formats::object_name(profile, *info, multiplexer.index());
  const EntryInfo* entry = find_entry(*info, multiplexer.sub());
  if (entry == nullptr || entry->name.empty()) return fmt::format("{} {}", text, name);
  return fmt::format("{} {}, {}", text, name,
                     formats::entry_name(*info, *entry, multiplexer.sub()));
}

const char* crc_text(const sdo::Message& message) {
  return message.has_block_crc() ? ", with CRC" : "";
}

/// `, 2 segments a block`
void append_block_size(std::string& text, unsigned segments) {
  text += ", ";
  append_number(text, segments);
  text += " segments a block";
}

/// `block upload, got segments up to 2, then 127 segments a block`
void append_got(std::string& text, std::string_view name, const sdo::Message& message) {
  fmt::format_to(std::back_inserter(text), "{}, got segments up to {}, then {} segments a block",
                 name, message.acknowledged(), message.next_block_size());
}

void append_end(std::string& text, std::string_view name, const sdo::Message& message) {
  fmt::format_to(std::back_inserter(text), "{} end, CRC {:04X}h, last segment of {} bytes", name,
                 message.crc(), sdo::segment_max - message.block_unused());
}

/// `, 19 bytes, with CRC`
void append_size(std::string& text, const sdo::Message& message) {
  if (message.has_block_size()) {
    text += ", ";
    append_number(text, message.value());
    text += " bytes";
  }
  text += crc_text(message);
}

void append_switch(std::string& text, const sdo::Message& message) {
  append_block_size(text, message.block_size());
  const unsigned threshold = message.switch_threshold();
  if (threshold != 0) {
    text += ", segmented up to ";
    append_number(text, threshold);
    text += " bytes";
  }
  text += crc_text(message);
}

void append_block_segment(std::string& text, const sdo::Message& message) {
  text += "block segment ";
  append_number(text, message.sequence_number());
  if (message.is_block_last()) text += ", the last";
}

std::string_view short_text(SdoMessage kind) {
  switch (kind) {
    case SdoMessage::read_segment:
      return "read a segment";
    case SdoMessage::write_segment:
      return "write a segment";
    case SdoMessage::segment:
      return "segment";
    case SdoMessage::segment_written:
      return "segment written";
    case SdoMessage::block_upload_start:
      return "block upload start";
    case SdoMessage::block_upload_done:
      return "block upload done";
    case SdoMessage::block_download_done:
      return "block download done";
    default:
      return "unknown command";
  }
}

}  // namespace

const SdoWords::Object& SdoWords::object(const Profile& profile, sdo::Multiplexer multiplexer) {
  return objects_.at(profile, multiplexer, [&] {
    const ObjectInfo* info = find_description(profile, multiplexer.index());
    return Object{.entry = info == nullptr ? nullptr : find_entry(*info, multiplexer.sub()),
                  .text = object_words(profile, multiplexer)};
  });
}

void SdoWords::append_object(std::string& text, std::string_view front, const sdo::Message& message,
                             const Profile& profile) {
  text += front;
  text += object(profile, message.multiplexer()).text;
}

/// With the value, or with the size of a segmented transfer.
void SdoWords::append_initiate(std::string& text, const sdo::Message& message,
                               decoder::Network& network, NodeId server, const Profile& profile) {
  const Object& known = object(profile, message.multiplexer());
  text += known.text;
  if (message.is_expedited()) {
    const std::size_t size = message.has_size() ? message.expedited_size() : sdo::expedited_max;
    std::array<std::uint8_t, sdo::expedited_max> bytes{};
    store(bytes.data(), message.value());
    text += " = ";
    const sdo::Multiplexer place = message.multiplexer();
    const EntryInfo* entry =
        network.as_told(server, profile, known.entry, place.index(), place.sub());
    const std::span value = std::span(bytes).first(size);
    if (entry != known.entry) return append_value_text(text, entry, value);
    return values_.append(text, entry, value);
  }
  text += ", ";
  if (!message.has_size()) {
    text += "segmented";
    return;
  }
  append_number(text, message.value());
  text += " bytes in segments";
}

void SdoWords::append_block(std::string& text, SdoMessage kind, const sdo::Message& message,
                            const Profile& profile) {
  constexpr std::string_view upload = "block upload";
  constexpr std::string_view download = "block download";
  switch (kind) {
    case SdoMessage::block_upload:
      append_object(text, "block upload ", message, profile);
      return append_switch(text, message);
    case SdoMessage::block_upload_ready:
      append_object(text, "block upload ", message, profile);
      return append_size(text, message);
    case SdoMessage::block_upload_got:
      return append_got(text, upload, message);
    case SdoMessage::block_upload_end:
      return append_end(text, upload, message);
    case SdoMessage::block_download:
      append_object(text, "block download ", message, profile);
      return append_size(text, message);
    case SdoMessage::block_download_ready:
      append_object(text, "block download ", message, profile);
      append_block_size(text, message.block_size());
      text += crc_text(message);
      return;
    case SdoMessage::block_download_got:
      return append_got(text, download, message);
    case SdoMessage::block_download_end:
      return append_end(text, download, message);
    case SdoMessage::block_segment:
      return append_block_segment(text, message);
    default:
      text += short_text(kind);
  }
}

void SdoWords::append(std::string& text, SdoMessage kind, const Frame& frame,
                      decoder::Network& network, NodeId server, decoder::SdoBehind behind) {
  if (behind.node != 0) {
    fmt::format_to(std::back_inserter(text), "{} of network {}: ", node_text(behind.node),
                   behind.network);
  }
  const Profile& profile = behind.node == 0 ? network.profile(server) : cia301::profile;
  const sdo::Message message(frame);
  switch (kind) {
    case SdoMessage::abort:
      append_object(text, "abort ", message, profile);
      text.append(", ").append(abort_text(message.abort_code()));
      return;
    case SdoMessage::read:
      return append_object(text, "read ", message, profile);
    case SdoMessage::write:
      text += "write ";
      return append_initiate(text, message, network, server, profile);
    case SdoMessage::value:
      return append_initiate(text, message, network, server, profile);
    case SdoMessage::indication:
      text += "the next transfer";
      return;
    case SdoMessage::written:
      append_object(text, "", message, profile);
      text += " written";
      return;
    default:
      return append_block(text, kind, message, profile);
  }
}

void SdoWords::append_transfer(std::string& text, const decoder::SdoTransfer& transfer,
                               const decoder::DecodedValue& value) {
  text += transfer.is_write ? "written " : "read ";
  text += object(*value.profile, {transfer.index, transfer.sub}).text;
  text += " = ";
  values_.append(text, value);
  if (transfer.size > transfer.bytes.size()) {
    fmt::format_to(std::back_inserter(text), " ... ({} bytes)", transfer.size);
  }
}

}  // namespace canvoy::text
