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
  std::int64_t number = 0;  ///< raw
  std::string name;         ///< as the description has it
};

/// A number in some bits, the least significant one first.
struct Signal {
  /// How the bits are read.
  enum class Type : std::uint8_t { unsigned_number, signed_number, real32, real64 };
  std::uint16_t index = 0;  ///< 0: not in a dictionary
  std::uint8_t sub = 0;     ///< sub-index
  std::string name = {};    ///< for display; may contain blanks
  unsigned first_bit = 0;   ///< in the message; 0: the least significant of its first byte
  unsigned bits = 1;        ///< 1 to 64
  Type type = Type::unsigned_number;                     ///< see Type
  double factor = 1;                                     ///< amount = number * `factor` + `offset`
  double offset = 0;                                     ///< of the amount
  std::string unit = {};                                 ///< UTF-8
  std::optional<std::pair<double, double>> limits = {};  ///< of the amount
  std::vector<SignalState> states = {};                  ///< numbers with a name
  bool is_selector = false;  ///< selects which of the other signals the message has
  /// Number of the selector with which the message has this signal; nothing: always.
  std::optional<std::uint32_t> selected_by = {};
  std::string comment = {};  ///< for people; may be empty
};

/// The content of a message with one CAN-ID.
struct SignalMessage {
  std::uint32_t can_id = 0;                 ///< 11 or 29 bits
  unsigned length = 8;                      ///< bytes, 0 to 8
  std::string name = {};                    ///< for display; may contain blanks
  std::vector<std::string> senders = {};    ///< names of nodes; empty: unknown
  std::vector<std::string> receivers = {};  ///< names of nodes; empty: unknown
  std::vector<Signal> signals = {};         ///< in the order of their bits
  std::string comment = {};                 ///< for people; may be empty
};

/// An entry of a dictionary. Texts in the notation of a data sheet.
struct DictionaryLine {
  std::uint16_t index = 0;          ///< of the object
  std::uint8_t sub = 0;             ///< sub-index
  std::string name = {};            ///< of the entry
  std::string type = {};            ///< of CiA 301: `UNSIGNED16`
  std::string access = {};          ///< `ro`, `wo`, `rw`, `const`
  bool may_be_mapped = false;       ///< into a PDO
  std::string initial = {};         ///< default; empty: none
  std::string value = {};           ///< of a configured device
  std::string clause = {};          ///< `CiA 419, 7.2.3`
  std::vector<Signal> fields = {};  ///< the numbers in it; none for a text
};

/// A node, with all that its sheet or its profile says.
struct SignalNode {
  std::string name = {};                        ///< of the node; unique in the table
  std::uint8_t id = 0;                          ///< node-ID, 1 to 127
  std::string product = {};                     ///< ProductName; may be empty
  std::string profile = {};                     ///< its title; may be empty
  std::vector<DictionaryLine> dictionary = {};  ///< in the order of the indices
};

struct SignalTable {
  std::vector<SignalNode> nodes;        ///< in order of node-ID
  std::vector<SignalMessage> messages;  ///< in order of CAN-ID
};

}  // namespace canvoy::formats
