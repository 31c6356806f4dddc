// canvoy browse BUS NODE: the dictionary of a running node on the terminal.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/session/bus_news.hpp"
#include "canvoy/tools/sheet/node_reader.hpp"
#include "canvoy/tools/sheet/node_tree.hpp"
#include "canvoy/tools/sheet/scan_line.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/terminal/screen.hpp"
#include "canvoy/tools/terminal/typing.hpp"

namespace canvoy::tools {

namespace {

struct BrowseOptions {
  std::string bus;
  std::string node;
  std::string sheet;
  std::string profile;
  std::string time_out = {};
  bool json = false;
};

class Browser {
 public:
  Browser(Session& session, NodeTree& tree, std::string title)
      : session_(session), tree_(tree), title_(std::move(title)) {
    session_.show_progress(false);
    for (host::HostBus* bus : session.buses()) news_.follow(*bus, false);
  }

  int run() {
    constexpr Duration step = 50ms;
    while (!is_over_) {
      rows_ = tree_.rows(search_);
      place_ = std::min(place_, rows_.empty() ? 0 : rows_.size() - 1);
      draw();
      session_.loop().run_until(session_.loop().now() + step);
      if (session_.loop().signal() != 0) break;
      take_keys();
      refresh();
    }
    return exit_done;
  }

 private:
  void take_keys() {
    while (true) {
      const std::optional<Key> key = screen_.key();
      if (!key) return;
      take(*key);
    }
  }

  /// Question to the user in the last row.
  enum class Question : std::uint8_t { none, value, search, save, load, confirm };

  /// Reads the shown rows in sequence.
  void refresh() {
    if (rows_.empty() || question_ == Question::confirm) return;
    const std::size_t shown = std::min(rows_.size() - first_, room_);
    if (shown == 0) return;
    refreshed_ = (refreshed_ + 1) % shown;
    try {
      const bool has_answered = tree_.refresh(rows_.at(first_ + refreshed_));
      if (!has_answered) return;
      answered_at_ = session_.loop().now();
      loss_.clear();
    } catch (const Failure& failure) {
      loss_ = failure.what();
    }
  }

  /// What fails is told until the next key.
  template <class Step>
  void attempt(std::string_view failed, const Step& step) {
    try {
      step();
    } catch (const Failure& failure) {
      message_ = fmt::format("{}{}", failed, failure.what());
    }
  }

  // Keys

  void take(Key key) {
    if (question_ == Question::confirm) return confirm(key);
    if (question_ != Question::none) return answer(key);
    message_.clear();
    if (const auto rows = rows_moved(key, room_, rows_.size())) {
      place_ = moved_row(place_, *rows, rows_.size());
      return;
    }
    switch (static_cast<char32_t>(key)) {
      case 'q':
        is_over_ = true;
        break;
      case '/':
        ask(Question::search, {});
        break;
      case 'w':
        ask(Question::save, "node.dcf");
        break;
      case 'l':
        ask(Question::load, "node.dcf");
        break;
      case 'e':
        edit();
        break;
      case static_cast<char32_t>(Key::enter):
        open_or_edit();
        break;
      default:
        break;
    }
  }

  void open_or_edit() {
    if (rows_.empty()) return;
    if (!rows_[place_].is_folder) return edit();
    tree_.toggle(rows_[place_]);
    rows_ = tree_.rows(search_);
  }

  void edit() {
    if (rows_.empty() || rows_[place_].is_folder) return;
    if (!tree_.is_writable(rows_[place_])) {
      message_ = "it can only be read";
      return;
    }
    edited_ = rows_[place_];
    ask(Question::value, {});
  }

  void ask(Question question, std::string typed) {
    question_ = question;
    typed_ = std::move(typed);
  }

  void answer(Key key) {
    if (key == Key::escape) {
      if (question_ == Question::search) search_.clear();
      question_ = Question::none;
    } else if (key == Key::enter) {
      finish();
    } else {
      type_key(typed_, key);
    }
    if (question_ == Question::search) search_ = typed_;
    // The next key may concern a row that is only found now.
    rows_ = tree_.rows(search_);
    place_ = std::min(place_, rows_.empty() ? 0 : rows_.size() - 1);
  }

  void finish() {
    const Question question = question_;
    question_ = Question::none;
    message_.clear();
    switch (question) {
      case Question::value:
        attempt("write failed: ", [this] { tree_.write(edited_, typed_); });
        break;
      case Question::save:
        attempt("save failed: ", [this] { save(); });
        break;
      case Question::load:
        attempt("", [this] { load(); });
        break;
      case Question::search:
      case Question::none:
      case Question::confirm:
        break;
    }
  }

