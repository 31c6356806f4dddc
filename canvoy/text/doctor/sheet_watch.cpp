#include "canvoy/text/doctor/sheet_watch.hpp"

#include <fmt/format.h>

#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

/// Entries that are equal in all devices of a kind: the device type, the identity except for the
/// serial number, and constants of the sheet.
bool is_fixed(std::uint16_t index, std::uint8_t sub, const formats::SheetEntry& entry) {
  constexpr std::uint8_t serial_number = 4;
  if (index == object_index::device_type) return true;
  if (index == object_index::identity) return sub < serial_number;
  return entry.access == "const";
}

std::optional<std::int64_t> said(const formats::SheetEntry& entry, NodeId node) {
  const auto number =
      formats::sheet_number(entry.value.empty() ? entry.default_value : entry.value);
  return number ? std::optional(number->at(node)) : std::nullopt;
}

}  // namespace

void SheetWatch::tell(NodeId node, const formats::DataSheet& sheet, KnownParameters& known) {
  // The heartbeat period is chosen for each network: a default gives no information on this one.
  const auto learn = [&](std::uint16_t index, std::uint8_t sub, const formats::SheetEntry& entry) {
    const bool is_heartbeat =
        index == object_index::heartbeat_producer || index == object_index::heartbeat_consumers;
    if (is_heartbeat && entry.value.empty()) return;
    if (const auto number = said(entry, node)) {
      known.learn(node, index, sub, static_cast<std::uint32_t>(*number));
    }
  };
  for (const auto& [index, object] : sheet.objects) {
    if (object.is_variable()) learn(index, 0, object.own);
    for (const auto& [sub, entry] : object.subs) learn(index, sub, entry);
  }
}

void SheetWatch::hear(Time at, const Frame& frame, const decoder::Decoded& decoded) {
  if (sheets_.empty() || decoded.service != decoder::Decoded::Service::sdo_response) return;
  const auto found = sheets_.find(decoded.node);
  if (found == sheets_.end() || decoded.behind.node != 0) return;
  if (decoded.message == decoder::SdoMessage::abort) {
    return refused(at, decoded.node, *found->second, frame);
  }
  const bool is_read = decoded.transfer != nullptr && !decoded.transfer->is_write;
  if (is_read) compare(at, decoded.node, *found->second, *decoded.transfer);
}

void SheetWatch::compare(Time at, NodeId node, const formats::DataSheet& sheet,
                         const decoder::SdoTransfer& transfer) {
  const formats::SheetEntry* entry = sheet.find(transfer.index, transfer.sub);
  const std::string place = object_text(transfer.index, transfer.sub);
  if (entry == nullptr) {
    return differs(at, node, transfer.index, transfer.sub,
                   fmt::format("{} is in the device, and not in the sheet", place));
  }
  const std::size_t length = byte_length(static_cast<DataType>(entry->data_type));
  if (length != 0 && length != transfer.size) {
    return differs(
        at, node, transfer.index, transfer.sub,
        fmt::format("{} has {} bytes, and by the sheet {}", place, transfer.size, length));
  }
  const auto wanted = said(*entry, node);
  if (!wanted || length == 0 || length > sizeof(std::uint64_t)) return;
  if (!is_fixed(transfer.index, transfer.sub, *entry)) return;
  const std::uint64_t is = load_unsigned(transfer.bytes);
  const std::uint64_t mask = length == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << length * 8) - 1;
  const std::uint64_t should_be = static_cast<std::uint64_t>(*wanted) & mask;
  if (is == should_be) return;
  const auto digits = static_cast<int>(2 * length);
  differs(at, node, transfer.index, transfer.sub,
          fmt::format("{} is {:0{}X}h, and by the sheet {:0{}X}h", place, is, digits, should_be,
                      digits));
}

void SheetWatch::refused(Time at, NodeId node, const formats::DataSheet& sheet,
                         const Frame& frame) {
  const sdo::Message message(frame);
  if (!is_absent(static_cast<AbortCode>(message.value()))) return;
  const std::uint16_t index = message.multiplexer().index();
  const std::uint8_t sub = message.multiplexer().sub();
  if (sheet.find(index, sub) == nullptr) return;
  differs(at, node, index, sub,
          fmt::format("{} is in the sheet, and not in the device", object_text(index, sub)));
}

void SheetWatch::differs(Time at, NodeId node, std::uint16_t index, std::uint8_t sub,
                         std::string text) {
  constexpr std::size_t differences_max = 1024;
  const std::tuple key(node, index, sub);
  if (differences_.size() == differences_max && !differences_.contains(key)) return;
  Difference& difference = differences_[key];
  difference.text = std::move(text);
  difference.tally.add(at);
}

}  // namespace canvoy::text
