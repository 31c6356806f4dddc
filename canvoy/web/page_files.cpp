#include "canvoy/web/page_files.hpp"

#include <algorithm>
#include <array>

// As they are: a generator of sources for them would be one more program that a build has to have.
#define CANVOY_PAGE_FILE(name, file)                                                         \
  asm(".pushsection .rodata\n" #name ": .incbin \"" CANVOY_PAGE_FOLDER "/" file "\"\n" #name \
      "_end:\n.popsection\n");                                                               \
  extern "C" const char name[];                                                              \
  extern "C" const char name##_end[];

CANVOY_PAGE_FILE(canvoy_page_html, "index.html")
CANVOY_PAGE_FILE(canvoy_page_script, "page.js")
CANVOY_PAGE_FILE(canvoy_page_style, "page.css")
CANVOY_PAGE_FILE(canvoy_page_icon, "icon.svg")
CANVOY_PAGE_FILE(canvoy_page_openapi, "openapi.json")
CANVOY_PAGE_FILE(canvoy_report_html, "report.html")
CANVOY_PAGE_FILE(canvoy_report_script, "report.js")

#undef CANVOY_PAGE_FILE

namespace canvoy::web {

namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

std::span<const PageFile> page_files() {
  static const std::array files = {
      PageFile{"/", "text/html; charset=utf-8", between(canvoy_page_html, canvoy_page_html_end)},
      PageFile{"/page.js", "text/javascript; charset=utf-8",
               between(canvoy_page_script, canvoy_page_script_end)},
      PageFile{"/page.css", "text/css; charset=utf-8",
               between(canvoy_page_style, canvoy_page_style_end)},
      PageFile{"/icon.svg", "image/svg+xml", between(canvoy_page_icon, canvoy_page_icon_end)},
      PageFile{"/openapi.json", "application/json",
               between(canvoy_page_openapi, canvoy_page_openapi_end)},
  };
  return files;
}

const PageFile* find_page_file(std::string_view path) {
  const auto files = page_files();
  const auto found = std::ranges::find(files, path, &PageFile::path);
  return found == files.end() ? nullptr : &*found;
}

ReportFiles report_files() {
  return {.page = between(canvoy_report_html, canvoy_report_html_end),
          .style = between(canvoy_page_style, canvoy_page_style_end),
          .script = between(canvoy_report_script, canvoy_report_script_end)};
}

}  // namespace canvoy::web
