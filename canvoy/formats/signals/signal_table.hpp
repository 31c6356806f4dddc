// Tables of the nodes of a bus: their dictionaries, and the bits of each message. Made from data
// sheets and profiles (canvoy/text/signal_table_maker.hpp), written as DBC, CSV and HTML
// (dbc_writer.hpp, signal_csv.hpp, signal_html.hpp).
//
//     write_text("charger.dbc", write_dbc(table));
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace canvoy::formats {

/// A raw number with a name.
struct SignalState {
  std::int64_t number = 0;
  std::string name;
};

/// A number in some bits, the least significant one first.
struct Signal {
  enum class Type : std::uint8_t { unsigned_number, signed_number, real32, real64 };
  std::uint16_t index = 0;  ///< 0: not in a dictionary
  std::uint8_t sub = 0;
  std::string name = {};  ///< for display; may contain blanks
  unsigned first_bit = 0;
  unsigned bits = 1;
  Type type = Type::unsigned_number;
  double factor = 1;  ///< amount = number * `factor` + `offset`
  double offset = 0;
  std::string unit = {};                                 ///< UTF-8
  std::optional<std::pair<double, double>> limits = {};  ///< of the amount
  std::vector<SignalState> states = {};
  bool is_selector = false;  ///< selects which of the other signals the message has
  /// Number of the selector with which the message has this signal; nothing: always.
  std::optional<std::uint32_t> selected_by = {};
  std::string comment = {};
};

/// The content of a message with one CAN-ID.
struct SignalMessage {
  std::uint32_t can_id = 0;
  unsigned length = 8;
  std::string name = {};
  std::vector<std::string> senders = {};  ///< names of nodes; empty: unknown
  std::vector<std::string> receivers = {};
  std::vector<Signal> signals = {};
  std::string comment = {};
};

/// An entry of a dictionary. Texts in the notation of a data sheet.
struct DictionaryLine {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::string name = {};
  std::string type = {};
  std::string access = {};
  bool may_be_mapped = false;
  std::string initial = {};
  std::string value = {};           ///< of a configured device
  std::string clause = {};          ///< `CiA 419, 7.2.3`
  std::vector<Signal> fields = {};  ///< the numbers in it; none for a text
};

struct SignalNode {
  std::string name = {};
  std::uint8_t id = 0;
  std::string product = {};
  std::string profile = {};
  std::vector<DictionaryLine> dictionary = {};
};

struct SignalTable {
  std::vector<SignalNode> nodes;
  std::vector<SignalMessage> messages;  ///< in order of CAN-ID
};

}  // namespace canvoy::formats
