#include "canvoy/formats/table/parquet.hpp"

#include <bit>

#include "canvoy/formats/table/thrift.hpp"
#include "canvoy/formats/trace/inflater.hpp"

namespace canvoy::formats {

namespace {

using Of = ThriftStruct::Of;

constexpr std::string_view parquet_mark = "PAR1";

// Numbers of parquet.thrift.
constexpr std::int32_t parquet_plain = 0;
constexpr std::int32_t parquet_levels = 3;
constexpr std::int32_t codec_gzip = 2;

void append_parquet_number(std::string& bytes, std::uint64_t value, unsigned size) {
  for (unsigned byte = 0; byte < size; ++byte) bytes += static_cast<char>(value >> 8 * byte);
}

std::int32_t physical_type(ParquetType type) {
  switch (type) {
    case ParquetType::time:
      return 2;
    case ParquetType::whole:
      return 1;
    case ParquetType::real:
      return 5;
    case ParquetType::text:
    case ParquetType::nullable_text:
      break;
  }
  return 6;
}

/// What a number or bytes mean, in the older way and in the newer one.
void append_meaning(ThriftStruct& element, ParquetType type) {
  constexpr std::int32_t utf8 = 0;
  constexpr std::int32_t timestamp_micros = 10;
  if (type == ParquetType::text || type == ParquetType::nullable_text) {
    element.number(6, utf8);
    ThriftStruct meaning = element.begin(10);
    meaning.begin(1).end();
    meaning.end();
  }
  if (type != ParquetType::time) return;
  element.number(6, timestamp_micros);
  ThriftStruct meaning = element.begin(10);
  ThriftStruct timestamp = meaning.begin(8);
  timestamp.flag(1, true);
  ThriftStruct unit = timestamp.begin(2);
  unit.begin(2).end();
  unit.end();
  timestamp.end();
  meaning.end();
}

void append_schema(std::string& bytes, const std::vector<ParquetColumn>& columns) {
  ThriftStruct root(bytes);
  root.text(4, "schema");
  root.number(5, static_cast<std::int32_t>(columns.size()));
  root.end();
  for (const ParquetColumn& column : columns) {
    ThriftStruct element(bytes);
    element.number(1, physical_type(column.type()));
    element.number(3, column.is_nullable() ? 1 : 0);
    element.text(4, column.name());
    append_meaning(element, column.type());
    element.end();
  }
}

std::string page_head(std::uint32_t rows, std::size_t size, std::size_t packed_size) {
  std::string bytes;
  ThriftStruct page(bytes);
  page.number(1, 0);
  page.number(2, static_cast<std::int32_t>(size));
  page.number(3, static_cast<std::int32_t>(packed_size));
  ThriftStruct data = page.begin(5);
  data.number(1, static_cast<std::int32_t>(rows));
  data.number(2, parquet_plain);
  data.number(3, parquet_levels);
  data.number(4, parquet_levels);
  data.end();
  page.end();
  return bytes;
}

/// Where a column of a group stands.
struct Chunk {
  std::uint64_t at = 0;
  std::uint64_t size = 0;
  std::uint64_t packed_size = 0;
};

void append_chunk(std::string& bytes, const ParquetColumn& column, const Chunk& chunk,
                  std::uint32_t rows) {
  ThriftStruct whole(bytes);
  whole.long_number(2, static_cast<std::int64_t>(chunk.at));
  ThriftStruct data = whole.begin(3);
  data.number(1, physical_type(column.type()));
  data.list(2, Of::numbers, 2);
  data.item(parquet_plain);
  data.item(parquet_levels);
  data.list(3, Of::texts, 1);
  data.item(column.name());
  data.number(4, codec_gzip);
  data.long_number(5, rows);
  data.long_number(6, static_cast<std::int64_t>(chunk.size));
  data.long_number(7, static_cast<std::int64_t>(chunk.packed_size));
  data.long_number(9, static_cast<std::int64_t>(chunk.at));
  data.end();
  whole.end();
}

}  // namespace

void ParquetColumn::append(std::uint64_t value, unsigned size) {
  append_parquet_number(values_, value, size);
}

void ParquetColumn::add(std::optional<double> number) {
  is_there_.push_back(number.has_value());
  if (number) append(std::bit_cast<std::uint64_t>(*number), 8);
}

void ParquetColumn::add(std::string_view text) {
  if (is_nullable()) is_there_.push_back(true);
  append(text.size(), 4);
  values_ += text;
}

// Of a nullable column, a bit for each row stands before the values: groups of eight, after their
// number and that they are bits.
std::string ParquetColumn::take_page() {
  std::string page;
  if (is_nullable()) {
    const std::size_t groups = (is_there_.size() + 7) / 8;
    std::string levels;
    ThriftStruct::append_varint(levels, groups << 1 | 1);
    const std::size_t head = levels.size();
    levels.append(groups, '\0');
    for (std::size_t row = 0; row < is_there_.size(); ++row) {
      if (is_there_[row]) levels[head + row / 8] |= static_cast<char>(1U << row % 8);
    }
    append_parquet_number(page, levels.size(), 4);
    page += levels;
  }
  page += values_;
  values_.clear();
  is_there_.clear();
  return page;
}

void ParquetWriter::begin(std::string& file) {
  if (at_ != 0) return;
  file += parquet_mark;
  at_ = parquet_mark.size();
}

void ParquetWriter::end_row(std::string& file) {
  if (++rows_here_ == rows_max) write_group(file);
}

void ParquetWriter::write_group(std::string& file) {
  begin(file);
  ThriftStruct group(group_list_);
  group.list(1, Of::structures, columns_.size());
  std::uint64_t size = 0;
  for (ParquetColumn& column : columns_) {
    const std::string page = column.take_page();
    Deflater deflater;
    const std::string_view packed = deflater.run(page, true);
    const std::string head = page_head(rows_here_, page.size(), packed.size());
    const Chunk chunk{at_, head.size() + page.size(), head.size() + packed.size()};
    append_chunk(group_list_, column, chunk, rows_here_);
    file += head;
    file += packed;
    at_ += chunk.packed_size;
    size += chunk.size;
  }
  group.long_number(2, static_cast<std::int64_t>(size));
  group.long_number(3, rows_here_);
  group.end();
  ++groups_;
  rows_ += rows_here_;
  rows_here_ = 0;
}

void ParquetWriter::finish(std::string& file) {
  if (rows_here_ > 0) write_group(file);
  begin(file);
  std::string about;
  ThriftStruct all(about);
  all.number(1, 1);
  all.list(2, Of::structures, columns_.size() + 1);
  append_schema(about, columns_);
  all.long_number(3, static_cast<std::int64_t>(rows_));
  all.list(4, Of::structures, groups_);
  about += group_list_;
  all.text(6, "canvoy");
  all.end();
  file += about;
  append_parquet_number(file, about.size(), 4);
  file += parquet_mark;
}

}  // namespace canvoy::formats
