#include "canvoy/formats/signals/signal_csv.hpp"

#include <fmt/format.h>

#include <map>
#include <tuple>

namespace canvoy::formats {

namespace {

/// In the form of RFC 4180.
std::string csv_text(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string made = "\"";
  for (const char each : text) {
    if (each == '"') made += '"';
    made += each;
  }
  return made + '"';
}

/// `0 unknown; 1 ready`
std::string csv_states(const Signal& signal) {
  std::string text;
  for (const SignalState& state : signal.states) {
    if (!text.empty()) text += "; ";
    text += fmt::format("{} {}", state.number, state.name);
  }
  return text;
}

struct SignalPlace {
  const SignalMessage* message = nullptr;
  unsigned first_bit = 0;
};

/// Positions of the values of a node in the messages that it sends or receives.
class SignalPlaces {
 public:
  SignalPlaces(const SignalTable& table, const SignalNode& node) {
    for (const SignalMessage& message : table.messages) {
      for (const auto* names : {&message.senders, &message.receivers}) {
        for (const std::string& name : *names) {
          if (name == node.name) add(message);
        }
      }
    }
  }
  SignalPlace find(const Signal& field) const {
    const auto found = places_.find({field.index, field.sub, field.name});
    return found == places_.end() ? SignalPlace{} : found->second;
  }

 private:
  void add(const SignalMessage& message) {
    for (const Signal& signal : message.signals) {
      if (signal.selected_by) continue;
      places_.try_emplace({signal.index, signal.sub, signal.name},
                          SignalPlace{&message, signal.first_bit});
    }
  }
  std::map<std::tuple<std::uint16_t, std::uint8_t, std::string>, SignalPlace> places_;
};

std::string csv_number(const Signal& field, const SignalPlace& place) {
  std::string text = fmt::format("{},{},{},{},{},{},", csv_text(field.name), field.first_bit,
                                 field.bits, csv_text(field.unit), field.factor, field.offset);
  if (field.limits) text += fmt::format("{},{}", field.limits->first, field.limits->second);
  if (!field.limits) text += ',';
  text += ',' + csv_text(csv_states(field)) + ',';
  if (place.message == nullptr) return text + ",,";
  return text + fmt::format("{:03X},{},{}", place.message->can_id, csv_text(place.message->name),
                            place.first_bit);
}

}  // namespace

std::string write_signal_csv(const SignalTable& table) {
  std::string text =
      "node_id,node,index,sub,name,type,access,pdo_mapping,default,value,clause,field,first_bit,"
      "bits,"
      "unit,factor,offset,minimum,maximum,states,can_id,message,message_bit\n";
  for (const SignalNode& node : table.nodes) {
    const SignalPlaces places(table, node);
    for (const DictionaryLine& line : node.dictionary) {
      const std::string entry = fmt::format(
          "{},{},{:04X},{:02X},{},{},{},{},{},{},{},", node.id, csv_text(node.name), line.index,
          line.sub, csv_text(line.name), line.type, line.access, line.may_be_mapped ? 1 : 0,
          csv_text(line.initial), csv_text(line.value), csv_text(line.clause));
      if (line.fields.empty()) text += entry + ",,,,,,,,,,,\n";
      for (const Signal& field : line.fields)
        text += entry + csv_number(field, places.find(field)) + '\n';
    }
  }
  return text;
}

}  // namespace canvoy::formats
