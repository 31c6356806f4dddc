#include "canvoy/tools/ask/asked_object.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/place_json.hpp"
#include "canvoy/tools/value_argument.hpp"
#include "canvoy/words/value_text.hpp"

namespace canvoy::tools {

AskedObject::AskedObject(Session& session, NodeId node, std::string_view text, unsigned profile,
                         std::string_view type)
    : network_(session.network()),
      node_(node),
      address_(find_object_of(session, node, text, profile)),
      type_name_(type) {
  if (type.empty()) {
    known_.emplace(session, node, address_);
  } else {
    typed_ = EntryInfo{.type = parse_type_argument(type)};
  }
}

/// What the user says of the entry goes before what a profile says.
void AskedObject::check(std::span<const std::uint8_t> bytes) const {
  if (!typed_) return;
  const unsigned length = byte_length(typed_->type);
  if (length == 0 || length == bytes.size()) return;
  throw Failure(fmt::format("the node has {} bytes there, and {} has {}: hex {:02X}", bytes.size(),
                            type_name_, length, fmt::join(bytes, " ")));
}

std::string AskedObject::text(std::span<const std::uint8_t> bytes) const {
  check(bytes);
  return words::value_text(entry(), bytes);
}

void AskedObject::append_place(words::JsonLine& json) const {
  if (network_ != 0) json.key("network").number(network_);
  json.key("node").number(node_);
  append_index(json, address_.index, address_.sub);
  if (address_.entry != nullptr) json.key("name").text(name());
}

void AskedObject::append_value(words::JsonLine& json, std::string& line,
                               std::span<const std::uint8_t> bytes) const {
  check(bytes);
  json.key("raw").hex(bytes);
  json.key("value");
  words::append_value_json(line, entry(), bytes);
  if (entry() != nullptr && entry()->value.unit != Unit::none) {
    json.key("unit").text(symbol(entry()->value.unit));
  }
}

}  // namespace canvoy::tools
