#include "canvoy/formats/signals/dbc_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace canvoy::formats {

namespace {

/// Limit of the tools for this format.
constexpr std::size_t dbc_name_max = 32;
/// Stands for an unknown node.
constexpr const char* nobody = "Vector__XXX";

/// Converts UTF-8 to ISO 8859-1; other characters are spelled out.
std::string latin1(std::string_view text) {
  static const std::map<std::string_view, std::string_view> written_out = {
      {"\xCE\xA9", "Ohm"}, {"\xE2\x80\xB0", "1/1000"}};
  std::string made;
  for (std::size_t at = 0; at < text.size();) {
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    const std::string_view character = text.substr(at, length);
    at += length;
    const auto known = written_out.find(character);
    if (known != written_out.end()) {
      made += known->second;
    } else if (length == 1) {
      made += character;
    } else if (length == 2 && first <= 0xC3 && character.size() == 2) {
      made +=
          static_cast<char>((first & 3U) << 6 | (static_cast<unsigned char>(character[1]) & 0x3FU));
    } else {
      made += '?';
    }
  }
  return made;
}

/// A text of a DBC cannot contain a quotation mark.
std::string dbc_text(std::string_view text) {
  std::string made = latin1(text);
  std::ranges::replace(made, '"', '\'');
  std::ranges::replace(made, '\\', '/');
  return '"' + made + '"';
}

/// Names of one kind, made unique.
class DbcNames {
 public:
  /// The name in at most 32 characters, unique; `full` if it is longer.
  std::string take(std::string_view name, std::string_view distinction = {}) {
    std::string full = identifier_of(name);
    if (full_.contains(full) && !distinction.empty()) {
      full = identifier_of(fmt::format("{}_{}", full, distinction));
    }
    for (unsigned i = 2; full_.contains(full); ++i)
      full = fmt::format("{}_{}", identifier_of(name), i);
    full_.insert(full);
    std::string made = full.substr(0, dbc_name_max);
    for (unsigned i = 1; used_.contains(made); ++i) {
      const std::string number = fmt::format("_{}", i);
      made = full.substr(0, std::min(full.size(), dbc_name_max - number.size())) + number;
    }
    used_.insert(made);
    last_full_ = std::move(full);
    return made;
  }
  const std::string& last_full() const { return last_full_; }

 private:
  std::set<std::string> full_;
  std::set<std::string> used_;
  std::string last_full_;
};

class DbcWriter {
 public:
  explicit DbcWriter(const SignalTable& table) : table_(table) {}

  std::string write() {
    text_ = "VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_:";
    for (const SignalNode& node : table_.nodes) add_node(node);
    text_ += "\n\n";
    for (const SignalMessage& message : table_.messages) add_message(message);
    text_ += senders_ + '\n' + comments_ + '\n';
    for (const auto& [kind, part] :
         {std::pair{"BU_", "Node"}, {"BO_", "Message"}, {"SG_", "Signal"}}) {
      text_ += fmt::format("BA_DEF_ {} \"System{}LongSymbol\" STRING ;\n", kind, part);
    }
    for (const char* part : {"Node", "Message", "Signal"}) {
      text_ += fmt::format("BA_DEF_DEF_ \"System{}LongSymbol\" \"\";\n", part);
    }
    return text_ + long_names_ + '\n' + states_ + types_;
  }

 private:
  void add_node(const SignalNode& node) {
    const std::string name = node_names_.take(node.name);
    nodes_[node.name] = name;
    text_ += ' ' + name;
    if (name != node_names_.last_full())
      add_long_name("Node", "BU_ " + name, node_names_.last_full());
    const std::string comment = fmt::format("node-ID {}, {}", node.id, node.product);
    comments_ += fmt::format("CM_ BU_ {} {};\n", name, dbc_text(comment));
  }

  void add_long_name(const char* part, const std::string& place, const std::string& full) {
    long_names_ += fmt::format("BA_ \"System{}LongSymbol\" {} \"{}\";\n", part, place, full);
  }

