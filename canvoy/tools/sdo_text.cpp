#include "canvoy/tools/sdo_text.hpp"

#include <fmt/format.h>

#include <array>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/text.hpp"
#include "canvoy/tools/value.hpp"

namespace canvoy::tools {

namespace {

using decoder::SdoMessage;

std::string object(const Profile& profile, sdo::Multiplexer multiplexer) {
  std::string text = object_text(multiplexer.index(), multiplexer.sub());
  const ObjectInfo* info = find_description(profile, multiplexer.index());
  if (info == nullptr) return text;
  const EntryInfo* entry = find_entry(*info, multiplexer.sub());
  if (entry == nullptr || entry->name.empty()) return fmt::format("{} {}", text, info->name);
  return fmt::format("{} {}, {}", text, info->name, entry->name);
}

std::string object_with_value(const Profile& profile, const sdo::Message& message) {
  const sdo::Multiplexer multiplexer = message.multiplexer();
  const std::string text = object(profile, multiplexer);
  if (!message.is_expedited()) {
    if (!message.has_size()) return text + ", segmented";
    return fmt::format("{}, {} bytes in segments", text, message.value());
  }
  const std::size_t size = message.has_size() ? message.expedited_size() : sdo::expedited_max;
  std::array<std::uint8_t, sdo::expedited_max> bytes{};
  store(bytes.data(), message.value());
  const ObjectInfo* info = find_description(profile, multiplexer.index());
  const EntryInfo* entry = info == nullptr ? nullptr : find_entry(*info, multiplexer.sub());
  return fmt::format("{} = {}", text, value_text(entry, std::span(bytes).first(size)));
}

const char* crc_text(const sdo::Message& message) {
  return message.has_block_crc() ? ", with CRC" : "";
}

std::string block_size_text(unsigned segments) {
  return fmt::format("{} segments a block", segments);
}

/// `block download 2050h:01h, 19 bytes, with CRC`
std::string size_text(std::string_view name, const Profile& profile, const sdo::Message& message) {
  const std::string size =
      message.has_block_size() ? fmt::format(", {} bytes", message.value()) : "";
  return fmt::format("{} {}{}{}", name, object(profile, message.multiplexer()), size,
                     crc_text(message));
}

std::string got_text(std::string_view name, const sdo::Message& message) {
  return fmt::format("{}, got segments up to {}, then {}", name, message.acknowledged(),
                     block_size_text(message.next_block_size()));
}

std::string end_text(std::string_view name, const sdo::Message& message) {
  return fmt::format("{} end, CRC {:04X}h, last segment of {} bytes", name, message.crc(),
                     sdo::segment_max - message.block_unused());
}

std::string block_upload_text(const Profile& profile, const sdo::Message& message) {
  const unsigned threshold = message.switch_threshold();
  const std::string switches =
      threshold == 0 ? "" : fmt::format(", segmented up to {} bytes", threshold);
  return fmt::format("block upload {}, {}{}{}", object(profile, message.multiplexer()),
                     block_size_text(message.block_size()), switches, crc_text(message));
}

std::string block_text(SdoMessage kind, const sdo::Message& message, const Profile& profile) {
  constexpr std::string_view upload = "block upload";
  constexpr std::string_view download = "block download";
  switch (kind) {
    case SdoMessage::block_upload:
      return block_upload_text(profile, message);
    case SdoMessage::block_upload_ready:
      return size_text(upload, profile, message);
    case SdoMessage::block_upload_start:
      return "block upload start";
    case SdoMessage::block_upload_got:
      return got_text(upload, message);
    case SdoMessage::block_upload_end:
      return end_text(upload, message);
    case SdoMessage::block_upload_done:
      return "block upload done";
    case SdoMessage::block_download:
      return size_text(download, profile, message);
    case SdoMessage::block_download_ready:
      return fmt::format("block download {}, {}{}", object(profile, message.multiplexer()),
                         block_size_text(message.block_size()), crc_text(message));
    case SdoMessage::block_download_got:
      return got_text(download, message);
    case SdoMessage::block_download_end:
      return end_text(download, message);
    case SdoMessage::block_download_done:
      return "block download done";
    case SdoMessage::block_segment:
      return fmt::format("block segment {}{}", message.sequence_number(),
                         message.is_block_last() ? ", the last" : "");
    default:
      return "unknown command";
  }
}

}  // namespace

std::string sdo_text(SdoMessage kind, const Frame& frame, const Profile& profile) {
  const sdo::Message message(frame);
  switch (kind) {
    case SdoMessage::abort:
      return fmt::format("abort {}, {}", object(profile, message.multiplexer()),
                         abort_text(message.abort_code()));
    case SdoMessage::read:
      return "read " + object(profile, message.multiplexer());
    case SdoMessage::write:
      return "write " + object_with_value(profile, message);
    case SdoMessage::value:
      return object_with_value(profile, message);
    case SdoMessage::written:
      return object(profile, message.multiplexer()) + " written";
    case SdoMessage::read_segment:
      return "read a segment";
    case SdoMessage::write_segment:
      return "write a segment";
    case SdoMessage::segment:
      return "segment";
    case SdoMessage::segment_written:
      return "segment written";
    default:
      return block_text(kind, message, profile);
  }
}

}  // namespace canvoy::tools
