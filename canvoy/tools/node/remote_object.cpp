#include "canvoy/tools/node/remote_object.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/place_json.hpp"

namespace canvoy::tools {

RemoteObject::RemoteObject(Session& session, NodeId node, std::string_view text,
                           const ProfileChoice& profile, std::string_view type)
    : network_(session.network()),
      node_(node),
      address_(find_object_of(session, node, text, profile)),
      type_name_(type) {
  if (type.empty()) {
    known_.emplace(session, node, address_, profile);
  } else {
    typed_ = EntryInfo{.type = parse_type_argument(type)};
  }
}

/// The type given by the user takes precedence over the profile.
void RemoteObject::check(std::span<const std::uint8_t> bytes) const {
  if (!typed_) return;
  const unsigned length = byte_length(typed_->type);
  if (length == 0 || length == bytes.size()) return;
  throw Failure(fmt::format("the node has {} bytes there, and {} has {}: hex {:02X}", bytes.size(),
                            type_name_, length, fmt::join(bytes, " ")));
}

std::string RemoteObject::text(std::span<const std::uint8_t> bytes) const {
  check(bytes);
  return text::value_text(entry(), bytes);
}

void RemoteObject::append_place(text::JsonLine& json) const {
  if (network_ != 0) json.key("network").number(network_);
  json.key("node").number(node_);
  append_index(json, address_.index, address_.sub);
  if (address_.entry != nullptr) json.key("name").text(name());
}

void RemoteObject::append_value(text::JsonLine& json, std::string& line,
                                std::span<const std::uint8_t> bytes) const {
  check(bytes);
  json.key("raw").hex(bytes);
  json.key("value");
  text::append_value_json(line, entry(), bytes);
  if (entry() != nullptr && entry()->value.unit != Unit::none) {
    json.key("unit").text(symbol(entry()->value.unit));
  }
}

}  // namespace canvoy::tools
