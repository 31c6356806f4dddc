// The latest values, one row for each object, frame or node, with value, age and rate. A frame
// costs a lookup and a comparison for each value; texts are made when they are shown.
//
//     LiveTable table(LiveTable::By::object);
//     table.take(now, "can0", frame, words);
//     for (const std::string& line : table.lines({.now = now, .columns = 80, .rows = 20}))
//     show(line);
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/text/frame_decoder.hpp"

namespace canvoy::tools {

class LiveTable {
 public:
  enum class By : std::uint8_t { object, frame, node };
  enum class Sort : std::uint8_t { place, name, age, rate, change };
  static constexpr unsigned sort_count = 5;

  struct View {
    static constexpr std::size_t as_needed = 0;   ///< of columns: each row is one line
    static constexpr std::size_t all = SIZE_MAX;  ///< of rows

    Duration now{};
    std::size_t columns = 80;
    std::size_t rows = 24;  ///< lines of the table, including its head
    std::size_t first = 0;  ///< first row shown
    Sort sort = Sort::place;
    bool is_reversed = false;
    std::string search = {};  ///< a part of the name, object or value of a row, ignoring case
    bool has_marks = false;   ///< changes are shown in reverse, and overdue rows faint
  };

  explicit LiveTable(By by) : by_(by) {}

  void take(Duration time, std::string_view bus, const Frame& frame, const text::FrameWords& words);

  /// The head, and the rows of the view; long names and values go on in further lines.
  std::vector<std::string> lines(const View& view) const;
  /// Number of rows that lines() has whole: a page.
  std::size_t page(const View& view) const;
  /// All rows as JSON Lines.
  std::string json(Duration now) const;
  /// Number of rows of the view, shown or not.
  std::size_t count(const View& view) const { return chosen(view).size(); }
  std::size_t size() const { return rows_.size(); }
  /// True if a row was dropped for lack of room.
  bool is_full() const { return is_full_; }

  static std::string_view name_of(Sort sort);

 private:
  static constexpr std::size_t rows_max = 20'000;
  /// Time for which a change is shown.
  static constexpr Duration change_span = 1s;

  struct Key {
    std::string bus;
    std::uint32_t place = 0;   ///< node-ID; by frame: CAN-ID and kind of identifier
    std::uint32_t object = 0;  ///< index and sub-index; 0: not an object
    std::string service;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  /// Rate of a recurring event.
  class Recurrence {
   public:
    void take(double interval_s);
    /// Events per second. Decreases when the time since the last one exceeds the longest recent
    /// pause.
    double rate(double age_s) const;
    /// True if the last one is older than three of the longest recent pauses, and than two seconds;
    /// of one that came once, than ten seconds.
    bool is_overdue(double age_s) const;

   private:
    double intervals_ = 0;  ///< number of intervals, with less weight for older ones
    double span_s_ = 0;     ///< sum of the intervals
    double pause_s_ = 0;    ///< the longest interval
  };
  struct Row {
    NodeId node = 0;
    std::string id;  ///< CAN-ID in the format of candump
    std::string service;
    std::optional<decoder::DecodedValue> value;  ///< as mapped; else `text`
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
                  const text::FrameWords& words, const decoder::DecodedValue& value);
  void take_text(Duration time, Key key, const Frame& frame, const text::FrameWords& words);
  static double rate(const Row& row, Duration now);
  std::vector<Shown> chosen(const View& view) const;
  static void sort(std::vector<Shown>& shown, const View& view);
  /// Columns for names, with a blank behind them, and for values.
  struct Widths {
    std::size_t name;
    std::size_t value;
  };
  Widths widths(const std::vector<Shown>& rows, const View& view) const;
  std::string_view title_of_names() const;
  void append_row(std::vector<std::string>& lines, const Shown& shown, const Widths& widths,
                  const View& view) const;
  std::string place_text(const Shown& shown) const;
  std::string head(const Widths& widths) const;

  By by_;
  std::map<Key, Row> rows_;
  Key wanted_;  ///< reused to keep its buffers
  bool has_buses_ = false;
  std::string first_bus_;
  bool is_full_ = false;
};

}  // namespace canvoy::tools
