#include "canvoy/web/page_files.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <deque>
#include <string>

#include "canvoy/can/check_invariant.hpp"

// Included as they are: a generator of sources would be one more program in a build.
#define CANVOY_PAGE_FILE(name, file)                                                         \
  asm(".pushsection .rodata\n" #name ": .incbin \"" CANVOY_PAGE_FOLDER "/" file "\"\n" #name \
      "_end:\n.popsection\n");                                                               \
  extern "C" const char name[];                                                              \
  extern "C" const char name##_end[];

CANVOY_PAGE_FILE(canvoy_page_html, "index.html")
CANVOY_PAGE_FILE(canvoy_page_script, "page.js")
CANVOY_PAGE_FILE(canvoy_page_plots, "uplot.js")
CANVOY_PAGE_FILE(canvoy_page_style, "page.css")
CANVOY_PAGE_FILE(canvoy_page_icon, "icon.svg")
CANVOY_PAGE_FILE(canvoy_report_html, "report.html")
CANVOY_PAGE_FILE(canvoy_report_script, "report.js")
CANVOY_PAGE_FILE(canvoy_report_style, "report.css")

#undef CANVOY_PAGE_FILE

namespace canvoy::web {

namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

constexpr int gzip_window = 15 + 16;  ///< zlib: the largest window, and a gzip header
constexpr int gzip_memory = 9;

/// With its prepared forms.
PageFile page_file(std::string_view path, std::string_view type, std::string_view content) {
  static std::deque<std::string> kept;
  PageFile file{.path = path, .type = type, .content = content};
  file.gzip = kept.emplace_back(compressed(content));
  const uLong sum =
      crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
  file.tag = kept.emplace_back(fmt::format("\"{:08x}-{}\"", sum, content.size()));
  return file;
}

}  // namespace

std::span<const PageFile> page_files() {
  static const std::array files = {
      page_file("/", "text/html; charset=utf-8", between(canvoy_page_html, canvoy_page_html_end)),
      page_file("/page.js", "text/javascript; charset=utf-8",
                between(canvoy_page_script, canvoy_page_script_end)),
      page_file("/uplot.js", "text/javascript; charset=utf-8",
                between(canvoy_page_plots, canvoy_page_plots_end)),
      page_file("/page.css", "text/css; charset=utf-8",
                between(canvoy_page_style, canvoy_page_style_end)),
      page_file("/icon.svg", "image/svg+xml", between(canvoy_page_icon, canvoy_page_icon_end)),
  };
  return files;
}

const PageFile* find_page_file(std::string_view path) {
  const auto files = page_files();
  const auto found = std::ranges::find(files, path, &PageFile::path);
  return found == files.end() ? nullptr : &*found;
}

std::string compressed(std::string_view text) {
  z_stream stream{};
  check_invariant(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_window, gzip_memory,
                               Z_DEFAULT_STRATEGY) == Z_OK);
  std::string made(deflateBound(&stream, text.size()), '\0');
  // zlib does not write to this memory.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(made.data());
  stream.avail_out = static_cast<uInt>(made.size());
  check_invariant(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  made.resize(stream.total_out);
  deflateEnd(&stream);
  return made;
}

ReportFiles report_files() {
  return {.page = between(canvoy_report_html, canvoy_report_html_end),
          .style = between(canvoy_report_style, canvoy_report_style_end),
          .script = between(canvoy_report_script, canvoy_report_script_end)};
}

}  // namespace canvoy::web
