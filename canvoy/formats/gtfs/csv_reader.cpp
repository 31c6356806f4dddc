#include "canvoy/formats/gtfs/csv_reader.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::gtfs {

namespace {

constexpr std::size_t piece_bytes = 256 * std::size_t{1024};

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

CsvRead CsvReader::bad(std::string what) {
  is_over_ = true;
  problem_ = std::move(what);
  return CsvRead::bad;
}

/// Reads a piece after the buffered data. False: an error, which is reported.
bool CsvReader::refill() {
  buffer_.erase(0, begin_);
  begin_ = 0;
  const std::size_t had = buffer_.size();
  buffer_.resize(had + piece_bytes);
  const host::Result<std::size_t> count = file_->read(std::span(buffer_).subspan(had));
  buffer_.resize(had + (count ? *count : 0));
  if (!count) {
    bad(count.error().what);
    return false;
  }
  is_all_here_ = *count == 0;
  return true;
}

bool CsvReader::begin_file() {
  is_begun_ = true;
  line_ = 1;
  // More than one piece is needed only if the first ones are very short.
  while (buffer_.size() < 3 && !is_all_here_) {
    if (!refill()) return false;
  }
  const std::string_view start(buffer_);
  if (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")) {
    bad("the text is UTF-16; save it as UTF-8");
    return false;
  }
  if (start.starts_with("\xEF\xBB\xBF")) begin_ = 3;
  return true;
}

/// Position of the line end that ends the row, with regard to quotation marks; npos if it is not
/// buffered yet.
std::size_t CsvReader::quoted_row_end(std::size_t from) {
  bool is_quoted = false;
  bool is_field_start = true;
  for (std::size_t i = from; i < buffer_.size(); ++i) {
    const char c = buffer_[i];
    if (is_quoted) {
      // A second quotation mark reopens what the first has closed.
      if (c == '"') is_quoted = false;
      continue;
    }
    if (c == '\n') return i;
    if (c == '"' && (is_field_start || (i > from && buffer_[i - 1] == '"' && has_quotes_))) {
      is_quoted = true;
      has_quotes_ = true;
    }
    if (c == ',') {
      is_field_start = true;
      has_quotes_ = false;
    } else if (!is_blank(c)) {
      is_field_start = false;
    }
  }
  return is_all_here_ && !is_quoted ? buffer_.size() : std::string::npos;
}

/// Puts the next row into row_, without its line end. False: an error, which is reported.
bool CsvReader::find_row() {
  while (true) {
    std::size_t end = buffer_.find('\n', begin_);
    if (end == std::string::npos && is_all_here_) end = buffer_.size();
    bool is_quoted = false;
    if (end != std::string::npos) {
      const std::string_view line(buffer_.data() + begin_, end - begin_);
      is_quoted = line.find('"') != std::string_view::npos;
      if (is_quoted) {
        has_quotes_ = false;
        end = quoted_row_end(begin_);
      }
    }
    const std::size_t size = (end == std::string::npos ? buffer_.size() : end) - begin_;
    if (size > row_bytes_max) {
      bad("more than 65536 bytes in one row; is a quotation mark missing?");
      return false;
    }
    if (end != std::string::npos) {
      row_ = std::string_view(buffer_.data() + begin_, size);
      has_quotes_ = is_quoted;
      return true;
    }
    if (is_all_here_) {
      bad("the file ends within quotation marks");
      return false;
    }
    if (!refill()) return false;
  }
}

bool CsvReader::split_plain(std::string_view row) {
  while (true) {
    const std::size_t comma = row.find(',');
    fields_.push_back(trimmed(row.substr(0, comma)));
    if (comma == std::string_view::npos) return true;
    row.remove_prefix(comma + 1);
  }
}

/// Takes a quoted field, and the comma after it, off `rest`.
bool CsvReader::take_quoted(std::string_view& rest) {
  const std::size_t start = unquoted_.size();
  rest.remove_prefix(1);
  while (true) {
    const std::size_t mark = rest.find('"');
    if (mark == std::string_view::npos) return false;
    unquoted_.append(rest.substr(0, mark));
    rest.remove_prefix(mark + 1);
    if (!rest.starts_with('"')) break;
    unquoted_.push_back('"');
    rest.remove_prefix(1);
  }
  fields_.push_back(trimmed(std::string_view(unquoted_).substr(start)));
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  return rest.empty() || rest.starts_with(',');
}

bool CsvReader::split_quoted(std::string_view row) {
  unquoted_.clear();
  // Its content is never longer than the row, so views stay valid.
  unquoted_.reserve(row.size());
  const char* const unquoted = unquoted_.data();
  while (true) {
    while (!row.empty() && is_blank(row.front())) row.remove_prefix(1);
    if (row.starts_with('"')) {
      if (!take_quoted(row)) {
        bad("text behind a closing quotation mark");
        return false;
      }
      check_invariant(unquoted_.data() == unquoted);
    } else {
      const std::size_t comma = std::min(row.find(','), row.size());
      fields_.push_back(trimmed(row.substr(0, comma)));
      row.remove_prefix(comma);
    }
    if (row.empty()) return true;
    row.remove_prefix(1);
  }
}

CsvRead CsvReader::next() {
  fields_.clear();
  if (is_over_) return problem_.empty() ? CsvRead::end : CsvRead::bad;
  if (!is_begun_ && !begin_file()) return CsvRead::bad;
  while (true) {
    line_ = next_line_;
    if (begin_ == buffer_.size() && is_all_here_) {
      is_over_ = true;
      return CsvRead::end;
    }
    if (!find_row()) return CsvRead::bad;
    begin_ = std::min(begin_ + row_.size() + 1, buffer_.size());
    ++next_line_;
    if (has_quotes_) {
      next_line_ += static_cast<std::size_t>(std::count(row_.begin(), row_.end(), '\n'));
    }
    if (!trimmed(row_).empty()) break;
  }
  const bool is_split = has_quotes_ ? split_quoted(row_) : split_plain(row_);
  return is_split ? CsvRead::row : CsvRead::bad;
}

}  // namespace canvoy::gtfs
