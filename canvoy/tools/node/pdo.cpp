// canvoy pdo BUS NODE PDO [OBJECT=VALUE...]: sends or reads a PDO of a node with its present
// mapping (CiA 301, 7.5.2.35 to 7.5.2.38).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <deque>
#include <memory>
#include <optional>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/object_argument.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/node/ask_options.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/node/remote_object.hpp"
#include "canvoy/tools/session/sent_frame.hpp"

namespace canvoy::tools {

namespace {

struct PdoOptions : AskOptions {
  std::string pdo = {};
  std::vector<std::string> values = {};
  bool requests = false;
};

/// `rpdo1` to `tpdo512`.
struct PdoName {
  bool is_transmit = false;
  unsigned number = 1;

  unsigned parameter() const {
    const unsigned first =
        is_transmit ? object_index::tpdo_parameter : object_index::rpdo_parameter;
    return first + number - 1;
  }
  unsigned mapping() const {
    return parameter() + object_index::rpdo_mapping - object_index::rpdo_parameter;
  }
};

PdoName parse_pdo_name(const std::string& text) {
  constexpr unsigned number_max = 512;
  constexpr std::size_t word_length = 4;
  const std::string_view word = std::string_view(text).substr(0, word_length);
  const bool is_transmit = same_name(word, "tpdo");
  unsigned number = 0;
  const char* last = text.data() + text.size();
  const char* first = std::min(text.data() + word_length, last);
  const auto [end, error] = std::from_chars(first, last, number);
  const bool is_number = error == std::errc{} && end == last && number >= 1 && number <= number_max;
  if (is_number && (is_transmit || same_name(word, "rpdo"))) return {is_transmit, number};
  throw UsageError(
      fmt::format("'{}' is no PDO: write rpdo1 to rpdo512, or tpdo1 to tpdo512", text));
}

struct WantedValue {
  std::string object;
  std::string value;
};
std::vector<WantedValue> parse_wanted(const PdoOptions& options) {
  std::vector<WantedValue> wanted;
  for (const std::string& text : options.values) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos || sign == 0) {
      throw UsageError(fmt::format("'{}' is not understood: write OBJECT=VALUE", text));
    }
    wanted.push_back({text.substr(0, sign), text.substr(sign + 1)});
    check_object(wanted.back().object, options.profile);
  }
  return wanted;
}

/// The PDO as mapped in the node, and the values to put in.
class HandmadePdo {
 public:
  HandmadePdo(Session& session, NodeId node, const PdoName& name, const ProfileChoice& profile)
      : session_(session), node_(node), name_(name), profile_(profile) {
    const CobId cob_id{static_cast<std::uint32_t>(number(name.parameter(), 1))};
    if (!cob_id.valid()) {
      throw Failure(fmt::format("{}: its {:04X}h:01h says that this PDO is not used",
                                text::node_text(node), name.parameter()));
    }
    can_id_ = cob_id.can_id();
    const auto count = static_cast<unsigned>(number(name.mapping(), 0));
    constexpr unsigned count_max = 64;
    if (count > count_max) throw Failure("a multiplexed PDO cannot be made by hand");
    for (unsigned sub = 1; sub <= count; ++sub)
      add(static_cast<std::uint32_t>(number(name.mapping(), sub)));
  }

  void put(const WantedValue& wanted) {
    const ObjectAddress address = find_object_of(session_, node_, wanted.object, profile_);
    for (Part& part : parts_) {
      if (part.mapped.index != address.index || part.mapped.sub != address.sub) continue;
      const EntryInfo* entry = part.object ? part.object->entry() : nullptr;
      part.bytes = parse_value(entry == nullptr ? entry_of(part.mapped) : *entry, wanted.value,
                               present(part));
      return;
    }
    std::vector<std::string> names;
    for (const Part& part : parts_) {
      if (part.object) names.push_back(part.object->name());
    }
    throw UsageError(fmt::format("'{}' is not in this PDO, which has {}", wanted.object,
                                 fmt::join(names, "; ")));
  }