  void save() {
    const std::string text = sheet_text(tree_.sheet(), typed_);
    write_value_file(typed_, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    message_ = "written to " + typed_;
  }

  void load() {
    change_ = tree_.compare(typed_);
    if (change_.differences.empty()) {
      message_ = "the node is as " + typed_ + " has it";
    } else {
      question_ = Question::confirm;
      first_difference_ = 0;
    }
  }

  void confirm(Key key) {
    if (const auto rows = rows_moved(key, room_, change_.differences.size())) {
      const std::size_t hidden =
          change_.differences.size() - std::min(change_.differences.size(), room_);
      first_difference_ = moved_row(first_difference_, *rows, hidden + 1);
    }
    if (key == Key{'n'} || key == Key::escape) question_ = Question::none;
    if (key != Key{'y'}) return;
    question_ = Question::none;
    message_.clear();
    std::size_t written = 0;
    attempt("", [&] {
      for (const ConfigurationEntry& step : change_.steps) {
        tree_.write(step);
        ++written;
      }
    });
    const std::string count = fmt::format("{} of {} written", written, change_.steps.size());
    message_ = message_.empty() ? count : count + "; " + message_;
  }

  // The picture

  /// A row; long names and values go on in further lines.
  std::vector<std::string> row_lines(const NodeTree::Row& row, bool is_chosen,
                                     std::size_t columns) const {
    constexpr std::size_t place_columns = 12;
    constexpr std::size_t access_columns = 6;
    const formats::SheetEntry* entry = tree_.entry(row);
    const std::size_t rest =
        columns > place_columns + access_columns ? columns - place_columns - access_columns : 0;
    const std::size_t name_columns = std::min(longest_name_, rest * 2 / 5);
    const std::size_t value_columns = rest > 0 ? rest - name_columns - 1 : 0;
    const std::vector<std::string> names =
        in_lines(row.name, name_columns > sign_columns ? name_columns - sign_columns : 0);
    const std::vector<std::string> values = in_lines(tree_.value(row), value_columns);
    std::string place(row.depth, ' ');
    place += text::object_text(row.place.index, row.place.sub);
    std::string sign = row.is_folder ? (row.is_open ? "- " : "+ ") : "  ";
    std::string access = row.is_folder || entry == nullptr ? "" : " " + entry->access;
    std::vector<std::string> lines;
    for (std::size_t i = 0; i == 0 || i < std::max(names.size(), values.size()); ++i) {
      if (i > 0 && value_columns == 0) break;  // no room for either
      std::string line = in_columns(place, place_columns);
      line += in_columns(sign + (i < names.size() ? names[i] : ""), name_columns) + ' ';
      const std::string value = in_columns(i < values.size() ? values[i] : "", value_columns);
      line += !loss_.empty()           ? "\x1b[2m" + value + "\x1b[22m"
              : tree_.has_changed(row) ? "\x1b[1m" + value + "\x1b[22m"
                                       : value;
      line += in_columns(access, access_columns);
      lines.push_back(is_chosen ? "\x1b[7m" + line + "\x1b[27m" : line);
      place.clear();
      sign = "  ";
      access.clear();
    }
    return lines;
  }

  std::string last_row() const {
    switch (question_) {
      case Question::value:
        return fmt::format("{} = {}_  (now {}; Enter writes, Esc does not)", edited_.name, typed_,
                           tree_.value(edited_));
      case Question::search:
        return fmt::format("search: {}_  (Enter keeps it, Esc ends it)", typed_);
      case Question::save:
        return fmt::format("save to (.dcf or .xdc): {}_", typed_);
      case Question::load:
        return fmt::format("load from: {}_", typed_);
      case Question::confirm:
        return fmt::format("write these {} to the node? y, n{}", change_.differences.size(),
                           change_.differences.size() > room_ ? "  (arrows show the others)" : "");
      case Question::none:
        break;
    }
    if (!message_.empty()) return message_;
    if (!loss_.empty()) return loss_;
    return fmt::format("q quit  Enter open, edit  / search{}  w save  l load",
                       search_.empty() ? "" : ": " + search_);
  }

  /// The node, or what is wrong: the age of the values first, since a long reason is cut.
  std::string first_row() const {
    const Time now = session_.loop().now();
    std::string wrong = news_.text(now);
    if (!loss_.empty()) {
      const auto age = std::chrono::floor<std::chrono::seconds>(now - answered_at_);
      wrong = fmt::format("values are {} s old, {}", age.count(),
                          wrong.empty() ? "the node does not answer" : wrong);
    }
    return wrong.empty() ? title_ : fmt::format("\x1b[1m{}\x1b[22m  {}", wrong, title_);
  }

  void draw() {
    const Screen::Size size = Screen::size();
    std::vector<std::string> lines = {first_row()};
    std::vector<std::string> last = in_lines(last_row(), size.columns);
    if (last.size() * 3 > size.rows) last = {last_row()};
    const std::size_t end = size.rows > last.size() ? size.rows - last.size() : 1;
    room_ = end > 1 ? end - 1 : 1;
    const auto append = [&lines, end](std::vector<std::string> more) {
      for (std::string& line : more) {
        if (lines.size() < end) lines.push_back(std::move(line));
      }
    };
    if (question_ == Question::confirm) {
      for (std::size_t i = first_difference_; i < change_.differences.size(); ++i) {
        append(in_lines(difference_text(change_.differences[i]), size.columns));
      }
    } else {
      longest_name_ = 0;
      for (const NodeTree::Row& row : rows_) {
        longest_name_ = std::max(longest_name_, columns_of(row.name) + sign_columns);
      }
      show_chosen(size.columns);
      for (std::size_t i = first_; i < rows_.size() && lines.size() < end; ++i) {
        append(row_lines(rows_[i], i == place_, size.columns));
      }
    }
    lines.resize(end);
    lines.insert(lines.end(), last.begin(), last.end());
    screen_.draw(lines);
  }

  static std::string difference_text(const NodeTree::Difference& each) {
    return fmt::format("{} {}: {} -> {}", text::object_text(each.place.index, each.place.sub),
                       each.name, each.here, each.there);
  }

  /// The chosen row is on the screen, whole where there is room for it, and none of the room is
  /// left empty behind the last row.
  void show_chosen(std::size_t columns) {
    first_ = std::min(first_, place_);
    if (rows_.empty()) return;
    const auto height = [&](std::size_t row) {
      return row_lines(rows_[row], false, columns).size();
    };
    std::size_t taken = height(place_);
    for (std::size_t i = place_; i > first_; --i) {
      taken += height(i - 1);
      if (taken <= room_) continue;
      first_ = i;
      return;
    }
    for (std::size_t i = place_ + 1; i < rows_.size() && taken <= room_; ++i) taken += height(i);
    while (first_ > 0 && taken + height(first_ - 1) <= room_) taken += height(--first_);
  }

  Session& session_;
  NodeTree& tree_;
  std::string title_;
  Screen screen_;
  std::vector<NodeTree::Row> rows_;
  NodeTree::Comparison change_;  ///< of the open question
  std::size_t first_difference_ = 0;
  NodeTree::Row edited_;
  Question question_ = Question::none;
  std::string typed_;
  std::string search_;
  std::string message_;  ///< what the last key has done
  std::size_t place_ = 0;
  std::size_t first_ = 0;
  std::size_t room_ = 1;
  static constexpr std::size_t sign_columns = 2;
  std::size_t longest_name_ = 0;  ///< of the rows, with its sign
  std::size_t refreshed_ = 0;
  std::string loss_;  ///< why the node did not answer last; empty: it did
  bool is_over_ = false;
  Time answered_at_ = session_.loop().now();
  BusNews news_{[](const std::string&) {}};
};

/// Prints all once, without a terminal.
int print_tree(NodeTree& tree, bool json) {
  for (const NodeTree::Row& folder : tree.rows({})) {
    if (folder.is_folder) tree.toggle(folder);
  }
  for (const NodeTree::Row& row : tree.rows({})) {
    if (json) {
      if (!row.is_folder) fmt::print("{}\n", tree.json(row));
      continue;
    }
    const std::string value = tree.value(row);
    fmt::print("{}{} {}{}{}\n", std::string(2 * std::size_t{row.depth}, ' '),
               text::object_text(row.place.index, row.place.sub), row.name,
               value.empty() ? "" : " = ", value);
  }
  return exit_done;
}

int browse(const BrowseOptions& options) {
  const NodeId node = parse_node_id(options.node);
  formats::Findings findings;
  std::optional<formats::DataSheet> given;
  if (!options.sheet.empty()) given = read_sheet_file(options.sheet, findings);
  Session session(options.bus, parse_answer_time(options.time_out));
  NodeReader reader(session, node, {.bus = options.bus, .profile = options.profile});
  ScanLine line;
  reader.on_progress(
      [&line](const formats::SheetScan::Progress& progress) { line.show(progress); });
  formats::DataSheet sheet = given ? reader.read_by(*given, options.sheet) : reader.read();
  line.end();
  const std::string product(sheet.text("DeviceInfo", "ProductName"));
  NodeTree tree(session, node, std::move(sheet));
  if (options.json || !Screen::is_there()) return print_tree(tree, options.json);
  const std::string title =
      fmt::format("{}  {}, {} by {}", options.bus, text::node_text(node), product, reader.source());
  return Browser(session, tree, title).run();
}

}  // namespace

void add_browse(Verb& app) {
  const auto options = std::make_shared<BrowseOptions>();
  Verb& command = app.add_verb("browse", "Look at the dictionary of a node, and change it");
  command.add({
      {"bus", options->bus, bus_text, required},
      {"node", options->node, "10, 0x0A, 0Ah, or its name in the file of --network", required},
      {"--eds", options->sheet, "what the node has (default: as for canvoy eds read)"},
      {"--profile", options->profile, "447-3, 417-4 (default: what the node's 1000h says)",
       excludes("--eds")},
      {"--timeout", options->time_out, answer_time_text, answer_time_rules},
      {"--json", options->json, "all entries once, one JSON object a line"},
  });
  command.set_footer(
      "Where no terminal shows it, all entries are printed once.\n"
      "Keys: arrows, Page Up and Down, Home, End; Enter opens an object, or edits an entry in its "
      "unit;\n"
      "/ searches; w saves into a DCF; l shows what a DCF would change, and writes it; q ends.\n"
      "Examples:\n"
      "  canvoy browse can0 10\n"
      "  canvoy browse can0 5 --eds pump.eds\n"
      "  canvoy browse can0 10 --json");
  command.runs([options] { return browse(*options); });
}

}  // namespace canvoy::tools
