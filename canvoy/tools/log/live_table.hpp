// What was said last, a row for each object, frame or node: with its value, its age, and how often
// it comes. A frame costs a look-up and a comparison for each value; texts are made when they are
// shown.
//
//     LiveTable table(LiveTable::By::object);
//     table.take(now, "can0", frame, words);
//     for (const std::string& line : table.lines({.now = now, .columns = 80, .rows = 20}))
//     show(line);
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/words/frame_decoder.hpp"

namespace canvoy::tools {

class LiveTable {
 public:
  enum class By : std::uint8_t { object, frame, node };
  enum class Sort : std::uint8_t { place, name, age, rate, change };
  static constexpr unsigned sort_count = 5;

  struct View {
    Duration now{};
    std::size_t columns = 80;
    std::size_t rows = 24;  ///< of the table, its head included
    std::size_t first = 0;  ///< row that is shown first
    Sort sort = Sort::place;
    bool is_reversed = false;
    std::string search = {};  ///< a part of a row's name, object or value, in any case
    bool has_marks = false;   ///< what has changed is shown in reverse
  };

  explicit LiveTable(By by) : by_(by) {}

  void take(Duration time, std::string_view bus, const Frame& frame,
            const words::FrameWords& words);

  /// The head, and the rows that the view shows.
  std::vector<std::string> lines(const View& view) const;
  /// All rows as JSON Lines.
  std::string json(Duration now) const;
  /// How many rows the view has, whether they fit or not.
  std::size_t count(const View& view) const { return chosen(view).size(); }
  std::size_t size() const { return rows_.size(); }
  /// Whether something had no room any more.
  bool is_full() const { return is_full_; }

  static std::string_view name_of(Sort sort);

 private:
  static constexpr std::size_t rows_max = 20'000;
  /// How long something counts as changed.
  static constexpr Duration change_span = 1s;

  struct Key {
    std::string bus;
    std::uint32_t place = 0;   ///< node-ID; by frame: the CAN-ID, and what kind of one it is
    std::uint32_t object = 0;  ///< index and sub-index; 0: what is no object
    std::string service;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  /// How often something came lately.
  class Recurrence {
   public:
    void take(double interval_s);
    /// A second. It falls when nothing has come for longer than the longest pause lately.
    double rate(double age_s) const;

   private:
    double intervals_ = 0;  ///< how many, of which older ones count less
    double span_s_ = 0;     ///< how long all of them took
    double pause_s_ = 0;    ///< the longest of them
  };
  struct Row {
    NodeId node = 0;
    std::string id;  ///< CAN-ID as candump writes it
    std::string service;
    std::optional<decoder::DecodedValue> value;  ///< as it was mapped; else `text`
    std::string text;
    Duration time{};
    Duration changed{};
    std::uint64_t count = 0;
    Recurrence recurrence = {};
  };
  struct Shown {
    const Key* key;
    const Row* row;
    std::string name;
    std::string value;
  };

  Row* row_at(const Key& key);
  static void count(Row& row, Duration time, bool has_changed);
  void take_value(Duration time, std::string_view bus, const Frame& frame,
                  const words::FrameWords& words, const decoder::DecodedValue& value);
  void take_text(Duration time, Key key, const Frame& frame, const words::FrameWords& words);
  static double rate(const Row& row, Duration now);
  std::vector<Shown> chosen(const View& view) const;
  static void sort(std::vector<Shown>& shown, const View& view);
  std::string line(const Shown& shown, const View& view) const;
  std::string place_text(const Shown& shown) const;
  std::string head(const View& view) const;

  By by_;
  std::map<Key, Row> rows_;
  Key wanted_;  ///< its texts keep their room
  bool has_buses_ = false;
  std::string first_bus_;
  bool is_full_ = false;
};

}  // namespace canvoy::tools