  Frame request() const {
    return Frame::remote_frame(can_id_, static_cast<std::uint8_t>((bits_ + 7) / 8));
  }
  /// Entries without a given value keep that of the node.
  Frame frame() {
    std::uint64_t whole = 0;
    unsigned first = 0;
    for (Part& part : parts_) {
      if (part.bytes.empty() && part.object) part.bytes = part.object->read(session_);
      const std::uint64_t value = number_in(part.bytes);
      const BitRange range{static_cast<std::uint8_t>(first), part.mapped.bits, false};
      whole = insert(whole, range, static_cast<std::int64_t>(value));
      first += part.mapped.bits;
    }
    std::array<std::uint8_t, 8> bytes{};
    store(bytes.data(), whole);
    return Frame::data_frame(can_id_, std::span(bytes).first((bits_ + 7) / 8));
  }
  std::string text(const Frame& frame) const {
    std::vector<std::string> values;
    for (const Part& part : parts_) {
      if (!part.object) continue;
      values.push_back(fmt::format("{} = {}", part.object->name(), part.object->text(part.bytes)));
    }
    return fmt::format("{}  {}", FrameText(frame).view(), fmt::join(values, ", "));
  }

 private:
  struct Part {
    MappingValue mapped;
    std::optional<RemoteObject> object;  ///< nothing: unused bits
    std::vector<std::uint8_t> bytes = {};
  };

  /// Value of fields that are not given: the earlier one, or that of the node, if it is readable.
  std::uint64_t present(const Part& part) {
    const bool has_fields =
        part.object && part.object->entry() != nullptr && !part.object->entry()->fields.empty();
    if (!has_fields) return 0;
    if (!part.bytes.empty()) return number_in(part.bytes);
    const auto held = session_.try_read(node_, part.mapped.index, part.mapped.sub);
    return held ? number_in(*held) : 0;
  }
  static std::uint64_t number_in(std::span<const std::uint8_t> bytes) {
    return bytes.size() > sizeof(std::uint64_t) ? 0 : load_unsigned(bytes);
  }
  std::uint64_t number(unsigned index, unsigned sub) {
    return number_in(
        session_.read(node_, static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub)));
  }
  void add(std::uint32_t raw) {
    const MappingValue mapped(raw);
    bits_ += mapped.bits;
    if (bits_ > pdo_bits_max) throw Failure("the node maps more than 64 bits into this PDO");
    Part& part = parts_.emplace_back(Part{mapped, std::nullopt});
    if (mapped.is_dummy()) return;
    part.object.emplace(session_, node_, fmt::format("{:04X}:{:02X}", mapped.index, mapped.sub),
                        profile_);
  }
  /// For an undescribed object: the number of bits.
  static EntryInfo entry_of(const MappingValue& mapped) {
    using enum DataType;
    constexpr std::array types = {unsigned8,  unsigned16, unsigned24, unsigned32,
                                  unsigned40, unsigned48, unsigned56, unsigned64};
    return EntryInfo{.type = types.at(mapped.bits == 0 ? 0 : (mapped.bits - 1U) / 8)};
  }

  Session& session_;
  NodeId node_;
  PdoName name_;
  ProfileChoice profile_;
  std::uint32_t can_id_ = 0;
  unsigned bits_ = 0;
  std::deque<Part> parts_;
};

int send_pdo(const PdoOptions& options, Sessions& sessions) {
  const NodeId node = options.node_id();
  const PdoName name = parse_pdo_name(options.pdo);
  const std::vector<WantedValue> wanted = parse_wanted(options);
  if (options.requests && !(name.is_transmit && wanted.empty())) {
    throw UsageError("--request asks for a TPDO, and has no values");
  }
  Session& session = options.open(sessions);
  HandmadePdo pdo(session, node, name, options.profile);
  for (const WantedValue& each : wanted) pdo.put(each);
  const Frame frame = options.requests ? pdo.request() : pdo.frame();
  session.send(frame);
  if (options.json) {
    print_sent(session, frame);
  } else if (options.requests) {
    fmt::print("{}\n", FrameText(frame).view());
  } else {
    fmt::print("{}\n", pdo.text(frame));
  }
  return exit_done;
}

}  // namespace

void add_pdo(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<PdoOptions>();
  Verb& command = app.add_verb(
      "pdo", "Send a PDO to a node, or in its name, with values as the node maps them");
  options->add_bus(command);
  options->add_node(command);
  command.add({
      {"pdo", options->pdo, "rpdo1: to the node; tpdo1: in its name", required},
      {"value", options->values, "OBJECT=VALUE of what is mapped (default: as the node has it)"},
      {"--request", options->requests, "ask for a TPDO by a remote frame"},
  });
  options->add_profile(command);
  options->add_time_out(command);
  options->add_json(command);
  command.add_examples(
      "  canvoy pdo can0 5 rpdo2 battery_status=ready battery_temperature='21.5 degC'\n"
      "  canvoy pdo can0 10 tpdo1\n"
      "  canvoy pdo can0 10 tpdo1 --request --json");
  command.runs([options, &sessions] { return send_pdo(*options, sessions); });
}

}  // namespace canvoy::tools