  std::string node_of(const std::vector<std::string>& names) const {
    const auto found = names.empty() ? nodes_.end() : nodes_.find(names.front());
    return found == nodes_.end() ? nobody : found->second;
  }

  void add_message(const SignalMessage& message) {
    const std::string name =
        message_names_.take(message.name, fmt::format("{:03X}", message.can_id));
    text_ += fmt::format("BO_ {} {}: {} {}\n", message.can_id, name, message.length,
                         node_of(message.senders));
    if (name != message_names_.last_full()) {
      add_long_name("Message", fmt::format("BO_ {}", message.can_id), message_names_.last_full());
    }
    if (message.senders.size() > 1) add_senders(message);
    if (!message.comment.empty()) {
      comments_ += fmt::format("CM_ BO_ {} {};\n", message.can_id, dbc_text(message.comment));
    }
    std::string receivers;
    for (const std::string& receiver : message.receivers) {
      receivers += (receivers.empty() ? "" : ",") + node_of({receiver});
    }
    if (receivers.empty()) receivers = nobody;
    DbcNames names;
    for (const Signal& signal : message.signals) add_signal(message, signal, names, receivers);
    text_ += '\n';
  }

  void add_senders(const SignalMessage& message) {
    std::string names;
    for (const std::string& sender : message.senders) {
      names += (names.empty() ? "" : ",") + node_of({sender});
    }
    senders_ += fmt::format("BO_TX_BU_ {} : {};\n", message.can_id, names);
  }

  void add_signal(const SignalMessage& message, const Signal& signal, DbcNames& names,
                  const std::string& receivers) {
    const std::string name =
        names.take(signal.name, fmt::format("{:04X}_{:02X}", signal.index, signal.sub));
    std::string selection = signal.is_selector ? " M" : "";
    if (signal.selected_by) selection = fmt::format(" m{}", *signal.selected_by);
    const auto limits = signal.limits.value_or(std::pair{0.0, 0.0});
    text_ += fmt::format(
        " SG_ {}{} : {}|{}@1{} ({},{}) [{}|{}] {} {}\n", name, selection, signal.first_bit,
        signal.bits, signal.type == Signal::Type::unsigned_number ? '+' : '-', signal.factor,
        signal.offset, limits.first, limits.second, dbc_text(signal.unit), receivers);
    const std::string place = fmt::format("{} {}", message.can_id, name);
    if (name != names.last_full()) add_long_name("Signal", "SG_ " + place, names.last_full());
    if (!signal.comment.empty()) {
      comments_ += fmt::format("CM_ SG_ {} {};\n", place, dbc_text(signal.comment));
    }
    if (!signal.states.empty()) {
      states_ += "VAL_ " + place;
      for (const SignalState& state : signal.states) {
        states_ += fmt::format(" {} {}", state.number, dbc_text(state.name));
      }
      states_ += " ;\n";
    }
    if (signal.type == Signal::Type::real32) types_ += fmt::format("SIG_VALTYPE_ {} : 1;\n", place);
    if (signal.type == Signal::Type::real64) types_ += fmt::format("SIG_VALTYPE_ {} : 2;\n", place);
  }

  const SignalTable& table_;
  DbcNames node_names_;
  DbcNames message_names_;
  std::map<std::string, std::string> nodes_;
  // Parts of the file, in order.
  std::string text_;
  std::string senders_;
  std::string comments_;
  std::string long_names_;
  std::string states_;
  std::string types_;
};

}  // namespace

std::string identifier_of(std::string_view name) {
  std::string made;
  for (const char each : name) {
    const bool is_kept = (each >= 'a' && each <= 'z') || (each >= 'A' && each <= 'Z') ||
                         (each >= '0' && each <= '9');
    if (is_kept) {
      made += each;
    } else if (!made.empty() && made.back() != '_') {
      made += '_';
    }
  }
  while (!made.empty() && made.back() == '_') made.pop_back();
  const bool is_number = !made.empty() && made.front() >= '0' && made.front() <= '9';
  return made.empty() || is_number ? '_' + made : made;
}

std::string write_dbc(const SignalTable& table) {
  return DbcWriter(table).write();
}

}  // namespace canvoy::formats
