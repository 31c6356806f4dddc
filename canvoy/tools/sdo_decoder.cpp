#include "canvoy/tools/sdo_decoder.hpp"

#include <fmt/format.h>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/text.hpp"
#include "canvoy/tools/value.hpp"

namespace canvoy::tools {

namespace {

/// What the lower bits of the first byte say in a block transfer.
enum class BlockUpload : std::uint8_t { initiate = 0, end = 1, response = 2, start = 3 };
enum class BlockDownload : std::uint8_t { initiate = 0, end = 1, response = 2 };

constexpr unsigned subcommand_mask = 0x03;
constexpr unsigned size_flag = 0x02;
constexpr unsigned crc_flag = 0x04;
constexpr unsigned last_segment = 0x80;
constexpr unsigned sequence_mask = 0x7F;

std::uint8_t byte_at(const sdo::Message& message, unsigned position) {
  return message.frame(0).data.at(position);
}

const char* crc_text(const sdo::Message& message) {
  return (message.first_byte() & crc_flag) != 0 ? ", with CRC" : "";
}

std::string end_text(std::string_view transfer, const sdo::Message& message) {
  const unsigned unused = message.first_byte() >> 2 & 0x07U;
  const unsigned crc = byte_at(message, 1) | unsigned{byte_at(message, 2)} << 8;
  return fmt::format("{} end, CRC {:04X}h, last segment of {} bytes", transfer, crc,
                     sdo::segment_max - unused);
}

std::string block_size_text(unsigned segments) {
  return fmt::format("{} segments a block", segments);
}

}  // namespace

std::string SdoDecoder::request(const Frame& frame, NodeId node, std::uint16_t channel_id) {
  const sdo::Message message(frame);
  Channel& channel = channel_of(node, channel_id);
  const bool is_abort = message.first_byte() == sdo::command(sdo::Request::abort);
  if (is_abort) return abort(channel, node, message);
  if (channel.sender == Sender::client) return block_segment(channel, message);
  if (message.request() != sdo::Request::block_upload) channel = {};
  switch (message.request()) {
    case sdo::Request::initiate_upload:
      return "read " + object(node, message.multiplexer());
    case sdo::Request::initiate_download:
      return "write " + object_with_value(node, message);
    case sdo::Request::download_segment:
      return "write a segment";
    case sdo::Request::upload_segment:
      return "read a segment";
    case sdo::Request::abort:
      return abort(channel, node, message);
    case sdo::Request::block_upload:
      return block_upload_request(channel, node, message);
    case sdo::Request::block_download:
      return block_download_request(node, message);
  }
  return "unknown command";
}

std::string SdoDecoder::response(const Frame& frame, NodeId node, std::uint16_t channel_id) {
  const sdo::Message message(frame);
  Channel& channel = channel_of(node, channel_id);
  const bool is_abort = message.first_byte() == sdo::command(sdo::Request::abort);
  if (is_abort) return abort(channel, node, message);
  if (channel.sender == Sender::server) return block_segment(channel, message);
  if (message.response() != sdo::Response::block_download) channel = {};
  switch (message.response()) {
    case sdo::Response::initiate_upload:
      return object_with_value(node, message);
    case sdo::Response::initiate_download:
      return object(node, message.multiplexer()) + " written";
    case sdo::Response::download_segment:
      return "segment written";
    case sdo::Response::upload_segment:
      return "segment";
    case sdo::Response::abort:
      return abort(channel, node, message);
    case sdo::Response::block_upload:
      return block_upload_response(node, message);
    case sdo::Response::block_download:
      return block_download_response(channel, node, message);
  }
  return "unknown command";
}

// Block transfer

std::string SdoDecoder::block_segment(Channel& channel, const sdo::Message& message) {
  const unsigned number = message.first_byte() & sequence_mask;
  const bool last = (message.first_byte() & last_segment) != 0;
  if (last) channel.last = static_cast<std::uint8_t>(number);
  return fmt::format("block segment {}{}", number, last ? ", the last" : "");
}

std::string SdoDecoder::block_upload_request(Channel& channel, NodeId node,
                                             const sdo::Message& message) {
  switch (static_cast<BlockUpload>(message.first_byte() & subcommand_mask)) {
    case BlockUpload::initiate: {
      channel = {};
      const unsigned threshold = byte_at(message, 5);
      const std::string switches =
          threshold == 0 ? "" : fmt::format(", segmented up to {} bytes", threshold);
      return fmt::format("block upload {}, {}{}{}", object(node, message.multiplexer()),
                         block_size_text(byte_at(message, 4)), switches, crc_text(message));
    }
    case BlockUpload::start:
      channel = {.sender = Sender::server};
      return "block upload start";
    case BlockUpload::response: {
      const unsigned number = byte_at(message, 1);
      if (channel.last != 0 && number == channel.last) channel.sender = Sender::nobody;
      channel.last = 0;
      return fmt::format("block upload, got segments up to {}, then {}", number,
                         block_size_text(byte_at(message, 2)));
    }
    case BlockUpload::end:
      break;
  }
  channel = {};
  return "block upload done";
}

std::string SdoDecoder::block_upload_response(NodeId node, const sdo::Message& message) {
  const bool ends = (message.first_byte() & 0x01U) != 0;
  if (ends) return end_text("block upload", message);
  const bool has_size = (message.first_byte() & size_flag) != 0;
  const std::string size = has_size ? fmt::format(", {} bytes", message.value()) : "";
  return fmt::format("block upload {}{}{}", object(node, message.multiplexer()), size,
                     crc_text(message));
}

std::string SdoDecoder::block_download_request(NodeId node, const sdo::Message& message) {
  const bool ends = (message.first_byte() & 0x01U) != 0;
  if (ends) return end_text("block download", message);
  const bool has_size = (message.first_byte() & size_flag) != 0;
  const std::string size = has_size ? fmt::format(", {} bytes", message.value()) : "";
  return fmt::format("block download {}{}{}", object(node, message.multiplexer()), size,
                     crc_text(message));
}

std::string SdoDecoder::block_download_response(Channel& channel, NodeId node,
                                                const sdo::Message& message) {
  switch (static_cast<BlockDownload>(message.first_byte() & subcommand_mask)) {
    case BlockDownload::initiate:
      channel = {.sender = Sender::client};
      return fmt::format("block download {}, {}{}", object(node, message.multiplexer()),
                         block_size_text(byte_at(message, 4)), crc_text(message));
    case BlockDownload::response: {
      const unsigned number = byte_at(message, 1);
      if (channel.last != 0 && number == channel.last) channel.sender = Sender::nobody;
      channel.last = 0;
      return fmt::format("block download, got segments up to {}, then {}", number,
                         block_size_text(byte_at(message, 2)));
    }
    case BlockDownload::end:
      channel = {};
      return "block download done";
  }
  channel = {};
  return "unknown command";
}

// Objects

std::string SdoDecoder::abort(Channel& channel, NodeId node, const sdo::Message& message) const {
  channel = {};
  return fmt::format("abort {}, {}", object(node, message.multiplexer()),
                     abort_text(message.abort_code()));
}

std::string SdoDecoder::object(NodeId node, sdo::Multiplexer multiplexer) const {
  std::string text = object_text(multiplexer.index(), multiplexer.sub());
  const ObjectInfo* info = find_description(network_->profile(node), multiplexer.index());
  if (info == nullptr) return text;
  const EntryInfo* entry = find_entry(*info, multiplexer.sub());
  if (entry == nullptr || entry->name.empty()) return fmt::format("{} {}", text, info->name);
  return fmt::format("{} {}, {}", text, info->name, entry->name);
}

std::string SdoDecoder::object_with_value(NodeId node, sdo::Message message) {
  const sdo::Multiplexer multiplexer = message.multiplexer();
  const std::string text = object(node, multiplexer);
  if (!message.is_expedited()) {
    if (!message.has_size()) return text + ", segmented";
    return fmt::format("{}, {} bytes in segments", text, message.value());
  }
  const std::size_t size = message.has_size() ? message.expedited_size() : sdo::expedited_max;
  std::array<std::uint8_t, sdo::expedited_max> bytes{};
  store(bytes.data(), message.value());
  const ObjectInfo* info = find_description(network_->profile(node), multiplexer.index());
  const EntryInfo* entry = info == nullptr ? nullptr : find_entry(*info, multiplexer.sub());
  return fmt::format("{} = {}", text, value_text(entry, std::span(bytes).first(size)));
}

}  // namespace canvoy::tools
